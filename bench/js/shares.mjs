// The shares that cells are to have, equal for every contender: uniform between 0.5 and 1.5, or
// heavy-tailed (lognormal, sigma 1.5: of 10 000 the largest is some 80 000 times the smallest).

const kSigma = 1.5;

/** @param {number} count @param {boolean} isTailed @returns {Float64Array} */
export function sharesOf(count, isTailed) {
  let state = 20_261_122;
  const random = () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
  const normal = () => Math.sqrt(-2 * Math.log(random())) * Math.cos(2 * Math.PI * random());
  return Float64Array.from({ length: count }, () =>
    isTailed ? Math.exp(kSigma * normal()) : 0.5 + random(),
  );
}

/** The largest deviation of an area from its share, relative to that. */
export function deviationOf(areas, shares) {
  const sum = (list) => list.reduce((a, b) => a + b, 0);
  const perShare = sum(areas) / sum(shares);
  return areas.reduce(
    (most, area, k) => Math.max(most, Math.abs(area / (perShare * shares[k]) - 1)),
    0,
  );
}
