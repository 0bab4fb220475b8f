// compareDistance() and isNearer() against the oracle, their laws, and their filter against their
// exact stage.
#include "predicate/distance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "number/dyadic.h"
#include "predicate/samples.h"
#include "predicate/stage_counts.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::internal {
namespace {

using namespace test;

void expectSameAsOracle(double x, double y, const Circle& a, const Circle& b) {
  const int expected = oracleCompareDistance(x, y, a, b);
  const Sign sign = compareDistance(x, y, toSite(a), toSite(b));
  ASSERT_EQ(static_cast<int>(sign), expected) << "point " << x << " " << y << "\n"
                                              << toText(insertAll({a, b}));
  ASSERT_EQ(compareDistance(x, y, toSite(b), toSite(a)), -sign) << "antisymmetric";
  const bool nearer = expected > 0 || (expected == 0 && oracleSmaller(a, b));
  ASSERT_EQ(isNearer(x, y, toSite(a), toSite(b)), nearer);
  const Sign exact = stages::distanceExact(x, y, toSite(a), toSite(b));
  for (const MaybeSign early : {stages::distanceFilter(x, y, toSite(a), toSite(b)),
                                stages::distanceMiddle(x, y, toSite(a), toSite(b)),
                                stages::distanceFixed(x, y, toSite(a), toSite(b))}) {
    if (early.known) {
      ASSERT_EQ(early.sign, exact);
    }
  }
}

TEST(Distance, AgreesWithTheOracleOnAGrid) {
  int ties = 0;
  for (int a = 0; a < 64; ++a) {
    for (int b = 0; b < 64; ++b) {
      const Circle first{a % 4 * 1.0, a / 4 % 4 * 1.0, a / 16 * 1.0};
      const Circle second{b % 4 * 1.0, b / 4 % 4 * 1.0, b / 16 * 1.0};
      for (int point = 0; point < 16; ++point) {
        const double x = point % 4, y = point / 4;
        expectSameAsOracle(x, y, first, second);
        if (HasFatalFailure()) return;
        ties += oracleCompareDistance(x, y, first, second) == 0;
      }
    }
  }
  EXPECT_GT(ties, 3000);
}

TEST(Distance, AgreesWithTheOracleOnEveryGenerator) {
  for (const NamedGenerator& generator : corpus()) {
    SCOPED_TRACE(generator.name);
    Random random(71);
    const Circles circles = generator.make(random, 20);
    for (int run = 0; run < runs(300); ++run) {
      const Circle& a = circles[random.below(circles.size())];
      const Circle& b = circles[random.below(circles.size())];
      const Circle& p = circles[random.below(circles.size())];
      // At a centre; half-way between two; with coordinates of different sites.
      const double x = run % 3 == 0 ? p.x : run % 3 == 1 ? (a.x + b.x) / 2 : a.x;
      const double y = run % 3 == 0 ? p.y : run % 3 == 1 ? (a.y + b.y) / 2 : b.y;
      expectSameAsOracle(x, y, a, b);
      if (HasFatalFailure()) return;
    }
  }
}

/// The sign of |p - c| - r - t, exactly.
Sign signOfDistanceLess(double t, double x, double y, const Site& s) {
  const Dyadic dx = Dyadic(s.x) - Dyadic(x), dy = Dyadic(s.y) - Dyadic(y),
               reach = Dyadic(t) + Dyadic(s.r), square = dx * dx + dy * dy;
  if (reach.sign() == Sign::kNegative) return Sign::kPositive;
  return (square - reach * reach).sign();
}

void expectRounded(double x, double y, const Site& s) {
  const double distance = roundedDistance(x, y, s);
  const auto describe = [&] {
    std::ostringstream text;
    text.precision(17);
    text << distance << " from " << x << " " << y << " to " << s.x << " " << s.y << " " << s.r;
    return text.str();
  };
  ASSERT_EQ(signOf(distance), signOfDistanceLess(0, x, y, s)) << describe();
  const double infinity = std::numeric_limits<double>::infinity();
  if (distance == 0) return;
  ASSERT_EQ(signOfDistanceLess(std::nextafter(distance, infinity), x, y, s), Sign::kNegative)
      << describe();
  ASSERT_EQ(signOfDistanceLess(std::nextafter(distance, -infinity), x, y, s), Sign::kPositive)
      << describe();
}

TEST(Distance, IsRoundedWithinOneUnitInTheLastPlace) {
  expectRounded(0, 0, {3e15, 4e15 + 1, 5e15});
  expectRounded(0, 0, {3, 4, 5});
  expectRounded(1, 1, {1, 1, 0});
  expectRounded(1, 1, {1, 1, -3});
  Random random(73);
  for (const NamedGenerator& generator : corpus()) {
    SCOPED_TRACE(generator.name);
    const Circles circles = generator.make(random, 20);
    for (int run = 0; run < runs(200); ++run) {
      const Circle& a = circles[random.below(circles.size())];
      const Circle& b = circles[random.below(circles.size())];
      // On the rim of a, up to rounding, towards b; a few doubles beside it; and at b's centre.
      const double way = std::hypot(b.x - a.x, b.y - a.y);
      double x = b.x, y = b.y;
      if (run % 4 != 0 && way > 0) {
        x = a.x + a.r * ((b.x - a.x) / way);
        y = a.y + a.r * ((b.y - a.y) / way);
        for (int step = random.below(5); step > 0; --step) x = std::nextafter(x, b.x);
      }
      if (!isInRange(x) || !isInRange(y)) continue;
      expectRounded(x, y, toSite(a));
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Distance, OneUlpAside) {
  const Circle a{-3, 4, 1}, b{3, 4, 1};  // the bisector is x = 0
  for (const double x : {0.0, 1e-100, -1e-100, 1e-16, -1e-17}) {
    EXPECT_EQ(static_cast<int>(compareDistance(x, 0, toSite(a), toSite(b))), x > 0   ? 1
                                                                             : x < 0 ? -1
                                                                                     : 0)
        << x;
  }
}

/// The bound holds, and not by much: errors of half of it do occur.
TEST(Distance, StaysWithinItsBound) {
  Random random(73);
  int large = 0;
  for (int run = 0; run < runs(20000); ++run) {
    const double size = std::ldexp(1.0, random.below(7) - 3);
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    const double r = random.oneIn(2) ? 0 : random.between(-1, 1);
    const Site site{size * random.between(-1, 1), size * random.between(-1, 1), r};
    const ApproxDistance distance(x, y, site);
    const Dyadic dx = Dyadic(site.x) - Dyadic(x), dy = Dyadic(site.y) - Dyadic(y);
    // The length, value + r, compared with value + r + bound: all of them are positive.
    const auto isBeyond = [&](double bound) {
      const Dyadic length = Dyadic(distance.value) + Dyadic(r);
      const Dyadic low = length - Dyadic(bound), high = length + Dyadic(bound);
      const Dyadic square = dx * dx + dy * dy;
      return (square - high * high).sign() == Sign::kPositive ||
             (low * low - square).sign() == Sign::kPositive;
    };
    if (distance.value + r < 0.01) continue;
    ASSERT_FALSE(isBeyond(distance.bound)) << "run " << run;
    large += isBeyond(distance.bound * 0.45);
  }
  EXPECT_GT(large, 0);
}

TEST(Distance, EasyComparisonsAreAnsweredByTheFilter) {
  Random random(72);
  const Circles circles = randomCircles(random, 200, Hidden::k20Percent);
  const auto before = stages::counts().distanceExact, beforeFixed = stages::counts().distanceFixed;
  for (int run = 0; run < 2000; ++run) {
    const Site a = toSite(circles[random.below(100)]);
    const Site b = toSite(circles[100 + random.below(100)]);
    (void)compareDistance(random.between(-1e6, 1e6), random.between(-1e6, 1e6), a, b);
  }
  EXPECT_EQ(stages::counts().distanceExact, before);
  EXPECT_EQ(compareDistance(0, 0, {3, 4, 0}, {5, 12, 8}), Sign::kZero);
  EXPECT_EQ(stages::counts().distanceFixed, beforeFixed + 1) << "a tie needs long integers";
  EXPECT_EQ(stages::counts().distanceExact, before);
}

}  // namespace
}  // namespace apollonius::internal
