// A page's download for each use (tools/sizes.mjs) is within its budget, and README.md says it.
import { readFigures } from "../../tools/figures.mjs";
import { bundleOf, measureSizes, uses } from "../../tools/sizes.mjs";

let sizes;
beforeAll(async () => {
  sizes = await measureSizes();
});

test.each(Object.keys(uses))("%s", (use) => {
  expect(sizes[use]).toBeLessThanOrEqual(uses[use].budget);
});

test("README.md has these sizes, to 2 KB (npm run sizes -- --write)", () => {
  const { sizes: said } = readFigures(); // README.md quotes some of them
  for (const [name, bytes] of Object.entries(sizes))
    expect(Math.abs(said[name] - bytes / 1000)).toBeLessThanOrEqual(2);
});

test("who imports only the error gets only that", async () => {
  const code =
    'import { ApolloniusError } from "apollonius-diagram"; new ApolloniusError("broken");';
  expect((await bundleOf(code)).length).toBeLessThan(500);
});

test("a bundle holds no code of parts that its use does not need", async () => {
  // Words of which only messages of that part are made.
  const words = {
    shapes: "the region has no area",
    sphere: "from -90 to 90",
    treemap: "d3-hierarchy",
  };
  const needed = {
    core: [],
    default: ["shapes"],
    sphere: ["sphere"],
    treemap: ["shapes", "treemap"],
  };
  for (const [use, parts] of Object.entries(needed)) {
    const text = Buffer.from(await bundleOf(uses[use].code)).toString();
    const found = Object.keys(words).filter((part) => text.includes(words[part]));
    expect([use, found]).toEqual([use, parts]);
  }
});
