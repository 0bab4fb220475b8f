// Numbers of two doubles, against exact ones: no operation is off by more than half of what its
// bound says.
#include "number/twofold.h"

#include <gtest/gtest.h>

#include <cmath>

#include "number/dyadic.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

Dyadic exact(const Twofold& t) { return Dyadic(t.value) + Dyadic(t.rest); }
Dyadic magnitude(const Dyadic& x) { return x.sign() == Sign::kNegative ? -x : x; }

/// Is |off| at most `share` of half the roundoff of |of|?
void expectSmall(const Dyadic& off, const Dyadic& of, double share, const char* what, int run) {
  const Dyadic most = magnitude(of) * Dyadic(share * kTwofoldRoundoff / 2);
  EXPECT_NE((most - magnitude(off)).sign(), Sign::kNegative) << what << ", run " << run;
}

void expectNormalized(const Twofold& t) { EXPECT_EQ(t.value + t.rest, t.value); }

class Operands {
 public:
  explicit Operands(Random random) : random_(random) {}

  /// Makes a number of ordinary size, of which the second double has many digits, few, or none.
  Twofold next() {
    const double value =
        std::ldexp(random_.between(0.5, 1), random_.below(40)) * (random_.oneIn(2) ? 1 : -1);
    const double rest = random_.oneIn(4)   ? 0
                        : random_.oneIn(3) ? std::ldexp(value, -53)
                                           : value * std::ldexp(random_.between(-1, 1), -53);
    return Twofold(value) + rest;
  }
  /// Nearly or exactly -a.
  Twofold nearlyMinus(const Twofold& a) {
    const double value = random_.oneIn(2) ? a.value : std::nextafter(a.value, 0);
    return Twofold(-value) + a.rest * random_.between(-1, 1);
  }
  [[nodiscard]] bool isRare() { return random_.oneIn(3); }

 private:
  Random random_;
};

TEST(Twofold, OperationsAreWithinTheirBounds) {
  Operands operands(Random(91));
  for (int run = 0; run < test::runs(20000); ++run) {
    const Twofold a = operands.next(),
                  b = operands.isRare() ? operands.nearlyMinus(a) : operands.next();
    const Dyadic x = exact(a), y = exact(b);
    for (const Twofold& t : {a + b, a - b, a * b, a / b}) expectNormalized(t);
    expectSmall(exact(a + b) - (x + y), x + y, 1, "sum", run);
    expectSmall(exact(a - b) - (x - y), x - y, 1, "difference", run);
    expectSmall(exact(a * b) - x * y, x * y, 1, "product", run);
    expectSmall(exact(a / b) * y - x, x, 1, "quotient", run);
    const Twofold positive = a.value > 0 ? a : -a, rooted = root(positive);
    expectNormalized(rooted);
    expectSmall(exact(rooted) * exact(rooted) - exact(positive), x, 2, "root", run);
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(Twofold, ProductsOfDoublesAreExact) {
  Operands operands(Random(92));
  for (int run = 0; run < test::runs(20000); ++run) {
    const double a = operands.next().value, b = operands.next().value;
    EXPECT_EQ((exact(productOf(a, b)) - Dyadic(a) * Dyadic(b)).sign(), Sign::kZero) << run;
  }
}

TEST(Twofold, WhatCancelsIsZero) {
  EXPECT_EQ((productOf(3, 5) + -15.0).value, 0);
  const Twofold third = Twofold(1) / 3.0;
  EXPECT_EQ((third - third).value, 0);
  EXPECT_EQ((third - third).rest, 0);
}

}  // namespace
}  // namespace apollonius::internal
