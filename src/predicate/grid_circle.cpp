#include "predicate/grid_circle.h"

#include <algorithm>
#include <array>

#include "number/twofold.h"
#include "predicate/bounded_center.h"

namespace apollonius::internal {

namespace {

/// The centre and its distance from the reference site, in units: x, y, rho. The relative error of
/// each is less than 4 kTwofoldRoundoff.
using Center = std::array<Twofold, 3>;

/// The centre for equal weights: its coordinates seen from the reference site at (x, y) are
/// quotients of integers, `over` / `twice`, below 2^53 each.
Center centerOfPoints(double x, double y, const Row<double>& j, const Row<double>& k) {
  const double twice = 2 * (j.x * k.y - j.y * k.x);
  const double overX = j.p * k.y - k.p * j.y, overY = k.p * j.x - j.p * k.x;
  return {(productOf(x, twice) + overX) / twice, (productOf(y, twice) + overY) / twice,
          root(productOf(overX, overX) + productOf(overY, overY)) / twice};
}

}  // namespace

OnGrid circleOnGrid(const Site& i, const Site& j, const Site& k, VoronoiCircle& circle) {
  const double jx = j.x - i.x, jy = j.y - i.y, jr = j.r - i.r;
  const double kx = k.x - i.x, ky = k.y - i.y, kr = k.r - i.r;
  const double largest = std::max(
      {absolute(jx), absolute(jy), absolute(jr), absolute(kx), absolute(ky), absolute(kr)});
  // Multiples of 2^(e-16). Differences are below 2^17 of them, p below 2^35, that of the other two
  // sites below 2^37, and products below 2^52.
  const int unit = exponentOf(largest) - 16;
  const double shift = 1.5 * powerOfTwo(unit + 52);  // its doubles are that far apart
  const auto isMultiple = [shift](double v) { return (v + shift) - shift == v; };
  for (const Site* s : {&i, &j, &k}) {
    if (!isMultiple(s->x) || !isMultiple(s->y) || !isMultiple(s->r)) return OnGrid::kNo;
  }
  if (jr != 0 || kr != 0) return OnGrid::kYes;
  const double scale = powerOfTwo(-unit);
  const Row<double> rowJ = rowOf(jx * scale, jy * scale, jr * scale),
                    rowK = rowOf(kx * scale, ky * scale, kr * scale);
  const Center center = centerOfPoints(i.x * scale, i.y * scale, rowJ, rowK);
  for (const Twofold& number : center) {
    if (!isRounded(number, 3 * kTwofoldRoundoff * absolute(number.value))) return OnGrid::kYes;
  }
  const double rho = center[2].value / scale;
  circle.x = center[0].value / scale;
  circle.y = center[1].value / scale;
  circle.s = rho - i.r;
  circle.slope = -1;
  circle.error = roundedUp(
      kUnitRoundoff * (4 * rho + absolute(circle.x) + absolute(circle.y) + absolute(circle.s)));
  return OnGrid::kYesRounded;
}

}  // namespace apollonius::internal
