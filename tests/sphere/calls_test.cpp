// The sphere's own calls refuse wrong arguments, and answer for hidden sites and empty diagrams.
// diagram/calls_test.cpp has the calls of both surfaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "sphere/sphere_sets.h"

namespace apollonius::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Site 1 is hidden.
SphericalDiagram threeSites() { return diagramOf({{10, 20, 0.5}, {12, 20, 0.1}, {-100, 0, 0.1}}); }

TEST(SphericalCalls, RadiiAreThoseThatTheCallerMayGive) {
  for (const double radius : {1.0, 6371.0, kLargestMagnitude})
    EXPECT_TRUE(SphericalDiagram::isRadius(radius)) << radius;
  for (const double radius : {0.0, -1.0, 1e-300, 1e300, kInfinity, kNaN})
    EXPECT_FALSE(SphericalDiagram::isRadius(radius)) << radius;
  EXPECT_EQ(SphericalDiagram(6371).radius(), 6371);
}

TEST(SphericalCalls, PointsThatAreNoneAreInNoCell) {
  const SphericalDiagram diagram = threeSites();
  bool isInside = true;
  EXPECT_EQ(diagram.contains(0, kNaN, 0, kEverywhere, isInside), Error::kNotFinite);
  EXPECT_EQ(diagram.contains(0, 0, 90.5, kEverywhere, isInside), Error::kOutOfRange);
  EXPECT_TRUE(isInside);
}

TEST(SphericalCalls, UnknownSitesHaveNoCells) {
  const SphericalDiagram diagram = threeSites();
  for (const SiteId id : {SiteId{3}, kNoSite}) {
    SphericalPoint point = {};
    bool is = true;
    double area = 77;
    RingArrays rings;
    EXPECT_EQ(diagram.contains(id, 0, 0, kEverywhere, is), Error::kUnknownSite);
    EXPECT_EQ(diagram.cellArea(id, kEverywhere, area), Error::kUnknownSite);
    EXPECT_EQ(diagram.cellCentroid(id, kEverywhere, point), Error::kUnknownSite);
    EXPECT_EQ(diagram.cellPolygon(id, 0.1, false, kEverywhere, rings), Error::kUnknownSite);
    EXPECT_EQ(area, 77);
  }
}

TEST(SphericalCalls, TolerancesThatAreNoneAreRefused) {
  const SphericalDiagram diagram = threeSites();
  RingArrays rings;
  CoverageArrays polygons;
  for (const auto& [tolerance, error] : {std::pair{kNaN, Error::kNotFinite},
                                         {kInfinity, Error::kNotFinite},
                                         {0.0, Error::kOutOfRange},
                                         {kFinestTolerance / 2, Error::kOutOfRange}}) {
    EXPECT_EQ(diagram.cellPolygon(0, tolerance, true, kEverywhere, rings), error) << tolerance;
    EXPECT_EQ(diagram.cellPolygons(tolerance, true, {}, polygons), error) << tolerance;
  }
  EXPECT_EQ(diagram.cellPolygon(0, kFinestTolerance, true, kEverywhere, rings), Error::kNone);
}

TEST(SphericalCalls, HiddenSitesHaveNoCell) {
  const SphericalDiagram diagram = threeSites();
  bool is = false;
  ASSERT_EQ(diagram.contains(1, 12, 20, kEverywhere, is), Error::kNone);
  EXPECT_FALSE(is);
  ASSERT_EQ(diagram.contains(2, 12, 20, kEverywhere, is), Error::kNone);
  EXPECT_FALSE(is);
  double area = 77;
  ASSERT_EQ(diagram.cellArea(1, kEverywhere, area), Error::kNone);
  EXPECT_EQ(area, 0);
  SphericalPoint centroid = {7, 8};
  ASSERT_EQ(diagram.cellCentroid(1, kEverywhere, centroid), Error::kNone);
  EXPECT_TRUE(std::isnan(centroid.lon) && std::isnan(centroid.lat));
  RingArrays rings;
  ASSERT_EQ(diagram.cellPolygon(1, 0.1, true, kEverywhere, rings), Error::kNone);
  EXPECT_TRUE(rings.coordinates.empty());
}

TEST(SphericalCalls, OneCellIsTheSphere) {
  SphericalDiagram diagram(2);
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(10, 20, 0.5, id), Error::kNone);
  double area = 0;
  ASSERT_EQ(diagram.cellArea(id, kEverywhere, area), Error::kNone);
  EXPECT_NEAR(area, 16 * std::numbers::pi, 1e-12);
  SphericalPoint centroid = {};
  ASSERT_EQ(diagram.cellCentroid(id, kEverywhere, centroid), Error::kNone);
  EXPECT_NEAR(centroid.lon, 10, 1e-12) << "no direction: the site's own";
  EXPECT_NEAR(centroid.lat, 20, 1e-12);
}

TEST(SphericalCalls, AssignedDiagramsHaveTheRadiusOfTheOther) {
  SphericalDiagram diagram = threeSites();
  diagram = SphericalDiagram(5);
  EXPECT_EQ(diagram.radius(), 5);
  EXPECT_EQ(diagram.size(), 0u);
}

TEST(SphericalCalls, AnEmptyDiagramHasNoPolygons) {
  CoverageArrays polygons;
  ASSERT_EQ(SphericalDiagram().cellPolygons(0.1, true, {}, polygons), Error::kNone);
  EXPECT_TRUE(polygons.sites.empty());
}

TEST(SphericalCalls, RemovedSitesHaveNoPolygons) {
  SphericalDiagram diagram = diagramOf({{10, 20, 0.5}, {90, 0, 0}, {-100, 0, 0.1}, {0, -60, 0}});
  bool isRemoved = false;
  ASSERT_EQ(diagram.remove(1, isRemoved), Error::kNone);
  CoverageArrays polygons;
  ASSERT_EQ(diagram.cellPolygons(0.1, true, {}, polygons), Error::kNone);
  EXPECT_EQ(polygons.sites, (std::vector<SiteId>{0, 2, 3}));
}

TEST(SphericalCalls, TheFarthestSideIsOppositeToTheNearest) {
  Random random(73);
  for (const NamedSites& set : namedSets(random, 40)) {
    SCOPED_TRACE(set.name);
    const SphericalDiagram diagram = diagramOf(set.sites);
    for (int k = 0; k < 40; ++k) {
      const SphericalPoint p = randomPoint(random);
      const auto farSide = [&](const SphericalCircle& site) {
        return distanceOf(p, site) + 2 * site.r;
      };
      double most = -kInfinity;
      for (const SphericalCircle& site : set.sites) most = std::max(most, farSide(site));
      SiteId id = kNoSite;
      double distance = 0;
      ASSERT_EQ(diagram.farthest(p.lon, p.lat, id, distance), Error::kNone);
      EXPECT_NEAR(distance, most, 1e-14);
      EXPECT_NEAR(farSide(set.sites[id]), most, 1e-14);
    }
  }
}

TEST(SphericalCalls, InterpolationRefusesWhatDoesNotFit) {
  const SphericalDiagram diagram = threeSites();
  const double points[] = {0, 0, 1, 1}, noPoints[] = {0, 0, kNaN, 1};
  const std::vector<double> values(3);
  std::vector<double> two(2), one(1);
  EXPECT_EQ(diagram.interpolate(std::vector<double>(2), points, 0, two), Error::kBadLength);
  EXPECT_EQ(diagram.interpolate(values, points, 0, one), Error::kBadLength);
  EXPECT_EQ(diagram.interpolate(values, noPoints, 0, two), Error::kNotFinite);
}

}  // namespace
}  // namespace apollonius::test
