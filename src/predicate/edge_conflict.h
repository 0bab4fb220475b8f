// With which part of a Voronoi edge is a site in conflict, if it has the same state at both ends?
#pragma once

#include "number/approx.h"
#include "number/fp.h"
#include "number/pair.h"
#include "number/sign.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// A Voronoi edge: the part of the bisector of i and j from its vertex (j, i, l) to its vertex
/// (i, j, k), with i on its left. At most one of i, j, and at most one corner of each face, is
/// infinite.
struct EdgeCorners {
  Corner i, j, k, l;
};

/// Is the interior of the edge in conflict with q, while neither end is?
/// REQUIRES: as isVertexInConflict for both ends, which are not in conflict. Degree 12.
[[nodiscard]] bool isInteriorInConflict(const EdgeCorners& edge, const Site& q);

/// Is all of the edge in conflict with q, as both ends are?
/// REQUIRES: as isVertexInConflict for both ends, which are in conflict. Degree 12.
[[nodiscard]] bool isEntireEdgeInConflict(const EdgeCorners& edge, const Site& q);

/// As above, with the cached circles of the edge's faces (i, j, k) and (j, i, l) for a first
/// filter.
[[nodiscard]] bool isInteriorInConflict(const EdgeCorners& edge, const VoronoiCircle& atK,
                                        const VoronoiCircle& atL, const Site& q);
[[nodiscard]] bool isEntireEdgeInConflict(const EdgeCorners& edge, const VoronoiCircle& atK,
                                          const VoronoiCircle& atL, const Site& q);

/// A quick yes to "is all of the edge in conflict?", which is the answer in nearly all cases of an
/// insertion. True only if no part of the edge between i and j is nearer to them than to q; false
/// says nothing. REQUIRES: both ends of the edge, the vertices of atK and atL, are in conflict with
/// q; i and j are finite. About forty flops.
///
/// Seen from the larger of i and j, the directions in conflict form an arc with the middle M
/// (chordOf), and those of the edge a range of at most half a turn, between the directions k and l
/// of its ends. If part of the edge were not in conflict, then the middle of the rest, -M, would be
/// in the range, hence -M = s k + t l with s, t >= 0, and M·k, M·l could not both be positive. (If
/// q covers i or j, the answer is yes anyway.)
///
/// Bound: M's components pass 8 roundings (formulas.h), so their error is at most
/// e = 9u (l_q m_j + l_j m_q), with l the largest difference and m = x² + y² + r²; those of k have
/// the circle's error and one rounding; the scalar product has two roundings more.
inline bool isSurelyInConflictBetweenEnds(const Site& i, const Site& j, const VoronoiCircle& atK,
                                          const VoronoiCircle& atL, const Site& q) {
  constexpr double u1 = kUnitRoundoff;
  const bool swapped = i.r < j.r;
  const Site &reference = swapped ? j : i, &other = swapped ? i : j;
  const double qx = q.x - reference.x, qy = q.y - reference.y, qr = q.r - reference.r;
  const double jx = other.x - reference.x, jy = other.y - reference.y, jr = other.r - reference.r;
  const double qxy = qx * qx + qy * qy, jxy = jx * jx + jy * jy, qrr = qr * qr, jrr = jr * jr;
  const double pq = qxy - qrr, pj = jxy - jrr;
  const double mx = qx * pj - jx * pq, my = qy * pj - jy * pq;
  // l <= |x| + |y| + |r|, which is as good.
  const double lq = absolute(qx) + absolute(qy) + absolute(qr),
               lj = absolute(jx) + absolute(jy) + absolute(jr);
  const double e = 9 * u1 * (lq * (jxy + jrr) + lj * (qxy + qrr));
  const double m = absolute(mx) + absolute(my);
  // Underflow: the scalar products are above it, or the answer is false; the loss of smaller
  // products is then below the bound.
  if (atK.isHalfPlane() || atL.isHalfPlane() || !(m * u1 > powerOfTwo(-900))) return false;
  const Pair centreK = loadPair(&atK.x), centreL = loadPair(&atL.x);
  const Pair x = firsts(centreK, centreL) - reference.x,
             y = seconds(centreK, centreL) - reference.y;
  const Pair error{static_cast<double>(atK.error), static_cast<double>(atL.error)};
  const Pair size = absolute(x) + absolute(y);
  const Pair bound = (m * (error + 4 * u1 * size) + e * (size + 2 * error)) * (1 + 32 * u1);
  return areBoth(x * mx + y * my > bound);
}

namespace stages {

/// The direction from the reference site whose membership in the edge's range of directions decides
/// an edge conflict: the middle of q's shadow on the bisector (neither end in conflict), or its
/// opposite (both ends in conflict).
enum class Probe : signed char { kMiddle = 1, kOpposite = -1 };

// For all of these: positive means that the direction is strictly within the range; zero or
// negative that it is not. REQUIRES: i is finite, and the larger of i and j if both are; q covers
// neither.

/// Takes the directions of the edge's ends from the cached circles of (i, j, k) and (j, i, l).
[[nodiscard]] MaybeSign edgeCircleFilter(const Site& i, Corner j, const VoronoiCircle& atK,
                                         const VoronoiCircle& atL, const Site& q, Probe probe);
/// In doubles with an error bound.
[[nodiscard]] MaybeSign edgeFilter(const Site& i, Corner j, Corner k, Corner l, const Site& q,
                                   Probe probe);
/// In doubles that are exact.
[[nodiscard]] MaybeSign edgeMiddle(const Site& i, Corner j, Corner k, Corner l, const Site& q,
                                   Probe probe);
/// In integers of fixed width.
[[nodiscard]] MaybeSign edgeFixed(const Site& i, Corner j, Corner k, Corner l, const Site& q,
                                  Probe probe);
[[nodiscard]] Sign edgeExact(const Site& i, Corner j, Corner k, Corner l, const Site& q,
                             Probe probe);

}  // namespace stages

}  // namespace apollonius::internal
