// The state of the page in its address: the set, what was changed in it, the view, and what is
// shown. So a link shows the same, and neither a reload nor the way back loses anything. More edits
// than an address can hold are kept in the browser's history entry.
import type { App } from "../app.js";
import type { Label, Sites } from "../model/sites.js";
import type { Watch } from "./building.js";
import { type Row, sitesFromRows } from "./import.js";
import { loadSet, type Params } from "./presets.js";

/** The middle of the window, and its width, in units. */
export type Looked = [x: number, y: number, width: number];
export type State = {
  key: string;
  params: Params;
  edits: string;
  view: Looked | null;
  isCentres: boolean;
  shown: Record<string, boolean>;
};

const kMostEdits = 500;
const kMostKept = 20_000; // circles
const kDigits = 6; // of the view

const differs = (a: Float64Array, b: Float64Array, at: number) =>
  a[at] !== b[at] || a[at + 1] !== b[at + 1] || a[at + 2] !== b[at + 2];

/**
 * What was changed in the set that these circles were: removed "12-", changed "12:x,y,r", new
 * "x,y,r,name", with "~" between them.
 */
export function editsOf(sites: Sites) {
  const { original, xyr, ids } = sites;
  const count = original.length / 3;
  const edits: string[] = [];
  const numbers = (id: number) => xyr.subarray(3 * id, 3 * id + 3).join();
  let k = 0; // of the ids, which ascend
  for (let id = 0; id < count && edits.length <= kMostEdits; id++) {
    const isThere = ids[k] === id;
    if (isThere) k++;
    if (!isThere) edits.push(`${id}-`);
    else if (differs(xyr, original, 3 * id)) edits.push(`${id}:${numbers(id)}`);
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
      changed.push(Number(id));
      numbers.push(...rest.slice(1).split(",").map(Number));
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

/** The part of the address after "#". @param page `usual`: layers at first */
export function addressOf(
  { sites, view, painter }: App,
  { isCentres, usual }: { isCentres: boolean; usual: Record<string, boolean> },
) {
  const edits = editsOf(sites);
  const parts = [["set", sites.info.key]];
  for (const [name, value] of Object.entries(sites.info.params ?? {}))
    if (value !== false) parts.push([name, String(value === true ? 1 : value)]);
  if (edits) parts.push(["edits", edits]);
  const { x, y } = view.disc();
  parts.push(["view", [x, y, view.width / view.scale].map(short).join()]);
  if (isCentres) parts.push(["to", "centres"]);
  const switched = Object.entries(painter.layers)
    .filter(([name, isShown]) => usual[name] !== isShown)
    .map(([name, isShown]) => (isShown ? name : `-${name}`));
  if (switched.length > 0) parts.push(["show", switched.join()]);
  return { hash: `#${parts.map((part) => part.join("=")).join("&")}`, isWhole: edits !== null };
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
  const { set = "opening", edits = "", view, to, show = "", ...params } = all;
  return {
    key: set,
    params,
    edits,
    view: lookedOf(view),
    isCentres: to === "centres",
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
  if (kept?.rows) return sitesFromRows(kept.rows, kept.title);
  const sites =
    state.key === "data"
      ? sitesFromRows([], "Your data")
      : await loadSet(state.key, state.params, watch);
  if (state.edits) applyEdits(sites, state.edits);
  return sites;
}

/** What this page has put into a history entry. */
export type Kept = { rows: Row[]; title: string };

/** What a history entry keeps beside its address. */
export function keptOf(sites: Sites, isWhole: boolean): Kept | null {
  if (isWhole || sites.size > kMostKept) return null;
  const rows = Array.from(sites.ids, (id) => ({
    ...sites.site(id),
    name: sites.labels.get(id)?.name,
  }));
  return { rows, title: sites.info.title };
}
