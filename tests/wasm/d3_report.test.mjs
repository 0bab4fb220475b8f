// Expectations of d3-delaunay's users, asked of both through the same names; where the two differ,
// docs/D3_DELAUNAY.md says so.
import { readFileSync } from "node:fs";
import path from "node:path";
import { Delaunay as Theirs } from "d3-delaunay";
import { root } from "../../tools/toolchain/folders.mjs";
import { Delaunay as Ours } from "./support/d3_adapter.mjs";
import { report } from "./support/d3_report.mjs";

const differing = report.filter(([, , why]) => why !== undefined);
const [doc] = readFileSync(path.join(root, "docs/D3_DELAUNAY.md"), "utf8").split("# From d3-geo");

test.each(report.filter(([, , why]) => why === undefined))("the same: %s", (_, ask) => {
  expect(ask(Ours)).toEqual(ask(Theirs));
});

test.each(differing)("differs, and is documented: %s", (what, ask, why) => {
  expect(ask(Ours)).not.toEqual(ask(Theirs));
  expect(doc).toContain(`| ${what} | ${why} |`);
});

test("the document has no other differences, and counts those that agree", () => {
  const rows = doc.slice(doc.indexOf("## As measured")).match(/^\| (?!asked|--).*\|$/gm);
  expect(rows.length).toBe(differing.length);
  expect(doc).toContain(`${report.length - differing.length} of ${report.length}`);
});
