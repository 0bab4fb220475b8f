#include "predicate/compute_circle.h"

#include <algorithm>
#include <limits>

#include "number/ball.h"
#include "predicate/bounded_center.h"
#include "predicate/kernels.h"
#include "predicate/reference_site.h"
#include "predicate/vertex_conflict.h"

namespace apollonius::internal {

namespace {

/// Differences to the reference site times a power of two: one rounding each.
Row<double> rowFrom(const Site& reference, const Site& s, double scale) {
  return rowOf((s.x - reference.x) * scale, (s.y - reference.y) * scale,
               (s.r - reference.r) * scale);
}

double largestDifference(const Site& a, const Site& b) {
  return std::max({absolute(a.x - b.x), absolute(a.y - b.y), absolute(a.r - b.r)});
}

/// Circle of three finite sites, and a bound on its error.
Existence boundedCircle(const Site& reference, const Site& sj, const Site& sk,
                        VoronoiCircle& circle) {
  const double scale =
      inputScale(std::max(largestDifference(reference, sj), largestDifference(reference, sk)));
  BoundedCenter<double> center;
  const Existence existence = findCenter(
      rowFrom(reference, sj, scale), rowFrom(reference, sk, scale), rowFrom(sj, sk, scale), center);
  circle.slope = -1;
  circle.x = reference.x + center.x / scale;
  circle.y = reference.y + center.y / scale;
  circle.s = center.rho / scale - reference.r;
  circle.error = existence == Existence::kYes
                     ? roundedUp((center.error / scale +
                                  kUnitRoundoff * (absolute(circle.x) + absolute(circle.y) +
                                                   absolute(circle.s))) *
                                 (1 + powerOfTwo(-5)))
                     : std::numeric_limits<float>::infinity();
  return existence;
}

/// Half-plane of two finite sites, the reference site and t; `side` is +1 if it is the reference
/// site's left on the way to t, else -1. There are few of these faces, so the bound is computed
/// along with the value.
VoronoiCircle halfPlane(const Site& reference, const Site& t, int side) {
  const double size = std::max(
      {absolute(t.x - reference.x), absolute(t.y - reference.y), absolute(t.r - reference.r)});
  const double scale = inputScale(size);
  const Ball x = Ball::rounded((t.x - reference.x) * scale),
             y = Ball::rounded((t.y - reference.y) * scale);
  const Ball r = Ball::rounded((t.r - reference.r) * scale);
  const Ball n = x * x + y * y;
  const Ball root = Ball(side) * sqrt(lorentz(x, y, r));
  // The direction (a, b) of findCenter with t for one row and infinity for the other.
  const Ball a = (Ball(0) - (y * root + r * x)) / n, b = (x * root - r * y) / n;
  const Ball offset =
      a * Ball::exact(reference.x) + b * Ball::exact(reference.y) + Ball::exact(reference.r);
  VoronoiCircle plane;
  plane.x = a.value();
  plane.y = b.value();
  plane.s = offset.value();
  plane.error = roundedUp(offset.bound());
  plane.slope = roundedUp(std::max(a.bound(), b.bound()));
  return plane;
}

}  // namespace

VoronoiCircle voronoiCircle(Corner i, Corner j, Corner k) {
  rotateToReference(i, j, k);
  if (k == nullptr) return halfPlane(*i, *j, 1);
  if (j == nullptr) return halfPlane(*i, *k, -1);
  VoronoiCircle circle;
  (void)boundedCircle(*i, *j, *k, circle);  // that it exists is known to the caller
  return circle;
}

bool findCertainVoronoiCircle(Corner i, Corner j, Corner k, VoronoiCircle& circle) noexcept {
  rotateToReference(i, j, k);
  if (k != nullptr && j != nullptr) return boundedCircle(*i, *j, *k, circle) == Existence::kYes;
  circle = k == nullptr ? halfPlane(*i, *j, 1) : halfPlane(*i, *k, -1);
  return true;
}

bool findVoronoiCircle(Corner i, Corner j, Corner k, VoronoiCircle& circle) {
  rotateToReference(i, j, k);
  if (j == nullptr || k == nullptr) {
    circle = voronoiCircle(i, j, k);
    return true;
  }
  const Existence existence = boundedCircle(*i, *j, *k, circle);
  return existence == Existence::kYes ||
         (existence == Existence::kUnknown && hasVoronoiCircle(*i, *j, *k));
}

}  // namespace apollonius::internal
