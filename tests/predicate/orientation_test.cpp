// The turn between two directions, of points almost in line and of points so close together that
// products underflow.
#include "predicate/orientation.h"

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
    ASSERT_EQ(orient2d(from, a, b), (left - right).sign()) << "run " << run;
    turns += (left - right).sign() != Sign::kZero;
  }
  EXPECT_GT(turns, test::runs(10000));
}

/// Found by a search: the two products are on both sides of the middle between two subnormal
/// numbers, but not those of the exact differences.
TEST(TurnOf, IsExactWhereProductsUnderflow) {
  struct {
    Point from, a, b;
  } const cases[] = {{{0x1.067ba7f46872fp-539, -0x1.bfbdb6f2f1eaap-540},
                      {0x1.27eb7e90c13d7p-536, 0x1.d6405c460a20bp-537},
                      {0x1.39073dec1559bp-536, 0x1.f877dafcb2592p-537}},
                     {{-0x1.31b054d8494bfp-540, -0x1.3ddd62b4db348p-540},
                      {0x1.64f93ad0b3553p-536, 0x1.643669f2ea36bp-536},
                      {0x1.33a25c4f641eep-536, 0x1.32df8b719b006p-536}},
                     {{-0x1.0f78513b86998p-542, -0x1.0e9cb4ab5987ep-539},
                      {0x1.21949c5719d5dp-537, 0x1.ccd2636c3f50fp-538},
                      {0x1.41533226282a4p-537, 0x1.0627c7852dfcep-537}}};
  for (const auto& [from, a, b] : cases) {
    const auto minus = [](double p, double q) { return Dyadic(p) - Dyadic(q); };
    const Dyadic left = minus(a.x, from.x) * minus(b.y, from.y),
                 right = minus(a.y, from.y) * minus(b.x, from.x);
    EXPECT_EQ(orient2d(from, a, b), (left - right).sign());
  }
}

}  // namespace
}  // namespace apollonius::internal
