// The sphere's calls apart from what they compute: what is refused, what a hidden site or an empty
// diagram gives, lists of sites, and the search that goes on.
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

struct BadPoint {
  double lon, lat;
  Error error;
};
constexpr BadPoint kBadPoints[] = {{kNaN, 0, Error::kNotFinite},
                                   {0, kNaN, Error::kNotFinite},
                                   {kInfinity, 0, Error::kNotFinite},
                                   {0, 90.5, Error::kOutOfRange},
                                   {0, -90.5, Error::kOutOfRange}};

TEST(SphericalCalls, RadiiAreThoseThatTheCallerMayGive) {
  for (const double radius : {1.0, 6371.0, kLargestMagnitude})
    EXPECT_TRUE(SphericalDiagram::isRadius(radius)) << radius;
  for (const double radius : {0.0, -1.0, 1e-300, 1e300, kInfinity, kNaN})
    EXPECT_FALSE(SphericalDiagram::isRadius(radius)) << radius;
  EXPECT_EQ(SphericalDiagram(6371).radius(), 6371);
}

TEST(SphericalCalls, PointsThatAreNoneAreRefused) {
  const SphericalDiagram diagram = threeSites();
  SphericalNearestFirst search(diagram);
  for (const auto& [lon, lat, error] : kBadPoints) {
    SiteId id = 77;
    double distance = 77;
    bool isInside = true;
    std::vector<SiteId> sites = {77}, one = {77};
    EXPECT_EQ(diagram.find(lon, lat, id), error);
    EXPECT_EQ(diagram.find(lon, lat, id, distance), error);
    const double points[] = {lon, lat};
    EXPECT_EQ(diagram.find(lon, lat, kInfinity, id), error);
    EXPECT_EQ(diagram.find(lon, lat, kInfinity, id, distance), error);
    EXPECT_EQ(diagram.findMany(points, one, {}), error);
    EXPECT_EQ(diagram.kNearest(lon, lat, 3, kInfinity, sites), error);
    NearbyLists lists;
    EXPECT_EQ(diagram.kNearestMany(points, 3, kInfinity, false, lists), error);
    EXPECT_EQ(diagram.pick(lon, lat, kInfinity, Top::kSmallest, id), error);
    EXPECT_EQ(diagram.farthest(lon, lat, id, distance), error);
    EXPECT_EQ(diagram.contains(0, lon, lat, kEverywhere, isInside), error);
    EXPECT_EQ(search.start(lon, lat), error);
    EXPECT_EQ(id, 77u);
    EXPECT_EQ(distance, 77);
    EXPECT_TRUE(isInside);
    EXPECT_EQ(sites, std::vector<SiteId>{77});
    EXPECT_EQ(one, std::vector<SiteId>{77});
  }
  SiteId id = 0;
  NearbyLists lists;
  std::vector<SiteId> sites;
  EXPECT_EQ(diagram.kNearest(0, 0, 3, kNaN, sites), Error::kNotFinite);
  EXPECT_EQ(diagram.kNearestMany({}, 3, kNaN, false, lists), Error::kNotFinite);
  EXPECT_EQ(diagram.find(0, 0, kNaN, id), Error::kNotFinite);
  EXPECT_EQ(diagram.findMany({}, kNaN, {}, {}), Error::kNotFinite);
  const double three[] = {1, 2, 3};
  EXPECT_EQ(diagram.kNearestMany(three, 3, kInfinity, false, lists), Error::kBadLength);
  EXPECT_EQ(diagram.pick(0, 0, kNaN, Top::kSmallest, id), Error::kNotFinite);
  EXPECT_EQ(diagram.pick(0, 0, -1, Top::kSmallest, id), Error::kOutOfRange);
  EXPECT_EQ(search.start(0, 0, kNaN), Error::kNotFinite);
}

TEST(SphericalCalls, ArraysOfOtherLengthsAreRefused) {
  SphericalDiagram diagram = threeSites();
  const double points[] = {0, 0, 1, 1};
  std::vector<SiteId> two(2), three(3);
  std::vector<double> one(1);
  EXPECT_EQ(diagram.findMany(points, three, {}), Error::kBadLength);
  EXPECT_EQ(diagram.findMany(points, two, one), Error::kBadLength);
  EXPECT_EQ(diagram.updateMany(std::vector<SiteId>{0, 1}, points), Error::kBadLength);
  SiteArrays sites;
  ASSERT_EQ(diagram.sites(sites), Error::kNone);
  EXPECT_EQ(sites.xyr, flat({{10, 20, 0.5}, {12, 20, 0.1}, {-100, 0, 0.1}}));
}

