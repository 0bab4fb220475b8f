// Dyadic against an independent exact integer arithmetic (support/oracle_numbers.h), on expressions
// that cancel.
#include "number/dyadic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "number/fp.h"
#include "support/effort.h"
#include "support/oracle_numbers.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Integer;
using test::Random;

int sign(const Dyadic& x) { return static_cast<int>(x.sign()); }

/// A double of up to `bits` bits and an exponent within +-range; sometimes 0.
double randomDouble(Random& random, int bits, int range) {
  if (random.oneIn(10)) return 0;
  const auto mantissa = static_cast<double>(random.next() >> (64 - bits));
  const double value = std::ldexp(mantissa, static_cast<int>(random.integer(-range, range)));
  return random.oneIn(2) ? value : -value;
}

TEST(Dyadic, SignOfDoubles) {
  EXPECT_EQ(sign(Dyadic()), 0);
  EXPECT_EQ(sign(Dyadic(0)), 0);
  EXPECT_EQ(sign(Dyadic(-7)), -1);
  EXPECT_EQ(sign(Dyadic(0.0)), 0);
  EXPECT_EQ(sign(Dyadic(-0.0)), 0);
  EXPECT_EQ(sign(Dyadic(std::numeric_limits<double>::denorm_min())), 1);
  EXPECT_EQ(sign(Dyadic(-std::numeric_limits<double>::denorm_min())), -1);
  EXPECT_EQ(sign(Dyadic(std::numeric_limits<double>::max())), 1);
}

TEST(Dyadic, SubnormalsAreExact) {
  const double smallest = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(sign(Dyadic(3 * smallest) - Dyadic(smallest) - Dyadic(2 * smallest)), 0);
  const double smallestNormal = std::numeric_limits<double>::min();
  EXPECT_EQ(sign(Dyadic(smallestNormal) - Dyadic(smallestNormal - smallest) - Dyadic(smallest)), 0);
}

TEST(Dyadic, RingLaws) {
  Random random(11);
  for (int run = 0; run < test::runs(20000); ++run) {
    const int range = run % 2 == 0 ? 8 : 400;
    const Dyadic a(randomDouble(random, 53, range));
    const Dyadic b(randomDouble(random, 53, range));
    const Dyadic c(randomDouble(random, 53, range));
    ASSERT_EQ(sign(a - a), 0);
    ASSERT_EQ(sign((a + b) - (b + a)), 0);
    ASSERT_EQ(sign((a + b) + c - (a + (b + c))), 0);
    ASSERT_EQ(sign(a * b - b * a), 0);
    ASSERT_EQ(sign((a * b) * c - a * (b * c)), 0);
    ASSERT_EQ(sign(a * (b + c) - (a * b + a * c)), 0);
    ASSERT_EQ(sign((a + b) * (a - b) - (a * a - b * b)), 0);
    ASSERT_EQ(sign(a + -a), 0);
    ASSERT_EQ(sign(a * b), sign(a) * sign(b));
    ASSERT_EQ(sign(-a), -sign(a));
  }
}

TEST(Dyadic, SignsAgreeWithIntegerArithmetic) {
  Random random(12);
  for (int run = 0; run < test::runs(20000); ++run) {
    // a * b - c * d where c * d is close to a * b, plus a last term far below: the sign hangs on
    // the last bits.
    const int range = run % 3 == 0 ? 300 : 20;
    const double a = randomDouble(random, 26, range);
    const double b = randomDouble(random, 26, range);
    const double product = a * b;  // exact: 26 bits each
    const double other = randomDouble(random, 3, range);
    const double c = random.oneIn(2) ? std::nextafter(product, 0) : product;
    const int unit = test::lowestBit({a, b, c, other, 1.0});
    const Integer one = Integer(1) << static_cast<unsigned>(-unit);
    const Integer expected = test::scaled(a, unit) * test::scaled(b, unit) -
                             (test::scaled(c, unit) + test::scaled(other, unit)) * one;
    ASSERT_EQ(sign(Dyadic(a) * Dyadic(b) - (Dyadic(c) + Dyadic(other))), expected.sign())
        << a << " " << b << " " << c << " " << other;
  }
}

TEST(Dyadic, WideExponentsKeepTheirLowBits) {
  const Dyadic huge(1e100);
  const Dyadic tiny(1e-100);
  EXPECT_EQ(sign(huge + tiny - huge - tiny), 0);
  EXPECT_EQ(sign(huge + tiny - huge), 1);
  Dyadic power(1);
  for (int k = 0; k < 12; ++k) power = power * huge;
  EXPECT_EQ(sign((power + tiny) - power), 1);
  EXPECT_EQ(sign((power + tiny) * (power - tiny) - power * power), -1);
}

Dyadic twoToThe(int exponent) {
  Dyadic power(1);
  for (; exponent != 0; exponent -= std::clamp(exponent, -1000, 1000))
    power = power * Dyadic(std::ldexp(1, std::clamp(exponent, -1000, 1000)));
  return power;
}

TEST(Dyadic, RoundedKeepsFiftyTwoBits) {
  Random random(14);
  for (int run = 0; run < test::runs(5000); ++run) {
    const int range = run % 2 == 0 ? 8 : 400;
    const Dyadic a(randomDouble(random, 53, range));
    const Dyadic b(randomDouble(random, 53, range));
    const Dyadic x = a * a * b - b;
    const Dyadic::Rounded rounded = x.rounded();
    const Dyadic back = Dyadic(rounded.mantissa) * twoToThe(rounded.exponent);
    const Dyadic error = back - x;
    const Dyadic bound = x * x * twoToThe(-104);
    ASSERT_LE(sign(error * error - bound), 0) << run;
    ASSERT_TRUE(rounded.mantissa == 0 ||
                (absolute(rounded.mantissa) >= 0x1p62 && absolute(rounded.mantissa) <= 0x1p63));
  }
}

}  // namespace
}  // namespace apollonius::internal
