// Is a site in conflict with a Voronoi vertex?
#pragma once

#include "number/approx.h"
#include "number/fp.h"
#include "number/sign.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// Is q in conflict with the Voronoi vertex of the face (i, j, k), i.e. does the vertex belong to
/// q's cell once q is added? REQUIRES: i, j, k counter-clockwise with an existing Voronoi circle,
/// at most one of them infinite, none covering another or q. Laws: the answer for (j, k, i) is the
/// same; zeros of the polynomial are decided as if infinity began at a finite, immense clearance
/// and larger sites had infinitely larger increments of their weights, so the answers never depend
/// on the order of insertion. Degree 8.
[[nodiscard]] bool isVertexInConflict(Corner i, Corner j, Corner k, const Site& q);

/// As above, with the face's cached circle for a first filter.
[[nodiscard]] bool isVertexInConflict(const VoronoiCircle& circle, Corner i, Corner j, Corner k,
                                      const Site& q);

/// Is there a circle that touches i, j, k from outside (or from inside) in counter-clockwise order?
/// The sites are finite and none covers another. A common tangent line is no conflict: infinity
/// takes it over. Degree 5.
[[nodiscard]] bool hasVoronoiCircle(const Site& i, const Site& j, const Site& k);

/// Does q touch the Voronoi circle of the face (i, j, k)? REQUIRES: as isVertexInConflict, i, j, k
/// finite. Degree 8.
[[nodiscard]] bool touchesCircle(const Site& i, const Site& j, const Site& k, const Site& q);
/// Does q touch the circle between i and j, so that the face (j, i, q) has the same circle? (Those
/// three can have a second one, in the other order.) REQUIRES: as touchesCircle.
[[nodiscard]] bool touchesBetween(const Site& i, const Site& j, const Site& k, const Site& q);

/// The first stage, which decides nearly all cases: vertex conflict from the cached circle alone.
/// Positive: conflict; negative: none; or unknown.
///
/// Circle: conflict means |c - q| < s + r. With h = fl(s + r) and E = error + 2u|h|, the exact s +
/// r and |c - q| differ from h and |fl(c) - q| by at most E together. d2 = fl(dx² + dy²) is exact
/// to a factor (1 + 4u + …), hence the 8u. Squares are compared, both sides being positive.
/// Half-plane: each of the three terms and sums adds at most 4u of the terms' size.
inline MaybeSign circleFilter(const VoronoiCircle& circle, const Site& q) {
  if (circle.isHalfPlane()) {
    const double ax = circle.x * q.x, by = circle.y * q.y;
    const double excess = (ax + by) + (q.r - circle.s);
    const double bound =
        circle.slope * (absolute(q.x) + absolute(q.y)) + circle.error +
        4 * kUnitRoundoff * (absolute(ax) + absolute(by) + absolute(q.r) + absolute(circle.s));
    if (excess > bound) return {Sign::kPositive, true};
    if (excess < -bound) return {Sign::kNegative, true};
    return {};
  }
  const double dx = circle.x - q.x, dy = circle.y - q.y;
  const double d2 = dx * dx + dy * dy;
  const double h = circle.s + q.r;
  const double e = circle.error + 2 * kUnitRoundoff * absolute(h);
  const double low = h - e, high = h + e;
  if (high < 0 || high * high * (1 + 8 * kUnitRoundoff) < d2) return {Sign::kNegative, true};
  if (low > 0 && low * low * (1 - 8 * kUnitRoundoff) > d2) return {Sign::kPositive, true};
  return {};
}

namespace stages {

// REQUIRES, for all of these: i is finite and the largest of the finite ones among i, j, k; q
// covers none of them; at most one of the four is infinite (q = nullptr asks whether infinity is
// nearer, that is, whether the face has no Voronoi circle). Positive: conflict; zero: q touches the
// circle.

/// First stage for equal weights: in doubles, exact on grids. Unknown if weights differ.
[[nodiscard]] MaybeSign vertexOfPoints(const Site& i, Corner j, Corner k, Corner q);
/// A later stage for equal weights: in numbers of twice the digits; exact for two pairs that are
/// mirror images in one axis-parallel line, however the coordinates were rounded.
[[nodiscard]] MaybeSign vertexTwofold(const Site& i, Corner j, Corner k, Corner q);
/// In doubles with an error bound.
[[nodiscard]] MaybeSign vertexFilter(const Site& i, Corner j, Corner k, Corner q);
/// In doubles that are exact.
[[nodiscard]] MaybeSign vertexMiddle(const Site& i, Corner j, Corner k, Corner q);
/// In integers of fixed width.
[[nodiscard]] MaybeSign vertexFixed(const Site& i, Corner j, Corner k, Corner q);
[[nodiscard]] Sign vertexExact(const Site& i, Corner j, Corner k, Corner q);
/// The answer if vertexExact is zero.
[[nodiscard]] bool vertexDegenerate(const Site& i, Corner j, Corner k, Corner q);
/// The geometric part of vertexDegenerate: of four sites that touch one circle (or line: one is
/// infinite), is q opposite to this corner?
enum class FaceCorner : unsigned char { kReference, kJ, kK };
[[nodiscard]] bool isOpposite(const Site& i, Corner j, Corner k, Corner q, FaceCorner corner);
/// The exact stage of isOpposite, in long integers.
[[nodiscard]] bool isOppositeExact(const Site& i, Corner j, Corner k, Corner q, FaceCorner corner);

}  // namespace stages

}  // namespace apollonius::internal
