#include "predicate/predicates.h"

#include "predicate/pole.h"
#include "predicate/shadow_check.h"
#include "predicate/stages.h"

namespace apollonius {

using stages::counts;

namespace {

bool coversCorner(const Site& q, Corner c) { return c != nullptr && covers(q, *c); }

/// The common part of vertex conflict and of the existence of a circle (q infinite).
bool circleIsBeaten(Corner i, Corner j, Corner k, Corner q) {
  rotateToPole(i, j, k);
  const MaybeSign filtered = stages::vertexFilter(*i, j, k, q);
  shadowCheck(filtered, [&] { return stages::vertexExact(*i, j, k, q); });
  ++(filtered.known ? counts().vertexFilter : counts().vertexExact);
  const Sign sign = filtered.known ? filtered.sign : stages::vertexExact(*i, j, k, q);
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  ++counts().vertexDegenerate;
  return stages::vertexDegenerate(*i, j, k, q);
}

/// `atK`, `atL`: cached circles of the edge's faces, or nullptr.
bool probeIsInRange(EdgeCorners e, const VoronoiCircle* atK, const VoronoiCircle* atL, const Site& q, stages::Probe probe) {
  if (isBetterPole(e.j, e.i)) {  // the same edge seen from its other side
    e = {e.j, e.i, e.l, e.k};
    std::swap(atK, atL);
  }
  const auto exact = [&] { return stages::edgeExact(*e.i, e.j, e.k, e.l, q, probe); };
  const auto decide = [&](MaybeSign filtered) {
    shadowCheck(filtered, exact, [](Sign s) { return s == Sign::kPositive ? Sign::kPositive : Sign::kNegative; });
    return filtered.known;
  };
  if (atK != nullptr) {
    const MaybeSign filtered = stages::edgeCircleFilter(*e.i, e.j, *atK, *atL, q, probe);
    if (decide(filtered)) return filtered.sign == Sign::kPositive;
  }
  const MaybeSign filtered = stages::edgeFilter(*e.i, e.j, e.k, e.l, q, probe);
  ++(filtered.known ? counts().edgeFilter : counts().edgeExact);
  if (decide(filtered)) return filtered.sign == Sign::kPositive;
  return exact() == Sign::kPositive;
}

}  // namespace

bool covers(const Site& a, const Site& b) {
  if (a.r <= b.r) return a.r == b.r && a.x == b.x && a.y == b.y;
  const MaybeSign filtered = stages::lorentzFilter(a, b);
  shadowCheck(filtered, [&] { return stages::lorentzExact(a, b); });
  if (filtered.known) return filtered.sign == Sign::kNegative;
  ++counts().lorentzExact;
  return stages::lorentzExact(a, b) != Sign::kPositive;
}

Sign compareDistance(double x, double y, const Site& a, const Site& b) {
  const MaybeSign filtered = stages::distanceFilter(x, y, a, b);
  shadowCheck(filtered, [&] { return stages::distanceExact(x, y, a, b); });
  if (filtered.known) return filtered.sign;
  ++counts().distanceExact;
  return stages::distanceExact(x, y, a, b);
}

bool isNearer(double x, double y, const Site& a, const Site& b) {
  const Sign sign = compareDistance(x, y, a, b);
  return sign == Sign::kPositive || (sign == Sign::kZero && precedes(a, b));
}

bool isVertexInConflict(Corner i, Corner j, Corner k, const Site& q) {
  if (coversCorner(q, i) || coversCorner(q, j) || coversCorner(q, k)) return true;
  return circleIsBeaten(i, j, k, &q);
}

bool isVertexInConflict(const VoronoiCircle& circle, Corner i, Corner j, Corner k, const Site& q) {
  const MaybeSign filtered = circleFilter(circle, q);
  shadowCheck(filtered, [&] { return isVertexInConflict(i, j, k, q) ? Sign::kPositive : Sign::kNegative; });
  if (filtered.known) return filtered.sign == Sign::kPositive;
  return isVertexInConflict(i, j, k, q);
}

bool hasVoronoiCircle(const Site& i, const Site& j, const Site& k) { return !circleIsBeaten(&i, &j, &k, nullptr); }

bool isVertexAtInfinity(const Site& i, const Site& j, const Site& k) {
  Corner a = &i, b = &j, c = &k;
  rotateToPole(a, b, c);
  const MaybeSign filtered = stages::vertexFilter(*a, b, c, nullptr);
  return (filtered.known ? filtered.sign : stages::vertexExact(*a, b, c, nullptr)) == Sign::kZero;
}

bool touchesBetween(const Site& i, const Site& j, const Site& k) {
  // √p is the distance of two points of contact, so the outer two have the largest.
  return stages::lorentzDifference(i, j, i, k) == Sign::kPositive && stages::lorentzDifference(i, j, j, k) == Sign::kPositive;
}

bool isInteriorInConflict(const EdgeCorners& edge, const Site& q) {
  return probeIsInRange(edge, nullptr, nullptr, q, stages::Probe::kMiddle);
}

bool isInteriorInConflict(const EdgeCorners& edge, const VoronoiCircle& atK, const VoronoiCircle& atL, const Site& q) {
  return probeIsInRange(edge, &atK, &atL, q, stages::Probe::kMiddle);
}

bool isEntireEdgeInConflict(const EdgeCorners& edge, const Site& q) {
  if (coversCorner(q, edge.i) || coversCorner(q, edge.j)) return true;
  return !probeIsInRange(edge, nullptr, nullptr, q, stages::Probe::kOpposite);
}

bool isEntireEdgeInConflict(const EdgeCorners& edge, const VoronoiCircle& atK, const VoronoiCircle& atL, const Site& q) {
  if (coversCorner(q, edge.i) || coversCorner(q, edge.j)) return true;
  return !probeIsInRange(edge, &atK, &atL, q, stages::Probe::kOpposite);
}

}  // namespace apollonius
