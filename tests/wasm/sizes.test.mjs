// What a page downloads for each use (tools/sizes.mjs) is within its budget, and README.md says it.
import { readFileSync } from "node:fs";
import path from "node:path";
import { bundleOf, measureSizes, readmeWith, uses } from "../../tools/sizes.mjs";
import { root } from "../../tools/toolchain/folders.mjs";

let sizes;
beforeAll(async () => {
  sizes = await measureSizes();
}, 60_000);

test.each(Object.keys(uses))("%s", (use) => {
  expect(sizes[use]).toBeLessThanOrEqual(uses[use].budget);
});

test("README.md has the table of these sizes, to 2 KB (npm run sizes -- --write)", () => {
  const readme = readFileSync(path.join(root, "README.md"), "utf8");
  const [said, measured] = [readme, readmeWith(sizes)].map((text) => [
    ...text.matchAll(/\| (\d+) KB \|$/gm),
  ]);
  expect(said.length).toBe(Object.keys(uses).length);
  const withoutNumbers = (text) => text.replaceAll(/\| \d+ KB \|$/gm, "");
  expect(withoutNumbers(readmeWith(sizes))).toBe(withoutNumbers(readme));
  for (const [k, [, kilobytes]] of measured.entries())
    expect(Math.abs(Number(said[k][1]) - Number(kilobytes))).toBeLessThanOrEqual(2);
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
