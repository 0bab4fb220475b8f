// Packages of Debian and Ubuntu, through the machine's own apt: its mirrors, its keys, its
// signature checks.
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { capture, run, say, SetUpError, succeeds, which } from "./process.mjs";

const quiet = { DEBIAN_FRONTEND: "noninteractive" };

export function hasApt() {
  return which("apt-get") !== null && which("dpkg") !== null;
}

/** "bookworm", "trixie", "noble"…; "" where there is no such file. */
export function codename() {
  try {
    return /^VERSION_CODENAME=(.*)$/m.exec(readFileSync("/etc/os-release", "utf8"))?.[1] ?? "";
  } catch {
    return "";
  }
}

function isInstalled(name) {
  return succeeds("sh", [
    "-c",
    `dpkg-query -W -f '\${Status}' "$1" 2>/dev/null | grep -q 'ok installed'`,
    "sh",
    name,
  ]);
}

/** The command prefix that makes us root, or null if we cannot be. */
function rootPrefix() {
  if (process.getuid?.() === 0) return [];
  if (which("sudo") === null) return null;
  if (process.stdin.isTTY) return ["sudo"];
  return succeeds("sudo", ["-n", "true"]) ? ["sudo", "-n"] : null;
}

function asRoot(args) {
  const [program, ...rest] = [...rootPrefix(), "env", "DEBIAN_FRONTEND=noninteractive", ...args];
  run(program, rest);
}

let updated = false;

/** Brings apt's package lists up to date, once a run; quietly does nothing if we cannot be root. */
function updateLists() {
  if (updated || rootPrefix() === null) return;
  updated = true;
  say("apt-get update");
  asRoot(["apt-get", "-qq", "update"]);
}

/** The version that apt would install, or null. */
export function candidate(name) {
  const find = () => {
    const version = /^ +Candidate: (.*)$/m.exec(
      capture("apt-cache", ["policy", name], { env: { LC_ALL: "C" } }),
    )?.[1];
    return version === undefined || version === "(none)" ? null : version;
  };
  const version = find();
  if (version !== null || updated) return version;
  updateLists();
  return find();
}

/** Sees to it that packages are installed. `why` completes "needed for …". */
export function ensureInstalled(names, why) {
  const missing = hasApt() ? names.filter((name) => !isInstalled(name)) : names;
  if (missing.length === 0) return;
  const list = missing.join(" ");
  if (!hasApt())
    throw new SetUpError(
      `Needed for ${why}, under their Debian names: ${list}. Please install them and try again.`,
    );
  if (rootPrefix() === null) {
    throw new SetUpError(
      `Needed for ${why}: ${list}. Root access is required; please run as root:\n` +
        `  apt-get install --no-install-recommends ${list}`,
    );
  }
  for (const name of missing) candidate(name);
  say(`apt-get install ${list}   (for ${why})`);
  const install = [
    "apt-get",
    "-qq",
    "-o",
    "Dpkg::Use-Pty=0",
    "install",
    "-y",
    "--no-install-recommends",
    ...missing,
  ];
  try {
    asRoot(install);
  } catch (error) {
    if (updated) throw error;
    updateLists(); // the lists were there but out of date
    asRoot(install);
  }
}

/**
 * The newest package whose name matches, by the first number group in its name as version; null if
 * there is none.
 */
export function newestPackage(prefix, pattern) {
  const list = () =>
    capture("apt-cache", ["pkgnames", prefix])
      .split("\n")
      .filter((name) => pattern.test(name));
  let names = list();
  if (names.length === 0) {
    updateLists();
    names = list();
  }
  const number = (name) => Number(pattern.exec(name)[1]);
  return names.sort((a, b) => number(b) - number(a))[0] ?? null;
}

/**
 * Downloads packages and calls `use` with the folder of the .deb files. With `release`, they come
 * from that release of Debian, through a throw-away apt state: neither the machine's sources nor
 * its dpkg database change.
 */
export function withDownloaded(names, { release } = {}, use) {
  const work = mkdtempSync(path.join(tmpdir(), "apollonius-apt-"));
  try {
    const env = release ? { APT_CONFIG: throwAwayState(work, release) } : {};
    if (release) capture("apt-get", ["-qq", "update"], { env: { ...quiet, ...env } });
    const downloads = path.join(work, "downloads");
    mkdirSync(downloads);
    capture("apt-get", ["-qq", "-o", "APT::Sandbox::User=root", "download", ...names], {
      cwd: downloads,
      env,
    });
    const files = readdirSync(downloads);
    use((name) =>
      path.join(
        downloads,
        files.find((file) => file.startsWith(`${name}_`)),
      ),
    );
  } finally {
    rmSync(work, { recursive: true, force: true });
  }
}

function throwAwayState(work, release) {
  for (const folder of ["lists/partial", "cache/archives/partial", "sources"]) {
    mkdirSync(path.join(work, folder), { recursive: true });
  }
  writeFileSync(path.join(work, "status"), "");
  writeFileSync(
    path.join(work, "sources", `${release}.sources`),
    [
      "Types: deb",
      `URIs: ${debianMirror()}`,
      `Suites: ${release}`,
      "Components: main",
      `Architectures: ${capture("dpkg", ["--print-architecture"]).trim()}`,
      "Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg",
      "",
    ].join("\n"),
  );
  const config = path.join(work, "apt.conf");
  writeFileSync(
    config,
    [
      'Dir::Etc::SourceList "/dev/null"; Dir::Etc::Preferences "/dev/null";',
      'Dir::Etc::PreferencesParts "/dev/null";',
      `Dir::Etc::SourceParts "${work}/sources"; Dir::State::Lists "${work}/lists";`,
      `Dir::State::Status "${work}/status"; Dir::Cache "${work}/cache";`,
      'APT::Sandbox::User "root"; Acquire::Languages "none"; Acquire::Retries "3";',
      "",
    ].join("\n"),
  );
  return config;
}

/** The mirror of Debian's main archive that this machine is set up with. */
function debianMirror() {
  const find = () =>
    capture("apt-get", [
      "indextargets",
      "--format",
      "$(ORIGIN)|$(CODENAME)|$(COMPONENT)|$(REPO_URI)",
      "Created-By: Packages",
    ])
      .split("\n")
      .map((line) => line.split("|"))
      .find(
        ([origin, name, component]) =>
          origin === "Debian" && name === codename() && component === "main",
      )?.[3];
  let mirror = find();
  if (mirror === undefined) {
    updateLists(); // a fresh machine knows origins only once it has fetched the lists
    mirror = find();
  }
  if (mirror === undefined)
    throw new SetUpError(
      "apt knows no mirror of Debian: run `apt-get update` as root and try again.",
    );
  return mirror;
}
