// The land under the cities: one path in the diagram's coordinates, filled under the view's
// transform.
import type { WorldMap } from "../model/world_map.js";
import type { View } from "./view.js";

export function drawMap(
  context: CanvasRenderingContext2D,
  view: View,
  theme: Record<string, string>,
  map: WorldMap,
) {
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
