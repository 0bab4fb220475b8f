// Edge conflict from the cached circles of the edge's two faces: turns between directions in
// doubles, some forty flops instead of polynomials of degree 12.
#include <algorithm>

#include "predicate/direction.h"
#include "predicate/formulas.h"
#include "predicate/stages.h"

namespace apollonius::stages {

namespace {

constexpr double u1 = kUnitRoundoff;

/// Middle of q's shadow on the bisector of the reference site and j (chordOf), or its opposite.
/// Roundings 8 (stages.cpp): the error of each component is at most 9u (l_q m_j + l_j m_q), with l
/// the largest difference and m = x² + y² + r².
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

}  // namespace apollonius::stages
