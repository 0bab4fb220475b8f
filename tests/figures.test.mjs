// Documents quote the measured figures (docs/figures.json), and only figures that exist.
import { readFileSync } from "node:fs";
import path from "node:path";
import { kQuotingDocuments, quoted, readFigures, updateQuotations } from "../tools/figures.mjs";
import { root } from "../tools/toolchain/folders.mjs";

test("each quotation is what the file has: else `npm run figures`", () => {
  expect(updateQuotations({ write: false })).toEqual([]);
});

test.each(kQuotingDocuments)("%s quotes some, whole", (name) => {
  const text = readFileSync(path.join(root, name), "utf8");
  const count = (pattern) => text.match(pattern)?.length ?? 0;
  expect(count(/<!--figure:/g)).toBeGreaterThan(5);
  expect(count(/<!--figure:[\w.-]+-->[^<]*<!--end-->/g)).toBe(count(/<!--figure:/g));
});

test("each command's figures have a date and a commit", () => {
  for (const figures of Object.values(readFigures()))
    expect(figures).toMatchObject({
      date: expect.stringMatching(/^\d{4}-\d\d-\d\d$/),
      commit: expect.stringMatching(/^[0-9a-f]{7}/),
    });
});

test("numbers are written with three digits, whole ones in groups, texts as they are", () => {
  const figures = { a: { b: 1234567, c: 0.123456, d: "some text", e: 12.3456 } };
  const text = "b c d e".replace(/\w/g, (key) => `<!--figure:a.${key}-->old<!--end-->`);
  const shown = quoted(text, figures, "text").replace(/<!--.*?-->/g, "");
  expect(shown).toBe("1 234 567 0.123 some text 12.3");
  expect(() => quoted("<!--figure:a.x--><!--end-->", figures, "text")).toThrow("no a.x");
});
