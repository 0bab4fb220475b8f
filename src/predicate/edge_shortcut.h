// A quick yes to "is the whole edge in conflict?", for edges both of whose ends are: nearly all of
// those that an insertion asks about.
#pragma once

#include <algorithm>

#include "number/fp.h"
#include "predicate/formulas.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius {

/// True only if no part of the edge between i and j is nearer to them than to q. REQUIRES: both
/// ends of the edge, the vertices of atK and atL, are in conflict with q; i and j are finite. False
/// says nothing. About forty flops.
///
/// Seen from the larger of i and j, the directions in conflict form an arc with the middle M
/// (chordOf), and those of the edge a range of at most half a turn, between the directions k and l
/// of its ends. If part of the edge were not in conflict, then the middle of the rest, -M, would be
/// in the range, hence -M = s k + t l with s, t >= 0, and M·k, M·l could not both be positive. (If
/// q covers i or j, the answer is yes anyway.)
///
/// Bound: M's components have depth 8 (stages.cpp), error at most e = 9u (l_q m_j + l_j m_q); those
/// of k the circle's error and one rounding; the scalar product has two roundings more.
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
  const auto isAhead = [&](const VoronoiCircle& circle) {
    const double x = circle.x - reference.x, y = circle.y - reference.y;
    const double size = absolute(x) + absolute(y);
    const double bound =
        (m * (circle.error + 4 * u1 * size) + e * (size + 2 * circle.error)) * (1 + 32 * u1);
    return x * mx + y * my > bound;
  };
  // Underflow: the scalar products are above it, or the answer is false; what smaller products lose
  // is then below the bound.
  return !atK.isHalfPlane() && !atL.isHalfPlane() && m * u1 > powerOfTwo(-900) && isAhead(atK) &&
         isAhead(atL);
}

}  // namespace apollonius
