// The first filters trust a cached circle's error only: a known answer must hold for every circle
// within it. The circles are made up, so that each part of a bound is the only one that matters in
// some of them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "number/dyadic.h"
#include "predicate/bearing.h"
#include "predicate/direction.h"
#include "predicate/edge_conflict.h"
#include "predicate/hull_turn.h"
#include "predicate/vertex_conflict.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

/// An error from next to nothing to the size of the circle.
float someError(Random& random) {
  if (random.oneIn(3)) return std::numeric_limits<float>::min();
  return static_cast<float>(std::ldexp(1.0, -static_cast<int>(random.integer(-1, 54))));
}

/// A double or a few of them aside.
double aside(double x, Random& random) {
  for (std::uint64_t steps = random.below(4u); steps > 0; --steps)
    x = std::nextafter(x, random.oneIn(2) ? HUGE_VAL : -HUGE_VAL);
  return x;
}

/// The ways in which a centre and a clearance can be off by `error` together.
std::array<std::array<Dyadic, 3>, 6> within(const VoronoiCircle& circle, double error) {
  const Dyadic x(circle.x), y(circle.y), s(circle.s), e(error);
  return {
      {{x + e, y, s}, {x - e, y, s}, {x, y + e, s}, {x, y - e, s}, {x, y, s + e}, {x, y, s - e}}};
}

/// Sign of s + r - |c - q|.
Sign exactConflict(const std::array<Dyadic, 3>& circle, const Site& q) {
  const auto& [x, y, s] = circle;
  const Dyadic dx = x - Dyadic(q.x), dy = y - Dyadic(q.y), h = s + Dyadic(q.r);
  return h.sign() == Sign::kNegative ? Sign::kNegative : (h * h - dx * dx - dy * dy).sign();
}

TEST(CircleFilter, KnowsOnlyWhatHoldsForAllCirclesWithinTheError) {
  Random random(151);
  int known = 0;
  for (int run = 0; run < test::runs(100000); ++run) {
    VoronoiCircle circle{random.between(-1, 1), random.between(-1, 1), random.between(-0.2, 1), 0,
                         -1};
    circle.error = someError(random);
    // q touches the circle, up to the error, rounding, or a little of both. With the centre on an
    // axis or a diagonal from q, the difference has no errors but those of the centre.
    // As shares, roundings are largest for numbers a little above a power of two.
    const double way = random.oneIn(3)
                           ? 1 + random.between(0, 1e-3)
                           : std::ldexp(random.between(1, 2), -static_cast<int>(random.below(30u)));
    const int turn = static_cast<int>(random.below(3u));
    Site q{circle.x + (turn == 1 ? 0 : way), circle.y + (turn == 0 ? 0 : way), 0};
    const double dx = circle.x - q.x, dy = circle.y - q.y;
    const double share = random.oneIn(2) ? random.between(-2, 2) : 0;
    // The computed distance is off by a few units itself.
    const double length = std::sqrt(dx * dx + dy * dy),
                 units = random.between(-4, 4) * kUnitRoundoff * length;
    q.r = length - circle.s + (share * circle.error + units);
    const MaybeSign answer = circleFilter(circle, q);
    if (!answer.known) continue;
    ++known;
    for (const auto& exact : within(circle, circle.error)) {
      ASSERT_EQ(exactConflict(exact, q), answer.sign)
          << "run " << run << ", error " << circle.error << ", weight " << q.r;
    }
  }
  EXPECT_GT(known, test::runs(5000));
}

/// Found by searches: without room for the roundings of the squares, and once with half of it, it
/// would be wrong.
TEST(CircleFilter, KnowsNothingWhereAllRoundingsAddUp) {
  const auto expectUnknown = [](double x, double y, double s, const Site& q, Sign exact) {
    const VoronoiCircle circle{x, y, s, 0x1p-126F, -1};
    ASSERT_EQ(exactConflict(within(circle, 0)[0], q), exact);
    EXPECT_FALSE(circleFilter(circle, q).known);
  };
  expectUnknown(0x1.4c9a6f0ed0966p-2, 0, 0x1.c961e4785257ap-2,
                {-0x1.5af3f942b1036p-1, -0x1.776d7e90a4b66p-26, 0x1.1c903e8df022ep-1},
                Sign::kNegative);
  expectUnknown(0x1.8af43a3dd2d31p-10, 0x1.131a3c81bb23p-6, 0x1.358389b70518ep-1,
                {-0x1.0669da85843f8p-1, -0x1.0143fd86b2124p-1, 0x1.025602506a8aap-3},
                Sign::kPositive);
}

