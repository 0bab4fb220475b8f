// kNearest() and within() against the oracle: all sites, hidden ones too, in exact order, boundary
// included.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/oracle.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

bool same(const Circle& a, const Circle& b) { return a.x == b.x && a.y == b.y && a.r == b.r; }

/// Is a before b in the order of distance to (x, y), ties to the larger circle? Identical circles
/// are equivalent.
bool isBefore(double x, double y, const Circle& a, const Circle& b) {
  const int sign = oracleCompareDistance(x, y, a, b);
  return sign < 0 || (sign == 0 && oracleSmaller(b, a));
}

bool inRange(double v) {
  return v == 0 || (std::abs(v) >= kSmallestMagnitude && std::abs(v) <= kLargestMagnitude);
}

/// A point where it is hard: a centre, a midpoint, mixed coordinates of two sites, a rim, or
/// anywhere.
Circle hardPoint(Random& random, const Circles& circles, int kind) {
  const Circle& a = circles[random.below(circles.size())];
  const Circle& b = circles[random.below(circles.size())];
  Circle p{a.x, a.y, 0};
  switch (kind % 5) {
    case 0:
      break;
    case 1:
      p.x = (a.x + b.x) / 2, p.y = (a.y + b.y) / 2;
      break;
    case 2:
      p.y = b.y;
      break;
    case 3:
      p.x = a.x + a.r;
      break;
    default:
      p.x = 2 * a.x - b.x, p.y = b.y + b.r;
      break;
  }
  return inRange(p.x) && inRange(p.y) ? p : a;
}

class Fixture {
 public:
  explicit Fixture(const Circles& circles, Random& random) : circles_(circles) {
    insertInto(diagram_, circles);
    // Some of the sites have come and gone, and some have been hidden and revived.
    for (std::size_t k = 0; k < circles.size() / 4; ++k) {
      const auto id = static_cast<SiteId>(random.below(circles.size()));
      EXPECT_EQ(diagram_.update(id, circles[id].x, circles[id].y, circles[id].r + 1), Error::kNone);
      EXPECT_EQ(diagram_.update(id, circles[id].x, circles[id].y, circles[id].r), Error::kNone);
    }
  }

  void check(double x, double y, std::size_t k, double distance) {
    std::vector<SiteId> expected(circles_.size());
    std::iota(expected.begin(), expected.end(), SiteId{0});
    std::stable_sort(expected.begin(), expected.end(),
                     [&](SiteId a, SiteId b) { return isBefore(x, y, circles_[a], circles_[b]); });
    std::vector<SiteId> all, some, close;
    ASSERT_EQ(diagram_.kNearest(x, y, circles_.size() + 1, all), Error::kNone);
    ASSERT_EQ(all.size(), circles_.size()) << "every site once";
    for (std::size_t i = 0; i < all.size(); ++i)
      ASSERT_TRUE(same(circles_[all[i]], circles_[expected[i]])) << "rank " << i;
    std::vector<SiteId> sorted = all;
    std::sort(sorted.begin(), sorted.end());
    ASSERT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end());
    SiteId nearest = kNoSite;
    double rounded = 0;
    ASSERT_EQ(diagram_.find(x, y, nearest, rounded), Error::kNone);
    ASSERT_EQ(all.front(), nearest);

    ASSERT_EQ(diagram_.kNearest(x, y, k, some), Error::kNone);
    ASSERT_EQ(some, std::vector<SiteId>(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(
                                                                       std::min(k, all.size()))));

    const Circle limit{x, y, -distance};
    const auto end = std::find_if(all.begin(), all.end(), [&](SiteId id) {
      return oracleCompareDistance(x, y, circles_[id], limit) > 0;
    });
    ASSERT_EQ(diagram_.within(x, y, distance, close), Error::kNone);
    ASSERT_EQ(close, std::vector<SiteId>(all.begin(), end)) << "distance " << distance;
    checkFind(x, y, distance, close.empty() ? kNoSite : nearest);
  }

  void checkFind(double x, double y, double maxDistance, SiteId expected) {
    SiteId alone = 0, found = 0, one[1] = {};
    double distance = 0, far[1] = {};
    ASSERT_EQ(diagram_.find(x, y, maxDistance, alone), Error::kNone);
    ASSERT_EQ(alone, expected) << "within " << maxDistance;
    ASSERT_EQ(diagram_.find(x, y, maxDistance, found, distance), Error::kNone);
    ASSERT_EQ(found, expected);
    const double point[] = {x, y};
    ASSERT_EQ(diagram_.findMany(point, maxDistance, one, far), Error::kNone);
    ASSERT_EQ(one[0], expected);
    ASSERT_EQ(far[0], distance);
    ASSERT_EQ(std::isinf(distance), expected == kNoSite);
  }

  void checkAtHardPoints(Random& random, int points) {
    for (int k = 0; k < points; ++k) {
      const Circle p = hardPoint(random, circles_, k);
      // A distance that some site has exactly, if doubles can tell it, and sometimes 0.
      const Circle& s = circles_[random.below(circles_.size())];
      double distance = std::sqrt((s.x - p.x) * (s.x - p.x) + (s.y - p.y) * (s.y - p.y)) - s.r;
      if (k % 4 == 0 || !inRange(distance)) distance = 0;
      check(p.x, p.y, random.below(circles_.size() + 2), distance);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }

 private:
  Circles circles_;
  Diagram diagram_;
};

