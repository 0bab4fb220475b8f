// Pages of the site that explain or show a call, by its heading in docs/API.md: addresses below the
// site's folder.
const asking = ["asking/", "Asking"];
const hidden = ["hidden/", "Hidden circles"];
const recipe = (anchor, title) => [`recipes/#${anchor}`, `the recipe “${title}”`];
const emptyCircle = recipe("i-want-the-largest-empty-circle", "I want the largest empty circle");
const geojson = recipe("i-want-geojson", "I want GeoJSON");
const interpolation = recipe(
  "i-want-to-interpolate-between-places",
  "I want to interpolate between places",
);
const filter = recipe(
  "i-want-to-pick-only-some-of-the-circles",
  "I want to pick only some of the circles",
);
const paths = recipe("i-want-cells-as-svg-paths", "I want cells as SVG paths");
const service = recipe("i-want-service-areas-on-the-globe", "I want service areas on the globe");
const areas = ["areas/", "Areas"];
const sphere = ["regions/#cells-on-a-sphere", "Cells on a sphere"];

/** @type {Readonly<Record<string, [address: string, title: string][]>>} */
export const kSeeAlso = {
  "Diagram.from": [
    recipe("i-want-to-join-with-my-data-by-key", "I want to join with my data by key"),
  ],
  "diagram.insert": [["insertion/", "Insertion"]],
  "diagram.remove": [["deletion/", "Deletion"]],
  "diagram.isHidden": [hidden],
  "diagram.coverOf": [hidden],
  "diagram.find": [asking, filter],
  "diagram.nearest": [asking],
  "diagram.findMany": [["asking/#many-questions-at-once", "Many questions at once"]],
  "diagram.kNearest": [asking, filter],
  "diagram.within": [asking],
  "diagram.pick": [
    asking,
    recipe("i-want-to-hover-a-bubble-chart", "I want to hover a bubble chart"),
  ],
  "diagram.neighbors": [
    recipe("i-want-to-know-who-is-next-to-whom", "I want to know who is next to whom"),
  ],
  "diagram.voronoi": [
    ["why/", "Why circles"],
    ["regions/", "Regions and the globe"],
  ],
  "function validate": [["exactness/", "Exactness"]],
  "function predicateCounts": [["exactness/", "Exactness"]],
  "voronoi.renderCell": [paths],
  "voronoi.renderCells": [paths],
  "voronoi.toGeoJSON": [geojson],
  "voronoi.largestEmptyCircle": [emptyCircle],
  "voronoi.emptyCircles": [emptyCircle],
  "voronoi.cellCircle": [["examples/#treemap", "an example that places names"]],
  "voronoi.naturalWeights": [interpolation],
  "voronoi.interpolate": [interpolation],
  "voronoi.fitAreas": [areas, recipe("i-want-areas-by-value", "I want areas by value")],
  "sphericalDiagram.find": [sphere],
  "sphericalVoronoi.toGeoJSON": [service],
  "sphericalVoronoi.largestEmptyCircle": [emptyCircle],
  "function treemap": [areas, ["examples/#treemap", "an example"]],
};