TEST(CircleFilter, AClearanceThatMayBeNegativeHidesNothing) {
  const VoronoiCircle vague{0, 0, 1, 1, -1};
  EXPECT_FALSE(circleFilter(vague, {0, 0, -0.5}).known) << "the clearance may be 0";
  EXPECT_FALSE(circleFilter(vague, {0, 0, -1}).known);
  const VoronoiCircle inner{0, 0, -2, 1e-9F, -1};
  const MaybeSign answer = circleFilter(inner, {0.5, 0, 1});
  EXPECT_TRUE(answer.known) << "too small to reach anything, wherever it is";
  EXPECT_EQ(answer.sign, Sign::kNegative);
}

TEST(CircleFilter, KnowsOnlyWhatHoldsForAllHalfPlanesWithinTheError) {
  Random random(152);
  int known = 0;
  for (int run = 0; run < test::runs(50000); ++run) {
    VoronoiCircle plane{random.between(-1, 1), random.between(-1, 1), random.between(-3, 3), 0, 0};
    plane.error = someError(random);
    plane.slope = someError(random);
    Site q{random.between(-1, 1), random.between(-1, 1), 0};
    const double share = random.oneIn(2) ? random.between(-4, 4) : 0;
    q.r = aside(plane.s - plane.x * q.x - plane.y * q.y +
                    share * (double{plane.error} + double{plane.slope}),
                random);
    const MaybeSign answer = circleFilter(plane, q);
    if (!answer.known) continue;
    ++known;
    for (int corner = 0; corner < 8; ++corner) {
      const auto moved = [&](double value, double error, int bit) {
        return Dyadic(value) + Dyadic((corner >> bit & 1) != 0 ? error : -error);
      };
      const Dyadic excess = moved(plane.x, plane.slope, 0) * Dyadic(q.x) +
                            moved(plane.y, plane.slope, 1) * Dyadic(q.y) + Dyadic(q.r) -
                            moved(plane.s, plane.error, 2);
      ASSERT_EQ(excess.sign(), answer.sign) << "run " << run;
    }
  }
  EXPECT_GT(known, test::runs(5000));
}

TEST(CircleBounds, AreRoundedUp) {
  Random random(157);
  for (int run = 0; run < test::runs(5000); ++run) {
    const double bound =
        std::ldexp(random.between(0.5, 1), static_cast<int>(random.integer(-200, 120)));
    EXPECT_GE(double{roundedUp(bound)}, bound);
  }
}

TEST(Direction, OfACircleStaysWithinItsBound) {
  Random random(153);
  for (int run = 0; run < test::runs(5000); ++run) {
    VoronoiCircle circle{random.between(-1, 1), random.between(-1, 1), 1, 0, -1};
    circle.error = someError(random);
    const Site reference{
        std::ldexp(random.between(-1, 1), static_cast<int>(random.integer(-20, 5))),
        random.between(-1, 1), 0.5};
    const Arrow arrow = directionOf(circle, reference);
    const Dyadic bound(arrow.error * (1 + powerOfTwo(-50)));  // it is rounded: see productBound
    for (const auto& [x, y, s] : within(circle, circle.error)) {
      for (const Dyadic& off :
           {x - Dyadic(reference.x) - Dyadic(arrow.x), y - Dyadic(reference.y) - Dyadic(arrow.y)}) {
        ASSERT_NE((off - bound).sign(), Sign::kPositive) << "run " << run;
        ASSERT_NE((off + bound).sign(), Sign::kNegative) << "run " << run;
      }
    }
  }
}

TEST(Direction, OfAHalfPlaneHasTheErrorOfItsNormal) {
  EXPECT_GE(directionOf({0.6, 0.8, 5, 0.5F, 0.25F}, {1, 2, 3}).error, 0.25);
}

