// Do the links that lead out of the project still lead somewhere? Those of README.md, docs/ and
// the pages of the site. A page that is gone is an error; what does not answer, or wants no
// programs, is only named.
import { readFileSync } from "node:fs";
import path from "node:path";
import { capture, SetUpError } from "../../tools/toolchain/process.mjs";
import { root } from "../../tools/toolchain/folders.mjs";

const kAtOnce = 8;
const kPatience = 15_000; // ms
const kGone = [404, 410];

/** The documents that link to each address. */
function linksOut() {
  const files = capture("git", ["ls-files", "*.md"], { cwd: root }).trim().split("\n");
  const links = new Map();
  for (const file of files) {
    const text = readFileSync(path.join(root, file), "utf8");
    for (const [, address] of text.matchAll(/\]\((https:\/\/[^)\s]+)\)/g)) {
      const own = address.replace(/#.*/, "");
      if (/github\.com\/(OWNER|[\w-]+\/apollonius-diagram)\b/.test(own)) continue; // not there yet
      links.set(own, [...(links.get(own) ?? []), file]);
    }
  }
  return links;
}

/** The status of an address; 0 if nothing answers. */
async function statusOf(address) {
  try {
    const signal = AbortSignal.timeout(kPatience);
    const { status } = await fetch(address, { signal, redirect: "follow" });
    return status;
  } catch {
    return 0;
  }
}

export async function checkLinks() {
  const links = [...linksOut()];
  const found = [];
  const worker = async () => {
    for (let next = links.shift(); next; next = links.shift())
      found.push({ address: next[0], files: next[1], status: await statusOf(next[0]) });
  };
  await Promise.all(Array.from({ length: kAtOnce }, worker));
  if (found.every(({ status }) => status === 0)) return "nothing answers: no network";
  const line = ({ address, files, status }) => `${status} ${address} (${files.join(", ")})`;
  const gone = found.filter(({ status }) => kGone.includes(status));
  if (gone.length > 0) throw new SetUpError(["Links lead nowhere:", ...gone.map(line)].join("\n"));
  const silent = found.filter(({ status }) => status === 0 || status >= 400);
  for (const one of silent) console.log(`does not say: ${line(one)}`);
  return `${found.length - silent.length} of ${found.length} links lead somewhere, none is gone`;
}
