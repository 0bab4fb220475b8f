#include "predicate/hull_turn.h"

#include "number/root_sign.h"
#include "predicate/direction.h"
#include "predicate/long_kernels.h"
#include "predicate/shadow_check.h"
#include "predicate/span.h"

namespace apollonius::internal {

namespace stages {

/// Up to a positive factor the normal is (-r x - y √p, -r y + x √p), (x, y, r, p) being the row of
/// j seen from i.
bool normalIsUpExact(const Site& i, const Site& j) {
  const ExactKernel kernel(i, {&j});
  const Row<Dyadic>& t = kernel.row(0);
  const Sign y = signOfRoot(-(t.r * t.y), t.x, t.p);
  return y == Sign::kPositive ||
         (y == Sign::kZero && signOfRoot(-(t.r * t.x), -t.y, t.p) == Sign::kPositive);
}

Sign spanExact(const Site& i, const Site& l, const Site& k) {
  constexpr auto kDecision = [](auto& kernel) {
    return spanSign(kernel, kernel.row(0), kernel.row(1));
  };
  const MaybeSign fixed = decide<FixedKernel>(i, {&l, &k}, kDecision);
  return fixed.known ? fixed.sign : decide<ExactKernel>(i, {&l, &k}, kDecision).sign;
}

}  // namespace stages

bool pointsUp(const Site& i, const Site& j, const VoronoiCircle& plane) {
  MaybeSign filtered;
  if (plane.y > plane.slope) filtered = {Sign::kPositive, true};
  if (plane.y < -plane.slope) filtered = {Sign::kNegative, true};
  const auto exact = [&] {
    return stages::normalIsUpExact(i, j) ? Sign::kPositive : Sign::kNegative;
  };
  shadowCheck(filtered, exact);
  return (filtered.known ? filtered.sign : exact()) == Sign::kPositive;
}

Sign turnOfHull(const Site& i, const Site& l, const Site& k, const VoronoiCircle& atL,
                const VoronoiCircle& atK) {
  const MaybeSign filtered = turn(directionOf(atL, i), directionOf(atK, i));
  shadowCheck(filtered, [&] { return stages::spanExact(i, l, k); });
  return filtered.known ? filtered.sign : stages::spanExact(i, l, k);
}

}  // namespace apollonius::internal
