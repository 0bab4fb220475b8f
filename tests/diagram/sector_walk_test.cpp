// The walk that asks one neighbour (locate.cpp) where directions are hard to tell apart: it must
// find what brute force finds. Giants of high degree, common tangents, directions that coincide,
// sites one unit in the last place apart. In builds with the shadow check each walk's end is
// compared with all neighbours as well.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "predicate/stage_counts.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/operations.h"
#include "support/oracle.h"

namespace apollonius::test {

using namespace internal;
namespace {

bool isInDocumentedRange(double v) {
  return v == 0 || (std::abs(v) >= kSmallestMagnitude && std::abs(v) <= kLargestMagnitude);
}

double nudged(Random& random, double v) {
  return std::nextafter(v, random.oneIn(2) ? 1e300 : -1e300);
}

/// Points in the directions that matter: on rays from one centre through another, on and beside the
/// axes between centres, at centres, and next to all of these.
std::vector<double> pointsOnRays(Random& random, const Circles& circles, int count) {
  std::vector<double> xy;
  for (int k = 0; k < count; ++k) {
    const Circle& a = circles[random.below(circles.size())];
    const Circle& b = circles[random.below(circles.size())];
    const double along = random.oneIn(2) ? static_cast<double>(random.integer(-3, 4)) / 2
                         : random.oneIn(2)
                             ? 1 + random.between(-1, 1) * random.unit() * random.unit() * 0.3
                             : random.between(-1, 3);
    double x = a.x + along * (b.x - a.x), y = a.y + along * (b.y - a.y);
    if (random.oneIn(4)) x = nudged(random, x);
    if (random.oneIn(4)) y = nudged(random, y);
    if (isInDocumentedRange(x) && isInDocumentedRange(y)) xy.insert(xy.end(), {x, y});
  }
  return xy;
}

void expectNearestByBruteForce(const Circles& circles, Random& random, int points) {
  Diagram diagram;
  for (const Circle& c : circles) {
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.insert(c.x, c.y, c.r, id), Error::kNone);
  }
  std::string broken;
  ASSERT_EQ(diagram.validate(broken), Error::kNone);
  ASSERT_EQ(broken, "") << toText(insertAll(circles));
  const std::vector<double> xy = pointsOnRays(random, circles, points);
  for (std::size_t k = 0; k + 1 < xy.size(); k += 2) {
    SiteId id = kNoSite;
    double distance = 0;
    ASSERT_EQ(diagram.find(xy[k], xy[k + 1], id, distance), Error::kNone);
    const Circle& expected =
        circles[static_cast<std::size_t>(oracleNearest(circles, xy[k], xy[k + 1]))];
    const Circle& got = circles[id];
    ASSERT_TRUE(got.x == expected.x && got.y == expected.y && got.r == expected.r)
        << "point " << xy[k] << " " << xy[k + 1] << " got " << got.x << " " << got.y << " " << got.r
        << " instead of " << expected.x << " " << expected.y << " " << expected.r << "\n"
        << toText(insertAll(circles));
  }
}

/// A giant whose boundary is lined with circles of all sizes, in few directions each: high degrees,
/// and directions from its centre that coincide or differ in the last places.
Circles linedGiant(Random& random, std::size_t n) {
  const double giant = 1e6;
  Circles circles{{0, 0, giant}};
  while (circles.size() < n) {
    const Direction d = randomDirection(random);
    for (int k = static_cast<int>(random.integer(1, 3)); k > 0; --k) {
      const double r = std::ldexp(1.0, static_cast<int>(random.integer(-30, 12)));
      const double gap =
          random.oneIn(3) ? 0 : std::ldexp(1.0, static_cast<int>(random.integer(-30, 3)));
      circles.push_back({d.x * (giant + r + gap), d.y * (giant + r + gap), r});
    }
  }
  return circles;
}

/// As before, with the giant's weight one unit in the last place off that of a ring of points about
/// it.
Circles ringAtTheRim(Random& random, std::size_t n) {
  Circles circles{{0.1, 0.1, 3}};
  while (circles.size() < n) {
    const Direction d = randomDirection(random);
    circles.push_back({nudged(random, 0.1 + 3 * d.x), nudged(random, 0.1 + 3 * d.y), 0});
  }
  return circles;
}

/// Circles of all sizes that touch one line from one side, up to rounding.
Circles alongOneLine(Random& random, std::size_t n) {
  Circles circles;
  const Direction d = randomDirection(random);
  for (std::size_t k = 0; k < n; ++k) {
    const double t = random.between(-1e3, 1e3),
                 r = std::ldexp(1.0, static_cast<int>(random.integer(-20, 20)));
    circles.push_back({t * d.x - r * d.y, t * d.y + r * d.x, r});
  }
  return circles;
}

class SectorWalkOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(SectorWalkOn, FindsTheNearestSite) {
  Random random(1811);
  for (const std::size_t n : {std::size_t{17}, std::size_t{60}, std::size_t{250}}) {
    for (int run = 0; run < runs(n < 100 ? sized(5, 20) : sized(1, 4)); ++run) {
      expectNearestByBruteForce(GetParam().make(random, n), random, 100);
      if (HasFatalFailure()) FAIL() << "n " << n << ", run " << run;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(HardDirections, SectorWalkOn,
                         ::testing::Values(NamedGenerator{"TangentInLayers", tangentInLayers},
                                           NamedGenerator{"LinedGiant", linedGiant},
                                           NamedGenerator{"RingAtTheRim", ringAtTheRim},
                                           NamedGenerator{"AlongOneLine", alongOneLine},
                                           NamedGenerator{"GiantDisk", giantDisk},
                                           NamedGenerator{"GiantDiskExact", giantDiskExact},
                                           NamedGenerator{"OneUlpApart", oneUlpApart},
                                           NamedGenerator{"CocircularPoints", cocircularPoints}),
                         [](const auto& parameter) { return parameter.param.name; });

// One by one, find(-609184.8, -876123.9) gave site 0; site 12 is nearer by 133 014.
TEST(SectorWalk, FifteenIntegerCircles) {
  const Circles circles{{-612995724, -8605092368, 8625712875},
                        {-932400, -732415, 0},
                        {1497300, -5736125, 4742660},
                        {3312612, 1295691, 2371330},
                        {3306885, -4920320, 4742660},
                        {666536, -980577, 0},
                        {-1146064, 303873, 0},
                        {-2565456, 3988892, 3556995},
                        {-1039476, 570343, 0},
                        {-1147225, -299460, 0},
                        {2369184, -100862, 1185665},
                        {-1088167, -470844, 0},
                        {-732415, -932400, 0},
                        {112665, -1180300, 0},
                        {711399, -948532, 0}};
  Diagram diagram;
  SiteId id = kNoSite;
  for (const Circle& c : circles) ASSERT_EQ(diagram.insert(c.x, c.y, c.r, id), Error::kNone);
  double distance = 0;
  ASSERT_EQ(diagram.find(-609184.8, -876123.9, id, distance), Error::kNone);
  EXPECT_EQ(id, 12u);
}

// The purpose of the walk: its work at a giant does not grow with the giant's degree.
TEST(SectorWalk, AsksFewNeighborsOfAGiant) {
  const auto directionsAsked = [](std::size_t n) {
    Random random(1812);
    Circles circles{{0, 0, 1e6}};
    for (std::size_t k = 0; k < n; ++k) {
      const Direction d = randomDirection(random);
      circles.push_back({d.x * (1e6 + 1), d.y * (1e6 + 1), random.unit()});
    }
    Diagram diagram;
    insertInto(diagram, circles);
    stages::counts() = {};
    for (int k = 0; k < 1000; ++k) {
      const Direction d = randomDirection(random);
      const double distance = random.between(0, 2e6);
      SiteId id = kNoSite;
      double found = 0;
      EXPECT_EQ(diagram.find(d.x * distance, d.y * distance, id, found), Error::kNone);
    }
    return static_cast<double>(stages::counts().rayCached) / 1000;
  };
  // One level of the hierarchy more, of which each leaves some sixteen directions to the next.
  const double few = directionsAsked(1000);
  for (const std::size_t n : {std::size_t{4000}, std::size_t{16000}}) {
    EXPECT_LT(directionsAsked(n), few + 64)
        << few << " directions a search at a degree of 1 000; now " << n;
  }
}

}  // namespace
}  // namespace apollonius::test
