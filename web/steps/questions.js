// What the predicates were asked, and at which stage they knew the answer.
import { Diagram, predicateCounts } from "apollonius-diagram";

/** @typedef {import("apollonius-diagram").PredicateCounts} PredicateCounts */
/** @typedef {{ question: string, stages: number[] }} Row answers by filter, middle, exact stage */
/** @typedef {{ rows: Row[], ties: number }} Questions */

const kQuestions = /** @type {const} */ ({
  covers: "Is one circle inside another?",
  distance: "Which of two circles is nearer?",
  bearing: "On which side of a vertex?",
  vertexConflict: "Is this vertex lost?",
  edgeConflict: "What of this edge is lost?",
});

/** What has been asked since these counts were taken. @param {PredicateCounts} before */
function since(before) {
  const now = predicateCounts();
  const rows = Object.entries(kQuestions).map(([name, question]) => ({
    question,
    stages: ["filter", "middle", "exact"].map((stage) => now[name][stage] - before[name][stage]),
  }));
  return { rows, ties: now.ties - before.ties };
}

/**
 * By the insertion of a circle, which is taken back.
 * @param {import("../model/sites.js").Sites} sites
 * @param {import("../model/sites.js").Circle} circle @returns {Questions}
 */
export function askedByInsertion(sites, circle) {
  const before = predicateCounts();
  return sites.tryOut(circle, () => since(before));
}

/**
 * By the deletion of a site, from a copy.
 * @param {import("../model/sites.js").Sites} sites @param {number} id @returns {Questions}
 */
export function askedByDeletion({ diagram }, id) {
  const copy = Diagram.fromBytes(diagram.toBytes(), { trusted: true });
  try {
    const before = predicateCounts();
    copy.remove(id);
    return since(before);
  } finally {
    copy.dispose();
  }
}

/** As the last step of what is explained. @param {Questions} asked */
export const stepOfQuestions = (asked, draw) => ({
  title: "The questions",
  text:
    "How often each was settled by the filter, in doubles with a bound on the error; by the " +
    `middle stage, which rounds nothing; or in integers of any length.${tiesIn(asked)}`,
  questions: asked,
  draw,
});

function tiesIn({ ties }) {
  if (ties === 0) return "";
  const which = ties === 1 ? "One circle touches" : `${ties} circles touch`;
  return ` ${which} the new one exactly: a rule that knows no order decides.`;
}
