// Signs of numbers with square roots against integer square roots of 200 binary places. For such
// small coefficients a value is either 0 or larger than 2^-60 (the product of its conjugates is a
// nonzero integer, and each of them is below 2^10).
#include "number/root_sign.h"

#include <gtest/gtest.h>

#include "number/dyadic.h"
#include "support/effort.h"
#include "support/oracle_numbers.h"
#include "support/random.h"

namespace apollonius::internal {
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

TEST(RootSign, DifferencesOfRootsOfAllSmallIntegers) {
  int zeros = 0;
  for (int c = 0; c <= 40; ++c) {
    for (int e = 0; e <= 40; ++e) {
      for (int a = -8; a <= 8; ++a) {
        const int expected = signOfPlaces(Integer(Integer(a) << kPlaces) + root(c) - root(e));
        zeros += expected == 0;
        ASSERT_EQ(static_cast<int>(signOfRootDifference<long long>(a, c, e)), expected)
            << a << " + sqrt " << c << " - sqrt " << e;
      }
    }
  }
  EXPECT_GT(zeros, 60) << "the zero cases are the point";
}

TEST(RootSign, DifferencesOfRootsOverDyadic) {
  test::Random random(21);
  for (int run = 0; run < test::runs(20000); ++run) {
    const int a = static_cast<int>(random.integer(-8, 8));
    const int c = static_cast<int>(random.integer(0, 8)) * static_cast<int>(random.integer(0, 8));
    const int e = static_cast<int>(random.integer(0, 8)) * static_cast<int>(random.integer(0, 8));
    // Scaled by a power of two: the sign is the same.
    const Dyadic scale(0x1p-40);
    ASSERT_EQ(signOfRootDifference(Dyadic(a) * scale, Dyadic(c) * scale * scale,
                                   Dyadic(e) * scale * scale),
              signOfRootDifference<long long>(a, c, e));
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
}  // namespace apollonius::internal
