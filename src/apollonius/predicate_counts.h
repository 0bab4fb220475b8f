// How often each stage of the predicates has answered: what exactness costs, counted.
#pragma once

#include "apollonius/export.h"

namespace apollonius {

/// Answers of one question by stage (docs/PREDICATES.md); whole numbers.
struct StageCounts {
  double filter = 0;  ///< in doubles, with a bound on the error
  double middle = 0;  ///< in doubles that are exact, or in integers of fixed width
  double exact = 0;   ///< in integers of any length
};

struct PredicateCounts {
  StageCounts covers;          ///< is one disc within another?
  StageCounts distance;        ///< which of two sites is nearer to a point?
  StageCounts bearing;         ///< on which side of a vertex is a point, seen from a site?
  StageCounts vertexConflict;  ///< does a new site take over a Voronoi vertex?
  StageCounts edgeConflict;    ///< which part of an edge does it take over, given the edge's ends?
  double ties = 0;             ///< vertex conflicts that were exactly zero: the canonical rule
};

/// Returns the counts of all diagrams since this thread began. To count one call, subtract two
/// readings.
[[nodiscard]] APOLLONIUS_EXPORT PredicateCounts predicateCounts() noexcept;

}  // namespace apollonius
