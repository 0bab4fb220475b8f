// `npm test -- changed` runs the tests nearest to what has changed since HEAD, so that a change is
// tried in a minute. `npm test` says whether it is right.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../tools/toolchain/folders.mjs";
import { capture } from "../tools/toolchain/process.mjs";

/** Files that differ from HEAD, and untracked ones. */
export function changedFiles() {
  const lines = (args) => capture("git", args, { cwd: root }).split("\n").filter(Boolean);
  return [
    ...lines(["diff", "--name-only", "HEAD"]),
    ...lines(["ls-files", "--others", "--exclude-standard"]),
  ];
}

const programFolders = readdirSync(path.join(root, "tests"), { withFileTypes: true })
  .filter((entry) => entry.isDirectory())
  .map(({ name }) => name)
  .filter((name) => testFilesIn(name).length > 0);

function testFilesIn(folder) {
  return readdirSync(path.join(root, "tests", folder)).filter((name) => /_test\.cpp$/.test(name));
}

/** GoogleTest's filter for the tests of a file, whatever instantiates them. */
function filterOf(file) {
  const text = readFileSync(path.join(root, file), "utf8");
  const suites = [...text.matchAll(/^TEST(?:_F|_P)?\(\s*(\w+)/gm)].map(([, suite]) => suite);
  return [...new Set(suites)].flatMap((suite) => [`${suite}.*`, `*/${suite}.*`]).join(":");
}

const kAll = "*";

/** The folder of tests that a file of src/api or of src/apollonius belongs to. */
const folderOfApi = (file) => {
  if (/\/(sphere|spherical_\w+\.h)/.test(file)) return "sphere";
  return /\/(shapes\/|voronoi\.h|region\.h|area_fit\.h|path\.h|bounds\.h)/.test(file)
    ? "geometry"
    : "diagram";
};

/** The native programs to run, each with a filter: of a changed test, or of a changed source. */
export function nativePlan(files) {
  const filters = new Map(); // by program
  const add = (folder, filter) => {
    if (programFolders.includes(folder))
      filters.set(folder, [...(filters.get(folder) ?? []), filter]);
  };
  for (const file of files) {
    if (!existsSync(path.join(root, file)) || !/\.(cpp|h)$/.test(file)) continue;
    const [top, folder] = file.split("/");
    const stem = path.basename(file).replace(/\.(cpp|h)$/, "");
    if (top === "src") {
      const own = /^(api|apollonius)$/.test(folder) ? folderOfApi(file) : folder;
      const named = programFolders.includes(own) ? testFilesIn(own) : [];
      const about = named.filter((name) => name.startsWith(stem));
      if (about.length === 0) add(own, kAll);
      for (const name of about) add(own, filterOf(`tests/${own}/${name}`));
    } else if (top === "tests" && folder === "support" && !file.endsWith("_test.cpp")) {
      for (const each of programFolders) add(each, kAll);
    } else if (top === "tests") {
      add(folder, file.endsWith("_test.cpp") ? filterOf(file) : kAll);
    }
  }
  return new Map(
    [...filters].map(([folder, list]) => [`${folder}_tests`, [...new Set(list)].join(":")]),
  );
}

/** Files of tests/web that are about a folder of web/ or web/playground/ ("": of files in it). */
export const kTestsOfPage = {
  "": ["page", "data"],
  data: ["data", "windows"],
  examples: ["examples", "globe"],
  figure: ["site"],
  figures: ["site", "answers"],
  pages: ["site"],
  recipes: ["recipe_cards"],
  model: ["page", "undo"],
  motion: ["motion", "panels"],
  picture: ["picture", "view", "windows"],
  sets: ["data", "files", "loading"],
  shared: ["site", "page", "random_sets"],
  tools: ["drags", "keys", "motion", "page", "tools"],
  ui: ["keys", "looks", "panels", "windows"],
};

/** Test files of the page to run, as patterns; empty: none. */
export function pagePlan(files) {
  const names = files.flatMap((file) => {
    if (/^tests\/web\/support\//.test(file)) return [""];
    const test = /^tests\/web\/(\w+\.test\.mjs)$/.exec(file)?.[1];
    if (test) return [test];
    const [, folder = ""] = /^web\/(?:playground\/)?(?:(\w+)\/)?/.exec(file) ?? [];
    const isOfPage = file.startsWith("web/") && !file.startsWith("web/examples/cluster/");
    return isOfPage ? (kTestsOfPage[folder] ?? [""]).map((name) => `${name}.test.mjs`) : [];
  });
  return [...new Set(names)].map((name) => `tests/web/${name}`);
}

// They start browsers, bundlers, compilers or many processes.
const kSlowOfPackage = [
  "attacks",
  "browsers",
  "determinism",
  "entries",
  "every_call",
  "lifetime",
  "out_of_memory",
  "snapshots",
  "tarball",
  "traps",
];

/** Files that documents are made of or tried by, with the names of the tests. */
const kTestsOfDocuments = [
  [/^README\.md$/, "readme"],
  [/^(docs\/examples\/|tools\/(examples|api_reference)\.mjs$)/, "(examples|reference)"],
];

/** Arguments of Jest for the package's tests; null: none. */
export function packagePlan(files) {
  if (files.some((file) => /^wasm\//.test(file)))
    return ["--testPathIgnorePatterns", ...kSlowOfPackage.map((name) => `/wasm/${name}\\.test`)];
  const ofDocuments = kTestsOfDocuments
    .filter(([pattern]) => files.some((file) => pattern.test(file)))
    .map(([, name]) => `/wasm/${name}\\.test`);
  if (ofDocuments.length > 0) return ["--testPathPatterns", ...ofDocuments];
  const isOne = (file) => /^tests\/((wasm|support)\/.*|[^/]*)\.mjs$/.test(file);
  return files.some(isOne) ? ["--onlyChanged"] : null;
}

/** Are the tests of the cluster example to run? */
export const clusterPlan = (files) =>
  files.some((file) => /^(web\/examples|tests)\/cluster\//.test(file));
