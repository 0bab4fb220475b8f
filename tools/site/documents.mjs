// The documents of docs/ as pages of the site, below "Reference".
import path from "node:path";
import { root } from "../toolchain/folders.mjs";
import { referencePages } from "./reference.mjs";
import { sourceOf } from "./source_address.mjs";

const kDocuments = [
  ["LOADING.md", "loading", "Loading", "Entries, bundlers, runtimes, sizes."],
  [
    "D3_DELAUNAY.md",
    "d3-delaunay",
    "From d3-delaunay",
    "d3-delaunay and d3-geo-voronoi, name by name.",
  ],
  ["SNAPSHOTS.md", "snapshots", "Snapshots", "The format of toBytes() and fromBytes()."],
  [
    "SCALE.md",
    "many-machines",
    "Many machines",
    "More circles than one memory holds, tile by tile.",
  ],
  ["RELIABILITY.md", "reliability", "Reliability", "What is promised, and how it is tested."],
  ["PREDICATES.md", "predicates", "Predicates", "The mathematics, the filters and their bounds."],
  ["PROOFS.md", "proofs", "Proofs", "Why the algorithms are right, and what they take."],
  ["ARCHITECTURE.md", "architecture", "Architecture", "A map of the code, and its terms."],
];

const folderOf = (name) => `reference/${name}`;
const byFile = new Map(kDocuments.map(([file, name]) => [file, folderOf(name)]));

/** Addresses of files of the repository in documents that are in the npm package, too. */
const kOwn = /^https:\/\/github\.com\/[\w-]+\/apollonius-diagram\/blob\/main\//;

/**
 * A function for the links of a page that is `up` above the site's folder: another page, a file
 * served, the source, or null.
 */
const addressFrom = (up) => (target) => {
  const own = target.replace(kOwn, "../");
  if (/^[a-z]+:/.test(own)) return own;
  const [relative, anchor] = own.split("#");
  const file = path.posix.normalize(path.posix.join("docs", relative));
  const end = anchor ? `#${anchor}` : "";
  const page = byFile.get(path.posix.basename(file));
  if (file === "docs/API.md") return `${up}reference/api/${end}`;
  if (page && file.startsWith("docs/")) return `${up}${page}/${end}`;
  if (file === "README.md") return `${up}${end}`;
  if (file.startsWith("web/examples/") && path.posix.extname(file))
    return `${up}${file.slice("web/".length)}`;
  return sourceOf(file);
};

/**
 * Pages, as list.mjs has them, with the `file` that each is made of, or its `text` (reference.mjs).
 */
export function documents() {
  const [loading, ...others] = kDocuments.map(([file, name, title, about]) => ({
    key: name,
    folder: folderOf(name),
    title,
    about,
    group: "Reference",
    file: path.join(root, "docs", file),
    address: addressFrom("../../"),
  }));
  return [loading, ...referencePages(addressFrom), ...others];
}