TEST(SphericalCalls, UnknownSitesAreRefused) {
  SphericalDiagram diagram = threeSites();
  for (const SiteId id : {SiteId{3}, kNoSite}) {
    SphericalCircle circle = {};
    SphericalPoint point = {};
    bool is = true;
    SiteId cover = 77;
    double area = 77;
    std::vector<SiteId> neighbors = {77};
    RingArrays rings;
    EXPECT_FALSE(diagram.has(id));
    EXPECT_EQ(diagram.site(id, circle), Error::kUnknownSite);
    EXPECT_EQ(diagram.isHidden(id, is), Error::kUnknownSite);
    EXPECT_EQ(diagram.coverOf(id, cover), Error::kUnknownSite);
    EXPECT_EQ(diagram.neighbors(id, neighbors), Error::kUnknownSite);
    EXPECT_EQ(diagram.contains(id, 0, 0, kEverywhere, is), Error::kUnknownSite);
    EXPECT_EQ(diagram.cellArea(id, kEverywhere, area), Error::kUnknownSite);
    EXPECT_EQ(diagram.cellCentroid(id, kEverywhere, point), Error::kUnknownSite);
    EXPECT_EQ(diagram.cellPolygon(id, 0.1, false, kEverywhere, rings), Error::kUnknownSite);
    EXPECT_EQ(cover, 77u);
    EXPECT_EQ(area, 77);
    EXPECT_EQ(neighbors, std::vector<SiteId>{77});
    ASSERT_EQ(diagram.remove(id, is), Error::kNone);
    EXPECT_FALSE(is) << "of no site: no error, but nothing is removed";
  }
  EXPECT_EQ(diagram.size(), 3u);
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

TEST(SphericalCalls, EmptyBatchesChangeNothing) {
  SphericalDiagram diagram = threeSites();
  std::size_t removed = 77;
  EXPECT_EQ(diagram.insertMany({}, {}), Error::kNone);
  EXPECT_EQ(diagram.updateMany({}, {}), Error::kNone);
  EXPECT_EQ(diagram.removeMany({}, removed), Error::kNone);
  EXPECT_EQ(removed, 0u);
  EXPECT_EQ(diagram.size(), 3u);
}

TEST(SphericalCalls, HiddenSitesHaveACoverAndNoCell) {
  const SphericalDiagram diagram = threeSites();
  bool is = false;
  SiteId cover = kNoSite;
  ASSERT_EQ(diagram.isHidden(1, is), Error::kNone);
  EXPECT_TRUE(is);
  ASSERT_EQ(diagram.coverOf(1, cover), Error::kNone);
  EXPECT_EQ(cover, 0u);
  ASSERT_EQ(diagram.coverOf(0, cover), Error::kNone);
  EXPECT_EQ(cover, kNoSite);
  ASSERT_EQ(diagram.contains(1, 12, 20, kEverywhere, is), Error::kNone);
  EXPECT_FALSE(is);
  ASSERT_EQ(diagram.contains(2, 12, 20, kEverywhere, is), Error::kNone);
  EXPECT_FALSE(is);
  std::vector<SiteId> neighbors = {77};
  ASSERT_EQ(diagram.neighbors(1, neighbors), Error::kNone);
  EXPECT_TRUE(neighbors.empty());
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

TEST(SphericalCalls, SitesAreListedInTheOrderOfTheirIds) {
  SphericalDiagram diagram = threeSites();
  bool removed = false;
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(50, 60, -0.2, id), Error::kNone);
  ASSERT_EQ(diagram.remove(2, removed), Error::kNone);
  SiteArrays sites;
  ASSERT_EQ(diagram.sites(sites), Error::kNone);
  EXPECT_EQ(sites.ids, (std::vector<SiteId>{0, 1, 3}));
  EXPECT_EQ(sites.xyr, flat({{10, 20, 0.5}, {12, 20, 0.1}, {50, 60, -0.2}}));
  EXPECT_EQ(std::vector<int>(sites.hidden.begin(), sites.hidden.end()), (std::vector{0, 1, 0}));
}

TEST(SphericalCalls, MovedDiagramsAreWhatTheyWere) {
  SphericalDiagram diagram = threeSites();
  const SphericalDiagram moved = std::move(diagram);
  EXPECT_EQ(moved.size(), 3u);
  EXPECT_EQ(moved.visibleSize(), 2u);
  diagram = SphericalDiagram(5);
  EXPECT_EQ(diagram.radius(), 5);
  EXPECT_EQ(diagram.size(), 0u);
}

TEST(SphericalCalls, AnEmptyDiagramHasNothing) {
  const SphericalDiagram diagram;
  SiteId id = 77;
  double distance = 0;
  ASSERT_EQ(diagram.find(1, 2, id, distance), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  EXPECT_EQ(distance, kInfinity);
  ASSERT_EQ(diagram.farthest(1, 2, id, distance), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  EXPECT_EQ(distance, -kInfinity);
  const double points[] = {1, 2, 3, 4};
  std::vector<SiteId> found(2), sites = {77};
  std::vector<double> distances(2);
  ASSERT_EQ(diagram.findMany(points, found, distances), Error::kNone);
  EXPECT_EQ(found, (std::vector<SiteId>{kNoSite, kNoSite}));
  EXPECT_EQ(distances, (std::vector<double>{kInfinity, kInfinity}));
  ASSERT_EQ(diagram.kNearest(1, 2, 5, kInfinity, sites), Error::kNone);
  EXPECT_TRUE(sites.empty());
  VertexArrays vertices;
  EdgeArrays edges;
  CoverageArrays polygons;
  ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
  ASSERT_EQ(diagram.edges(edges), Error::kNone);
  ASSERT_EQ(diagram.cellPolygons(0.1, true, {}, polygons), Error::kNone);
  EXPECT_TRUE(vertices.coordinates.empty());
  EXPECT_TRUE(edges.sites.empty());
  EXPECT_TRUE(polygons.sites.empty());
  SphericalNearestFirst search(diagram);
  ASSERT_EQ(search.start(1, 2), Error::kNone);
  ASSERT_EQ(search.next(id), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  EXPECT_EQ(search.distance(), kInfinity);
}

TEST(SphericalCalls, RemovedSitesHaveNoPolygons) {
  SphericalDiagram diagram = diagramOf({{10, 20, 0.5}, {90, 0, 0}, {-100, 0, 0.1}, {0, -60, 0}});
  bool isRemoved = false;
  ASSERT_EQ(diagram.remove(1, isRemoved), Error::kNone);
  CoverageArrays polygons;
  ASSERT_EQ(diagram.cellPolygons(0.1, true, {}, polygons), Error::kNone);
  EXPECT_EQ(polygons.sites, (std::vector<SiteId>{0, 2, 3}));
}

TEST(SphericalCalls, NoNearestSitesAreAskedFor) {
  std::vector<SiteId> sites = {77};
  ASSERT_EQ(threeSites().kNearest(1, 2, 0, kInfinity, sites), Error::kNone);
  EXPECT_TRUE(sites.empty());
}

TEST(SphericalCalls, UnderAPointIsTheSmallestOrTheLastElseTheNearest) {
  Random random(72);
  const SphericalSites sites = randomSites(random, 60, 0.4);
  const SphericalDiagram diagram = diagramOf(sites);
  int inNone = 0, inSeveral = 0;
  for (int k = 0; k < 300; ++k) {
    const SphericalPoint p = randomPoint(random);
    std::vector<SiteId> containing, nearest;
    ASSERT_EQ(diagram.kNearest(p.lon, p.lat, sites.size(), 0, containing), Error::kNone);
    ASSERT_EQ(diagram.kNearest(p.lon, p.lat, 1, kInfinity, nearest), Error::kNone);
    inNone += containing.empty() ? 1 : 0;
    inSeveral += containing.size() > 1 ? 1 : 0;
    const auto isSmaller = [&](SiteId a, SiteId b) { return sites[a].r < sites[b].r; };
    const SiteId smallest =
        containing.empty() ? nearest[0] : *std::ranges::min_element(containing, isSmaller);
    const SiteId last = containing.empty() ? nearest[0] : *std::ranges::max_element(containing);
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.pick(p.lon, p.lat, kInfinity, Top::kSmallest, id), Error::kNone);
    EXPECT_EQ(id, smallest);
    ASSERT_EQ(diagram.pick(p.lon, p.lat, kInfinity, Top::kLast, id), Error::kNone);
    EXPECT_EQ(id, last);
    ASSERT_EQ(diagram.pick(p.lon, p.lat, 0, Top::kLast, id), Error::kNone);
    EXPECT_EQ(id, containing.empty() ? kNoSite : last);
  }
  EXPECT_GT(inNone, 10);
  EXPECT_GT(inSeveral, 10);
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

TEST(SphericalNearestFirst, GivesOneSiteAfterAnotherUpToADistance) {
  Random random(71);
  const SphericalSites sites = randomSites(random, 50, 0.3);
  const SphericalDiagram diagram = diagramOf(sites);
  SphericalNearestFirst begun(diagram);
  SiteId id = 77;
  ASSERT_EQ(begun.next(id), Error::kNone);
  EXPECT_EQ(id, kNoSite) << "before start()";
  EXPECT_EQ(begun.distance(), kInfinity);
  ASSERT_EQ(begun.start(30, 40, 1), Error::kNone);
  SphericalNearestFirst search = std::move(begun);
  std::vector<SiteId> expected, found;
  ASSERT_EQ(diagram.kNearest(30, 40, 50, 1, expected), Error::kNone);
  for (;;) {
    ASSERT_EQ(search.next(id), Error::kNone);
    if (id == kNoSite) break;
    found.push_back(id);
    EXPECT_NEAR(search.distance(), distanceOf({30, 40}, sites[id]), 1e-14);
  }
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), 10u);
  EXPECT_LT(found.size(), 50u);
}

}  // namespace
}  // namespace apollonius::test
