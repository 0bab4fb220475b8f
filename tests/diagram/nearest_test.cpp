// find() and findMany() against the oracle: the right site always, ties included, and a correctly
// rounded-ish distance.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

struct Found {
  SiteId id = kNoSite;
  double distance = 0;
};

Found find(const Diagram& diagram, double x, double y) {
  Found found;
  EXPECT_EQ(diagram.find(x, y, found.id, found.distance), Error::kNone);
  return found;
}

/// Points where it is hard: centres, midpoints, mixed coordinates of two sites, rims, and anywhere.
std::vector<double> hardPoints(Random& random, const Circles& circles, int count) {
  std::vector<double> xy;
  for (int k = 0; k < count; ++k) {
    const Circle& a = circles[random.below(circles.size())];
    const Circle& b = circles[random.below(circles.size())];
    double x = a.x, y = a.y;
    switch (k % 5) {
      case 0:
        break;
      case 1:
        x = (a.x + b.x) / 2, y = (a.y + b.y) / 2;
        break;
      case 2:
        y = b.y;
        break;
      case 3:
        x = a.x + a.r;
        break;
      default:
        x = 2 * a.x - b.x, y = b.y + b.r;
        break;
    }
    const auto inRange = [](double v) {
      return v == 0 || (std::abs(v) >= kSmallestMagnitude && std::abs(v) <= kLargestMagnitude);
    };
    if (inRange(x) && inRange(y)) xy.insert(xy.end(), {x, y});
  }
  return xy;
}

void expectOraclesNearest(const Circles& circles, Location location, Random& random, int points) {
  Diagram diagram(location);
  insertInto(diagram, circles);
  const std::vector<double> xy = hardPoints(random, circles, points);
  std::vector<SiteId> nearest(xy.size() / 2);
  std::vector<double> distances(xy.size() / 2);
  ASSERT_EQ(diagram.findMany(xy, nearest, distances), Error::kNone);
  for (std::size_t k = 0; k < nearest.size(); ++k) {
    const double x = xy[2 * k], y = xy[2 * k + 1];
    const Circle& expected = circles[static_cast<std::size_t>(oracleNearest(circles, x, y))];
    Circle got{};
    ASSERT_EQ(diagram.site(nearest[k], got), Error::kNone);
    ASSERT_TRUE(got.x == expected.x && got.y == expected.y && got.r == expected.r)
        << "point " << x << " " << y << " got " << got.x << " " << got.y << " " << got.r << "\n"
        << toText(insertAll(circles));
    bool hidden = true;
    ASSERT_EQ(diagram.isHidden(nearest[k], hidden), Error::kNone);
    ASSERT_FALSE(hidden);
    // The distance is rounded: a few units in the last place of its two parts.
    const double dx = got.x - x, dy = got.y - y;
    const double length = std::sqrt(dx * dx + dy * dy);
    ASSERT_NEAR(distances[k], length - got.r, 1e-15 * (length + std::abs(got.r)));
    const Found alone = find(diagram, x, y);
    ASSERT_EQ(alone.id, nearest[k]) << "find and findMany agree";
    ASSERT_EQ(alone.distance, distances[k]) << "to the last bit";
  }
}

TEST(Nearest, AgreesWithTheOracleOnTinyGrids) {
  Random random(251);
  for (int run = 0; run < runs(3000); ++run) {
    const int side = static_cast<int>(random.integer(1, 6));
    const int heaviest = random.below(5);
    const std::size_t n = 1 + random.below(std::size_t{12});
    const Circles circles = tinyGrid(random, n, side, heaviest);
    expectOraclesNearest(circles, run % 2 == 0 ? Location::kHierarchy : Location::kWalk, random,
                         20);
    if (HasFatalFailure()) FAIL() << "run " << run;
  }
}

class NearestOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(NearestOn, AgreesWithTheOracle) {
  Random random(252);
  for (const Location location : {Location::kHierarchy, Location::kWalk}) {
    const Circles circles = GetParam().make(random, GetParam().large ? 150 : 15);
    expectOraclesNearest(circles, location, random, runs(GetParam().large ? 200 : 60));
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, NearestOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Nearest, TiesGoToTheLargerRThenXThenY) {
  Diagram diagram;
  SiteId id = kNoSite;
  const auto insert = [&](double x, double y, double r) {
    EXPECT_EQ(diagram.insert(x, y, r, id), Error::kNone);
    return id;
  };
  const SiteId south = insert(0, -2, 0);
  EXPECT_EQ(find(diagram, 0, 0).id, south);
  const SiteId north = insert(0, 2, 0);
  EXPECT_EQ(find(diagram, 0, 0).id, north) << "larger y";
  const SiteId west = insert(-2, 0, 0);
  EXPECT_EQ(find(diagram, 0, 0).id, north) << "larger x than the west's";
  const SiteId east = insert(2, 0, 0);
  EXPECT_EQ(find(diagram, 0, 0).id, east) << "larger x";
  const SiteId heavy = insert(-3, -4, 3);
  EXPECT_EQ(find(diagram, 0, 0).id, heavy) << "larger r";
  EXPECT_EQ(find(diagram, 0, 0).distance, 2);
  EXPECT_NE(find(diagram, -2, 0).id, heavy);
  EXPECT_EQ(find(diagram, -2, 0).id, west);
}

TEST(Nearest, EmptyDiagramAndOneSite) {
  Diagram diagram;
  EXPECT_EQ(find(diagram, 1, 2).id, kNoSite);
  EXPECT_EQ(find(diagram, 1, 2).distance, std::numeric_limits<double>::infinity());
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(3, 4, 7, id), Error::kNone);
  EXPECT_EQ(find(diagram, 0, 0).id, id);
  EXPECT_EQ(find(diagram, 0, 0).distance, -2) << "negative inside";
}

TEST(Nearest, DistancesMayBeLeftOut) {
  Diagram diagram;
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(3, 4, 7, id), Error::kNone);
  const double xy[] = {0, 0, 5, 5};
  std::vector<SiteId> ids(2);
  EXPECT_EQ(diagram.findMany(xy, ids, {}), Error::kNone);
  EXPECT_EQ(ids, (std::vector<SiteId>{id, id}));
}

void expectAsOneByOne(const Diagram& diagram, const std::vector<double>& xy) {
  std::vector<SiteId> ids(xy.size() / 2);
  std::vector<double> distances(ids.size());
  ASSERT_EQ(diagram.findMany(xy, ids, distances), Error::kNone);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    SiteId id = kNoSite;
    double distance = 0;
    ASSERT_EQ(diagram.find(xy[2 * k], xy[2 * k + 1], id, distance), Error::kNone);
    ASSERT_EQ(ids[k], id) << k;
    ASSERT_EQ(distances[k], distance) << k;
  }
}

TEST(FindMany, OfMorePointsThanAreSortedAtOnce) {
  Random random(77);
  Diagram diagram;
  insertInto(diagram, {{0, 0, 1}, {90, 10, 5}, {40, 80, 2}, {50, 50, 0}, {10, 90, 3}});
  std::vector<double> xy;
  for (int k = 0; k < 2 * 40'000; ++k) xy.push_back(random.between(-20, 120));
  expectAsOneByOne(diagram, xy);
}

TEST(FindMany, OfFewPointsAmongManySites) {
  Random random(78);
  Circles circles;
  for (int k = 0; k < 9000; ++k)
    circles.push_back({random.between(0, 1000), random.between(0, 1000), random.between(0, 5)});
  Diagram diagram;
  insertInto(diagram, circles);
  std::vector<double> xy;
  for (int k = 0; k < 2 * 100; ++k) xy.push_back(random.between(-20, 1020));
  expectAsOneByOne(diagram, xy);
}

}  // namespace
}  // namespace apollonius::test
