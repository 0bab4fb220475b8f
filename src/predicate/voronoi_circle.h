// The Voronoi circle of a face in doubles, with bounds on its error: kept with each face as the
// first filter of vertex conflicts (a few flops, one cache line). Listed coordinates are computed
// anew (preciseVoronoiCircle): the last bits of a kept circle depend on how it came about.
//
// For a bounded face: centre (x, y) and clearance s, the common distance to its three sites. For an
// unbounded face: the half-plane a·x + b·y >= c beyond the two circles' common tangent line, with
// outer unit normal (a, b); a site of weight r sticks out of it if a·x + b·y + r > c.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "number/approx.h"
#include "number/fp.h"
#include "predicate/site.h"

namespace apollonius {

struct VoronoiCircle {
  double x = 0;  ///< centre, or the normal's a
  double y = 0;  ///< centre, or the normal's b
  double s = 0;  ///< clearance, or the half-plane's c
  /// Of a circle: |exact centre - (x, y)| + |exact s - s| is at most this; infinite if nothing is
  /// known; NaN if it has not been computed. Of a half-plane: the error of c.
  float error = 0;
  /// Of a half-plane: the error of the normal's components; negative marks a circle.
  float slope = -1;

  [[nodiscard]] bool isHalfPlane() const { return slope >= 0; }
  [[nodiscard]] bool isMissing() const { return std::isnan(error); }
};

/// In the place of a circle that is to be computed when it is needed. The filters know nothing of
/// it.
inline constexpr VoronoiCircle kMissingCircle{0, 0, 0, std::numeric_limits<float>::quiet_NaN(), -1};

/// For bounds: the smallest convenient float that is at least x; infinity for NaN.
inline float roundedUp(double x) {
  if (!(x <= 1e38)) return std::numeric_limits<float>::infinity();
  return std::max(static_cast<float>(x * (1 + powerOfTwo(-22))), std::numeric_limits<float>::min());
}

/// The circle of a counter-clockwise face with an existing circle. The same bits for the same three
/// sites, whichever comes first and on whichever platform: the computation starts from the largest
/// site in the order of precedes().
[[nodiscard]] VoronoiCircle voronoiCircle(Corner i, Corner j, Corner k);

/// The circle as voronoiCircle() computes it, if the counter-clockwise triple of sites has one; at
/// most one of them is infinite, and none covers another. Returns whether it has.
[[nodiscard]] bool findVoronoiCircle(Corner i, Corner j, Corner k, VoronoiCircle& circle);

/// The same in doubles alone, which throw nothing: true only if they show that there is a circle.
[[nodiscard]] bool findCertainVoronoiCircle(Corner i, Corner j, Corner k,
                                            VoronoiCircle& circle) noexcept;

/// The same with coordinates that are good whatever the sites: errors of a few units in the last
/// place of the radius and of each coordinate. Takes long numbers where voronoiCircle's doubles do
/// not suffice. Coordinates beyond the range of doubles are infinite.
[[nodiscard]] VoronoiCircle preciseVoronoiCircle(Corner i, Corner j, Corner k);

/// The same for a circle that more than three sites touch, with the same bits whichever three of
/// them are given, the largest of all among them: the centre's offset from that site, and its
/// distance, are rounded correctly. (Not where the sites' digits range over more than 500 places:
/// there they are as preciseVoronoiCircle's.)
[[nodiscard]] VoronoiCircle commonVoronoiCircle(const Site& first, const Site& second,
                                                const Site& third);

/// Vertex conflict from the cached circle alone: positive, conflict; negative, none; or unknown.
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

}  // namespace apollonius