/// M of isSurelyInConflictBetweenEnds, exactly, from the larger of i and j.
std::array<Dyadic, 2> middleOfShadow(const Site& reference, const Site& other, const Site& q) {
  const auto row = [&](const Site& s) {
    return std::array<Dyadic, 3>{Dyadic(s.x) - Dyadic(reference.x),
                                 Dyadic(s.y) - Dyadic(reference.y),
                                 Dyadic(s.r) - Dyadic(reference.r)};
  };
  const auto p = [](const std::array<Dyadic, 3>& d) {
    return d[0] * d[0] + d[1] * d[1] - d[2] * d[2];
  };
  const auto j = row(other), k = row(q);
  return {k[0] * p(j) - j[0] * p(k), k[1] * p(j) - j[1] * p(k)};
}

TEST(EdgeShortcut, SaysYesOnlyIfItHoldsForAllCirclesWithinTheError) {
  Random random(154);
  int known = 0;
  for (int run = 0; run < test::runs(30000); ++run) {
    const double far = random.oneIn(2) ? 0 : 1000;
    const Site i{far + random.between(-1, 1), random.between(-1, 1), 0.3},
        j{far + random.between(-1, 1), random.between(-1, 1), random.between(-0.2, 0.2)};
    // Close to j, little is left of the shadow's middle but rounding.
    const double spread =
        random.oneIn(2) ? 1 : std::ldexp(1.0, -static_cast<int>(random.below(50u)));
    const Site q{j.x + spread * random.between(-1, 1), j.y + spread * random.between(-1, 1),
                 j.r + spread * random.between(-1, 1)};
    const auto middle = middleOfShadow(i, j, q);
    const double mx = std::ldexp(middle[0].rounded().mantissa, middle[0].rounded().exponent),
                 my = std::ldexp(middle[1].rounded().mantissa, middle[1].rounded().exponent);
    const double m = std::sqrt(mx * mx + my * my);
    if (!(m > 0)) continue;
    VoronoiCircle circle{0, 0, 0, someError(random), -1};
    // Nearly at right angles to the middle: by about the error, or by rounding.
    const double way = std::ldexp(random.between(-1, 1), static_cast<int>(random.integer(-3, 3)));
    const double ahead =
        (random.oneIn(2) ? circle.error : 0x1p-52 * std::fabs(way)) * random.between(-1, 6);
    circle.x = i.x + (-my * way + mx * ahead) / m;
    circle.y = i.y + (mx * way + my * ahead) / m;
    if (!isSurelyInConflictBetweenEnds(i, j, circle, circle, q)) continue;
    ++known;
    for (const auto& [x, y, s] : within(circle, circle.error)) {
      const Dyadic dot = (x - Dyadic(i.x)) * middle[0] + (y - Dyadic(i.y)) * middle[1];
      ASSERT_EQ(dot.sign(), Sign::kPositive) << "run " << run << ", error " << circle.error;
    }
  }
  EXPECT_GT(known, test::runs(1000));
}

TEST(EdgeShortcut, SaysNothingOfUnboundedEdges) {
  const Site i{0, 0, 1}, j{4, 0, 0.5}, q{2, 0, 0};
  const VoronoiCircle ahead{2, 1, 1.2, 1e-9F, -1}, plane{0.1, 0.99, 1, 1e-9F, 1e-9F};
  EXPECT_TRUE(isSurelyInConflictBetweenEnds(i, j, ahead, ahead, q));
  EXPECT_FALSE(isSurelyInConflictBetweenEnds(i, j, plane, ahead, q));
  EXPECT_FALSE(isSurelyInConflictBetweenEnds(i, j, ahead, plane, q));
}

