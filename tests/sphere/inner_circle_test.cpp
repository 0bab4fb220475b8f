// The largest circles inside cells of the sphere, against points of the cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "sphere/sphere_sets.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

constexpr double kPi = std::numbers::pi, kDegree = kPi / 180, kRounding = 1e-9;

/// The point at an angle from a point, at a bearing, clockwise from north.
SphericalPoint pointAt(const SphericalPoint& from, double angle, double bearing) {
  const double lat = from.lat * kDegree;
  const double sine =
      std::sin(lat) * std::cos(angle) + std::cos(lat) * std::sin(angle) * std::cos(bearing);
  const double toLat = std::asin(std::clamp(sine, -1.0, 1.0));
  const double turn = std::atan2(std::sin(bearing) * std::sin(angle) * std::cos(lat),
                                 std::cos(angle) - std::sin(lat) * std::sin(toLat));
  return {from.lon + turn / kDegree, toLat / kDegree};
}

/// Is a point in the cell of a site, which ends at a distance from its circle?
bool isIn(const SphericalSites& sites, SiteId id, double reach, const SphericalPoint& p,
          double slack) {
  const double own = distanceOf(p, sites[id]);
  return own <= leastDistance(sites, p) + slack && own <= reach + slack;
}

/// Is a disc in it, by its points on circles?
bool isAround(const SphericalSites& sites, SiteId id, double reach, const SphericalPoint& centre,
              double r, double slack) {
  const int rings = sized(3, 12);
  for (int ring = rings; ring > 0; --ring) {
    for (int k = 0; k < 64; ++k) {
      const SphericalPoint p = pointAt(centre, r * ring / rings, k * kPi / 32);
      if (!isIn(sites, id, reach, p, slack)) return false;
    }
  }
  return true;
}

void checkCells(const SphericalSites& sites, double reach, Random& random) {
  const SphericalDiagram diagram = diagramOf(sites);
  for (SiteId id = 0; id < sites.size(); ++id) {
    SphericalCircle circle{};
    const Error error = diagram.cellCircle(id, reach, circle);
    double area = 0;
    ASSERT_EQ(diagram.cellArea(id, reach, area), Error::kNone);
    ASSERT_EQ(error, Error::kNone) << id;
    ASSERT_EQ(std::isnan(circle.r), area == 0) << id;
    if (area == 0) continue;
    ASSERT_GE(circle.r, 0);
    const SphericalPoint centre{circle.lon, circle.lat};
    EXPECT_TRUE(isIn(sites, id, reach, centre, kRounding)) << id;
    EXPECT_TRUE(isAround(sites, id, reach, centre, circle.r, kRounding)) << id;
    EXPECT_LE(2 * kPi * (1 - std::cos(circle.r)), area * (1 + 1e-9) + kRounding) << id;
    // None about other points of the cell is larger.
    const double larger = 1.002 * circle.r + 1e-7;
    if (larger >= kPi) continue;
    for (int k = 0; k < sized(20, 200); ++k) {
      const SphericalPoint p =
          k % 2 == 0 ? pointAt(centre, random.between(0, 2 * circle.r), random.between(0, 2 * kPi))
                     : randomPoint(random);
      if (!isIn(sites, id, reach, p, 0)) continue;
      EXPECT_FALSE(isAround(sites, id, reach, p, larger, 0)) << id << ' ' << p.lon << ' ' << p.lat;
    }
  }
}

TEST(SphericalInnerCircle, IsInsideTheCellAndTheLargest) {
  Random random(91);
  for (int round = 0; round < sized(2, 12); ++round) {
    for (const NamedSites& set : namedSets(random, 3 + 15 * static_cast<std::size_t>(round))) {
      SCOPED_TRACE(set.name);
      checkCells(set.sites, std::numeric_limits<double>::infinity(), random);
      checkCells(set.sites, 0.2, random);
    }
  }
}

