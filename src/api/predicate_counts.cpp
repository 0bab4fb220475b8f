#include "apollonius/predicate_counts.h"

#include "predicate/stage_counts.h"

namespace apollonius {

namespace {

using Count = unsigned long long;

StageCounts byStage(Count filter, Count middle, Count exact) {
  return {static_cast<double>(filter), static_cast<double>(middle), static_cast<double>(exact)};
}

}  // namespace

PredicateCounts predicateCounts() noexcept {
  const internal::stages::Counts& c = internal::stages::counts();
  return {
      .covers = byStage(c.lorentzFilter, c.lorentzMiddle, c.lorentzExact),
      .distance = byStage(c.distanceAtOnce + c.distanceFilter, c.distanceMiddle + c.distanceFixed,
                          c.distanceExact),
      .bearing = byStage(c.rayCached + c.rayFilter, c.rayMiddle + c.rayFixed, c.rayExact),
      .vertexConflict = byStage(c.vertexAtOnce + c.vertexFilter,
                                c.vertexOfPoints + c.vertexTwofold + c.vertexMiddle + c.vertexFixed,
                                c.vertexExact),
      .edgeConflict = byStage(c.edgeAtOnce + c.edgeCached + c.edgeFilter,
                              c.edgeMiddle + c.edgeFixed, c.edgeExact),
      .ties = static_cast<double>(c.vertexDegenerate),
  };
}

}  // namespace apollonius