/// Nothing is said of sites so close together that products of their differences underflow.
TEST(EdgeShortcut, SaysNothingWhereProductsUnderflow) {
  Random random(155);
  constexpr double kUnit = powerOfTwo(-384);  // the last place of the smallest coordinates
  for (int run = 0; run < test::runs(5000); ++run) {
    const auto number = [&] {
      return powerOfTwo(-332) + kUnit * static_cast<double>(random.below(std::int64_t{1} << 40));
    };
    const Site i{number(), number(), powerOfTwo(-332) + powerOfTwo(-344)},
        j{number(), number(), number()}, q{number(), number(), number()};
    const auto middle = middleOfShadow(i, j, q);
    const Dyadic::Rounded mx = middle[0].rounded(), my = middle[1].rounded();
    const double scaledX = std::ldexp(mx.mantissa, mx.exponent + 1000),
                 scaledY = std::ldexp(my.mantissa, my.exponent + 1000);
    const double m = std::sqrt(scaledX * scaledX + scaledY * scaledY);
    if (!(m > 0)) continue;
    const double ahead = std::ldexp(random.between(-1, 1), -static_cast<int>(random.below(52u)));
    const VoronoiCircle circle{(-scaledY + scaledX * ahead) / m, (scaledX + scaledY * ahead) / m, 1,
                               0, -1};
    if (!isSurelyInConflictBetweenEnds(i, j, circle, circle, q)) continue;
    const Dyadic dot =
        (Dyadic(circle.x) - Dyadic(i.x)) * middle[0] + (Dyadic(circle.y) - Dyadic(i.y)) * middle[1];
    ASSERT_EQ(dot.sign(), Sign::kPositive) << "run " << run;
  }
}

/// A made-up end of an edge with infinity: a half-plane with this normal.
VoronoiCircle halfPlane(double x, double y, float slope) { return {x, y, 0, 1e-9F, slope}; }

Sign exactTurn(const VoronoiCircle& a, const VoronoiCircle& b) {
  return (Dyadic(a.x) * Dyadic(b.y) - Dyadic(a.y) * Dyadic(b.x)).sign();
}

/// The edges of the hull, seen from a site at the origin: is the direction of q between those of
/// the ends, which are less than half a turn apart, or more?
TEST(EdgeCircles, KnowOnlyWhatHoldsOfEdgesWithInfinity) {
  Random random(156);
  const Site i{0, 0, 1};
  int known = 0;
  for (int run = 0; run < test::runs(50000); ++run) {
    const float slope = std::numeric_limits<float>::min();
    const auto near = [&](const VoronoiCircle& c) {  // a multiple of it, up to rounding
      const double size = random.oneIn(2) ? random.between(0.5, 2) : -random.between(0.5, 2);
      return halfPlane(aside(size * c.x, random), aside(size * c.y, random), slope);
    };
    const VoronoiCircle atL = halfPlane(random.between(-1, 1), random.between(-1, 1), slope);
    const VoronoiCircle atK = random.oneIn(2)
                                  ? near(atL)
                                  : halfPlane(random.between(-1, 1), random.between(-1, 1), slope);
    const VoronoiCircle probe =
        run % 3 == 0   ? near(atL)
        : run % 3 == 1 ? near(atK)
                       : halfPlane(random.between(-1, 1), random.between(-1, 1), slope);
    const Site q{probe.x, probe.y, 0.5};
    const MaybeSign answer =
        stages::edgeCircleFilter(i, nullptr, atK, atL, q, stages::Probe::kMiddle);
    if (!answer.known) continue;
    ++known;
    const bool isBeforeK = exactTurn(probe, atK) == Sign::kPositive,
               isAfterL = exactTurn(atL, probe) == Sign::kPositive;
    const bool isLarge = exactTurn(atL, atK) == Sign::kNegative;
    ASSERT_EQ(answer.sign == Sign::kPositive,
              isLarge ? isBeforeK || isAfterL : isBeforeK && isAfterL)
        << "run " << run;
  }
  EXPECT_GT(known, test::runs(10000));
}

TEST(Bearing, AVertexThatMayBeOnEitherSideOfTheSiteSaysNothing) {
  const VoronoiCircle vague{0.25, 0, 1, 1, -1};
  for (const auto part : {stages::RayPart::kLeftwards, stages::RayPart::kAlong}) {
    EXPECT_FALSE(stages::rayCircleFilter(3, 0, vague, {0, 0, 1}, part).known);
  }
}

TEST(Hull, ANormalThatMayPointDownIsAskedExactly) {
  for (const double x : {-0x1p-60, 0x1p-60}) {
    const Site i{0, 0, 0}, j{x, -1, 0};
    for (const double estimate : {-0x1p-55, 0x1p-55}) {
      const VoronoiCircle plane{1, estimate, 0, 0x1p-50F, 0x1p-50F};
      EXPECT_EQ(pointsUp(i, j, plane), x > 0) << x << " " << estimate;
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
