// Random sets have the promised number of hidden circles, and are the same for the same seed.
import { expect, test } from "@jest/globals";
import { randomCircles } from "../../build/web/shared/random_sets.js";

const options = { seed: 7, width: 1600, height: 1000 };

function hiddenCount(xyr) {
  const n = xyr.length / 3;
  let hidden = 0;
  for (let i = 0; i < n; i++) {
    for (let j = 0; j < n; j++) {
      const d = Math.hypot(xyr[3 * i] - xyr[3 * j], xyr[3 * i + 1] - xyr[3 * j + 1]);
      if (i !== j && d <= xyr[3 * j + 2] - xyr[3 * i + 2]) {
        hidden++;
        break;
      }
    }
  }
  return hidden;
}

test.each([
  [100, 0],
  [100, 0.1],
  [1000, 0],
  [1000, 0.5],
  [1000, 0.95],
  [1, 0.95],
  [0, 0.5],
])("%i circles, %f of them hidden", (count, hiddenShare) => {
  const xyr = randomCircles({ ...options, count, hiddenShare });
  expect(xyr.length).toBe(3 * count);
  expect(hiddenCount(xyr)).toBe(Math.min(Math.round(count * hiddenShare), Math.max(count - 1, 0)));
});

test("the same seed gives the same circles, another one others", () => {
  const a = randomCircles({ ...options, count: 50, hiddenShare: 0.2 });
  expect(randomCircles({ ...options, count: 50, hiddenShare: 0.2 })).toEqual(a);
  expect(randomCircles({ ...options, seed: 8, count: 50, hiddenShare: 0.2 })).not.toEqual(a);
});
