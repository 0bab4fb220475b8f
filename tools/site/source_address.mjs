// Where the sources can be read on the web: the one place that says so is `repository` of
// package.json. Until it names an owner there is no such address, and links lead to files that are
// served, or are left out.
import { readFileSync } from "node:fs";
import path from "node:path";
import { root } from "../toolchain/folders.mjs";

const { repository } = JSON.parse(readFileSync(path.join(root, "package.json"), "utf8"));
const address = repository.url.replace(/^git\+/, "").replace(/\.git$/, "");

/** The repository's address, https://…/apollonius-diagram, or null. */
const sourceAddress = address.includes("/OWNER/") ? null : address;

/** The address of a file, by its path below the root, or null. */
export const sourceOf = (file) => (sourceAddress ? `${sourceAddress}/blob/main/${file}` : null);
