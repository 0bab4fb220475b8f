/** `count` circles {x, y, r} in a window, the same ones each time. */
export function randomCircles(count, width, height, smallest, largest, seed = 7) {
  let state = seed;
  const random = () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
  return Array.from({ length: count }, () => ({
    x: random() * width,
    y: random() * height,
    r: smallest + (largest - smallest) * random() ** 3,
  }));
}
