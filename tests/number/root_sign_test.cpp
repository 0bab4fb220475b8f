// Signs of numbers with square roots against integer square roots of 200 binary places. For such
// small coefficients a value is either 0 or larger than 2^-60 (the product of its conjugates is a
// nonzero integer, and each of them is below 2^10).
#include "number/root_sign.h"

#include <gtest/gtest.h>

#include "number/dyadic.h"
#include "support/effort.h"
#include "support/oracle_numbers.h"
#include "support/random.h"

namespace apollonius {
namespace {

using test::Integer;

constexpr unsigned kPlaces = 200;

Integer root(int x) { return sqrt(Integer(Integer(x) << 2 * kPlaces)); }

/// Sign of a number given with kPlaces binary places and an error far below 2^-60.
int signOfPlaces(const Integer& value) {
  return abs(value) < (Integer(1) << (kPlaces - 60)) ? 0 : value.sign();
}

TEST(RootSign, OneRootOnAllSmallIntegers) {
  for (int c = 0; c <= 12; ++c) {
    const Integer rootC = root(c);
    for (int a = -9; a <= 9; ++a) {
      for (int b = -5; b <= 5; ++b) {
        const int expected = signOfPlaces(Integer(Integer(a) << kPlaces) + b * rootC);
        ASSERT_EQ(static_cast<int>(signOfRoot<long long>(a, b, c)), expected)
            << a << " + " << b << " sqrt " << c;
        ASSERT_EQ(static_cast<int>(signOfRoot(Dyadic(a), Dyadic(b), Dyadic(c))), expected);
      }
    }
  }
}

TEST(RootSign, TwoRootsOnAllSmallIntegers) {
  int zeros = 0;
  for (int c = 0; c <= 6; ++c) {
    for (int e = 0; e <= 6; ++e) {
      const Integer rootC = root(c);
      const Integer rootE = root(e);
      const Integer rootCE = root(c * e);
      for (int coefficients = 0; coefficients < 7 * 7 * 7 * 7; ++coefficients) {
        const int a = coefficients % 7 - 3;
        const int b = coefficients / 7 % 7 - 3;
        const int d = coefficients / 49 % 7 - 3;
        const int f = coefficients / 343 - 3;
        const int expected =
            signOfPlaces(Integer(Integer(a) << kPlaces) + b * rootC + d * rootE + f * rootCE);
        zeros += expected == 0;
        ASSERT_EQ(static_cast<int>(signOfTwoRoots<long long>(a, b, c, d, e, f)), expected)
            << a << " + " << b << " sqrt " << c << " + " << d << " sqrt " << e << " + " << f
            << " sqrt " << c * e;
      }
    }
  }
  EXPECT_GT(zeros, 1000) << "the zero cases are the point";
}

TEST(RootSign, TwoRootsOverDyadic) {
  test::Random random(21);
  for (int run = 0; run < test::runs(20000); ++run) {
    int v[6];
    for (int& value : v) value = static_cast<int>(random.integer(-4, 4));
    const int c = static_cast<int>(random.integer(0, 5)) * static_cast<int>(random.integer(0, 5));
    const int e = static_cast<int>(random.integer(0, 5)) * static_cast<int>(random.integer(0, 5));
    const auto expected = signOfTwoRoots<long long>(v[0], v[1], c, v[2], e, v[3]);
    // Numerators and roots scaled by powers of two: the sign is the same.
    const Dyadic scale(0x1p-40);
    ASSERT_EQ(
        signOfTwoRoots(Dyadic(v[0]) * scale, Dyadic(v[1]), Dyadic(c) * scale * scale, Dyadic(v[2]),
                       Dyadic(e) * scale * scale, Dyadic(v[3]) * Dyadic(0x1p40)),
        expected);
  }
}

TEST(RootSign, NearlyEqualNumbers) {
  // a - sqrt(a^2 - 1), a - sqrt(a^2), a - sqrt(a^2 + 1) for large a.
  for (const double a : {1e3, 1e8, 1e15, 1e100}) {
    const Dyadic x(a);
    const Dyadic square = x * x;
    EXPECT_EQ(signOfRoot(x, Dyadic(-1), square - Dyadic(1)), Sign::kPositive);
    EXPECT_EQ(signOfRoot(x, Dyadic(-1), square), Sign::kZero);
    EXPECT_EQ(signOfRoot(x, Dyadic(-1), square + Dyadic(1)), Sign::kNegative);
    // sqrt(a) + sqrt(a + 2) < 2 sqrt(a + 1)
    EXPECT_EQ(
        signOfSum(
            Sign::kPositive, Sign::kNegative,
            [&] { return signOfRoot(Dyadic(-2) * x - Dyadic(2), Dyadic(2), x * (x + Dyadic(2))); }),
        Sign::kNegative);
  }
}

}  // namespace
}  // namespace apollonius
