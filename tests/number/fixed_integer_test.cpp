// FixedInteger against cpp_int: the same sums, differences, products and signs, over all sizes that
// formulas reach.
#include "number/fixed_integer.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using boost::multiprecision::cpp_int;
using test::Random;

struct Both {
  FixedInteger fixed;
  cpp_int integer;
};

Both inUnits(double value, int unit) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  cpp_int integer = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
  const int shift = exponent - 53 - unit;
  if (shift >= 0) integer <<= static_cast<unsigned>(shift);
  if (shift < 0) integer /= cpp_int(1) << static_cast<unsigned>(-shift);
  return {FixedInteger::inUnits(value, unit), integer};
}

Sign signOfInteger(const cpp_int& x) {
  return x > 0 ? Sign::kPositive : x < 0 ? Sign::kNegative : Sign::kZero;
}

void expectSame(const Both& both) { ASSERT_EQ(both.fixed.sign(), signOfInteger(both.integer)); }

/// An input of at most `bits` bits, often with few digits, sometimes zero.
Both randomInput(Random& random, int bits) {
  if (random.oneIn(10)) return {FixedInteger(0), 0};
  const int digits = static_cast<int>(random.integer(1, std::min(bits, 53)));
  const double mantissa =
      static_cast<double>(random.below(std::uint64_t{1} << digits)) * (random.oneIn(2) ? 1 : -1);
  const int unit = static_cast<int>(random.integer(-1060, 800));
  return inUnits(std::ldexp(mantissa, unit + static_cast<int>(random.integer(0, bits - digits))),
                 unit);
}

TEST(FixedInteger, SignsOfSmallNumbers) {
  for (int a = -3; a <= 3; ++a) {
    EXPECT_EQ(FixedInteger(a).sign(), signOf(a));
    for (int b = -3; b <= 3; ++b) {
      EXPECT_EQ((FixedInteger(a) + FixedInteger(b)).sign(), signOf(a + b)) << a << " " << b;
      EXPECT_EQ((FixedInteger(a) - FixedInteger(b)).sign(), signOf(a - b)) << a << " " << b;
      EXPECT_EQ((FixedInteger(a) * FixedInteger(b)).sign(), signOf(a * b)) << a << " " << b;
    }
  }
}

TEST(FixedInteger, InputsAreExact) {
  Random random(11);
  for (int run = 0; run < test::runs(2000); ++run) {
    const Both a = randomInput(random, FixedInteger::kInputBits);
    expectSame(a);
    // a's digits, by comparison with the same number built from its halves.
    cpp_int rest = abs(a.integer);
    FixedInteger built(0), power(1);
    while (rest > 0) {
      if ((rest & 1) != 0) built = built + power;
      power = power + power;
      rest >>= 1;
    }
    EXPECT_EQ((a.integer < 0 ? built + a.fixed : built - a.fixed).sign(), Sign::kZero) << a.integer;
  }
}

TEST(FixedInteger, FormulasOfAllDegreesAgree) {
  Random random(12);
  for (int run = 0; run < test::runs(3000); ++run) {
    const int bits = static_cast<int>(random.integer(1, FixedInteger::kInputBits));
    std::vector<Both> numbers;
    for (int k = 0; k < 4; ++k) numbers.push_back(randomInput(random, bits));
    std::vector<int> degrees(4, 1);
    for (int step = 0; step < 12; ++step) {
      const std::size_t i = random.below(numbers.size()), j = random.below(numbers.size());
      const Both &a = numbers[i], &b = numbers[j];
      if (random.oneIn(2) && degrees[i] + degrees[j] <= 12) {
        numbers.push_back({a.fixed * b.fixed, a.integer * b.integer});
        degrees.push_back(degrees[i] + degrees[j]);
      } else if (random.oneIn(2)) {
        numbers.push_back({a.fixed + b.fixed, a.integer + b.integer});
        degrees.push_back(std::max(degrees[i], degrees[j]));
      } else {
        numbers.push_back({a.fixed - b.fixed, a.integer - b.integer});
        degrees.push_back(std::max(degrees[i], degrees[j]));
      }
      expectSame(numbers.back());
    }
    // Signs alone would miss wrong digits: differences of equal values must vanish.
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        ASSERT_EQ((numbers[i].fixed - numbers[j].fixed).sign(),
                  signOfInteger(numbers[i].integer - numbers[j].integer));
      }
    }
    const Both &a = numbers[0], &b = numbers[1];
    ASSERT_EQ(((a.fixed + b.fixed) * (a.fixed - b.fixed) - (a.fixed * a.fixed - b.fixed * b.fixed))
                  .sign(),
              Sign::kZero);
  }
}

TEST(FixedInteger, LargestProducts) {
  const double largest =
      std::ldexp(static_cast<double>((std::uint64_t{1} << 53) - 1), FixedInteger::kInputBits - 53);
  FixedInteger product(1);
  cpp_int expected = 1, one = inUnits(largest, 0).integer;
  for (int degree = 1; degree <= 12; ++degree) {
    product = product * FixedInteger::inUnits(largest, 0);
    expected *= one;
  }
  FixedInteger sum = product;
  for (int k = 0; k < 8; ++k) sum = sum + sum;
  EXPECT_EQ(sum.sign(), Sign::kPositive);
  for (int k = 0; k < 256; ++k) sum = sum - product;
  EXPECT_EQ(sum.sign(), Sign::kZero);
}

TEST(FixedInteger, IsAssignedToItself) {
  FixedInteger x = FixedInteger::inUnits(-3 * 0x1p80, 0);
  const FixedInteger& same = x;
  x = same;
  EXPECT_EQ((x + FixedInteger::inUnits(3 * 0x1p80, 0)).sign(), Sign::kZero);
}

}  // namespace
}  // namespace apollonius::internal
