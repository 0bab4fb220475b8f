// The land under the cities: one path in the diagram's coordinates, filled under the view's
// transform; and the same rings as windows that cells end at.

/** @typedef {{ shape: Path2D, rings: number[][] }} Part rings x, y, … */
/** @typedef {{ land: Part, outline: Part }} WorldMap */

/** The file has whole numbers: x, y, then differences from point to point. */
function ringOf(steps) {
  const ring = [];
  for (let k = 0; k < steps.length; k++) ring[k] = steps[k] + (k < 2 ? 0 : ring[k - 2]);
  return ring;
}

/** @param {number[][]} steps @returns {Part} */
function makePart(steps) {
  const rings = steps.map(ringOf);
  const shape = new Path2D();
  for (const ring of rings) {
    shape.moveTo(ring[0], ring[1]);
    for (let k = 2; k < ring.length; k += 2) shape.lineTo(ring[k], ring[k + 1]);
    shape.closePath();
  }
  return { shape, rings };
}

/** @param {{ outline: number[], land: number[][] }} data @returns {WorldMap} */
export const makeMap = ({ outline, land }) => ({
  land: makePart(land),
  outline: makePart([outline]),
});

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import("./view.js").View} view
 * @param {Record<string, string>} theme
 * @param {WorldMap} map
 */
export function drawMap(context, view, theme, map) {
  context.save();
  context.transform(view.scale, 0, 0, -view.scale, view.originX, view.originY);
  context.lineWidth = 1 / view.scale;
  context.fillStyle = theme.sea;
  context.fill(map.outline.shape);
  context.strokeStyle = theme.coast;
  context.stroke(map.outline.shape);
  context.fillStyle = theme.land;
  context.fill(map.land.shape);
  context.stroke(map.land.shape);
  context.restore();
}
