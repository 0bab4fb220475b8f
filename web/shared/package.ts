// The package as the site loads it: its WebAssembly is files of their own, which the browser
// fetches while the page is read, and which pages and workers share.
import { load } from "apollonius-diagram/wasm";
import core from "apollonius-diagram/core.wasm?url";
import shapes from "apollonius-diagram/shapes.wasm?url";
import sphere from "apollonius-diagram/sphere.wasm?url";

const addresses = { core, shapes, sphere };
/** Parts of the package that are fetched only where they are needed. */
export type Part = "shapes" | "sphere";

/** Resolves when diagrams can be made, and what these parts can do. */
export async function whenLoaded(parts: readonly Part[]): Promise<void> {
  const wanted = ["core", ...parts] as const;
  await load(Object.fromEntries(wanted.map((part) => [part, addresses[part]])));
}
