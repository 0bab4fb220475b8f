#include "number/fp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace apollonius {
namespace {

TEST(Fp, PowersOfTwoAreExact) {
  for (int exponent = -1022; exponent <= 1023; ++exponent) {
    ASSERT_EQ(powerOfTwo(exponent), std::ldexp(1.0, exponent));
    ASSERT_EQ(exponentOf(powerOfTwo(exponent)), exponent);
    ASSERT_EQ(exponentOf(-1.75 * powerOfTwo(exponent)), exponent);
  }
}

TEST(Fp, UnitRoundoffIsHalfAnUlpOfOne) {
  EXPECT_EQ(1 + kUnitRoundoff, 1.0) << "a tie, rounded to even";
  EXPECT_GT(1 + 1.5 * kUnitRoundoff, 1.0);
}

TEST(Fp, ProductsAreNotContracted) {
  // With a fused multiply-add the rounding error of the product would come out instead of 0.
  volatile double a = 1 + powerOfTwo(-30);
  const double x = a;
  const double square = x * x;
  EXPECT_EQ(x * x - square, 0.0);
}

}  // namespace
}  // namespace apollonius
