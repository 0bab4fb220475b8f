#include "predicate/distance.h"

#include <limits>

#include "number/root_sign.h"
#include "number/twofold.h"
#include "predicate/kernels.h"
#include "predicate/long_kernels.h"
#include "predicate/question.h"

namespace apollonius::internal {

namespace stages {

MaybeSign distanceFilter(double x, double y, const Site& a, const Site& b) {
  const ApproxDistance da(x, y, a), db(x, y, b);
  const double difference = da.value - db.value;
  const double bound = da.bound + db.bound;
  if (difference > bound) return {Sign::kPositive, true};
  if (difference < -bound) return {Sign::kNegative, true};
  return {};
}

MaybeSign distanceMiddle(double x, double y, const Site& a, const Site& b) {
  if (a.r != b.r) return {};
  // With the weight of the sites the point sees their squared distances as p.
  return decide<UnitKernel>({x, y, a.r}, {&a, &b}, [](auto& kernel) {
    return kernel.sign(kernel.row(0).p - kernel.row(1).p, roundings::kRow.p);
  });
}

MaybeSign distanceFixed(double x, double y, const Site& a, const Site& b) {
  return decide<FixedKernel>({x, y, 0}, {&a, &b}, [](auto& kernel) {
    const auto &s = kernel.row(0), &t = kernel.row(1);
    return signOfRootDifference(t.r - s.r, s.x * s.x + s.y * s.y, t.x * t.x + t.y * t.y);
  });
}

Sign distanceExact(double x, double y, const Site& a, const Site& b) {
  const Dyadic px(x), py(y);
  const auto squaredTo = [&](const Site& s) {
    const Dyadic dx = Dyadic(s.x) - px, dy = Dyadic(s.y) - py;
    return dx * dx + dy * dy;
  };
  return signOfRootDifference(Dyadic(b.r) - Dyadic(a.r), squaredTo(a), squaredTo(b));
}

}  // namespace stages

Sign compareDistance(double x, double y, const Site& a, const Site& b) {
  using stages::counts;
  Question question([&] { return stages::distanceExact(x, y, a, b); }, counts().distanceExact);
  if (question.isSettledBy(stages::distanceFilter(x, y, a, b), counts().distanceFilter) ||
      question.isSettledBy(stages::distanceMiddle(x, y, a, b), counts().distanceMiddle) ||
      question.isSettledBy(stages::distanceFixed(x, y, a, b), counts().distanceFixed))
    return question.settled();
  return question.exact();
}

double roundedDistance(double x, double y, const Site& s) {
  const Twofold dx = Twofold(s.x) - x, dy = Twofold(s.y) - y;
  const Twofold square = dx * dx + dy * dy;
  if (square.value == 0) return 0 - s.r;
  const Twofold length = root(square), distance = length - s.r;
  // A few dozen kTwofoldRoundoff of the length: less than half a unit in the last place of this.
  if (absolute(distance.value) > powerOfTwo(-44) * length.value) return distance.value;
  // Next to the circle, where the two cancel: (|p - c|² - r²) / (|p - c| + r), with an exact
  // numerator, rounded to two doubles.
  const Dyadic ex = Dyadic(s.x) - Dyadic(x), ey = Dyadic(s.y) - Dyadic(y), r(s.r);
  const Dyadic over = ex * ex + ey * ey - r * r;
  const double value = over.rounded().value();
  const Twofold rounded(value, (over - Dyadic(value)).rounded().value());
  return (rounded / (length + s.r)).value;
}

bool isBeyond(double x, double y, const Site& site, double limit) {
  // The distance to a site with its centre at p is minus its weight.
  return limit < std::numeric_limits<double>::infinity() &&
         compareDistance(x, y, site, {x, y, -limit}) == Sign::kPositive;
}

bool isNearer(double x, double y, const Site& a, const Site& b) {
  const Sign sign = compareDistance(x, y, a, b);
  return sign == Sign::kPositive || (sign == Sign::kZero && precedes(a, b));
}

}  // namespace apollonius::internal