TEST(SphericalInnerCircle, OfFewSitesIsKnown) {
  SphericalDiagram diagram(2);
  SphericalCircle circle{};
  EXPECT_EQ(diagram.cellCircle(0, kEverywhere, circle), Error::kUnknownSite);
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(30, 40, 0.1, id), Error::kNone);
  ASSERT_EQ(diagram.cellCircle(0, kEverywhere, circle), Error::kNone);
  EXPECT_NEAR(circle.r, 2 * kPi, 1e-12);  // the whole sphere
  ASSERT_EQ(diagram.cellCircle(0, 0.5, circle), Error::kNone);
  EXPECT_NEAR(circle.lon, 30, 0.1);
  EXPECT_NEAR(circle.lat, 40, 0.1);
  EXPECT_LE(circle.r, 0.6 + 1e-12);
  EXPECT_GE(circle.r, 0.999 * 0.6);
  ASSERT_EQ(diagram.insert(-150, -40, 0.1, id), Error::kNone);  // the other side: hemispheres
  for (SiteId site = 0; site < 2; ++site) {
    ASSERT_EQ(diagram.cellCircle(site, kEverywhere, circle), Error::kNone);
    EXPECT_LE(circle.r, kPi + 1e-9);
    EXPECT_GE(circle.r, 0.999 * kPi);
  }
  ASSERT_EQ(diagram.insert(30, 40, 0.01, id), Error::kNone);  // hidden
  ASSERT_EQ(diagram.cellCircle(2, kEverywhere, circle), Error::kNone);
  EXPECT_TRUE(std::isnan(circle.r));
  EXPECT_EQ(diagram.cellCircle(0, std::numeric_limits<double>::quiet_NaN(), circle),
            Error::kNotFinite);
}

// From hemispheres to centimetres on the Earth.
TEST(SphericalInnerCircle, OfSmallCellsIsAsGood) {
  for (double size = 10; size > 1e-7; size /= 7) {
    SphericalSites sites;
    for (const double lon : {-1.0, 0.0, 1.0})
      for (const double lat : {-1.0, 0.0, 1.0}) sites.push_back({20 + size * lon, size * lat, 0});
    const SphericalDiagram diagram = diagramOf(sites);
    SphericalCircle circle{};
    ASSERT_EQ(diagram.cellCircle(4, kEverywhere, circle), Error::kNone);
    const double half = size / 2 * kDegree;  // half the side: the cell is nearly a square
    EXPECT_LE(circle.r, half * 1.0001) << size;
    EXPECT_GE(circle.r, half * 0.9985) << size;
  }
}

/// Sites within some 1e-6 of (0, 0), as far from each other and in the same directions about
/// another point.
SphericalSites movedTo(const SphericalPoint& place, const SphericalSites& sites) {
  SphericalSites moved;
  for (const auto& [lon, lat, r] : sites) {
    if (std::abs(place.lat) == 90) {
      // `lat` is upwards along the meridian of 180 degrees; seen from below it is mirrored.
      const double bearing = std::atan2(lon, -lat) / kDegree;
      const double toLat = place.lat - std::copysign(std::hypot(lon, lat), place.lat);
      moved.push_back({place.lat > 0 ? bearing : -bearing, toLat, r});
    } else {
      moved.push_back({place.lon + lon / std::cos(place.lat * kDegree), place.lat + lat, r});
    }
  }
  return moved;
}

// Within a hundred metres on the Earth, and sites with weights, so that edges are curved: pieces of
// their polygons were halved until memory ended, as rounding grew while they became shorter.
TEST(SphericalInnerCircle, OfSmallCellsWithCurvedEdgesEnds) {
  const SphericalSites small{
      {0, 0, 7.365845704749868e-8},
      {-3.315261596e-5, -9.449066955e-6, 4.403120570115409e-8},
      {-1.113519065e-5, -4.141941506e-5, 1.977240820060478e-8},
      {2.985791537e-5, -3.353122398e-5, 6.9055470478014436e-9},
      {3.225359409e-5, -1.897923149e-5, 2.2511980629987114e-8},
      {1.109039555e-5, 8.234957310e-6, 7.072192030422748e-8},
      {-4.449533599e-5, 3.344833843e-6, 5.616817172203719e-8},
  };
  const SphericalPoint places[] = {{-33.958, 23.97}, {0, 0},  {180, 0},
                                   {-180, 60},       {0, 90}, {0, -90}};
  for (const SphericalPoint& place : places) {
    SCOPED_TRACE(testing::Message() << place.lon << ", " << place.lat);
    const SphericalDiagram diagram = diagramOf(movedTo(place, small));
    SphericalCircle circle{};
    ASSERT_EQ(diagram.cellCircle(0, kEverywhere, circle), Error::kNone);
    double area = 0;
    ASSERT_EQ(diagram.cellArea(0, kEverywhere, area), Error::kNone);
    EXPECT_NEAR(circle.r, 2.4218e-7, 5e-10);
    EXPECT_LE(kPi * circle.r * circle.r, area);
  }
}

}  // namespace
}  // namespace apollonius::test
