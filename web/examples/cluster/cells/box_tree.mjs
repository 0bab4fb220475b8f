// The tree of boxes in a FlatGeobuf file, written while boxes come: of each level only what is not
// in the file yet is in memory. The format is that of a packed R-tree: the root first, the boxes
// of the features last; 16 neighbours of a level have one box around them in the level above.

export const kTogether = 16;
const kNode = 40; // bytes: xmin, ymin, xmax, ymax, and where its feature or its first child is

export class BoxTree {
  #levels; // from the features' boxes up to the root

  constructor(count) {
    const sizes = count > 0 ? [count] : [];
    while (sizes.length === 1 || sizes.at(-1) > 1) sizes.push(Math.ceil(sizes.at(-1) / kTogether));
    let first = sizes.reduce((sum, size) => sum + size, 0);
    this.bytes = kNode * first;
    this.#levels = sizes.map((size) => {
      first -= size;
      return { first, size, count: 0, nodes: [], around: undefined };
    });
  }

  /** The next feature's box, and at which byte of the features it begins. */
  add(box, place) {
    this.#add(0, box, place);
  }

  #add(height, box, place) {
    const level = this.#levels[height];
    const [xmin, ymin, xmax, ymax] = box;
    level.nodes.push(xmin, ymin, xmax, ymax, place);
    const begins = level.count++ % kTogether === 0;
    const around = begins ? box : level.around;
    level.around = [
      Math.min(xmin, around[0]),
      Math.min(ymin, around[1]),
      Math.max(xmax, around[2]),
      Math.max(ymax, around[3]),
    ];
    const isFull = level.count % kTogether === 0 || level.count === level.size;
    if (!isFull || height + 1 === this.#levels.length) return;
    const together = (level.count - 1) % kTogether; // before this one
    this.#add(height + 1, level.around, level.first + level.count - 1 - together);
  }

  /** Writes what is new since the last time into a file in which the tree begins at `start`. */
  async flush(output, start) {
    for (const level of this.#levels) {
      const added = level.nodes.length / 5;
      const bytes = Buffer.alloc(kNode * added);
      for (let k = 0; k < added; ++k) {
        for (let side = 0; side < 4; ++side)
          bytes.writeDoubleLE(level.nodes[5 * k + side], kNode * k + 8 * side);
        bytes.writeBigUInt64LE(BigInt(level.nodes[5 * k + 4]), kNode * k + 32);
      }
      const before = level.first + level.count - added;
      await output.writeAll(bytes, start + kNode * before);
      level.nodes = [];
    }
  }
}
