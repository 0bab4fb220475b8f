#include "predicate/edge_conflict.h"

#include <algorithm>
#include <utility>

#include "number/root_sign.h"
#include "predicate/covers.h"
#include "predicate/direction.h"
#include "predicate/kernels.h"
#include "predicate/long_kernels.h"
#include "predicate/question.h"
#include "predicate/reference_site.h"
#include "predicate/span.h"

namespace apollonius::internal {

namespace stages {

// --- From the cached circles: turns between directions in doubles, some forty flops instead of
// polynomials of degree 12

namespace {

constexpr double u1 = kUnitRoundoff;

/// Middle of q's shadow on the bisector of the reference site and j (chordOf), or its opposite. It
/// passes 8 roundings (formulas.h): the error of each component is at most 9u (l_q m_j + l_j m_q),
/// with l the largest difference and m = x² + y² + r².
Arrow shadowMiddle(const Site& reference, Corner j, const Site& q, Probe probe) {
  const double sign = probe == Probe::kMiddle ? 1 : -1;
  const double qx = q.x - reference.x, qy = q.y - reference.y, qr = q.r - reference.r;
  const double lq = std::max({absolute(qx), absolute(qy), absolute(qr)});
  if (j == nullptr) return {sign * qx, sign * qy, u1 * lq};
  const double jx = j->x - reference.x, jy = j->y - reference.y, jr = j->r - reference.r;
  const double lj = std::max({absolute(jx), absolute(jy), absolute(jr)});
  const double pq = lorentz(qx, qy, qr), pj = lorentz(jx, jy, jr);
  const double mq = qx * qx + qy * qy + qr * qr, mj = jx * jx + jy * jy + jr * jr;
  return {sign * (qx * pj - jx * pq), sign * (qy * pj - jy * pq), 9 * u1 * (lq * mj + lj * mq)};
}

}  // namespace

MaybeSign edgeCircleFilter(const Site& i, Corner j, const VoronoiCircle& atK,
                           const VoronoiCircle& atL, const Site& q, Probe probe) {
  const Arrow middle = shadowMiddle(i, j, q, probe);
  const Arrow towardsK = directionOf(atK, i), towardsL = directionOf(atL, i);
  const MaybeSign beforeK = turn(middle, towardsK), afterL = turn(towardsL, middle);
  constexpr MaybeSign kInside{Sign::kPositive, true}, kOutside{Sign::kNegative, true}, kUnknown{};
  if (j != nullptr) {
    // A bounded edge's range of directions, seen from the larger site, is at most half a turn.
    if ((beforeK.known && beforeK.sign == Sign::kNegative) ||
        (afterL.known && afterL.sign == Sign::kNegative))
      return kOutside;
    return beforeK.known && afterL.known ? kInside : kUnknown;
  }
  if (!beforeK.known || !afterL.known) return kUnknown;
  if (beforeK.sign == afterL.sign) return beforeK.sign == Sign::kPositive ? kInside : kOutside;
  const MaybeSign span = turn(towardsL, towardsK);
  return {-span.sign, span.known};
}

// --- The other stages

namespace {

/// sign(±end.w · turn - √D · along): which side of an end of the edge the probe is on. `side` is +
/// for the end at k, - at l.
template <class Kernel, class T>
Sign edgeEndSign(Kernel& kernel, const Chord<T>& end, const Chord<T>& shadow, Sign side) {
  using roundings::kChord;
  using roundings::kEdge;
  const EdgeForm<T> form(end, shadow);
  const Sign first = side * kernel.sign(end.w, kChord.w) * kernel.sign(form.turn, kEdge.turn);
  const Sign second = -kernel.sign(form.along, kEdge.along);
  return signOfSum(first, second, [&] {
    return kernel.sign(EdgeForm<T>::squares(end, shadow, form.along),
                       EdgeForm<Roundings>::squares(kChord, kChord, kEdge.along));
  });
}

/// Rows 0 … 3 are j, k, l, q.
template <class Kernel>
Sign edgeSign(Kernel& kernel, Probe probe) {
  using T = typename Kernel::Number;
  const Row<T> j = kernel.row(0);
  Chord<T> shadow = chordOf(j, kernel.row(3));
  if (probe == Probe::kOpposite) shadow = {T(0) - shadow.u, T(0) - shadow.v, shadow.w};
  const Sign beforeK = edgeEndSign(kernel, chordOf(j, kernel.row(1)), shadow, Sign::kPositive);
  const Sign afterL = edgeEndSign(kernel, chordOf(j, kernel.row(2)), shadow, Sign::kNegative);
  if (beforeK == Sign::kPositive && afterL == Sign::kPositive) return Sign::kPositive;
  // A range of at most half a turn (all bounded edges, seen from the larger site) asks for both, a
  // larger one for either.
  if (!j.isInfinite || (beforeK != Sign::kPositive && afterL != Sign::kPositive))
    return Sign::kNegative;
  return -spanSign(kernel, kernel.row(2), kernel.row(1));
}

template <class Kernel>
MaybeSign edgeSign(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  return decide<Kernel>(i, {j, k, l, &q},
                        [probe](auto& kernel) { return edgeSign(kernel, probe); });
}

}  // namespace

MaybeSign edgeFilter(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  return edgeSign<FilterKernel>(i, j, k, l, q, probe);
}

MaybeSign edgeMiddle(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  return edgeSign<UnitKernel>(i, j, k, l, q, probe);
}

MaybeSign edgeFixed(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  return edgeSign<FixedKernel>(i, j, k, l, q, probe);
}

Sign edgeExact(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  return edgeSign<ExactKernel>(i, j, k, l, q, probe).sign;
}

}  // namespace stages

// --- The questions

namespace {

/// `atK`, `atL`: cached circles of the edge's faces, or nullptr.
bool probeIsInRange(EdgeCorners e, const VoronoiCircle* atK, const VoronoiCircle* atL,
                    const Site& q, stages::Probe probe) {
  using stages::counts;
  if (isBetterReference(e.j, e.i)) {  // the edge from its other side
    e = {e.j, e.i, e.l, e.k};
    std::swap(atK, atL);
  }
  Question question([&] { return stages::edgeExact(*e.i, e.j, e.k, e.l, q, probe); },
                    counts().edgeExact, PositiveOrNot{});
  if ((atK != nullptr &&
       question.isSettledBy(stages::edgeCircleFilter(*e.i, e.j, *atK, *atL, q, probe),
                            counts().edgeCached)) ||
      question.isSettledBy(stages::edgeFilter(*e.i, e.j, e.k, e.l, q, probe),
                           counts().edgeFilter) ||
      question.isSettledBy(stages::edgeMiddle(*e.i, e.j, e.k, e.l, q, probe),
                           counts().edgeMiddle) ||
      question.isSettledBy(stages::edgeFixed(*e.i, e.j, e.k, e.l, q, probe), counts().edgeFixed))
    return question.settled() == Sign::kPositive;
  return question.exact() == Sign::kPositive;
}

}  // namespace

bool isInteriorInConflict(const EdgeCorners& edge, const Site& q) {
  return probeIsInRange(edge, nullptr, nullptr, q, stages::Probe::kMiddle);
}

bool isInteriorInConflict(const EdgeCorners& edge, const VoronoiCircle& atK,
                          const VoronoiCircle& atL, const Site& q) {
  return probeIsInRange(edge, &atK, &atL, q, stages::Probe::kMiddle);
}

bool isEntireEdgeInConflict(const EdgeCorners& edge, const Site& q) {
  if (coversCorner(q, edge.i) || coversCorner(q, edge.j)) return true;
  return !probeIsInRange(edge, nullptr, nullptr, q, stages::Probe::kOpposite);
}

bool isEntireEdgeInConflict(const EdgeCorners& edge, const VoronoiCircle& atK,
                            const VoronoiCircle& atL, const Site& q) {
  if (coversCorner(q, edge.i) || coversCorner(q, edge.j)) return true;
  return !probeIsInRange(edge, &atK, &atL, q, stages::Probe::kOpposite);
}

}  // namespace apollonius::internal
