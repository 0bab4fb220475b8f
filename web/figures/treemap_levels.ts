// A tree of three levels as cells within cells: the hours of a week. The hours are invented.
import { treemap, type WithCells } from "apollonius-diagram/treemap";
import { figure, type Point, type Size } from "../figure/figure.js";
import { drawPointer, type LookName, type Pen } from "../figure/pen.js";

type Datum = { name: string; hours?: number; children?: readonly Datum[] };

/** Names and hours: what is within a group follows it. */
const kWeek = {
  Sleep: { Nights: { Workdays: 37, Weekend: 17 }, Naps: { Sofa: 1, Train: 1 } },
  Work: {
    Making: { Code: 16, Text: 7, Review: 5 },
    Talking: { Meetings: 6, Calls: 3 },
    Travel: { Train: 5, Bicycle: 2 },
  },
  Home: {
    Meals: { Eating: 10, Cooking: 8, Shopping: 3 },
    Chores: { Cleaning: 4, Laundry: 2, Letters: 1 },
    Care: { Children: 10, Garden: 2 },
  },
  Free: {
    Friends: { Visits: 6, Phone: 2 },
    Sports: { Running: 3, Swimming: 2 },
    Culture: { Books: 7, Films: 5, Music: 3 },
  },
};
const kLevels = ["Groups", "Parts", "Activities"];
const kFills: readonly LookName[] = ["firstArea", "secondArea", "thirdArea", "fourthArea"];
const kOutlines: readonly LookName[] = ["strongEdge", "edge", "quietEdge"];

type Tree = { [name: string]: number | Tree };
type Node = {
  data: Datum;
  value: number;
  depth: number;
  group: number;
  path: string;
  children?: Node[];
};
type Laid = WithCells<Node>;
type State = { size: Size; root: Laid; level: number; pointer: Point | null };

/** As d3-hierarchy makes nodes: a value is the sum of what is below. */
function nodeOf(name: string, inside: number | Tree, depth = 0, path = "", group = 0): Node {
  if (typeof inside === "number")
    return { data: { name }, value: inside, depth, group, path: path + name };
  const prefix = depth === 0 ? "" : `${path}${name} › `;
  const children = Object.entries(inside).map(([key, value], k) =>
    nodeOf(key, value, depth + 1, prefix, depth === 0 ? k : group),
  );
  const value = children.reduce((sum, child) => sum + child.value, 0);
  return { data: { name }, value, depth, group, path: path + name, children };
}

const childrenOf = ({ children = [] }: Laid) => children;
const onLevel = (root: Laid, level: number): Laid[] =>
  level === 0 ? [root] : childrenOf(root).flatMap((child) => onLevel(child, level - 1));

/** The cell that a point is in: on each level that of the nearest circle. */
function cellAt(node: Laid, level: number, [x, y]: Point): Laid {
  if (level === 0) return node;
  const distance = ({ circle }: Laid) =>
    circle ? Math.hypot(x - circle.x, y - circle.y) - circle.r : Infinity;
  const nearest = childrenOf(node).reduce((a, b) => (distance(b) < distance(a) ? b : a));
  return cellAt(nearest, level - 1, [x, y]);
}

const shareOf = (part: number, all: number) => `${((100 * part) / all).toFixed(4)} %`;

function drawName(pen: Pen, { data: { name }, area, centroid }: Laid) {
  const size = Math.max(12, Math.min(20, Math.sqrt(area) / 6));
  const room = Math.sqrt(area) * pen.scale;
  const width = 0.62 * size * name.length; // about
  if (!centroid || room < width) return;
  const x = Math.max(centroid[0], width / 2 / pen.scale); // inside the picture
  pen.text(name, x, centroid[1], "name", { align: "middle", size });
}

export default figure<State>({
  size: { wide: [740, 420], narrow: [370, 460] },
  start(size) {
    const layout = treemap<Datum>().size(size);
    return { size, root: layout(nodeOf("Week", kWeek)), level: 3, pointer: null };
  },
  draw(pen, { size, root, level, pointer }) {
    const under = pointer && cellAt(root, level, pointer);
    for (const cell of onLevel(root, level))
      pen.path(cell.render() ?? "", cell === under ? "nearestCell" : kFills[cell.group]);
    for (let depth = level; depth > 0; depth--)
      for (const cell of onLevel(root, depth)) pen.path(cell.render() ?? "", kOutlines[depth - 1]);
    for (const cell of onLevel(root, level)) drawName(pen, cell);
    pen.rectangle(0, 0, ...size, "frame");
    if (pointer) drawPointer(pen, ...pointer);
  },
  say({ size, root, level, pointer }) {
    const whole = size[0] * size[1];
    if (pointer) {
      const { path, value, area } = cellAt(root, level, pointer);
      return [
        [path, "nearest"],
        `: ${value} of ${root.value} hours are ${shareOf(value, root.value)}, `,
        `its cell is ${shareOf(area, whole)} of the area.`,
      ];
    }
    const cells = onLevel(root, level);
    const errors = cells.map(({ value, area }) =>
      Math.abs((area * root.value) / (whole * value) - 1),
    );
    return [
      `${cells.length} cells. No area differs from its share by more than `,
      [`${Math.max(...errors).toExponential(0)} of it`, "neighbor"],
      ".",
    ];
  },
  hover(state, at) {
    state.pointer = at;
  },
  controls: [
    {
      kind: "choice",
      label: "Level",
      options: kLevels.map((name, k) => [String(k + 1), name] as const),
      get: ({ level }) => String(level),
      set(state, value) {
        state.level = Number(value);
      },
    },
  ],
});
