// The set that the page opens with: composed, so that one sees at once what circles do to cells.
// Sizes from 5 to 128, a large one that bends its neighbours' cells, two nested, one across
// another's rim.
import type { Triple } from "../model/circle.js";

export const kOpening: Triple[] = [
  [338, 318, 128], // the large one
  [296, 346, 34], // inside it: hidden
  [452, 236, 40], // across its rim
  [690, 392, 84],
  [724, 418, 26], // inside: hidden
  [876, 196, 62],
  [150, 168, 46],
  [128, 424, 30],
  [566, 146, 54],
  [560, 536, 48],
  [842, 528, 38],
  [318, 98, 24],
  [248, 536, 36],
  [430, 508, 18],
  [510, 358, 14],
  [540, 282, 9],
  [640, 254, 16],
  [718, 226, 7],
  [756, 118, 22],
  [672, 62, 10],
  [444, 62, 12],
  [232, 66, 8],
  [56, 90, 14],
  [58, 268, 18],
  [178, 296, 6],
  [60, 548, 12],
  [352, 572, 9],
  [676, 564, 10],
  [724, 510, 6],
  [948, 402, 26],
  [838, 330, 12],
  [962, 76, 16],
  [790, 264, 5],
  [946, 566, 8],
  [612, 470, 7],
];

/** The one that moves by itself at first: how far, in units, and how long, in milliseconds. */
export const kWanderer = { id: 3, reach: 26, time: 10_000 };
