// How often each stage of the predicates has answered: for predicateCounts(), tests, and the
// benchmark.
#pragma once

namespace apollonius::internal::stages {

/// Since the last reset, in this thread. `Cached` is the filter that takes the cached circles,
/// `Fixed` the middle stage in integers of fixed width. `AtOnce` is what filters settle where it
/// arises, without a call of the predicate: in walks, by circleFilter, and by
/// isSurelyInConflictBetweenEnds.
struct Counts {
  unsigned long long lorentzFilter = 0;
  unsigned long long lorentzMiddle = 0;
  unsigned long long lorentzExact = 0;
  unsigned long long distanceAtOnce = 0;
  unsigned long long distanceFilter = 0;
  unsigned long long distanceMiddle = 0;
  unsigned long long distanceFixed = 0;
  unsigned long long distanceExact = 0;
  unsigned long long vertexAtOnce = 0;
  unsigned long long vertexOfPoints = 0;
  unsigned long long vertexTwofold = 0;
  unsigned long long vertexFilter = 0;
  unsigned long long vertexMiddle = 0;
  unsigned long long vertexFixed = 0;
  unsigned long long vertexExact = 0;
  unsigned long long vertexDegenerate = 0;
  unsigned long long edgeAtOnce = 0;
  unsigned long long edgeCached = 0;
  unsigned long long edgeFilter = 0;
  unsigned long long edgeMiddle = 0;
  unsigned long long edgeFixed = 0;
  unsigned long long edgeExact = 0;
  unsigned long long rayCached = 0;
  unsigned long long rayFilter = 0;
  unsigned long long rayMiddle = 0;
  unsigned long long rayFixed = 0;
  unsigned long long rayExact = 0;
};
[[nodiscard]] inline Counts& counts() {
  static constinit thread_local Counts counts;
  return counts;
}

}  // namespace apollonius::internal::stages
