// Circles on the map of the Earth: what is known of them there, and what files and addresses say,
// so that circles that were on the map are on it again.
import type { SetInfo, Sites } from "../model/sites.js";
import { type MapData, makeMap } from "../model/world_map.js";
import { fetchData } from "./data_files.js";
import { Globe } from "../model/globe.js";

/** x, y and r are kilometres of this projection (globe.ts). `credit`: who has to be named. */
export type OnEarth = { projection: "equal-earth"; credit?: "cities" };

/** Returns where a set is on the Earth; null if it is in the plane. */
export function onEarthOf({ globe, credit }: SetInfo): OnEarth | null {
  if (!globe) return null;
  return { projection: "equal-earth", ...(credit ? { credit } : {}) };
}

/** Reads where a set is on the Earth from a file's data; null if it does not say. */
export function onEarthIn(data: unknown): OnEarth | null {
  if (typeof data !== "object" || data === null) return null;
  const { projection, credit } = data as Partial<Record<keyof OnEarth, unknown>>;
  if (projection !== "equal-earth") return null;
  return { projection, ...(credit === "cities" ? { credit } : {}) };
}

/** Asks for what the map is made from. */
export const fetchMap = () => fetchData<MapData>("land.json");

/** Facts about circles on the map. */
export async function earthInfo() {
  return {
    areaUnit: "km²", // a map of equal areas; its distances are not those on the Earth
    map: makeMap(await fetchMap()),
    globe: new Globe(),
  };
}

/** Puts circles onto the map, if they were on it. */
export async function putOnEarth(sites: Sites, onEarth: OnEarth | null) {
  if (!onEarth) return sites;
  const { credit } = onEarth;
  Object.assign(sites.info, await earthInfo(), { credit, params: onEarth });
  return sites;
}
