// Ball: the exact result of each operation lies within the bound, also when the arguments were
// inexact.
#include "number/ball.h"

#include <gtest/gtest.h>

#include <cmath>

#include "number/dyadic.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

/// Is the exact number `numerator / denominator` (denominator > 0) within the ball?
bool contains(const Ball& ball, const Dyadic& numerator, const Dyadic& denominator = Dyadic(1)) {
  if (!(ball.bound() <= 1e300)) return true;  // says that it knows nothing
  const Dyadic error = Dyadic(ball.value()) * denominator - numerator;
  const Dyadic bound = Dyadic(ball.bound()) * denominator;
  return (error - bound).sign() != Sign::kPositive && (error + bound).sign() != Sign::kNegative;
}

double randomNumber(Random& random) {
  const double value =
      std::ldexp(random.between(0.5, 1), static_cast<int>(random.integer(-60, 60)));
  return random.oneIn(2) ? value : -value;
}

/// A ball about a rounded value together with an exact number inside it.
struct Inexact {
  Ball ball;
  Dyadic exact;
  static Inexact random(Random& random) {
    const double value = randomNumber(random);
    const double error =
        random.oneIn(3)
            ? 0
            : absolute(value) * std::ldexp(1.0, static_cast<int>(random.integer(-55, -1)));
    return {Ball::bounded(value, error),
            Dyadic(value) + Dyadic(error) * Dyadic(random.between(-1, 1))};
  }
};

bool isCertainlyPositive(const Ball& ball) { return ball.value() > ball.bound(); }

TEST(Ball, OperationsContainTheExactResult) {
  Random random(41);
  for (int run = 0; run < test::runs(20000); ++run) {
    const Inexact a = Inexact::random(random);
    const Inexact b = Inexact::random(random);
    ASSERT_TRUE(contains(a.ball + b.ball, a.exact + b.exact)) << run;
    ASSERT_TRUE(contains(a.ball - b.ball, a.exact - b.exact)) << run;
    ASSERT_TRUE(contains(a.ball * b.ball, a.exact * b.exact)) << run;
    const int sign = static_cast<int>(b.exact.sign());
    ASSERT_TRUE(contains(a.ball / b.ball, a.exact * Dyadic(sign), b.exact * Dyadic(sign))) << run;
  }
}

TEST(Ball, RootContainsTheExactRoot) {
  Random random(42);
  for (int run = 0; run < test::runs(20000); ++run) {
    Inexact a = Inexact::random(random);
    if (a.exact.sign() != Sign::kPositive || a.ball.value() < 0) continue;
    const Ball root = sqrt(a.ball);
    if (!(root.bound() <= 1e300)) continue;
    const Dyadic low = Dyadic(root.value()) - Dyadic(root.bound());
    const Dyadic high = Dyadic(root.value()) + Dyadic(root.bound());
    ASSERT_NE((high * high - a.exact).sign(), Sign::kNegative) << run;
    if (low.sign() == Sign::kPositive) {
      ASSERT_NE((low * low - a.exact).sign(), Sign::kPositive) << run;
    }
  }
}

TEST(Ball, NothingIsKnownAfterDivisionByZeroOrRootOfNegative) {
  const Ball nothing[] = {Ball::exact(1) / Ball::bounded(0.5, 1), sqrt(Ball::bounded(0.5, 1)),
                          sqrt(Ball::exact(-1)), Ball::exact(1e300) * Ball::exact(1e300)};
  for (const Ball& ball : nothing) {
    EXPECT_FALSE(ball.bound() <= 1e300);
    EXPECT_FALSE(isCertainlyPositive(ball));
    EXPECT_FALSE(isCertainlyPositive(Ball(0) - ball));
  }
}

TEST(Ball, UnderflowStaysWithinTheBound) {
  const Ball small = Ball::exact(0x1.8p-600);
  const Dyadic exact(0x1.8p-600);
  EXPECT_EQ((small * small).value(), 0);
  EXPECT_TRUE(contains(small * small, exact * exact));
  EXPECT_FALSE((small * small).bound() > 1e-200);
}

TEST(Ball, CertainlyPositiveMeansPositive) {
  EXPECT_TRUE(isCertainlyPositive(Ball::exact(1e-300)));
  EXPECT_FALSE(isCertainlyPositive(Ball::exact(0)));
  EXPECT_FALSE(isCertainlyPositive(Ball::bounded(1, 1)));
  EXPECT_TRUE(isCertainlyPositive(Ball::bounded(1, 0.99)));
}

}  // namespace
}  // namespace apollonius::internal
