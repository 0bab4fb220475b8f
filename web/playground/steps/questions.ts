// What the predicates were asked, and at which stage they knew the answer.
import { Diagram, type PredicateCounts, predicateCounts } from "apollonius-diagram";
import type { Circle, Sites } from "../model/sites.js";
import type { Step } from "./insertion.js";

/** Answers by filter, middle, exact stage. */
export type Row = { question: string; stages: number[] };
export type Questions = { rows: Row[]; ties: number };

const kQuestions = [
  ["covers", "Is one circle inside another?"],
  ["distance", "Which of two circles is nearer?"],
  ["bearing", "On which side of a vertex?"],
  ["vertexConflict", "Is this vertex lost?"],
  ["edgeConflict", "What of this edge is lost?"],
] as const;
const kStages = ["filter", "middle", "exact"] as const;

/** What has been asked since these counts were taken. */
function since(before: PredicateCounts) {
  const now = predicateCounts();
  const rows = kQuestions.map(([name, question]) => ({
    question,
    stages: kStages.map((stage) => now[name][stage] - before[name][stage]),
  }));
  return { rows, ties: now.ties - before.ties };
}

/** By the insertion of a circle, which is taken back. */
export function askedByInsertion(sites: Sites, circle: Circle): Questions {
  const before = predicateCounts();
  return sites.tryOut(circle, () => since(before));
}

/** By the deletion of a site, from a copy. */
export function askedByDeletion({ diagram }: Sites, id: number): Questions {
  const copy = Diagram.fromBytes(diagram.toBytes(), { trusted: true });
  try {
    const before = predicateCounts();
    copy.remove(id);
    return since(before);
  } finally {
    copy.dispose();
  }
}

/** As the last step of what is explained. */
export const stepOfQuestions = (asked: Questions, draw: Step["draw"]): Step => ({
  title: "The questions",
  text:
    "How often each was settled by the filter, in doubles with a bound on the error; by the " +
    `middle stage, which rounds nothing; or in integers of any length.${tiesIn(asked)}`,
  questions: asked,
  draw,
});

function tiesIn({ ties }: Questions) {
  if (ties === 0) return "";
  const which = ties === 1 ? "One circle touches" : `${ties} circles touch`;
  return ` ${which} the new one exactly: a rule that knows no order decides.`;
}
