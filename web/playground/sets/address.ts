// The state of the page in its address: the set, what was changed in it, the view, and what is
// shown. So a link shows the same, and neither a reload nor the way back loses anything. More edits
// than an address can hold are kept in the browser's history entry.
import type { App } from "../app.js";
import type { Label, Sites } from "../model/sites.js";
import type { Watch } from "./building.js";
import type { Circles } from "./columns.js";
import { type OnEarth, onEarthIn, onEarthOf, putOnEarth } from "./earth.js";
import { sitesFromRows } from "./import.js";
import { packed, unpacked } from "./packing.js";
import { loadSet, type Params } from "./presets.js";

/** The middle of the window, and its width, in units. */
export type Looked = [x: number, y: number, width: number];
export type State = {
  key: string;
  params: Params;
  edits: string;
  view: Looked | null;
  shown: Record<string, boolean>;
};

const kMostEdits = 2000;
const kLongPlain = 500; // characters of edits that are still written as they are
const kLongest = 8000; // characters of an address that every browser and most messages pass on
const kMostKept = 20_000; // circles
const kDigits = 6; // of the view

/**
 * Changes in the set that these circles were: removed "12-", moved "12:x,y", changed "12:x,y,r",
 * new "x,y,r,name", with "~" between them.
 */
export function editsOf(sites: Sites) {
  const { original, xyr, ids } = sites;
  const count = original.length / 3;
  const edits: string[] = [];
  const numbers = (id: number, count = 3) => xyr.subarray(3 * id, 3 * id + count).join();
  const differs = (id: number, k: number) => xyr[3 * id + k] !== original[3 * id + k];
  let k = 0; // of the ids, which ascend
  for (let id = 0; id < count && edits.length <= kMostEdits; id++) {
    const isThere = ids[k] === id;
    if (isThere) k++;
    if (!isThere) edits.push(`${id}-`);
    else if (differs(id, 2)) edits.push(`${id}:${numbers(id)}`);
    else if (differs(id, 0) || differs(id, 1)) edits.push(`${id}:${numbers(id, 2)}`);
  }
  for (; k < ids.length && edits.length <= kMostEdits; k++) {
    const name = sites.labels.get(ids[k])?.name;
    const said = name ? `,${encodeURIComponent(name).replaceAll("~", "%7E")}` : "";
    edits.push(numbers(ids[k]) + said);
  }
  return edits.length > kMostEdits ? null : edits.join("~");
}

/** Changes the circles as `editsOf` says. */
export function applyEdits(sites: Sites, edits: string) {
  const removed: number[] = [];
  const changed: number[] = [];
  const numbers: number[] = [];
  const added: number[] = [];
  const labels: (Label | undefined)[] = [];
  for (const edit of edits.split("~").filter(Boolean)) {
    const [, id, rest] = edit.match(/^(\d+)([-:].*)$/) ?? [];
    if (rest === "-") removed.push(Number(id));
    else if (rest) {
      const [x, y, r = sites.site(Number(id)).r] = rest.slice(1).split(",").map(Number);
      changed.push(Number(id));
      numbers.push(x, y, r);
    } else {
      const [x, y, r, name] = edit.split(",");
      added.push(Number(x), Number(y), Number(r));
      labels.push(name ? { name: decodeURIComponent(name) } : undefined);
    }
  }
  if (changed.length > 0) sites.update(changed, Float64Array.from(numbers));
  if (added.length > 0) {
    const ids = sites.insert(Float64Array.from(added));
    labels.forEach((label, k) => label && sites.labels.set(ids[k], label));
  }
  if (removed.length > 0) sites.remove(removed);
}

const short = (value: number) => String(Number(value.toPrecision(kDigits)));

/** An address, and whether it holds all changes; `length` is how long it would be then. */
export type Address = { hash: string; isWhole: boolean; length: number };

/** Short ones as they are, long ones packed. */
const partOf = (edits: string) =>
  edits.length > kLongPlain ? ["packed", packed(edits)] : ["edits", edits];

/** The part of the address after "#". @param usual layers at first */
export function addressOf({ sites, view, painter }: App, usual: Record<string, boolean>): Address {
  const edits = editsOf(sites);
  const parts = [["set", sites.info.key]];
  for (const [name, value] of Object.entries(sites.info.params ?? {}))
    if (value !== false) parts.push([name, String(value === true ? 1 : value)]);
  const { x, y } = view.disc();
  const rest = [["view", [x, y, view.width / view.scale].map(short).join()]];
  const switched = Object.entries(painter.layers)
    .filter(([name, isShown]) => usual[name] !== isShown)
    .map(([name, isShown]) => (isShown ? name : `-${name}`));
  if (switched.length > 0) rest.push(["show", switched.join()]);
  const joined = (all: string[][]) => `#${all.map((part) => part.join("=")).join("&")}`;
  const bare = joined([...parts, ...rest]);
  if (edits === null) return { hash: bare, isWhole: false, length: Infinity };
  if (edits === "") return { hash: bare, isWhole: true, length: bare.length };
  const hash = joined([...parts, partOf(edits), ...rest]);
  const isWhole = hash.length <= kLongest;
  return { hash: isWhole ? hash : bare, isWhole, length: hash.length };
}

export function stateOf(hash: string): State {
  const all: Partial<Record<string, string>> = Object.fromEntries(
    hash
      .replace(/^#/, "")
      .split("&")
      .filter(Boolean)
      .map((part) => {
        const at = part.indexOf("=");
        return at < 0 ? [part, ""] : [part.slice(0, at), part.slice(at + 1)];
      }),
  );
  const { set = "opening", edits = "", packed: letters, view, show = "", ...params } = all;
  return {
    key: set,
    params,
    edits: letters ? unpacked(letters) : edits,
    view: lookedOf(view),
    shown: Object.fromEntries(
      show
        .split(",")
        .filter(Boolean)
        .map((name) => [name.replace(/^-/, ""), !name.startsWith("-")]),
    ),
  };
}

function lookedOf(text = ""): Looked | null {
  const [x, y, width, ...rest] = text.split(",").map(Number);
  const isView = rest.length === 0 && [x, y, width].every(Number.isFinite) && width > 0;
  return isView ? [x, y, width] : null;
}

/** The circles of an address. @param kept in the history entry */
export async function sitesOf(state: State, kept: Kept | null, watch?: Watch) {
  if (kept?.rows) return putOnEarth(sitesFromRows(kept, kept.title), kept.onEarth ?? null);
  const sites =
    state.key === "data"
      ? await putOnEarth(sitesFromRows({ rows: [] }, "Your data"), onEarthIn(state.params))
      : await loadSet(state.key, state.params, watch);
  if (state.edits) applyEdits(sites, state.edits);
  return sites;
}

/** The state that this page has put into a history entry. */
export type Kept = Circles & { title: string; onEarth?: OnEarth | null };

/** Returns what a history entry keeps beside its address. */
export function keptOf(sites: Sites, isWhole: boolean): Kept | null {
  if (isWhole || sites.size > kMostKept) return null;
  const rows = Array.from(sites.ids, (id) => ({
    ...sites.site(id),
    ...sites.labels.get(id),
  }));
  const { title, about } = sites.info;
  return { rows, title, about, onEarth: onEarthOf(sites.info) };
}
