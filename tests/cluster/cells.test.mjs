// Files of cells: the libraries of the formats read them, and the index of FlatGeobuf finds the
// cells in a rectangle, for any number of cells in any parts.
import { readFileSync } from "node:fs";
import path from "node:path";
import { expect, test } from "@jest/globals";
import { asyncBufferFromFile, parquetReadObjects } from "hyparquet";
import { cellFormats } from "../../web/examples/cluster/cells/index.mjs";
import { areaSections, join } from "../../web/examples/cluster/tiles.mjs";
import { generator } from "../wasm/support/random.mjs";
import { meets, polygonsOf, readFlatGeobuf, readLines } from "./support/cells.mjs";
import { emptyFolder, readDoubles } from "./support/files.mjs";

const folder = emptyFolder("cells");
const window = [0, 0, 100, 100];

/** A ring around a square; the other way round with a negative height. */
const square = (x, y, width, height = width) =>
  Float64Array.of(x, y, x + width, y, x + width, y + height, x, y + height, x, y);

/** Squares; every third one has a hole, every fifth one another part. */
function randomCells(count) {
  const random = generator(count + 1);
  return Array.from({ length: count }, (_, k) => {
    const [x, y] = [95 * random(), 95 * random()];
    const hole = square(x + 0.5, y + 0.75, 0.25, -0.25);
    const polygons = [k % 3 === 0 ? [square(x, y, 1), hole] : [square(x, y, 1)]];
    if (k % 5 === 0) polygons.push([square(x + 2, y, 1)]);
    return { id: 2 ** 40 + 7 * k, area: random(), polygons };
  });
}

/**
 * Parts as workers write them and `collect` reads them, of 0, 1, 2, … cells; `asked` counts how
 * many times each section of all parts was.
 */
function partsOf(cells, { count = 2 ** 41, slice = count, asked = {} } = {}) {
  const parts = [];
  for (let from = 0, size = 0; from < cells.length; from += size++) {
    const some = cells.slice(from, from + size);
    const sections = areaSections(
      some.flatMap(({ id, area }) => [id, area]),
      count,
      slice,
    );
    for (const [name, { encode }] of Object.entries(cellFormats))
      sections[name] = Buffer.concat(some.map(encode));
    parts.push(sections);
  }
  return async function* (names) {
    for (const name of names) asked[name] = (asked[name] ?? 0) + 1;
    for (const sections of parts)
      yield Object.fromEntries(names.map((name) => [name, sections[name]]));
  };
}

test.each([0, 1, 2, 15, 16, 17, 256, 257, 1000])("%i cells in all formats", async (count) => {
  const cells = randomCells(count);
  const out = path.join(folder, String(count));
  const common = { window, isLonLat: count % 2 === 0, features: count };
  const files = {};
  for (const [name, { join }] of Object.entries(cellFormats))
    [files[name]] = await join(out, partsOf(cells), common);
  const expected = cells.map(({ id, area, polygons }) => ({
    id,
    area,
    polygons: polygons.map((rings) =>
      rings.map((ring) =>
        Array.from({ length: ring.length / 2 }, (_, k) => [...ring.slice(2 * k, 2 * k + 2)]),
      ),
    ),
  }));
  const found = ({ id, area, geometry }) => ({
    id: Number(id),
    area,
    polygons: polygonsOf(geometry),
  });

  if (count > 0) {
    const lines = readLines(files.geojson);
    const ofLine = ({ id, properties, geometry }) => found({ id, ...properties, geometry });
    expect(lines.map(ofLine)).toEqual(expected);
  }
  const rows = await parquetReadObjects({ file: await asyncBufferFromFile(files.geoparquet) });
  expect(rows.map(found)).toEqual(expected);

  const { header, features } = await readFlatGeobuf(files.flatgeobuf);
  const ofFeature = ({ properties, geometry }) => found({ ...properties, geometry });
  expect(header.featuresCount).toBe(count);
  expect(header.crs?.code).toBe(common.isLonLat ? 4326 : undefined);
  expect(features.map(ofFeature)).toEqual(expected);
  if (count === 0) return; // the library searches no empty index
  for (const [minX, minY, maxX, maxY] of [
    window,
    [20, 30, 25, 70],
    [50, 50, 50, 50],
    [-2, 0, -1, 9],
  ]) {
    const rect = { minX, minY, maxX, maxY };
    const searched = await readFlatGeobuf(files.flatgeobuf, rect);
    const there = features.filter(({ geometry }) => meets(geometry, rect));
    expect(searched.features.map(ofFeature)).toEqual(there.map(ofFeature));
  }
});

test("areas come out by id, and each section is read once, however many slices", async () => {
  const random = generator(7);
  const cells = randomCells(500).map((cell) => ({ ...cell, id: Math.floor(300 * random()) }));
  const areas = new Float64Array(300);
  for (const { id, area } of cells) areas[id] += area;
  const common = { count: 300, window, isLonLat: false, cells: Object.keys(cellFormats) };
  let first;
  for (const slice of [1000, 300, 299, 100, 7]) {
    const asked = {};
    const parts = partsOf(cells, { count: 300, slice, asked });
    const files = await join(path.join(folder, `slices-${slice}`), parts, common, slice);
    expect([...readDoubles(files[0])]).toEqual([...areas]);
    expect(Object.keys(asked)).toHaveLength(Math.ceil(300 / slice) + 3);
    expect(new Set(Object.values(asked))).toEqual(new Set([1]));
    const { header } = await readFlatGeobuf(files.find((file) => file.endsWith(".fgb")));
    expect(header.featuresCount).toBe(500);
    const contents = files.map((file) => readFileSync(file, "latin1"));
    first ??= contents;
    expect(contents.every((content, k) => content === first[k])).toBe(true);
  }
});
