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

/// Two points a double apart from a third, on an axis: what is lost to underflow is not zero.
TEST(VertexOfPoints, ProductsThatUnderflowAreUnknown) {
  const double low = powerOfTwo(-332), step = powerOfTwo(-384);
  const Site i{low, 0, 0}, j{low, powerOfTwo(-99), 0}, k{low + step, 0, 0}, q{low - step, 0, 0};
  ASSERT_NE(q.x, low);
  const Sign exact = stages::vertexExact(i, &j, &k, &q);
  ASSERT_NE(exact, Sign::kZero);
  const MaybeSign answer = stages::vertexOfPoints(i, &j, &k, &q);
  EXPECT_TRUE(!answer.known || answer.sign == exact);
}

/// The minors of neighbouring fractions are 1 or -1, far less than the last place of their
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

/// Calls `visit(j, k, q)` for each order of the other three.
template <class Visit>
void visitOrders(const std::array<Site, 4>& s, Visit&& visit) {
  std::array<std::size_t, 4> order{0, 1, 2, 3};
  do {
    visit(s[order[0]], s[order[1]], s[order[2]], s[order[3]]);
  } while (std::next_permutation(order.begin(), order.end()));
}

/// Corners of rectangles and trapezoids, at decimals, shifted, tiny and huge: on one circle though
/// their coordinates are rounded, and where rounding has broken the symmetry, as the exact stage
/// says.
TEST(VertexTwofold, MirrorImagesAreOnOneCircle) {
  Random random(186);
  int mirrored = 0, broken = 0;
  for (int run = 0; run < test::runs(2000); ++run) {
    const double shift = run % 3 == 0 ? 1e6 : 0,
                 scale = std::array{1.0, powerOfTwo(-300), powerOfTwo(300)}[run % 7 % 3];
    const auto number = [&] { return scale * (shift + 0.1 * random.between(0, 100)); };
    const auto decimal = [&](std::int64_t k) {
      return scale * (shift + 0.1 * static_cast<double>(k));
    };
    std::array<Site, 4> s;
    const std::int64_t a = random.integer(-50, 50), b = a + random.integer(1, 9),
                       inset = random.oneIn(3) ? 0 : random.integer(-9, 9);
    const double y = number(), z = number();
    const bool isTurned = random.oneIn(2);
    const auto place = [&](double along, double across) {
      return isTurned ? Site{across, along, 7} : Site{along, across, 7};
    };
    if (inset == 0 && random.oneIn(2)) {  // not decimals
      const double left = number(), right = number();
      s = {place(left, y), place(right, y), place(left, z), place(right, z)};
    } else {
      s = {place(decimal(a), y), place(decimal(b), y), place(decimal(a + inset), z),
           place(decimal(b - inset), z)};
    }
    const bool areDistinct = [&] {
      for (std::size_t n = 0; n < 4; ++n) {
        for (std::size_t m = 0; m < n; ++m) {
          if (s[n].x == s[m].x && s[n].y == s[m].y) return false;
        }
      }
      return true;
    }();
    if (!areDistinct) continue;
    const Sign exact = stages::vertexExact(s[0], &s[1], &s[2], &s[3]);
    ++(exact == Sign::kZero ? mirrored : broken);
    ASSERT_TRUE(exact == Sign::kZero || inset != 0);
    visitOrders(s, [&](const Site& i, const Site& j, const Site& k, const Site& q) {
      const MaybeSign answer = stages::vertexTwofold(i, &j, &k, &q);
      ASSERT_TRUE(answer.known || exact != Sign::kZero) << "run " << run;
      if (answer.known) {
        ASSERT_EQ(answer.sign, stages::vertexExact(i, &j, &k, &q)) << "run " << run;
      }
      const Site heavier{q.x, q.y, 8};
      ASSERT_FALSE(stages::vertexTwofold(i, &j, &k, &heavier).known) << "weights differ";
    });
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(mirrored, test::runs(500));
  EXPECT_GT(broken, test::runs(200));
}

/// Sums that are equal when they are rounded are not the same.
TEST(VertexTwofold, RoundedSumsAreNoMirrorImages) {
  const std::array<Site, 4> s{
      Site{1, 0, 0}, {0x1p-60, 0, 0}, {1, 1, 0}, {-0x1p-60, 1, 0}};  // nearly a rectangle
  ASSERT_EQ(s[0].x + s[1].x, s[2].x + s[3].x);
  visitOrders(s, [](const Site& i, const Site& j, const Site& k, const Site& q) {
    const Sign exact = stages::vertexExact(i, &j, &k, &q);
    ASSERT_NE(exact, Sign::kZero);
    const MaybeSign answer = stages::vertexTwofold(i, &j, &k, &q);
    ASSERT_TRUE(answer.known);
    ASSERT_EQ(answer.sign, exact);
  });
}

/// Three points on a circle that passes by the origin, and the reference site there, at the double
/// with which the exact sign changes, and a few of its last places away: 2^-106 of the others. And
/// the same answers at the ends of the range that the bound is derived for, unknown beyond.
TEST(VertexTwofold, IsRightNextToTheCircle) {
  Random random(187);
  int known = 0, unknown = 0;
  for (int run = 0; run < test::runs(2000); ++run) {
    const auto number = [&] { return random.between(-1, 1); };
    Site i{0, std::ldexp(number(), -55), 0};
    const Site j{number(), number(), 0}, k{number(), number(), 0};
    Site q{0, number(), 0};
    const bool isLine = run % 4 == 0;  // through three points
    const auto exact = [&] { return stages::vertexExact(i, &j, isLine ? nullptr : &k, &q); };
    const auto bisect = [&](double& x, double low, double high) {
      x = low;
      const Sign atLow = exact();
      x = high;
      if (exact() == atLow) return false;
      for (int step = 0; step < 300 && std::nextafter(low, high) != high; ++step) {
        x = low + (high - low) / 2;
        (exact() == atLow ? low : high) = x;
      }
      x = low;
      return true;
    };
    if (!bisect(q.x, -3, number()) || !bisect(i.x, -0x1p-48, 0x1p-48)) continue;
    const double root = i.x;
    for (const int off : {0, 1, 2, -1, -2, 5, -5, 30, -30, 200, -200, 2000, -2000}) {
      i.x = root + off * (std::nextafter(root, 9) - root);
      const Sign sign = exact();
      const MaybeSign answer = stages::vertexTwofold(i, &j, isLine ? nullptr : &k, &q);
      ++(answer.known ? known : unknown);
      ASSERT_TRUE(!answer.known || answer.sign == sign) << "run " << run << ", " << off;
      const auto scaled = [&](double scale) {
        const auto by = [scale](const Site& s) { return Site{s.x * scale, s.y * scale, 0}; };
        const Site si = by(i), sj = by(j), sk = by(k), sq = by(q);
        return stages::vertexTwofold(si, &sj, isLine ? nullptr : &sk, &sq);
      };
      for (const double scale : {powerOfTwo(-100), powerOfTwo(198)}) {
        const MaybeSign again = scaled(scale);
        ASSERT_TRUE(again.known == answer.known && again.sign == answer.sign) << "run " << run;
      }
      ASSERT_FALSE(scaled(powerOfTwo(203)).known || scaled(powerOfTwo(-201)).known);
    }
  }
  EXPECT_GT(known, test::runs(1000));
  EXPECT_GT(unknown, test::runs(1000));
}

/// Parts of differences that would be subnormal in products are no reason to be wrong.
TEST(VertexTwofold, KnowsNothingOfTinyCoordinates) {
  const double low = powerOfTwo(-332), step = powerOfTwo(-384);
  const Site i{low, 0, 0}, j{low, powerOfTwo(-99), 0}, k{low + step, 0, 0}, q{low - step, 0, 0};
  EXPECT_FALSE(stages::vertexTwofold(i, &j, &k, &q).known);
  // At the last coordinates that it knows, a minor of one unit of 2^-504.
  const double unit = powerOfTwo(-252), least = powerOfTwo(-200);
  const Site o{0, 0, 0}, a{least, least + unit, 0}, b{least + unit, least + 2 * unit, 0};
  const Sign sign = stages::vertexExact(o, &a, &b, nullptr);
  ASSERT_NE(sign, Sign::kZero);
  const MaybeSign answer = stages::vertexTwofold(o, &a, &b, nullptr);
  EXPECT_TRUE(!answer.known || answer.sign == sign);
  const Site below{std::nextafter(least, 0), least, 0};
  EXPECT_FALSE(stages::vertexTwofold(o, &a, &below, nullptr).known);
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
