// The package as the site loads it: its WebAssembly is a file of its own, which the browser fetches
// while the page is read, and which pages and workers share.
import { load } from "apollonius-diagram/wasm";
import address from "apollonius-diagram/apollonius.wasm?url";

/** Resolves when diagrams can be made. */
export const whenLoaded = () => load(address);
