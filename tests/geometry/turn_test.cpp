// The turn between two directions, of points almost in line and of points so close together that
// products underflow.
#include "geometry/turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "number/dyadic.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

TEST(TurnOf, IsExactForPointsAlmostInLine) {
  Random random(561);
  int turns = 0;
  for (int run = 0; run < test::runs(20000); ++run) {
    const double size =
        std::ldexp(1.0, run % 3 == 0 ? -530 - random.below(15) : random.below(20) - 10);
    const auto number = [&] { return size * random.between(-1, 1); };
    const Point from{number(), number()}, a{number(), number()};
    const double t = random.between(-2, 2);
    const Point b{from.x + t * (a.x - from.x), from.y + t * (a.y - from.y)};
    const auto minus = [](double p, double q) { return Dyadic(p) - Dyadic(q); };
    const Dyadic left = minus(a.x, from.x) * minus(b.y, from.y),
                 right = minus(a.y, from.y) * minus(b.x, from.x);
    ASSERT_EQ(turnOf(from, a, b), (left - right).sign()) << "run " << run;
    turns += (left - right).sign() != Sign::kZero;
  }
  EXPECT_GT(turns, test::runs(10000));
}

}  // namespace
}  // namespace apollonius::internal
