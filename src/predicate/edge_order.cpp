#include "predicate/edge_order.h"

#include <utility>

#include "predicate/direction.h"
#include "predicate/kernels.h"
#include "predicate/long_kernels.h"
#include "predicate/reference_site.h"
#include "predicate/shadow_check.h"
#include "predicate/vertex_conflict.h"

namespace apollonius::internal {

// --- The turn between shadows

namespace stages {

namespace {

/// Rows 0, 1, 2 are j, l, k.
constexpr auto kShadowTurnDecision = [](auto& kernel) {
  const auto j = kernel.row(0);
  return kernel.sign(EdgeForm(chordOf(j, kernel.row(1)), chordOf(j, kernel.row(2))).turn,
                     roundings::kEdge.turn);
};

}  // namespace

MaybeSign shadowTurnFilter(const Site& i, const Site& j, const Site& l, const Site& k) {
  return decide<FilterKernel>(i, {&j, &l, &k}, kShadowTurnDecision);
}

Sign shadowTurnExact(const Site& i, const Site& j, const Site& l, const Site& k) {
  // Needed so seldom that a stage of shorter numbers would only be more code.
  return decide<ExactKernel>(i, {&j, &l, &k}, kShadowTurnDecision).sign;
}

}  // namespace stages

Sign turnBetweenShadows(const Site& i, const Site& j, const Site& l, const Site& k) {
  const MaybeSign filtered = stages::shadowTurnFilter(i, j, l, k);
  shadowCheck(filtered, [&] { return stages::shadowTurnExact(i, j, l, k); });
  return filtered.known ? filtered.sign : stages::shadowTurnExact(i, j, l, k);
}

// --- The edge

namespace {

bool haveEqualWeights(const EdgeCorners& e) {
  return e.i->r == e.j->r && e.j->r == e.k->r && e.k->r == e.l->r;
}

/// The turn from the end at l to the end at k, both of them finite; known only if doubles tell them
/// apart. Negative: they come in the wrong order.
MaybeSign turnAlong(const EdgeCorners& e, const VoronoiCircle& atK, const VoronoiCircle& atL) {
  return turn(directionOf(atL, *e.i), directionOf(atK, *e.i));
}

/// REQUIRES: i is the larger site, and both are finite.
bool isBoundedDelaunayEdge(const EdgeCorners& e) {
  // Is a site's shadow cut off at the upper end of the bisector, the vertex (i, j, infinity), or at
  // the lower one?
  const auto reachesUpperEnd = [&](const Site& q) {
    return isVertexInConflict(e.i, e.j, nullptr, q);
  };
  const auto reachesLowerEnd = [&](const Site& q) {
    return isVertexInConflict(e.j, e.i, nullptr, q);
  };
  if (e.k == e.l) return e.k == nullptr || reachesUpperEnd(*e.k);
  if (e.l != nullptr && isVertexInConflict(e.i, e.j, e.k, *e.l)) return false;
  if (e.k != nullptr && isVertexInConflict(e.j, e.i, e.l, *e.k)) return false;
  // With equal weights a shadow is half a turn, which no arc cuts off at both ends.
  if (e.k == nullptr || e.l == nullptr || haveEqualWeights(e)) return true;
  if (reachesUpperEnd(*e.k) || reachesLowerEnd(*e.l)) return true;
  return turnBetweenShadows(*e.i, *e.j, *e.l, *e.k) == Sign::kPositive;
}

/// REQUIRES: j is infinity.
bool isDelaunayEdgeAtInfinity(const EdgeCorners& e) {
  return e.k == e.l || !isVertexInConflict(e.i, nullptr, e.k, *e.l);
}

}  // namespace

bool isDelaunayEdge(EdgeCorners e, const VoronoiCircle& circleAtK, const VoronoiCircle& circleAtL) {
  const VoronoiCircle *atK = &circleAtK, *atL = &circleAtL;
  if (isBetterReference(e.j, e.i)) {  // the edge from its other side
    e = {e.j, e.i, e.l, e.k};
    std::swap(atK, atL);
  }
  if (e.j == nullptr) {
    // An edge of positive length is in order if the hull turns once, which the caller checks.
    return (e.k != e.l && turnAlong(e, *atK, *atL).known) || isDelaunayEdgeAtInfinity(e);
  }
  if (e.k != nullptr && e.l != nullptr && e.k != e.l) {
    const MaybeSign order = turnAlong(e, *atK, *atL);
    if (order.known) {
      // (If the order is right, isBoundedDelaunayEdge() may still find a conflict that does not
      // belong to a Delaunay graph.)
      const bool isRight = order.sign == Sign::kPositive;
      if (!isRight)
        shadowCheck(order,
                    [&] { return isBoundedDelaunayEdge(e) ? Sign::kPositive : Sign::kNegative; });
      return isRight;
    }
  }
  return isBoundedDelaunayEdge(e);
}

}  // namespace apollonius::internal
