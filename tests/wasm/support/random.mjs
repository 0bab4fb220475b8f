/** A seeded generator of numbers in [0, 1): a 32-bit xorshift, the same on every machine. */
export function generator(seed) {
  let state = seed >>> 0 || 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

/** `count` circles as x, y, r triples, centres in a square of side 2000 around the origin. */
export function randomCircles(count, seed, largestRadius = 40) {
  const random = generator(seed);
  return Float64Array.from({ length: 3 * count }, (_, k) =>
    k % 3 === 2 ? random() * largestRadius : random() * 2000 - 1000,
  );
}
