// Snapshots with a right checksum, whatever else is wrong with them.

/** The checksum of docs/SNAPSHOTS.md, put where it belongs. */
export function signed(bytes) {
  const words = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const add = (sum, word) => {
    const product = BigInt.asUintN(64, (sum ^ word) * 0x9e3779b97f4a7c15n);
    return product ^ (product >> 29n);
  };
  const sums = [0n, 0n];
  for (let at = 0; at < bytes.length - 8; at += 8)
    sums[(at / 8) % 2] = add(sums[(at / 8) % 2], words.getBigUint64(at, true));
  words.setBigUint64(bytes.length - 8, add(...sums), true);
  return bytes;
}
