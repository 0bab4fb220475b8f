// The sets to start from, each of which shows something.
import type { Triple } from "../model/circle.js";
import { emptySites, Sites } from "../model/sites.js";
import { build, type RandomOptions, type Watch } from "./building.js";
import { loadCities } from "./cities.js";
import { gasket } from "./gasket.js";
import { kOpening } from "./opening.js";
import { generator } from "../../shared/random_sets.js";

/** Parameters of a set, as the page's address has them. */
export type Params = Partial<Record<string, string>>;
/** `circles` makes them: x, y, r of each. */
export type Preset = { title: string; about: string; circles: () => Triple[] };

const kMostRandom = 1_000_000;

/** Rows and columns of equal circles. */
const lattice = (columns: number, rows: number, spacing: number, r: number) =>
  Array.from(
    { length: columns * rows },
    (_, k): Triple => [(k % columns) * spacing, Math.floor(k / columns) * spacing, r],
  );

/** Equal steps around a circle. */
const around = (count: number, distance: number, r: (k: number) => number) =>
  Array.from({ length: count }, (_, k): Triple => {
    const angle = (2 * Math.PI * k) / count;
    return [distance * Math.cos(angle), distance * Math.sin(angle), r(k)];
  });

/** Bubbles one by one, the largest first, each as near to the middle as there is room. */
function bubbles() {
  const random = generator(5);
  const sizes = Array.from({ length: 70 }, () => 6 + 60 * random() ** 3).sort((a, b) => b - a);
  const placed: Triple[] = [];
  for (const r of sizes) {
    for (let t = 0; ; t += 0.05) {
      const [x, y] = [9 * t * Math.cos(t * 2.4), 6 * t * Math.sin(t * 2.4)];
      if (placed.some(([px, py, pr]) => Math.hypot(px - x, py - y) < pr + r + 3)) continue;
      placed.push([x, y, r]);
      break;
    }
  }
  return placed;
}

/** Each circle touches the one before. */
function chain() {
  let last: Triple = [0, 0, 10];
  const circles = [last];
  for (let k = 1; k < 26; k++) {
    const [x, y, before] = last;
    const r = 10 + 34 * Math.sin(k * 0.62) ** 2;
    const angle = 0.5 * Math.sin(k * 0.45) + 0.24 * k - 1;
    const distance = before + r;
    last = [x + distance * Math.cos(angle), y + distance * Math.sin(angle), r];
    circles.push(last);
  }
  return circles;
}

function equalRadii() {
  const random = generator(3);
  return Array.from({ length: 40 }, (): Triple => [1000 * random(), 600 * random(), 14]);
}

export const kPresets: Record<string, Preset> = {
  opening: {
    title: "Large and small",
    about: "A large circle bends its neighbours’ cells; circles inside it have none.",
    circles: () => kOpening.map(([x, y, r]): Triple => [x, 600 - y, r]),
  },
  two: {
    title: "Two circles",
    about: "Where both are equally near is one branch of a hyperbola, around the smaller one.",
    circles: () => [
      [0, 0, 90],
      [260, 40, 30],
    ],
  },
  nesting: {
    title: "Nested circles",
    about: "A circle inside another is hidden: it is nowhere the nearest. Move the cover away.",
    circles: () => [
      [0, 0, 150],
      [30, 20, 70],
      [50, 30, 25],
      [-90, -60, 20],
      [330, 60, 40],
      [250, -150, 60],
      [-260, 120, 50],
      [60, 270, 30],
      [340, 220, 12],
    ],
  },
  equal: {
    title: "Equal radii",
    about: "Circles of one size have the plain Voronoi diagram of their centres.",
    circles: equalRadii,
  },
  grid: {
    title: "Grid",
    about: "Every vertex has four sites: degenerate everywhere, and exact all the same.",
    circles: () => lattice(12, 8, 80, 18),
  },
  cocircular: {
    title: "On one circle",
    about: "Sixteen circles touch one circle from outside: their cells meet in one point.",
    circles: () =>
      around(16, 240, () => 0).map(([x, y], k): Triple => {
        const r = 8 + 22 * (k % 3);
        const f = (240 + r) / 240;
        return [x * f, y * f, r];
      }),
  },
  chain: {
    title: "Tangent chain",
    about: "Each circle touches the next: the edge between them passes through the contact.",
    circles: chain,
  },
  gasket: {
    title: "Apollonian gasket",
    about: "Circles that touch three others each; the diagram’s vertices are the next ones.",
    circles: () => gasket(300, 4),
  },
  planet: {
    title: "Planet and ring",
    about: "Small circles around a large one: its cell has one edge for each of them.",
    circles: () => [[0, 0, 200], ...around(48, 262, (k) => 4 + 9 * (k % 4 === 0 ? 1 : 0.3))],
  },
  bubbles: {
    title: "Bubble chart",
    about:
      "What the pointer means: the smallest bubble under it, else the one with the nearest rim.",
    circles: bubbles,
  },
};

/** @param params from the page's address */
export function randomOptions({ n, hidden, seed, tall }: Params): RandomOptions {
  const whole = (text: string | undefined, least: number, most: number, usual: number) => {
    const value = Math.round(Number(text));
    return text && Number.isFinite(value) ? Math.max(least, Math.min(most, value)) : usual;
  };
  return {
    n: whole(n, 0, kMostRandom, 1000),
    hidden: whole(hidden, 0, 95, 5),
    seed: whole(seed, 0, 2 ** 31, 1),
    tall: tall === "1",
  };
}

const triplesOf = (circles: Triple[]) => Float64Array.from(circles.flat());

/** @param key of a preset, "cities", "random", "empty" */
export async function loadSet(key: string, params: Params = {}, watch: Watch = {}): Promise<Sites> {
  if (key === "cities") return loadCities();
  if (key === "random") {
    const options = randomOptions(params);
    const title = `${options.n.toLocaleString("en").replaceAll(",", "\u202f")} random circles`;
    const said = { n: options.n, hidden: options.hidden, seed: options.seed };
    const info = { key, title, params: options.tall ? { ...said, tall: 1 } : said };
    return build(options, info, watch);
  }
  if (!Object.hasOwn(kPresets, key)) return emptySites();
  const preset = kPresets[key];
  const circles = preset.circles();
  const isTall = params.tall === "1";
  const xyr = triplesOf(isTall ? circles.map(([x, y, r]): Triple => [y, x, r]) : circles);
  const info = { key, title: preset.title, about: preset.about, params: isTall ? { tall: 1 } : {} };
  return new Sites(xyr, info);
}
