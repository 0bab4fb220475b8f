// Who may include whom: the layers of docs/ARCHITECTURE.md, checked on the #include and import
// lines themselves. Biome forbids circles of imports (noImportCycles).
import { readdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { switched } from "./mutants/switched.mjs";

const root = fileURLToPath(new URL("..", import.meta.url));

// as .gitignore says
const ignored = /^(node_modules|build.*|dist|\.git|\.cache)$|\.(tgz|tsbuildinfo)$/;

/** All files of the repository, as paths from its root. */
function filesIn(folder) {
  return readdirSync(path.join(root, folder), { withFileTypes: true })
    .filter((entry) => !ignored.test(entry.name))
    .flatMap((entry) =>
      entry.isDirectory() ? filesIn(`${folder}${entry.name}/`) : [folder + entry.name],
    );
}
const files = filesIn("");

const std = /^<[a-z_]+>$/;
/** The rules of the folders of src/geometry, each with the others that it may include. */
function geometry(folders) {
  return Object.entries(folders).map(([folder, others]) => ({
    of: new RegExp(`^src/geometry/${folder}/`),
    may: [
      std,
      /^"apollonius\/(path|reach|types)\.h"$/,
      /^"(base|number|predicate|topology|delaunay|diagram)\//,
      new RegExp(`^"geometry/(${others ? `${others}|` : ""}${folder})/`),
    ],
  }));
}

/** The rules of the folders of the playground, each with what else it may import. */
function playground(folders) {
  return Object.entries(folders).map(([folder, others]) => ({
    of: new RegExp(`^web/playground/${folder}/`),
    may: [/^\.\/\w+\.js$/, /^apollonius-diagram$/, /^\.\.\/\.\.\/shared\/\w+\.js$/, ...others],
  }));
}

/** The types that Embind writes. */
const ofModule = /^\.\.\/\.\.\/\.\.\/build\/wasm\/apollonius\.mjs$/;

const rules = [
  // Public headers, installed as they are: nothing but the standard library and each other.
  { of: /^src\/apollonius\//, may: [std, /^"apollonius\//] },
  { of: /^src\/base\//, may: [std, /^"base\//] },
  {
    of: /^src\/number\//,
    may: [std, /^<boost\/multiprecision\//, /^<emscripten\/console\.h>$/, /^"number\//],
  },
  { of: /^src\/predicate\//, may: [std, /^"(base|number|predicate)\//] },
  { of: /^src\/topology\//, may: [std, /^"(base|topology)\//] },
  {
    of: /^src\/delaunay\//,
    may: [std, /^"(base|topology|predicate|delaunay)\//, /^"number\/(sign|invariant)\.h"$/],
  },
  {
    of: /^src\/diagram\//,
    may: [
      std,
      /^"apollonius\/types\.h"$/,
      /^"(base|topology|predicate|delaunay|diagram)\//,
      /^"number\/(sign|invariant)\.h"$/,
    ],
  },
  {
    of: /^src\/sphere\//,
    may: [
      std,
      /^"apollonius\/(reach|types)\.h"$/,
      /^"(base|topology|predicate|delaunay|diagram|sphere)\//,
    ],
  },
  ...geometry({
    curve: "",
    window: "curve",
    cell: "curve|window",
    polygons: "curve|window|cell",
    draw: "curve|window",
    clipping: "curve|window|cell|draw",
    inscribed: "curve|window|cell|clipping",
    enclosing: "",
  }),
  {
    of: /^src\/api\//,
    may: [
      std,
      /^"apollonius\//,
      /^"(base|number|predicate|topology|delaunay|diagram|geometry|sphere|api)\//,
    ],
  },
  {
    of: /^wasm\/bindings\/\w+\.(cpp|h)$/,
    may: [std, /^<emscripten\//, /^"apollonius\//, /^"(arrays|adapters|parts)\.h"$/],
  },
  {
    of: /^bench\/.*\.(cpp|h)$/,
    may: [
      std,
      /^"apollonius\//,
      /^"(tests\/)?support\/generators/,
      /^<CGAL\//,
      /^"bench\//,
      /^"predicate\/stage_counts\.h"$/, // it counts which stage answers
      /^<malloc\.h>$/,
    ],
  }, // and how much memory is in use

  {
    of: /^wasm\/package\/core\/(native\/)?\w+\.ts$/,
    may: [
      /^\.{1,2}\/(native\/)?\w+\.js$/,
      /^\.\.\/\.\.\/errors\.js$/,
      /^(\.\.\/)+build\/wasm\/apollonius\.mjs$/,
    ],
  },
  {
    of: /^wasm\/package\/shapes\/\w+\.ts$/,
    may: [/^\.\/\w+\.js$/, /^\.\.\/(core\/(native\/)?\w+|errors)\.js$/, ofModule],
  },
  {
    of: /^wasm\/package\/sphere\/\w+\.ts$/,
    may: [
      /^\.\/\w+\.js$/,
      /^\.\.\/(core\/(native\/)?\w+|errors)\.js$/,
      /^\.\.\/shapes\/(by_id|circles|edges|geojson|interpolation|limits|types)\.js$/,
      /^\.\.\/\.\.\/\.\.\/build\/wasm\/apollonius\.mjs$/,
    ],
  },
  {
    of: /^wasm\/package\/treemap\/\w+\.ts$/,
    may: [/^\.\/\w+\.js$/, /^\.\.\/(core\/\w+|shapes\/\w+|errors)\.js$/],
  },
  // The entries.
  {
    of: /^wasm\/package\/(core|shapes|sphere)(_edge)?\.ts$/,
    may: [
      /^\.\/(core(_edge)?|errors)\.js$/,
      /^\.\/\w+\/(api|functions)\.js$/,
      /^\.\/core\/native\/(embedded|module)\.js$/,
      /^\.\.\/\.\.\/build\/wasm\/(core|shapes|sphere)\.wasm(\?module)?$/,
    ],
  },
  {
    of: /^wasm\/package\/wasm\.ts$/,
    may: [
      /^\.\/\w+\/(api|methods|enclose)\.js$/,
      /^\.\/core\/(arguments|native\/module)\.js$/,
      /^\.\/errors\.js$/,
    ],
  },
  {
    of: /^wasm\/package\/diagnostics\.ts$/,
    may: [/^\.\/core\/(diagram|inner|native\/module)\.js$/, /^\.\/sphere\/spherical_diagram\.js$/],
  },
  {
    of: /^wasm\/package\/\w+\.ts$/,
    may: [/^\.\/\w+\.js$/, /^\.\/\w+\/(api|methods|functions|enclose)\.js$/],
  },
  {
    of: /^web\/examples\/.*\.(jsx?|vue|svelte)$/,
    may: [
      /^\.\/random_circles\.js$/,
      /^apollonius-diagram(\/(sphere|treemap))?$/,
      /^d3-[a-z]+$/,
      /^@observablehq\/plot$/,
      /^(react|vue|leaflet|maplibre-gl)$/,
      /^(@deck\.gl\/(core|layers)|chart\.js(\/helpers)?|echarts\/[a-z]+)$/,
      /^(vega(-embed)?|plotly\.js-gl2d-dist-min)$/,
    ],
  },
  ...playground({
    model: [/^@preact\/signals-core$/, /^d3-geo$/],
    picture: [/^\.\.\/model\//, /^apollonius-diagram\/diagnostics$/],
    tools: [/^\.\.\/((app|pointer)\.js$|(model|picture)\/)/],
    sets: [/^\.\.\/(app\.js$|(model|picture)\/)/, /^(d3-dsv|fflate)$/],
    motion: [/^\.\.\/(app\.js$|(model|picture|sets)\/)/],
    ui: [/^\.\.\/((app|pointer)\.js$|(model|picture|tools|sets|motion)\/)/],
  }),
  {
    of: /^web\/playground\/(app|edits|pointer|camera)\.ts$/,
    may: [/^\.\/(edits|pointer|camera)\.js$/, /^\.\/(model|picture)\//, /^\.\.\/shared\/\w+\.js$/],
  },
  {
    of: /^web\/playground\/\w+\.ts$/,
    may: [
      /^\.\/(\w+\/)?\w+\.js$/,
      /^\.\.\/(shared\/\w+|figure\/pen)\.js$/,
      /^apollonius-diagram(\/diagnostics)?$/,
    ],
  },
  {
    of: /^web\/shared\/package\.ts$/,
    may: [/^apollonius-diagram\/(wasm|(core|shapes|sphere)\.wasm\?url)$/],
  },
  { of: /^web\/shared\/.*\.ts$/, may: [/^\.\/\w+\.js$/] },
  {
    of: /^web\/figure\/.*\.ts$/,
    may: [/^(\.|\.\.\/shared)\/\w+\.js$/, /^\.\.\/recipes\/cards\.js$/],
  },
  {
    of: /^web\/figures\/measure\/.*\.ts$/,
    may: [
      /^\.\.\/\.\.\/shared\/(package|random_sets)\.js$/,
      /^(apollonius-diagram|delaunator|flatbush)$/,
    ],
  },
  {
    of: /^web\/recipes\/.*\.ts$/,
    may: [
      /^\.(\/limited_time|\.\/shared\/(dom|errors))\.js$/,
      /\.css\?raw$/,
      /^acorn(-walk)?$/,
      /^\.\.\/\.\.\/package\.json$/,
    ],
  },
  {
    of: /^web\/figures\/.*\.ts$/,
    may: [
      /^\.\/(measure\/)?\w+\.js$/,
      /^\.\.\/figure\/(figure|pen)\.js$/,
      /^\.\.\/shared\/random_sets\.js$/,
      /^apollonius-diagram(\/(sphere|treemap|diagnostics))?$/,
      /^(d3-hierarchy|d3-geo|d3-delaunay|delaunator|flatbush)$/,
    ],
  },
  {
    of: /^web\/.*\.mjs$/,
    may: [
      /^node:/,
      /^\.\/[\w./]+$/,
      /^\.\.\/(files|formats\/(join|parquet_file))\.mjs$/,
      /^[a-z][\w-]*$/,
      /^stream-json\/(filters|streamers)\/[\w-]+\.js$/,
      /^flatgeobuf\/lib\/mjs\/[\w/-]+\.js$/, // its main file imports OpenLayers
    ],
  },
  {
    of: /^bench\/.*\.m?js$/,
    may: [
      /^node:/,
      /^\.\/[\w./]+$/,
      /^[a-z@][\w./-]*$/,
      /^\.\.\/tools\/(toolchain\/|(build|figures)\.mjs$)/,
      // The site's.
      /^\.\.\/\.\.\/tools\/(serve|build_site|site\/list|toolchain\/browser)\.mjs$/,
      /^\.\.\/tests\/wasm\/support\/install_packed\.mjs$/,
      /^\.\.\/web\/examples\/cluster\/this_machine\.mjs$/,
      /^\/web\/shared\/random_sets\.js$/, // in a page that is made
    ],
  },
];

const included = [/^\s*#\s*include\s*([<"][^>"]+[>"])/gm];
const importedFirst = [
  /^\s*(?:import|export)\b[^;"']*?\bfrom\s*["']([^"']+)["']/gm,
  /^\s*import\s*["']([^"']+)["']/gm,
];
const imported = [...importedFirst, /\bawait import\(\s*["']([^"']+)["']/g];

/** Returns what a file includes or imports, in the words of its own lines. */
function dependencies(file, patterns = /\.(cpp|h)$/.test(file) ? included : imported) {
  const text = readFileSync(path.join(root, file), "utf8");
  return patterns.flatMap((pattern) => [...text.matchAll(pattern)].map((match) => match[1]));
}

function sources(folder) {
  return files.filter((file) => file.startsWith(folder) && /\.(cpp|h|ts|js|mjs)$/.test(file));
}

test("every file of src/ belongs to a layer", () => {
  const homeless = sources("src/").filter((file) => !rules.some((rule) => rule.of.test(file)));
  expect(homeless).toEqual([]);
});

test.each(
  rules.map((rule) => [rule.of.source, rule]),
)("%s includes only what it may", (_, rule) => {
  const own = files.filter((file) => rules.find((candidate) => candidate.of.test(file)) === rule);
  const forbidden = own.flatMap((file) =>
    dependencies(file)
      .filter((name) => !rule.may.some((pattern) => pattern.test(name)))
      .map((name) => `${file}: ${name}`),
  );
  expect(forbidden).toEqual([]);
});

/** The classes that a .cpp file defines methods of. */
function classesOfMethods(file) {
  const text = readFileSync(path.join(root, file), "utf8");
  return [...text.matchAll(/^(?! )[\w:<>*& ,]*?\b([A-Z]\w+)::~?\w+\(/gm)].map(([, name]) => name);
}

test("the methods of a class are defined in the folder of its header", () => {
  const headers = sources("src/").filter((file) => file.endsWith(".h"));
  const folderOf = new Map();
  for (const file of headers) {
    const text = readFileSync(path.join(root, file), "utf8");
    for (const [, name] of text.matchAll(
      /^(?:class|struct) (?:APOLLONIUS_EXPORT )?(\w+)[^;]*? \{/gm,
    ))
      folderOf.set(name, [...(folderOf.get(name) ?? []), path.dirname(file)]);
  }
  expect(folderOf.get("DelaunayGraph")).toEqual(["src/delaunay"]);
  const strays = sources("src/")
    .filter((file) => file.endsWith(".cpp"))
    .flatMap((file) =>
      classesOfMethods(file)
        .filter((name) => folderOf.has(name) && !folderOf.get(name).includes(path.dirname(file)))
        // The public classes' implementation.
        .filter(
          (name) => !(file.startsWith("src/api/") && folderOf.get(name).includes("src/apollonius")),
        )
        .map((name) => `${file}: ${name}`),
    );
  expect(classesOfMethods("src/delaunay/snapshot.cpp")).toContain("DelaunayGraph");
  expect(strays).toEqual([]);
});

test("the patterns do read lines", () => {
  expect(dependencies("wasm/bindings/adapters.h")).toContain('"apollonius/diagram.h"');
  expect(dependencies("wasm/package/core/diagram.ts")).toContain("./native/module.js");
  expect(dependencies("tests/layers.test.mjs")).toContain("node:fs");
});

test("the package reaches the module through Embind only, not its memory or inner names", () => {
  const users = sources("wasm/")
    .filter((file) => file.endsWith(".ts"))
    .filter((file) =>
      /\bHEAP\w+|\.buffer\b.*memory|_malloc|\$\$|\.wasmExports/.test(
        readFileSync(path.join(root, file), "utf8"),
      ),
    );
  expect(users).toEqual([]);
});

test("only native/module.ts starts the module or imports more of it than types", () => {
  const importing = sources("wasm/")
    .filter((file) => file.endsWith(".ts"))
    .filter((file) =>
      /import (?!type )[^;]*build\/wasm\/apollonius\.mjs/.test(
        readFileSync(path.join(root, file), "utf8"),
      ),
    );
  expect(importing).toEqual(["wasm/package/core/native/module.ts"]);
});

test("commands start on a fresh clone: before their first line they import no package", () => {
  const { scripts } = JSON.parse(readFileSync(path.join(root, "package.json"), "utf8"));
  const ofNode = Object.values(scripts).map((script) => /^node (\S+)/.exec(script)?.[1]);
  const reached = new Set(ofNode.filter((file) => file !== undefined));
  const strangers = [];
  for (const file of reached) {
    for (const name of dependencies(file, importedFirst)) {
      if (name.startsWith(".")) reached.add(path.posix.join(path.posix.dirname(file), name));
      else if (!name.startsWith("node:")) strangers.push(`${file}: ${name}`);
    }
  }
  expect(reached.size).toBeGreaterThan(10);
  expect(strangers).toEqual([]);
});

test("lack of memory is caught by its type; `catch (...)` only sets right and throws on", () => {
  const swallowing = ["src/", "wasm/"]
    .flatMap(sources)
    .filter((file) => /\.(cpp|h)$/.test(file))
    .flatMap((file) =>
      readFileSync(path.join(root, file), "utf8")
        .split("catch (...)")
        .slice(1)
        .filter((rest) => !/^ \{(?:(?!\n {2,4}\}\n)[\s\S])*?\bthrow;/.test(rest))
        .map(() => file),
    );
  expect(swallowing).toEqual([]);
});

test("no line of a source file is longer than 100 columns", () => {
  const named = /\.(cpp|h|js|mjs|ts|cmake|yml|sh)$|(^|\/)(CMakeLists\.txt|\.clang-tidy|run)$/;
  const long = files
    .filter((file) => named.test(file))
    .flatMap((file) =>
      readFileSync(path.join(root, file), "utf8")
        .split("\n")
        .flatMap((line, k) => ([...line].length > 100 ? [`${file}:${k + 1}`] : [])),
    );
  expect(long).toEqual([]);
});

test("each mutant, and each line that no test comes by, has its place in the sources", () => {
  const read = (file) => readFileSync(path.join(root, file), "utf8");
  for (const [k, mutant] of JSON.parse(read("tests/mutants/mutants.json")).entries())
    expect(() => switched(read(mutant.file), [[mutant, k]])).not.toThrow();
  for (const { file, lines } of JSON.parse(read("tests/check/uncovered.json"))) {
    const there = new Set(
      read(file)
        .split("\n")
        .map((line) => line.trim()),
    );
    for (const line of lines) expect(there).toContain(line);
  }
});

test("documents name files and code that are there", () => {
  const read = (file) => readFileSync(path.join(root, file), "utf8");
  const isCode = /\.(cpp|h|ts|m?js|jsx|vue|svelte|cmake|yml|json|html|css|txt)$/;
  const code = files.filter((file) => isCode.test(file)).map(read);
  const known = `${files.join("\n")}\n${code.join("\n")}`;
  // Names of other libraries are in the examples.
  const names =
    /`((?:\w+::)?([A-Za-z_]\w+)(?:\(\))?|(?!dist\/)([\w./-]+\.(?:ts|mjs|cpp|h|json|cmake)))`/g;
  const missing = files
    .filter((file) => file.endsWith(".md") && file !== "docs/API.md") // that one is generated
    .flatMap((file) =>
      [...read(file).matchAll(names)]
        .filter(([, , name, place]) => !known.includes(name ?? place))
        .map(([, what]) => `${file}: ${what}`),
    );
  expect(missing).toEqual([]);
});

test("top-level entries are the documented ones", () => {
  const allowed = new Set([
    "src",
    "wasm",
    "web",
    "tests",
    "bench",
    "docs",
    "cmake",
    "tools",
    "CMakeLists.txt",
    "package.json",
    "package-lock.json",
    "README.md",
    "CHANGELOG.md",
    "SECURITY.md",
    "CITATION.cff",
    "LICENSE",
  ]);
  const others = [...new Set(files.map((file) => file.split("/")[0]))].filter(
    (name) => !allowed.has(name) && !name.startsWith("."),
  );
  expect(others).toEqual([]);
});

test("no file names a package registry's host, nor the lock file download addresses", () => {
  // In pieces, so that this file does not name them either.
  const hosts = [
    ["npmjs", "org"],
    ["npmjs", "com"],
    ["debian", "org"],
    ["ubuntu", "com"],
    ["nodesource", "com"],
    ["yarnpkg", "com"],
    ["pypi", "org"],
    ["crates", "io"],
  ].map((parts) => parts.join("."));
  const named = files.flatMap((file) => {
    const text = readFileSync(path.join(root, file), "latin1");
    return hosts.filter((host) => text.includes(host)).map((host) => `${file}: ${host}`);
  });
  expect(named).toEqual([]);
  expect(readFileSync(path.join(root, "package-lock.json"), "utf8")).not.toMatch(/"resolved"/);
});
