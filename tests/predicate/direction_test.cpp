// Turns between inexact directions: a known answer must hold for every exact direction within the
// bounds.
#include "predicate/direction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "number/dyadic.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

Sign exactTurn(const Dyadic& ax, const Dyadic& ay, const Dyadic& bx, const Dyadic& by) {
  return (ax * by - ay * bx).sign();
}

/// Checks the corners of both boxes of uncertainty: the turn is linear in each component.
void expectRight(const Arrow& a, const Arrow& b) {
  const MaybeSign answer = turn(a, b);
  if (!answer.known) return;
  for (int corner = 0; corner < 16; ++corner) {
    const auto moved = [&](double value, double error, int bit) {
      return Dyadic(value) + Dyadic((corner >> bit & 1) != 0 ? error : -error);
    };
    ASSERT_EQ(exactTurn(moved(a.x, a.error, 0), moved(a.y, a.error, 1), moved(b.x, b.error, 2),
                        moved(b.y, b.error, 3)),
              answer.sign)
        << a.x << " " << a.y << " " << b.x << " " << b.y;
  }
}

TEST(Turn, NearlyParallelArrows) {
  Random random(121);
  int known = 0;
  for (int run = 0; run < test::runs(50000); ++run) {
    const double x = random.between(-1, 1);
    const Arrow a{x, random.between(-1, 1),
                  run % 2 == 0 ? 0 : std::ldexp(1.0, -1 - random.below(run % 5 == 0 ? 3 : 70))};
    // A multiple of a, rounded and moved by a few ulps: the turn is about as large as its rounding
    // errors.
    const double length =
        std::ldexp(random.between(1, 2), random.below(40) - 20) * (random.oneIn(2) ? 1 : -1);
    const double bend = std::ldexp(random.between(-1, 1), -random.below(run % 5 == 0 ? 3 : 58));
    Arrow b{a.x * length - a.y * length * bend, a.y * length + a.x * length * bend, 0};
    if (run % 3 == 0)
      b.error = std::abs(length) * std::ldexp(1.0, -1 - random.below(run % 5 == 0 ? 3 : 70));
    known += turn(a, b).known;
    expectRight(a, b);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(known, test::runs(10000));
}

TEST(Turn, KnowsWhatIsClear) {
  const Arrow east{1, 0, 1e-6}, north{0, 1e10, 1e3}, west{-1, 0, 1e-6};
  EXPECT_TRUE(turn(east, north).known);
  EXPECT_EQ(turn(east, north).sign, Sign::kPositive);
  EXPECT_EQ(turn(north, east).sign, Sign::kNegative);
  EXPECT_FALSE(turn(east, east).known);
  EXPECT_FALSE(turn(east, west).known);
}

TEST(Turn, KnowsNothingOfTheUnknown) {
  const double infinity = HUGE_VAL;
  for (const Arrow& bad : {Arrow{infinity, 1, 0}, Arrow{1, 0, infinity}, Arrow{std::nan(""), 1, 0},
                           Arrow{1e200, 1e200, std::nan("")}}) {
    EXPECT_FALSE(turn(bad, {0, 1, 0}).known);
    EXPECT_FALSE(turn({1, -1, 0}, bad).known);
  }
  EXPECT_FALSE(turn({1e-200, 0, 0}, {0, 1e-200, 0}).known) << "too close to underflow";
}

TEST(Turn, KnowsNothingWhereProductsUnderflow) {
  Random random(123);
  for (int run = 0; run < test::runs(5000); ++run) {
    const double size = std::ldexp(1.0, -520 - random.below(20)),
                 bend = std::ldexp(random.between(-1, 1), -random.below(40));
    const Arrow a{size * random.between(-1, 1), size * random.between(-1, 1),
                  std::ldexp(size, -random.below(30))};
    expectRight(a, {a.x - bend * a.y, a.y + bend * a.x, 0});
    if (HasFatalFailure()) return;
  }
}

TEST(Turn, OfLessThanAQuarterIsCertain) {
  Random random(124);
  int known = 0;
  for (int run = 0; run < test::runs(20000); ++run) {
    const double error = run % 2 == 0 ? 0 : std::ldexp(1.0, -1 - random.below(60));
    const Arrow a{random.between(-1, 1), random.between(-1, 1), error};
    const double bend = std::ldexp(random.between(-1, 1), -random.below(58));
    const Arrow b{-a.y + bend * a.x, a.x + bend * a.y,
                  run % 3 == 0 ? error : 0};  // nearly at right angles
    if (!differByLessThanAQuarter(a, b)) continue;
    ++known;
    for (int corner = 0; corner < 16; ++corner) {
      const auto moved = [&](double value, double bound, int bit) {
        return Dyadic(value) + Dyadic((corner >> bit & 1) != 0 ? bound : -bound);
      };
      const Dyadic dot = moved(a.x, a.error, 0) * moved(b.x, b.error, 2) +
                         moved(a.y, a.error, 1) * moved(b.y, b.error, 3);
      ASSERT_EQ(dot.sign(), Sign::kPositive) << "run " << run;
    }
  }
  EXPECT_GT(known, test::runs(1000));
}

TEST(Direction, OfAPointStaysWithinItsBound) {
  Random random(122);
  for (int run = 0; run < test::runs(5000); ++run) {
    const double px = random.between(-1, 1);
    const Site reference{
        random.oneIn(2) ? px + random.between(-1, 1) * 1e-10 : random.between(-1e6, 1e6),
        random.between(-1, 1), 0};
    const double py = random.between(-1, 1);
    const Arrow arrow = directionOf(px, py, reference);
    for (const Dyadic& error : {Dyadic(px) - Dyadic(reference.x) - Dyadic(arrow.x),
                                Dyadic(py) - Dyadic(reference.y) - Dyadic(arrow.y)}) {
      ASSERT_LE(static_cast<int>((error - Dyadic(arrow.error)).sign()), 0);
      ASSERT_GE(static_cast<int>((error + Dyadic(arrow.error)).sign()), 0);
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
