#include "predicate/grid_circle.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "number/twofold.h"
#include "predicate/bounded_center.h"

namespace apollonius::internal {

namespace {

constexpr double u2 = kTwofoldRoundoff;

/// A number and how far off it is at most.
struct Bounded {
  Twofold number;
  double error;

  /// Is its first double certainly the one nearest to what it stands for?
  [[nodiscard]] bool isRounded() const {
    const double value = number.value;
    return value + (number.rest + error) == value && value + (number.rest - error) == value;
  }
};

/// The centre and its distance from the reference site, in units: x, y, rho.
using Center = std::array<Bounded, 3>;

/// Of equal weights: quotients of integers. With rows j and k, `over` and `twice` are those of the
/// centre seen from the reference site at (x, y), below 2^53 each.
Center centerOfPoints(double x, double y, const Row<double>& j, const Row<double>& k) {
  const double twice = 2 * (j.x * k.y - j.y * k.x);
  const double overX = j.p * k.y - k.p * j.y, overY = k.p * j.x - j.p * k.x;
  const auto quotient = [&](const Twofold& over) -> Bounded {
    const Twofold result = over / twice;
    return {result, 4 * u2 * absolute(result.value)};
  };
  return {quotient(productOf(x, twice) + overX), quotient(productOf(y, twice) + overY),
          quotient(root(productOf(overX, overX) + productOf(overY, overY)))};
}

/// Of any weights.
Center centerOfCircles(double x, double y, const Row<double>& j, const Row<double>& k) {
  const auto row = [](double dx, double dy, double dr) {
    return rowOf(Twofold(dx), Twofold(dy), Twofold(dr));
  };
  BoundedCenter<Twofold> center;
  const Existence existence = findCenter(row(j.x, j.y, j.r), row(k.x, k.y, k.r),
                                         row(k.x - j.x, k.y - j.y, k.r - j.r), center);
  const auto beside = [&](double own, const Twofold& part) -> Bounded {
    const Twofold result = part + own;
    return {result, existence == Existence::kYes
                        ? center.error * (1 + powerOfTwo(-5)) + u2 * absolute(result.value)
                        : HUGE_VAL};
  };
  return {beside(x, center.x), beside(y, center.y), beside(0, center.rho)};
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
  const double scale = powerOfTwo(-unit);
  const Row<double> rowJ = rowOf(jx * scale, jy * scale, jr * scale),
                    rowK = rowOf(kx * scale, ky * scale, kr * scale);
  const bool areEqual = jr == 0 && kr == 0;
  const Center center = areEqual ? centerOfPoints(i.x * scale, i.y * scale, rowJ, rowK)
                                 : centerOfCircles(i.x * scale, i.y * scale, rowJ, rowK);
  for (const Bounded& number : center) {
    if (!number.isRounded()) return OnGrid::kYes;
  }
  const double rho = center[2].number.value / scale;
  circle.x = center[0].number.value / scale;
  circle.y = center[1].number.value / scale;
  circle.s = rho - i.r;
  circle.slope = -1;
  circle.error = roundedUp(
      kUnitRoundoff * (4 * rho + absolute(circle.x) + absolute(circle.y) + absolute(circle.s)));
  return OnGrid::kYesRounded;
}

}  // namespace apollonius::internal
