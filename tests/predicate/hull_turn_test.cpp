// How far the outer normal turns at a site of the hull. Would catch a full turn taken for none, as
// for a point on the rim of a circle.
#include "predicate/hull_turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "predicate/compute_circle.h"
#include "predicate/covers.h"
#include "support/effort.h"
#include "support/generators.h"

namespace apollonius::test {

using namespace internal;
namespace {

Sign hullTurn(const Site& i, const Site& l, const Site& k) {
  return turnOfHull(i, l, k, voronoiCircle(&i, &l, nullptr), voronoiCircle(&k, &i, nullptr));
}

/// Outer normal of the half-plane that touches a and b, with the hull to the left of the way from a
/// to b.
Direction normalOf(const Site& a, const Site& b) {
  // n · (b - a) = ra - rb, and n is to the right of the way.
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y, along = (a.r - b.r) / square;
  const double across = std::sqrt(square - (a.r - b.r) * (a.r - b.r)) / square;
  return {along * x + across * y, along * y - across * x};
}

TEST(HullTurn, IsThatOfTheNormals) {
  Random random(131);
  for (int run = 0; run < runs(3000); ++run) {
    const Circles c = randomCircles(random, 3, Hidden::k20Percent);
    const Site l{c[0].x, c[0].y, c[0].r}, i{c[1].x, c[1].y, c[1].r}, k{c[2].x, c[2].y, c[2].r};
    if (covers(l, i) || covers(i, l) || covers(k, i) || covers(i, k)) continue;
    const Direction from = normalOf(l, i), to = normalOf(i, k);
    const double sine = from.x * to.y - from.y * to.x;
    if (std::abs(sine) < 1e-9) continue;
    EXPECT_EQ(hullTurn(i, l, k), signOf(sine)) << "run " << run;
  }
}

TEST(HullTurn, AtTwoSites) {
  const Site large{0, 0, .5}, point{.3, .4, 0}, equal{7, 1, .5};
  EXPECT_EQ(hullTurn(large, point, point), Sign::kNegative) << "nearly a full turn";
  EXPECT_EQ(hullTurn(point, large, large), Sign::kPositive) << "nearly none";
  EXPECT_EQ(hullTurn(large, equal, equal), Sign::kZero) << "half a turn";
}

}  // namespace
}  // namespace apollonius::test
