#include "geometry/enclosing/enclosure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "number/dyadic.h"
#include "number/root_sign.h"
#include "number/twofold.h"
#include "predicate/compute_circle.h"
#include "predicate/kernels.h"
#include "predicate/orientation.h"
#include "predicate/precise_circle.h"
#include "predicate/vertex_conflict.h"

namespace apollonius::internal {

namespace {

/// The circle around two sites: with the distance D of the centres, R = (D + r_a + r_b) / 2, and
/// its centre is R - r_a from that of a in the direction of b.
VoronoiCircle aroundTwo(const Site& a, const Site& b) {
  // Differences of two doubles are exact here.
  const Twofold dx = Twofold(b.x) - a.x, dy = Twofold(b.y) - a.y;
  const double scale = inputScale(std::max(absolute(dx.value), absolute(dy.value)));
  const auto times = [](const Twofold& t, double power) {
    return Twofold(power * t.value, power * t.rest);
  };
  const Twofold x = times(dx, scale), y = times(dy, scale);
  const Twofold distance = times(root(x * x + y * y), 1 / scale);
  const Twofold twiceReach = distance + (Twofold(b.r) - a.r);  // 2 (R - r_a)
  const Twofold share = twiceReach / (distance + distance);
  VoronoiCircle circle;
  circle.x = (Twofold(a.x) + share * dx).value;
  circle.y = (Twofold(a.y) + share * dy).value;
  circle.s = ((twiceReach + a.r + a.r) * Twofold(0.5)).value;
  const double size = absolute(a.x) + absolute(a.y) + absolute(a.r) + absolute(b.r);
  circle.error =
      roundedUp(2 * kUnitRoundoff * (absolute(circle.x) + absolute(circle.y) + absolute(circle.s)) +
                powerOfTwo(-90) * (size + distance.value));
  return circle;
}

}  // namespace

Enclosure::Enclosure(const Site& a, const Site& b)
    : sites_(precedes(a, b) ? std::array<Site, 3>{b, a} : std::array<Site, 3>{a, b}), size_(2) {
  circle_ = aroundTwo(sites_[0], sites_[1]);
}

/// The centre is in the triangle of the sites' centres: from that of the circle around two of them
/// it goes along their bisector to the side of the third one. So the sites come around it as their
/// centres do.
Enclosure::Enclosure(const Site& a, const Site& b, const Site& c) : sites_{a, b, c}, size_(3) {
  if (orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y}) == Sign::kNegative)
    std::swap(sites_[1], sites_[2]);
  for (std::size_t k = 0; k < 3; ++k) opposite_[k] = opposite(sites_[k]);
  circle_ = voronoiCircle(opposite_.data(), &opposite_[1], &opposite_[2]);
}

Sign Enclosure::holds(const Site& q) const {
  const Site facing = opposite(q);
  const MaybeSign filtered = circleFilter(circle_, facing);
  if (filtered.known) return filtered.sign;
  if (size_ == 2) return holdsBeside(q);
  const auto& [i, j, k] = opposite_;
  if (touchesCircle(i, j, k, facing)) return Sign::kZero;
  return isVertexInConflict(&i, &j, &k, facing) ? Sign::kPositive : Sign::kNegative;
}

/// Seen from a, with b at X, q at Y, and weights less r_a, δ of b and ρ of q: the circle's radius
/// is (D + δ) / 2 where D = |X|, its centre at (D + δ) / (2D) X. So q is within if ρ is not above
/// that radius, and
///
///     |Y|² - ρ² + (D + δ) ρ - (D + δ) (X·Y) / D <= 0.
///
/// Times D this is of the form s + t D.
Sign Enclosure::holdsBeside(const Site& q) const {
  const Site &a = sites_[0], &b = sites_[1];
  const auto apart = [](double v, double from) { return Dyadic(v) - Dyadic(from); };
  const Dyadic x = apart(b.x, a.x), y = apart(b.y, a.y), delta = apart(b.r, a.r);
  const Dyadic qx = apart(q.x, a.x), qy = apart(q.y, a.y), rho = apart(q.r, a.r);
  const Dyadic square = x * x + y * y, along = x * qx + y * qy;
  if (signOfRoot(delta - rho - rho, Dyadic(1), square) == Sign::kNegative) return Sign::kNegative;
  return -signOfRoot(square * rho - delta * along,
                     qx * qx + qy * qy - rho * rho + delta * rho - along, square);
}

double Enclosure::excess(const Site& q) const {
  const double dx = q.x - circle_.x, dy = q.y - circle_.y;
  return std::sqrt(dx * dx + dy * dy) + q.r - circle_.s;
}

Site Enclosure::rounded() const {
  if (size_ < 3) return {circle_.x, circle_.y, circle_.s};
  const VoronoiCircle circle = commonVoronoiCircle(opposite_[0], opposite_[1], opposite_[2]);
  return {circle.x, circle.y, circle.s};
}

}  // namespace apollonius::internal
