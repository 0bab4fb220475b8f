// npm run release -- --dry: can this commit be published? Runs all checks in order, and prints the
// steps that are left to a person. .github/workflows/publish.yml publishes, for a tag.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "./toolchain/folders.mjs";
import { capture, run, SetUpError } from "./toolchain/process.mjs";
import { main } from "./toolchain/setup.mjs";

const read = (name) => readFileSync(path.join(root, name), "utf8");
const git = (...args) => capture("git", args, { cwd: root }).trim();

/** The checks; each returns a fault, or nothing. */
const checks = {
  "the working tree is clean": () => git("status", "--porcelain"),
  "CHANGELOG.md, CITATION.cff and package.json name one version"() {
    const { version } = JSON.parse(read("package.json"));
    const others = {
      "CHANGELOG.md": /^## (\S+)/m.exec(read("CHANGELOG.md"))?.[1],
      "CITATION.cff": /^version: (\S+)/m.exec(read("CITATION.cff"))?.[1],
    };
    return Object.entries(others)
      .filter(([, other]) => other !== version)
      .map(([name, other]) => `${name} has ${other}, package.json ${version}`)
      .join("; ");
  },
  "all tests pass": () => run(process.execPath, ["tests/run.mjs"], { cwd: root }),
  "npm would publish it": () =>
    run("npm", ["publish", "--dry-run", "--ignore-scripts"], { cwd: root }),
};

/** Lists what no program can do here. */
function forAPerson() {
  const { version, homepage } = JSON.parse(read("package.json"));
  return [
    ...(homepage.includes("/OWNER/")
      ? ["Put the repository's owner in place of OWNER: package.json, docs/CONTRIBUTING.md."]
      : []),
    ...(read("CHANGELOG.md").includes(`## ${version} (unreleased)`)
      ? ["Put today in place of “unreleased” in CHANGELOG.md, and commit."]
      : []),
    "Trusted publishing is set up once, in the package's settings at the registry.",
    `Tag it, which starts the publication: git tag v${version} && git push --follow-tags`,
  ];
}

await main(() => {
  if (process.argv[2] !== "--dry")
    throw new SetUpError("only `npm run release -- --dry`: a pushed tag publishes");
  for (const [name, check] of Object.entries(checks)) {
    const wrong = check();
    if (wrong) throw new SetUpError(`Not so: ${name}.\n${wrong}`);
    console.log(`ok  ${name}`);
  }
  console.log(["What is left for a person:", ...forAPerson()].join("\n- "));
});
