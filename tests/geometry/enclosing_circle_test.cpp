// The smallest circle around all circles, and the circle whose far side is farthest, against what
// defines them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "apollonius/diagram.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"

namespace apollonius::test {
namespace {

double farSide(const Circle& c, double x, double y) { return std::hypot(c.x - x, c.y - y) + c.r; }

double farthestSide(const Circles& circles, double x, double y) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Circle& c : circles) most = std::max(most, farSide(c, x, y));
  return most;
}

double sizeOf(const Circles& circles) {
  double size = 0;
  for (const Circle& c : circles)
    size = std::max({size, std::abs(c.x), std::abs(c.y), std::abs(c.r)});
  return size;
}

EnclosingCircle around(const Diagram& diagram) {
  EnclosingCircle circle;
  EXPECT_EQ(diagram.enclosingCircle(circle), Error::kNone);
  return circle;
}

/// It holds all circles, those that touch it do, and no shift of its centre comes closer to all of
/// these.
void expectSmallest(const Diagram& diagram, const Circles& circles) {
  const EnclosingCircle found = around(diagram);
  const double rounding = 1e-14 * (sizeOf(circles) + std::abs(found.r));
  EXPECT_NEAR(farthestSide(circles, found.x, found.y), found.r, rounding);
  ASSERT_FALSE(found.sites.empty());
  EXPECT_TRUE(std::is_sorted(found.sites.begin(), found.sites.end()));
  for (const SiteId id : found.sites)
    EXPECT_NEAR(farSide(circles[id], found.x, found.y), found.r, rounding);
  for (int k = 0; k < 40; ++k) {
    const double ux = std::cos(0.157 * k), uy = std::sin(0.157 * k);
    double least = std::numeric_limits<double>::infinity();
    for (const SiteId id : found.sites) {
      const Circle& c = circles[id];
      least = std::min(least, (c.x - found.x) * ux + (c.y - found.y) * uy);
    }
    EXPECT_LE(least, rounding);
  }
}

/// Expects equal bits from the circles in another order, inserted one by one.
void expectSameAfterAnotherHistory(const Diagram& diagram, const Circles& circles, Random& random) {
  std::vector<SiteId> order(circles.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<SiteId>(k);
  random.shuffle(order);
  Diagram other;
  for (const SiteId k : order) {
    SiteId id = 0;
    ASSERT_EQ(other.insert(circles[k].x, circles[k].y, circles[k].r, id), Error::kNone);
  }
  const EnclosingCircle expected = around(diagram), found = around(other);
  EXPECT_EQ(found.x, expected.x);
  EXPECT_EQ(found.y, expected.y);
  EXPECT_EQ(found.r, expected.r);
  EXPECT_EQ(found.sites.size(), expected.sites.size());
}

class EnclosingCircles : public testing::TestWithParam<NamedGenerator> {};

TEST_P(EnclosingCircles, AreTheSmallest) {
  Random random(61);
  for (int run = 0; run < runs(sized(60, 2000)); ++run) {
    SCOPED_TRACE(run);
    const Circles circles = GetParam().make(random, 1 + random.below(std::size_t{30}));
    Diagram diagram;
    insertInto(diagram, circles);
    expectSmallest(diagram, circles);
    expectSameAfterAnotherHistory(diagram, circles, random);
    if (HasFailure()) return;
  }
}

TEST_P(EnclosingCircles, FarthestSides) {
  Random random(62);
  for (int run = 0; run < runs(sized(20, 500)); ++run) {
    SCOPED_TRACE(run);
    const Circles circles = GetParam().make(random, 1 + random.below(std::size_t{30}));
    Diagram diagram;
    insertInto(diagram, circles);
    const double size = sizeOf(circles);
    for (int k = 0; k < 8; ++k) {
      const double x = random.between(-size, size), y = random.between(-size, size);
      SiteId id = 0;
      double distance = 0;
      const Error error = diagram.farthest(x, y, id, distance);
      if (error == Error::kOutOfRange) continue;
      ASSERT_EQ(error, Error::kNone);
      const double most = farthestSide(circles, x, y), rounding = 1e-14 * (size + std::abs(most));
      EXPECT_NEAR(distance, most, rounding);
      EXPECT_NEAR(farSide(circles[id], x, y), most, rounding);
    }
    if (HasFailure()) return;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, EnclosingCircles, testing::ValuesIn(corpus()),
                         [](const auto& tested) { return tested.param.name; });

// All of them touch the circle about the origin with radius 40 000: which three determine it must
// not tell in the last places.
TEST(EnclosingCircle, OfCirclesThatTouchOneCircle) {
  constexpr int kTriples[][3] = {{3, 4, 5},   {4, 3, 5},     {-5, 12, 13}, {-12, 5, 13},
                                 {8, 15, 17}, {-15, -8, 17}, {7, -24, 25}, {-20, -21, 29},
                                 {5, 0, 5},   {-5, 0, 5},    {0, 5, 5},    {0, -5, 5}};
  Random random(63);
  for (int run = 0; run < runs(sized(300, 5000)); ++run) {
    SCOPED_TRACE(run);
    Circles circles;
    for (std::size_t n = 2 + random.below(std::size_t{12}); n > 0; --n) {
      const auto& [x, y, length] = kTriples[random.below(std::size(kTriples))];
      const double times = static_cast<double>(random.integer(1, 500));
      circles.push_back({x * times, y * times, 40000 - length * times});
    }
    Diagram diagram;
    insertInto(diagram, circles);
    expectSmallest(diagram, circles);
    expectSameAfterAnotherHistory(diagram, circles, random);
    if (HasFailure()) return;
  }
}

TEST(EnclosingCircle, OfNone) {
  EnclosingCircle circle{1, 2, 3, {4}};
  EXPECT_EQ(Diagram().enclosingCircle(circle), Error::kNone);
  EXPECT_TRUE(circle.sites.empty());
  EXPECT_EQ(circle.r, -std::numeric_limits<double>::infinity());
  SiteId id = 0;
  double distance = 0;
  EXPECT_EQ(Diagram().farthest(0, 0, id, distance), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  EXPECT_EQ(Diagram().farthest(NAN, 0, id, distance), Error::kNotFinite);
}

}  // namespace
}  // namespace apollonius::test
