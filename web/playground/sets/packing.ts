// Long texts in an address: deflated, in the 64 characters that addresses hold as they are.
import { deflateSync, inflateSync, strFromU8, strToU8 } from "fflate";

export function packed(text: string) {
  const bytes = deflateSync(strToU8(text), { level: 9 });
  const letters = btoa(strFromU8(bytes, true));
  return letters.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

export function unpacked(letters: string) {
  const bytes = strToU8(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), true);
  return strFromU8(inflateSync(bytes));
}
