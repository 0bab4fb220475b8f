// Stages before the exact one where they come closest to being wrong: arguments made, or found by a
// search, so that one rounding, one limit or one part of a bound decides.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "number/fp.h"
#include "predicate/predicates.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

/// Four points on one circle of which two pairs are next to each other: which of them are opposite
/// is a difference in the last places of products. A rectangle turned by the angle of (3, 4): its
/// corners are integers, and on one circle.
std::array<Site, 4> rectangle(double a, double b, double unit) {
  const auto corner = [&](double along, double across) {
    return Site{unit * (3 * along - 4 * across), unit * (4 * along + 3 * across), 0};
  };
  return {corner(a, b), corner(a, -b), corner(-a, b), corner(-a, -b)};
}

void expectSameAsExact(std::array<Site, 4> corners, int run) {
  std::sort(corners.begin(), corners.end(),
            [](const Site& a, const Site& b) { return precedes(b, a); });
  const Site& i = corners[0];
  std::array<std::size_t, 3> order{1, 2, 3};
  do {
    const Site &j = corners[order[0]], &k = corners[order[1]], &q = corners[order[2]];
    ASSERT_EQ(stages::vertexDegenerate(i, &j, &k, &q),
              stages::isOppositeExact(i, &j, &k, &q, stages::FaceCorner::kReference))
        << "run " << run;
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Opposite, CornersOfThinRectangles) {
  Random random(181);
  for (int run = 0; run < test::runs(3000); ++run) {
    const double b = 0x1p28 + static_cast<double>(random.integer(0, std::int64_t{7} << 28));
    expectSameAsExact(rectangle(static_cast<double>(random.integer(1, 4)), b, 1), run);
    if (HasFatalFailure()) return;
  }
}

/// Where products of squares are subnormal, margins of a few units in the last place mean nothing.
TEST(Opposite, CornersOfTinyRectangles) {
  Random random(182);
  for (int run = 0; run < test::runs(10000); ++run) {
    const double b = 0x1p28 + static_cast<double>(random.integer(0, 1 << 28));
    expectSameAsExact(rectangle(1, b, powerOfTwo(-288 - run % 3)), run);
    if (HasFatalFailure()) return;
  }
}

/// Of two points a double apart from a third, on an axis: what is lost to underflow is not zero.
TEST(VertexOfPoints, ProductsThatUnderflowAreUnknown) {
  const double low = powerOfTwo(-332), step = powerOfTwo(-384);
  const Site i{low, 0, 0}, j{low, powerOfTwo(-99), 0}, k{low + step, 0, 0}, q{low - step, 0, 0};
  ASSERT_NE(q.x, low);
  const Sign exact = stages::vertexExact(i, &j, &k, &q);
  ASSERT_NE(exact, Sign::kZero);
  const MaybeSign answer = stages::vertexOfPoints(i, &j, &k, &q);
  EXPECT_TRUE(!answer.known || answer.sign == exact);
}

/// Of neighbouring fractions the minors are 1 or -1, far less than the last place of their
/// products: only of short numbers are they exact.
TEST(VertexOfPoints, MinorsOfLongNumbersAreRounded) {
  Random random(183);
  int known = 0;
  for (int run = 0; run < test::runs(3000); ++run) {
    double jx = 1, jy = 0, kx = 0, ky = 1;
    const double most = powerOfTwo(26 + run % 10);
    while (std::max({jx, jy, kx, ky}) < most) {  // down a Stern-Brocot tree
      const double times = static_cast<double>(random.integer(1, 9));
      if (random.oneIn(2)) {
        jx += times * kx, jy += times * ky;
      } else {
        kx += times * jx, ky += times * jy;
      }
    }
    const Site i{0, 0, 0}, j{jx, jy, 0}, k{kx, ky, 0}, q{jx - kx, jy - ky, 0};
    for (const auto& [a, b, c] : {std::array{&j, &k, &q}, {&k, &q, &j}, {&q, &j, &k}}) {
      const MaybeSign answer = stages::vertexOfPoints(i, a, b, c);
      if (!answer.known) continue;
      ++known;
      ASSERT_EQ(answer.sign, stages::vertexExact(i, a, b, c)) << "run " << run;
    }
  }
  EXPECT_GT(known, test::runs(100));
}

/// Where the exact sign changes, nothing but rounding is left of the formula's value.
TEST(VertexOfPoints, IsRightNextToTheCircle) {
  Random random(184);
  int known = 0;
  for (int run = 0; run < test::runs(3000); ++run) {
    const auto number = [&] {
      return std::ldexp(random.between(-1, 1),
                        -static_cast<int>(random.below(run % 2 == 0 ? 1u : 8u)));
    };
    const Site i{number(), number(), 0}, j{number(), number(), 0}, k{number(), number(), 0};
    const double y = number();
    const auto exactAt = [&](double x) {
      const Site q{x, y, 0};
      return stages::vertexExact(i, &j, &k, &q);
    };
    double low = -3, high = number();
    if (exactAt(low) == exactAt(high)) continue;
    const Sign atLow = exactAt(low);
    for (int step = 0; step < 80; ++step) {
      const double middle = low + (high - low) / 2;
      (exactAt(middle) == atLow ? low : high) = middle;
    }
    for (int step = 0; step < 8; ++step, low = std::nextafter(low, -9.0)) {
      const Site q{low, y, 0};
      const MaybeSign answer = stages::vertexOfPoints(i, &j, &k, &q);
      if (!answer.known) continue;
      ++known;
      ASSERT_EQ(answer.sign, exactAt(low)) << "run " << run;
    }
  }
  EXPECT_GT(known, 0);
}

/// The error of a distance to a giant is far larger than that of one to a point beside.
TEST(DistanceFilter, CountsTheErrorsOfBoth) {
  Random random(185);
  int known = 0;
  for (int run = 0; run < test::runs(3000); ++run) {
    const double giant = std::ldexp(random.between(1, 2), 20), t = random.between(-1, 1);
    const Site point{random.between(0.5, 1), random.between(-1, 1), 0},
        disc{-giant * (1 - t * t) / (1 + t * t), giant * 2 * t / (1 + t * t), giant - 1};
    double low = -0.5, high = 1.5;
    const double y = random.between(-0.5, 0.5);
    const auto exactAt = [&](double x) { return stages::distanceExact(x, y, point, disc); };
    if (exactAt(low) == exactAt(high)) continue;
    const Sign atLow = exactAt(low);
    for (int step = 0; step < 80; ++step) {
      const double middle = low + (high - low) / 2;
      (exactAt(middle) == atLow ? low : high) = middle;
    }
    for (const double off : {-0x1p-30, -0x1p-34, -0x1p-40, 0.0, 0x1p-40, 0x1p-34, 0x1p-30}) {
      for (const bool isTurned : {false, true}) {
        const Site &a = isTurned ? disc : point, &b = isTurned ? point : disc;
        const MaybeSign answer = stages::distanceFilter(low + off, y, a, b);
        if (!answer.known) continue;
        ++known;
        ASSERT_EQ(answer.sign, stages::distanceExact(low + off, y, a, b)) << "run " << run;
      }
    }
  }
  EXPECT_GT(known, test::runs(1000));
}

/// Integers of fixed width hold 117 digits: more are left to the exact stage.
TEST(FixedStages, LeaveLongRangesToTheExactOnes) {
  const Site a{0x1p60, 1, 0}, b{3, 0x1.8p-70, 0};
  EXPECT_FALSE(stages::distanceFixed(0.5, 0x1p-75, a, b).known);
  EXPECT_TRUE(stages::distanceFixed(0.5, 0.25, {0x1p50, 1, 0}, {3, 0x1.8p-60, 0}).known);
}

}  // namespace
}  // namespace apollonius::internal
