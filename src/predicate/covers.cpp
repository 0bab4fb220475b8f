#include "predicate/covers.h"

#include "predicate/kernels.h"
#include "predicate/long_kernels.h"
#include "predicate/question.h"

namespace apollonius::internal {

namespace stages {

MaybeSign lorentzFilter(const Site& a, const Site& b) {
  const Approx p = lorentz(Approx(a.x - b.x), Approx(a.y - b.y), Approx(a.r - b.r));
  return filteredSign(p, errorFactor(roundings::kRow.p));
}

MaybeSign lorentzMiddle(const Site& a, const Site& b) {
  return decide<UnitKernel>(
      a, {&b}, [](auto& kernel) { return kernel.sign(kernel.row(0).p, roundings::kRow.p); });
}

Sign lorentzExact(const Site& a, const Site& b) {
  return lorentz(Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.r) - Dyadic(b.r))
      .sign();
}

}  // namespace stages

bool covers(const Site& a, const Site& b) {
  using stages::counts;
  if (a.r <= b.r) return a.r == b.r && a.x == b.x && a.y == b.y;
  Question question([&] { return stages::lorentzExact(a, b); }, counts().lorentzExact);
  if (question.isSettledBy(stages::lorentzFilter(a, b), counts().lorentzFilter) ||
      question.isSettledBy(stages::lorentzMiddle(a, b), counts().lorentzMiddle))
    return question.settled() != Sign::kPositive;
  return question.exact() != Sign::kPositive;
}

}  // namespace apollonius::internal
