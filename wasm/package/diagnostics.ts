// The entry `apollonius-diagram/diagnostics`: what tests, papers and benchmarks ask of diagrams. It
// brings no wasm, and works in the instance of the entries that made them.
import type { Diagram } from "./core/diagram.js";
import { innerOf, nativeOf } from "./core/inner.js";
import { runningModule } from "./core/native/module.js";
import type { SphericalDiagram } from "./sphere/spherical_diagram.js";

/** Answers of one question by the stage that gave them. */
export interface StageCounts {
  /** In doubles, with a bound on the error. */
  filter: number;
  /** In doubles that are exact, or in integers of fixed width. */
  middle: number;
  /** In integers of any length. */
  exact: number;
}

/** How often each stage of the predicates has answered. */
export interface PredicateCounts {
  /** Is one disc within another? */
  covers: StageCounts;
  /** Which of two sites is nearer to a point? */
  distance: StageCounts;
  /** On which side of a vertex is a point, seen from a site? */
  bearing: StageCounts;
  /** Does a new site take over a Voronoi vertex? */
  vertexConflict: StageCounts;
  /** And what of an edge, given its ends? */
  edgeConflict: StageCounts;
  /** Vertex conflicts that were exactly zero, which the canonical rule has settled. */
  ties: number;
}

/**
 * How often each stage of the predicates has answered, for all diagrams since the module was
 * started (this call starts it if nothing has). The difference of two calls is what was asked in
 * between. Cost: O(1). Throws "not-loaded" as the first diagram does, and where no entry that has
 * diagrams is loaded.
 */
export function predicateCounts(): PredicateCounts {
  return runningModule().predicateCounts();
}

/**
 * How many levels of the hierarchy hold each site, by id (paper, section 4): 1 for most, 2 or more
 * for about one in 32, and so on; 0 for hidden sites and for ids not in use. Of the plane only: the
 * paper's hierarchy is of that. O(n). Throws "bad-option" for what is no diagram of the plane.
 */
export function levels(diagram: Diagram): Uint8Array {
  return nativeOf(diagram).levels();
}

/**
 * null, or the first broken invariant of the diagram in words. For tests: O(n) with large
 * constants. Throws "bad-option" for what is no diagram.
 */
export function validate(diagram: Diagram | SphericalDiagram): string | null {
  const { what, where, level } = innerOf(diagram).native.validate();
  if (what === "") return null;
  return `${level === 0 ? "" : `level ${level}: `}${what} ${where}`;
}
