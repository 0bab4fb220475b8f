// The edges of diagrams and of views, and where each is the narrowest.
import { checkedChoice, checkOptions } from "../core/arguments.js";
import type { Vertices } from "../core/types.js";
import type { EdgeOptions } from "./types.js";

/** Are the narrowest places wanted? */
export function isWithClearance(options: EdgeOptions | undefined): boolean {
  checkOptions(options, "clearance");
  return checkedChoice("options.clearance", options?.clearance, [false, true]);
}

/** The places of the module, without sites, of which they have none. */
export function narrowestOf({ xy, clearance }: Omit<Vertices, "sites">) {
  return { clearance, xy };
}
