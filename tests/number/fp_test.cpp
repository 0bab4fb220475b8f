#include "number/fp.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <string>

#include "apollonius/diagram.h"
#ifdef __SSE2__
#include <xmmintrin.h>
#endif

namespace apollonius::internal {
namespace {

TEST(Fp, PowersOfTwoAreExact) {
  for (int exponent = -1022; exponent <= 1023; ++exponent) {
    ASSERT_EQ(powerOfTwo(exponent), std::ldexp(1.0, exponent));
    ASSERT_EQ(exponentOf(powerOfTwo(exponent)), exponent);
    ASSERT_EQ(exponentOf(-1.75 * powerOfTwo(exponent)), exponent);
  }
}

TEST(Fp, LowestExponentIsThatOfTheLastDigit) {
  for (const int exponent : {-960, -53, 0, 31, 1000}) {
    for (int digits = 0; digits <= 52; ++digits) {
      const double x = powerOfTwo(exponent) * (digits == 0 ? 1 : 1 + powerOfTwo(-digits));
      EXPECT_EQ(lowestExponentOf(x), exponent - digits);
      EXPECT_EQ(lowestExponentOf(-x), exponent - digits);
    }
  }
  EXPECT_EQ(lowestExponentOf(0x1p-1074), -1074);
  EXPECT_EQ(lowestExponentOf(0x1.8p-1070), -1071);
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

TEST(Fp, ArithmeticIsAsAssumed) { EXPECT_STREQ(arithmeticViolation(), nullptr); }

#ifndef __wasm__  // which has one mode only
TEST(Fp, OtherDirectionsOfRoundingAreSeen) {
  for (const int direction : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    ASSERT_EQ(std::fesetround(direction), 0);
    const char* defect = arithmeticViolation();
    std::fesetround(FE_TONEAREST);
    ASSERT_NE(defect, nullptr) << direction;
    EXPECT_NE(std::string(defect).find("rounding"), std::string::npos) << defect;
  }
}
#endif

#ifdef __SSE2__
TEST(Fp, FlushedSubnormalsAreSeen) {
  constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
  const unsigned before = _mm_getcsr();
  for (const unsigned mode : {kFlushToZero, kDenormalsAreZero, kFlushToZero | kDenormalsAreZero}) {
    _mm_setcsr(before | mode);
    const char* defect = arithmeticViolation();
    _mm_setcsr(before);
    ASSERT_NE(defect, nullptr) << mode;
    EXPECT_NE(std::string(defect).find("subnormal"), std::string::npos) << defect;
  }
}

TEST(FpDeathTest, NoDiagramWithoutSubnormals) {
  EXPECT_DEATH(
      {
        _mm_setcsr(_mm_getcsr() | 0x8000);
        const Diagram diagram;
      },
      "broken invariant: subnormal numbers are flushed");
}
#endif

}  // namespace
}  // namespace apollonius::internal
