// The code of README and docs/LOADING.md can be pasted: it runs and gives what the comments beside
// it say, its links lead somewhere.
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../../tools/toolchain/folders.mjs";
import { runInNode } from "./support/node.mjs";

const readme = readFileSync(path.join(root, "README.md"), "utf8");
const loading = readFileSync(path.join(root, "docs/LOADING.md"), "utf8");
const blocks = [...`${readme}${loading}`.matchAll(/^```js\n([\s\S]*?)^```/gm)].map(
  (match) => match[1],
);
const importLine = 'import { Diagram } from "apollonius-diagram";\n';

/** The block with each `expression; // value` made to print the expression, and these values. */
function instrumented(block) {
  const values = [];
  const code = block.replace(
    /^(?!const|import)(\S.*?);\s+\/\/ (\[.*?\]|\d+|true|false)(?=$|:).*$/gm,
    (_, expression, value) => {
      values.push(value.replaceAll(" ", ""));
      return `show(${expression});`;
    },
  );
  const show =
    "const show = (value) =>\n" +
    "  console.log(JSON.stringify(ArrayBuffer.isView(value) ? [...value] : value));\n";
  return { code: show + code, values };
}

test("the first lines", () => {
  const block = blocks.find((text) => text.includes("const bubbles"));
  const { code, values } = instrumented(block);
  expect(values.length).toBe(5);
  expect(runInNode(code).split("\n")).toEqual(values);
});

test("the lines about cells", () => {
  const block = blocks.find((text) => text.includes("cellPolygons"));
  const context =
    "const calls = [];\n" +
    "const context = new Proxy({}, { get: (_, name) => () => calls.push(name) });\n";
  const output = runInNode(
    importLine +
      context +
      block.replace("ring.index, ring", "ring.index") +
      "console.log(calls.length > 1, path.slice(0, 1));",
  );
  expect(output.split("\n")).toEqual(["0", "1", "2", "true M"]);
});

test("the lines about the globe", () => {
  const first = blocks.find((text) => text.includes("const cities"));
  const { code, values } = instrumented(first);
  expect(values).toEqual(["0"]);
  const output = runInNode(`${code}console.log(Math.round(distance), Math.round(area / 1e6));`);
  const [found, numbers] = output.split("\n");
  expect(found).toBe(values[0]);
  expect(numbers).toMatch(/^5\d{3} \d+$/); // from Paris or London to New York
});

test("the lines about treemaps", () => {
  const block = blocks.find((text) => text.includes("treemap()"));
  const before =
    'import { createRequire } from "node:module";\n' +
    `const { hierarchy } = createRequire(${JSON.stringify(`${root}/`)})("d3-hierarchy");\n` +
    'const data = { name: "all", children: [{ size: 1 }, { size: 2 }] };\n' +
    "let calls = 0;\n" +
    "const context = new Proxy({}, { get: () => () => ++calls });\n";
  const after = "console.log(calls > 5, root.children[1].area.toFixed(1));";
  expect(runInNode(before + block + after)).toBe("true 300000.0");
});

test("the cells of the globe in d3-geo, and as they are given to maps", () => {
  const first = blocks.find((text) => text.includes("const cities"));
  const maps = blocks.find((text) => text.includes("geoOrthographic"));
  const output = runInNode(`import { geoOrthographic, geoPath } from "d3-geo";
    ${first}
    const calls = [];
    const context = new Proxy({}, { get: (_, name) => () => calls.push(name) });
    const shown = {};
    const map = { on: (_, click) => click({ latlng: { lng: 10, lat: 50 } }) };
    const L = { geoJSON: (data) => ({ addTo: (to) => { shown.leaflet = [data, to]; } }) };
    const maplibre = {
      addSource: (id, source) => { shown.source = [id, source]; },
      addLayer: (layer) => { shown.layer = layer; },
    };
    ${maps}
    const inside = ([lon, lat]) => Math.abs(lon) <= 180 && Math.abs(lat) <= 90;
    console.log(
      calls.includes("lineTo"),
      shown.leaflet[0] === cells && shown.leaflet[1] === map,
      shown.source[1].data === cells && shown.layer.source === shown.source[0],
      cells.features.map(({ properties }) => properties === cities[0]).join(),
      cells.features.every(({ geometry }) => geometry.coordinates.flat(2).flat().length > 0),
      cells.features.every(({ geometry: { type, coordinates } }) =>
        coordinates.flat(type === "Polygon" ? 1 : 2).every(inside)),
    );`);
  expect(output.split("\n")).toEqual(["0", "true true true true,false,false true true"]);
});

test("the address of the wasm is written as the tests of bundlers write it", () => {
  const block = blocks.find((text) => text.includes("apollonius-diagram/wasm"));
  const bundlers = readFileSync(path.join(root, "tests/wasm/support/bundle.mjs"), "utf8");
  for (const way of [
    '"apollonius-diagram/core.wasm?url"',
    'new URL("apollonius-diagram/core.wasm", import.meta.url)',
    'from "apollonius-diagram/core.wasm";',
  ]) {
    expect(block).toContain(way);
    expect(bundlers).toContain(way);
  }
  expect(blocks.length).toBe(6);
});

test("links and pictures are there", () => {
  const targets = [...readme.matchAll(/\]\(([^)]+)\)/g)]
    .map((match) => match[1])
    .filter((target) => !target.startsWith("http"));
  expect(targets.length).toBeGreaterThan(15);
  expect(targets.filter((target) => !existsSync(path.join(root, target.split("#")[0])))).toEqual(
    [],
  );
});