TEST(Nearby, AgreesWithTheOracleOnTinyGrids) {
  Random random(351);
  for (int run = 0; run < runs(1500); ++run) {
    const int side = static_cast<int>(random.integer(1, 6));
    const int heaviest = random.below(5);
    const Circles circles = tinyGrid(random, 1 + random.below(std::size_t{14}), side, heaviest);
    Fixture(circles, random).checkAtHardPoints(random, 8);
    if (HasFatalFailure()) FAIL() << "run " << run;
  }
}

class NearbyOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(NearbyOn, AgreesWithTheOracle) {
  Random random(352);
  const Circles circles = GetParam().make(random, GetParam().large ? 120 : 15);
  Fixture(circles, random).checkAtHardPoints(random, runs(GetParam().large ? 20 : 10));
}

INSTANTIATE_TEST_SUITE_P(Corpus, NearbyOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Nearby, ManySites) {
  Random random(353);
  for (const Hidden hidden : {Hidden::kNone, Hidden::k20Percent, Hidden::k95Percent}) {
    const Circles circles = randomCircles(random, 3000, hidden);
    Fixture(circles, random).checkAtHardPoints(random, runs(8));
  }
}

TEST(Nearby, TheBoundaryIsIncludedExactly) {
  Diagram diagram;
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(3, 4, 2, id), Error::kNone);
  std::vector<SiteId> sites;
  ASSERT_EQ(diagram.within(0, 0, 3, sites), Error::kNone);
  EXPECT_EQ(sites, std::vector<SiteId>{id});
  ASSERT_EQ(diagram.within(0, 0, std::nextafter(3.0, 0.0), sites), Error::kNone);
  EXPECT_TRUE(sites.empty());
  ASSERT_EQ(diagram.within(3, 4, -2, sites), Error::kNone);
  EXPECT_EQ(sites, std::vector<SiteId>{id});
  ASSERT_EQ(diagram.within(3, 4, std::nextafter(-2.0, -3.0), sites), Error::kNone);
  EXPECT_TRUE(sites.empty());
}

TEST(Farthest, TiesGoToTheHeavierThenTheGreaterXThenY) {
  for (const Circles& circles :
       {Circles{{0, 5, 0}, {3, 0, 2}, {-5, 0, 0}, {-3, 0, 2}, {0, -4, 1}, {0, 3, 2}},
        Circles{{-3, 0, 2}, {0, 3, 2}, {0, -4, 1}, {3, 0, 2}, {0, 5, 0}, {-5, 0, 0}}}) {
    Diagram diagram;
    insertInto(diagram, circles);
    SiteId id = kNoSite;
    double distance = 0;
    ASSERT_EQ(diagram.farthest(0, 0, id, distance), Error::kNone);
    EXPECT_TRUE(same(circles[id], {3, 0, 2}));
    EXPECT_EQ(distance, 5);
  }
}

TEST(Nearby, BadNumbersAreErrors) {
  Diagram diagram;
  std::vector<SiteId> sites;
  NearbyLists lists;
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(diagram.kNearest(nan, 0, 1, sites), Error::kNotFinite);
  EXPECT_EQ(diagram.kNearest(0, 1e101, 1, sites), Error::kOutOfRange);
  EXPECT_EQ(diagram.within(0, infinity, 1, sites), Error::kNotFinite);
  EXPECT_EQ(diagram.within(0, 0, nan, sites), Error::kNotFinite);
  EXPECT_EQ(diagram.within(0, 0, 1e101, sites), Error::kOutOfRange);
  EXPECT_EQ(diagram.kNearestMany(std::vector{0.0, nan}, 1, 1, true, lists), Error::kNotFinite);
  EXPECT_EQ(diagram.kNearestMany({}, 1, nan, true, lists), Error::kNotFinite);
  SiteId id = 7;
  double distance = 7;
  EXPECT_EQ(diagram.find(nan, 0, 1, id, distance), Error::kNotFinite);
  EXPECT_EQ(diagram.find(0, 0, nan, id), Error::kNotFinite);
  EXPECT_EQ(diagram.find(0, 0, 1e101, id, distance), Error::kOutOfRange);
  EXPECT_EQ(diagram.findMany({}, nan, {}, {}), Error::kNotFinite);
  EXPECT_EQ(diagram.farthest(nan, 0, id, distance), Error::kNotFinite);
  EXPECT_EQ(id, 7u);
  EXPECT_EQ(distance, 7);
}

}  // namespace
}  // namespace apollonius::test
