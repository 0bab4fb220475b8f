// Wasm that a bundle carries as text (asString in tools/build.mjs).

/** Its bytes. */
export function bytesOf(text: string, swaps: readonly number[]): Uint8Array<ArrayBuffer> {
  const byteOf = Uint8Array.from({ length: 256 }, (_, code) => code);
  for (let k = 0; k < swaps.length; k += 2) {
    const a = swaps[k] as number,
      b = swaps[k + 1] as number;
    byteOf[a] = b;
    byteOf[b] = a;
  }
  const decoded = new Uint8Array(text.length);
  for (let k = 0; k < decoded.length; ++k) decoded[k] = byteOf[text.charCodeAt(k)] as number;
  return decoded;
}
