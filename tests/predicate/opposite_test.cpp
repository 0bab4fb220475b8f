// Four points on one circle of which two pairs are next to each other: which of them are opposite
// is a difference in the last places of products, for the degenerate rule's first filter.
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

/// A rectangle turned by the angle of (3, 4): its corners are integers, and on one circle.
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

/// Where products of squares are subnormal, margins of a few units in the last place are none.
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

/// Coordinates of more digits than exact minors have: flat triangles and what is next to their
/// circle.
TEST(VertexOfPoints, MinorsOfLongNumbersAreRounded) {
  Random random(183);
  int known = 0;
  for (int run = 0; run < test::runs(30000); ++run) {
    const std::int64_t most = std::int64_t{1} << (27 + run % 9);
    const auto number = [&] { return static_cast<double>(random.integer(-most, most)); };
    const Site i{number(), number(), 0}, j{number(), number(), 0};
    const auto beside = [&](double t) {
      return Site{std::round(i.x + t * (j.x - i.x)) + static_cast<double>(random.integer(-1, 1)),
                  std::round(i.y + t * (j.y - i.y)) + static_cast<double>(random.integer(-1, 1)),
                  0};
    };
    // In line, the products of a minor are equal, but not what rounding leaves of them.
    const auto inLine = [&](double t) {
      return Site{i.x + t * (j.x - i.x), i.y + t * (j.y - i.y), 0};
    };
    const Site k = run % 2 == 0 ? inLine(3) : beside(random.between(-1, 2)),
               q = run % 4 == 0 ? inLine(-5) : beside(random.between(-1, 2));
    const MaybeSign answer = stages::vertexOfPoints(i, &j, &k, &q);
    if (!answer.known) continue;
    ++known;
    ASSERT_EQ(answer.sign, stages::vertexExact(i, &j, &k, &q)) << "run " << run;
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
