// A program that makes calls at different distances from the end of JavaScript's stack, until one
// succeeds. Prints how they ended, and the faults afterwards, of the diagram unless it said that it
// is broken, and of another one.
import { ApolloniusError, Diagram } from "../../../build/packed/consumer.mjs";
import { validate } from "../../../build/packed/diagnostics.mjs";
import { graph } from "./graph.mjs";
import { generator, randomCircles } from "./random.mjs";

const random = generator(61);
const grid = (count) =>
  Float64Array.from({ length: 3 * count }, (_, k) => Math.floor(random() * (k % 3 === 2 ? 5 : 60)));
const bystander = new Diagram(grid(100));
const before = JSON.stringify(graph(bystander));

const uses = {
  insert: (d) => d.insert(...grid(1)),
  insertMany: (d) => d.insertMany(grid(30)),
  remove: (d) => d.remove(d.ids()[0]),
  update: (d) => d.update(d.ids()[0], ...grid(1)),
  find: (d) => d.find(random(), random()),
  findMany: (d) => d.findMany(new Float64Array(200)),
  kNearest: (d) => d.kNearest(30, 30, 20),
  toBytes: (d) => d.toBytes(),
  fromBytes: (d) => Diagram.fromBytes(d.toBytes()),
  vertices: (d) => d.vertices(),
  render: (d) => d.render(),
  cellPolygon: (d) => d.voronoi().cellPolygon(d.find(30, 30)),
  toGeoJSON: (d) => d.voronoi().toGeoJSON(),
  constructor: () => new Diagram(randomCircles(300, 62)),
};

/** Calls at each depth from the deepest on up; ends when `attempt` says true. */
function dive(attempt) {
  let isDone = false;
  const deeper = () => {
    try {
      deeper();
    } catch {}
    if (!isDone) isDone = attempt();
  };
  deeper();
}

const ends = {};
const wrong = [];
for (let round = 0; round < 12; ++round) {
  for (const [name, use] of Object.entries(uses)) {
    const diagram = new Diagram(grid(200));

    dive.call(
      null,
      () => {
        let end = "none";
        try {
          use(diagram);
        } catch (error) {
          end = error instanceof ApolloniusError ? error.code : error.name;
        }
        ends[end] = (ends[end] ?? 0) + 1;
        return end === "none" || end === "broken";
      },
      ...new Array(round).fill(0),
    );
    try {
      if (validate(diagram) !== null) wrong.push(`${name}: ${validate(diagram)}`);
    } catch (error) {
      if (error.code !== "broken") wrong.push(`${name}: ${error}`);
    }
    try {
      if (JSON.stringify(graph(bystander)) !== before || validate(bystander) !== null)
        wrong.push(`${name}: another diagram has changed`);
      bystander.remove(bystander.insert(...grid(1)));
      const fresh = new Diagram(grid(200));
      if (validate(fresh) !== null) wrong.push(`${name}: a new diagram is wrong`);
      fresh.dispose();
    } catch (error) {
      wrong.push(`${name}, others: ${error}`);
    }
    diagram.dispose();
  }
}
console.log(JSON.stringify({ ends, wrong: [...new Set(wrong)] }));
