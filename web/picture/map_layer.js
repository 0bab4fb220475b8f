// The land under the cities: one path in the diagram's coordinates, filled under the view's
// transform.

/** @typedef {{ land: Path2D, outline: Path2D }} WorldMap */

/** Rings are whole numbers: x, y, then differences from point to point. */
function addRing(path, ring) {
  let x = ring[0];
  let y = ring[1];
  path.moveTo(x, y);
  for (let k = 2; k < ring.length; k += 2) {
    x += ring[k];
    y += ring[k + 1];
    path.lineTo(x, y);
  }
  path.closePath();
}

/** @param {{ outline: number[], land: number[][] }} data @returns {WorldMap} */
export function makeMap(data) {
  const land = new Path2D();
  for (const ring of data.land) addRing(land, ring);
  const outline = new Path2D();
  addRing(outline, data.outline);
  return { land, outline };
}

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
  context.fill(map.outline);
  context.strokeStyle = theme.coast;
  context.stroke(map.outline);
  context.fillStyle = theme.land;
  context.fill(map.land);
  context.stroke(map.land);
  context.restore();
}
