// A globe to turn: cells of cities on the sphere, and the nearest one in true kilometres.
import { SphericalDiagram } from "apollonius-diagram/sphere";
import { geoCircle, geoOrthographic, geoPath, type Projection } from "d3-geo";
import { figure, type Point, type Said } from "../figure/figure.js";
import { drawDot, drawPointer } from "../figure/pen.js";
import { kCities, kCoasts } from "./globe_places.js";

const kRadius = 6371.0088; // km, of the Earth
const kMostReach = 3000; // km, of the largest city's circle
const kTolerance = 12; // km, of the edges: half a pixel here
const kDegree = Math.PI / 180;

type Place = [longitude: number, latitude: number];
type State = {
  projection: Projection;
  reach: number;
  diagram: SphericalDiagram;
  edges: Place[][];
  at: Point | null; // the pointer, if it is on the globe
};

const land = {
  type: "Polygon",
  coordinates: kCoasts.map((ring) => ring.split(" ").map((place) => place.split(",").map(Number))),
};

/** The larger a city, the wider its circle: its head start. */
function setReach(state: State, reach: number) {
  state.reach = reach;
  state.diagram.dispose();
  state.diagram = SphericalDiagram.from(
    kCities,
    ([, lon]) => lon,
    ([, , lat]) => lat,
    ([, , , people]) => reach * Math.sqrt(people / kCities[0][3]),
    { radius: kRadius },
  );
  state.edges = state.diagram.voronoi().cellMesh({ tolerance: kTolerance }).coordinates;
}

/** The place under the pointer; beside the globe, and without one, the middle of the view. */
function asked({ projection, at }: State): Place {
  const [x, y] = at ?? projection.translate();
  return projection.invert([x, y]);
}

function turn(state: State, dx: number, dy: number) {
  const { projection } = state;
  const [lambda, phi] = projection.rotate();
  const degrees = 1 / kDegree / projection.scale();
  const tilt = Math.max(-90, Math.min(90, phi - dy * degrees));
  projection.rotate([longitude(lambda + dx * degrees), tilt]);
}

const longitude = (degrees: number) => degrees - 360 * Math.floor((degrees + 180) / 360);
const km = (value: number) =>
  Math.round(value)
    .toString()
    .replace(/\B(?=(\d{3})+$)/g, "\u202f");

function named([lon, lat]: Place) {
  const [east, north] = [Math.round(lon), Math.round(lat)];
  const latitude = `${Math.abs(north)}° ${north < 0 ? "S" : "N"}`;
  return `${latitude}, ${Math.abs(east)}° ${east < 0 ? "W" : "E"}`;
}

export default figure<State>({
  needs: ["sphere"],
  size: { wide: [740, 460], narrow: [370, 360] },
  start([width, height]) {
    const projection = geoOrthographic()
      .clipAngle(90)
      .precision(0.4)
      .rotate([-18, -32])
      .translate([width / 2, height / 2])
      .scale(Math.min(width, height) / 2 - 12);
    const state = { projection, reach: 0, diagram: new SphericalDiagram(), edges: [], at: null };
    setReach(state, 400);
    return state;
  },
  draw(pen, state) {
    const { projection, diagram, edges } = state;
    const path = geoPath(projection).digits(1);
    const [x, y] = projection.translate();
    const place = asked(state);
    const id = diagram.find(...place);
    pen.circle(x, y, projection.scale(), "sea");
    pen.path(path(land) ?? "", "land");
    const options = { tolerance: kTolerance, winding: "clockwise" } as const;
    const cell = diagram.voronoi().cellPolygon(id, options);
    pen.path(path({ type: "Polygon", coordinates: [cell] }) ?? "", "nearestCell");
    pen.path(path({ type: "MultiLineString", coordinates: edges }) ?? "", "edge");
    for (const { id: each, lon, lat, r, hidden } of diagram) {
      const circle = geoCircle().center([lon, lat]).precision(8);
      const degrees = r / kRadius / kDegree;
      const look = each === id ? "nearest" : hidden ? "hidden" : "circle";
      pen.path(path(circle.radius(Math.max(degrees, 0.6))()) ?? "", look);
    }
    const { lon, lat } = diagram.site(id);
    pen.path(path({ type: "LineString", coordinates: [place, [lon, lat]] }) ?? "", "ruler");
    const city = path({ type: "Point", coordinates: [lon, lat] }) && projection([lon, lat]);
    if (city) {
      drawDot(pen, ...city, "centre", 3);
      pen.text(kCities[id][0], city[0], city[1] - 14, "name", { align: "middle", isBold: true });
    }
    drawPointer(pen, ...(state.at ?? [x, y]));
  },
  say(state) {
    const { diagram, at, reach } = state;
    const place = asked(state);
    const { id, distance } = diagram.nearest(...place) ?? { id: 0, distance: 0 };
    const { r } = diagram.site(id);
    const start: Said[] = [
      at ? "Under the pointer, " : "In the middle, ",
      `${named(place)}: `,
      [kCities[id][0], "nearest"],
      ` is nearest, ${km(distance + r)} km away`,
    ];
    if (reach === 0) return [...start, "."];
    const rest = distance < 0 ? "inside its circle." : `of which ${km(r)} km are its head start.`;
    const { hiddenSize } = diagram;
    const hidden: Said[] =
      hiddenSize === 0
        ? []
        : [
            " Of the cities, ",
            [`${hiddenSize}`, "hidden"],
            hiddenSize === 1 ? " is hidden." : " are hidden.",
          ];
    return [...start, ", ", rest, ...hidden];
  },
  hover(state, at) {
    const [x, y] = state.projection.translate();
    const isOn = at && Math.hypot(at[0] - x, at[1] - y) < state.projection.scale();
    state.at = isOn ? at : null;
  },
  drag: turn,
  controls: [
    {
      kind: "slider",
      label: "Longitude",
      min: -180,
      max: 180,
      step: 1,
      get: ({ projection }) => Math.round(-projection.rotate()[0]),
      set({ projection }, value) {
        projection.rotate([-value, projection.rotate()[1]]);
      },
      show({ projection }) {
        const degrees = Math.round(-projection.rotate()[0]);
        return `${Math.abs(degrees)}° ${degrees < 0 ? "W" : "E"}`;
      },
    },
    {
      kind: "slider",
      label: "Head start",
      min: 0,
      max: kMostReach,
      step: 50,
      get: ({ reach }) => reach,
      set: setReach,
      show: ({ reach }) => `${km(reach)} km`,
    },
  ],
});
