// Degenerate position on the sphere: sites that touch others from inside, that are a rounding apart
// or lie on lattices; and snapshots that somebody has made up.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <span>

#include "base/byte_stream.h"
#include "sphere/sphere_sets.h"
#include "support/effort.h"
#include "support/saved.h"

namespace apollonius::test {
namespace {

constexpr double kPi = std::numbers::pi;

double sumOfAreas(const SphericalDiagram& diagram) {
  std::vector<double> areas;
  EXPECT_EQ(diagram.cellAreas({}, areas), Error::kNone);
  double sum = 0;
  for (const double area : areas) sum += area;
  return sum;
}

/// Checks a ring of polygons, whatever the position of the sites; returns the sum of the areas in
/// the plane of longitude and latitude.
template <class Arrays>
double expectRings(const Arrays& polygons) {
  double sum = 0;
  for (std::size_t ring = 0; ring + 1 < polygons.starts.size(); ++ring) {
    const std::size_t first = polygons.starts[ring], last = polygons.starts[ring + 1] - 1u;
    const auto lon = [&](std::size_t k) { return polygons.coordinates[2 * k]; };
    const auto lat = [&](std::size_t k) { return polygons.coordinates[2 * k + 1]; };
    EXPECT_EQ(lon(first), lon(last));
    EXPECT_EQ(lat(first), lat(last));
    for (std::size_t k = first; k < last; ++k) {
      EXPECT_TRUE(lon(k) != lon(k + 1) || lat(k) != lat(k + 1)) << "a point twice in a row";
      EXPECT_TRUE(std::abs(lon(k)) <= 180 && std::abs(lat(k)) <= 90);
      sum += (lon(k) - lon(k + 1)) * (lat(k) + lat(k + 1)) / 2;
    }
  }
  return sum;
}

/// kNearest at the mirror images of the sites.
void expectAllInOrder(const SphericalSites& sites, const SphericalDiagram& diagram) {
  for (const SphericalCircle& site : sites) {
    std::vector<double> expected;
    const SphericalPoint p = {site.lon, -site.lat};
    for (const SphericalCircle& other : sites) expected.push_back(distanceOf(p, other));
    std::ranges::sort(expected);
    std::vector<SiteId> ids;
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    ASSERT_EQ(diagram.kNearest(p.lon, p.lat, sites.size(), kAnywhere, ids), Error::kNone);
    ASSERT_EQ(ids.size(), sites.size());
    for (std::size_t k = 0; k < ids.size(); ++k)
      EXPECT_NEAR(distanceOf(p, sites[ids[k]]), expected[k], 1e-13);
  }
}

/// All that is asked of a diagram in any position.
void expectSound(const SphericalSites& sites, const SphericalDiagram& diagram) {
  Violation violation;
  ASSERT_EQ(diagram.validate(violation), Error::kNone);
  ASSERT_EQ(violation.text(), "");
  EXPECT_NEAR(sumOfAreas(diagram), 4 * kPi, 1e-6);
  CoverageArrays cut, whole;
  ASSERT_EQ(diagram.cellPolygons(0.1, true, {}, cut), Error::kNone);
  EXPECT_NEAR(expectRings(cut), 360 * 180, 1e-2);
  for (std::size_t ring = 0; ring + 1 < cut.starts.size(); ++ring)
    EXPECT_GE(cut.starts[ring + 1] - cut.starts[ring], 4u);
  ASSERT_EQ(diagram.cellPolygons(0.1, false, {}, whole), Error::kNone);
  (void)expectRings(whole);
  EXPECT_LT(cut.coordinates.size() + whole.coordinates.size(), 20000 * sites.size());
  expectAllInOrder(sites, diagram);
}

// --- Sites that are close together

TEST(SphericalDegenerate, PolygonsOfTwoSitesARoundingApartHaveFewPoints) {
  // Found by sphere_fuzz: at the pole the second one was a point of its own polygon.
  const SphericalSites atPole = {{-41.64705882352942, -89.999999999999119, 0}, {-180, -90, 0}};
  const SphericalDiagram diagram = diagramOf(atPole);
  for (const bool isCut : {false, true}) {
    CoverageArrays polygons;
    ASSERT_EQ(diagram.cellPolygons(0.01, isCut, {}, polygons), Error::kNone);
    EXPECT_LT(polygons.coordinates.size(), 4000u);
  }
}

TEST(SphericalDegenerate, PolygonsOfCloseSitesHaveFewPoints) {
  Random random(51);
  for (int k = 0; k < 60; ++k) {
    const double apart = 57 * std::pow(10, -6 - k % 10);
    const auto [lon, lat] = randomPoint(random);
    SphericalSites sites = {{lon, lat, 0},
                            {lon + apart * random.between(-1, 1),
                             std::clamp(lat + apart * random.between(-1, 1), -90.0, 90.0), 0}};
    if (k % 20 >= 10) {
      sites.push_back({lon + 100, 3, 0.1});
      sites.push_back({lon - 100, 20, 0});
    }
    const SphericalDiagram diagram = diagramOf(sites);
    for (const bool isCut : {false, true}) {
      CoverageArrays polygons;
      ASSERT_EQ(diagram.cellPolygons(0.01, isCut, {}, polygons), Error::kNone);
      EXPECT_LT(polygons.coordinates.size(), 8000u) << apart;
    }
  }
}

// --- Sites that others touch from inside

TEST(SphericalDegenerate, PolygonsOfANearlyCoveredSiteHaveFewPoints) {
  // Its edge is narrower than rounding, and its bisector misses the vertices.
  const SphericalSites sites = {{63.503462082115846, 67.564725825023842, 0.18968066019092417},
                                {63.260895044017474, -63.487320337593573, 1.0524522945985004},
                                {50.368239178610565, 28.161433804494298, -0.51178978461404057},
                                {-168.70723947039951, -36.070149943578656, -0.20550497254737038},
                                {70.191205790604755, -40.926150356651924, 0.65231157535368822},
                                {101.70124671013059, -35.774952680594701, 0.42036342430607743}};
  CoverageArrays polygons;
  ASSERT_EQ(diagramOf(sites).cellPolygons(0.1, false, {}, polygons), Error::kNone);
  EXPECT_LT(polygons.coordinates.size(), 200u);
}

TEST(SphericalDegenerate, ACellWithoutWidthHasNoRingOfTwoPoints) {
  // Found by sphere_fuzz: the last site touches the cap about (-30, -60) from inside.
  constexpr double kRadius = 6371.0088, kWeight = 3335.8524070059866;
  SphericalDiagram diagram(kRadius);
  std::vector<SiteId> ids(4);
  ASSERT_EQ(diagram.insertMany(
                flat({{-30, 15, kWeight}, {-30, -60, kWeight}, {-30, 15, 0}, {-180, -90, 0}}), ids),
            Error::kNone);
  CoverageArrays polygons;
  ASSERT_EQ(diagram.cellPolygons(0.001, true, {}, polygons), Error::kNone);
  EXPECT_NEAR(expectRings(polygons), 360 * 180, 1e-2);
  for (std::size_t ring = 0; ring + 1 < polygons.starts.size(); ++ring)
    EXPECT_GE(polygons.starts[ring + 1] - polygons.starts[ring], 4u);
}

/// Found by sphere_fuzz: of two sites, one on the rim of the other. Its cell is a needle, from the
/// site to the antipode of the cap; on the map it has no width where it ends at a pole or follows
/// the antimeridian. There was nothing of the other cell either.
TEST(SphericalDegenerate, CellsOfSitesOnTheRimsOfCapsCoverTheMap) {
  const auto expectCover = [](const SphericalSites& sites) {
    CoverageArrays polygons;
    ASSERT_EQ(diagramOf(sites).cellPolygons(1e-3, true, {}, polygons), Error::kNone);
    EXPECT_NEAR(expectRings(polygons), 360 * 180, 1e-2);
    for (std::size_t ring = 0; ring + 1 < polygons.starts.size(); ++ring)
      EXPECT_GE(polygons.starts[ring + 1] - polygons.starts[ring], 4u);
  };
  const auto onMeridian = [](double lon, double lat) {
    const double beyond = std::abs(lat) - 90;
    if (beyond <= 0) return SphericalCircle{lon, lat, 0};
    return SphericalCircle{lon > 0 ? lon - 180 : lon + 180, std::copysign(90 - beyond, lat), 0};
  };
  for (double lat = -90; lat <= 90; lat += 15) {
    for (double lon = -180; lon < 180; lon += 15) {
      for (double degrees = 15; degrees < 180; degrees += sized(30, 15)) {
        const SphericalCircle cap{lon, lat, kPi * degrees / 180};
        const SphericalCircle north = onMeridian(lon, lat + degrees);
        SCOPED_TRACE(std::to_string(lon) + ' ' + std::to_string(lat) + ", " +
                     std::to_string(degrees) + " degrees");
        expectCover({cap, north});
        expectCover({cap, north, onMeridian(lon, lat - degrees)});
        expectCover({cap, north, {lon, -lat, 0.1}});
      }
    }
  }
}

TEST(SphericalDegenerate, RingsOfTwoPointsAreLeftOutAtThePoleToo) {
  // Two sites of weight pi / 2 and less touch others from inside, all of them on one meridian.
  const SphericalSites sites = {{0, -75, kPi * 75 / 180 + 0x1p-52},
                                {0, 90, 0},
                                {0, 75, kPi / 4},
                                {180, 0, 0},
                                {0, 0, 0},
                                {0, 75, 0}};
  CoverageArrays polygons;
  ASSERT_EQ(diagramOf(sites).cellPolygons(0.01, true, {}, polygons), Error::kNone);
  for (std::size_t ring = 0; ring + 1 < polygons.starts.size(); ++ring)
    EXPECT_GE(polygons.starts[ring + 1] - polygons.starts[ring], 4u);
}

TEST(SphericalDegenerate, AnEdgeWithoutLengthHasNoPoints) {
  // Found by search: two sites that others nearly cover have an edge without length, in whose
  // direction their bisector goes from one end of the sphere to the other.
  const SphericalSites sites = {{105, 60, kPi / 12}, {60, -75, kPi / 12}, {-120, 45, kPi / 6},
                                {105, -90, 0},       {-75, 90, 1},        {-90, 60, 1}};
  const SphericalDiagram diagram = diagramOf(sites);
  CoverageArrays polygons;
  ASSERT_EQ(diagram.cellPolygons(0.01, true, {}, polygons), Error::kNone);
  ASSERT_EQ(polygons.sites.size(), 4u);
  EXPECT_EQ(polygons.starts.size() - 1, 4u) << "rings: a loop has been cut off";
}

// Found by sphere_fuzz: the first sites left no other pole than one that touched another site,
// whose circle was then hidden below whatever came.
TEST(SphericalDegenerate, ABetterPoleThatComesLaterIsTaken) {
  SphericalSites sites(5, {-30, 15, kPi / 6});
  sites.push_back({-30, -15, 0});
  SphericalDiagram diagram = diagramOf(sites);
  for (const SphericalCircle& site : SphericalSites{{-105, -90, 0}, {-30, 15, 0}, {60, 3, 0.1}}) {
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.insert(site.lon, site.lat, site.r, id), Error::kNone);
    sites.push_back(site);
    expectAllInOrder(sites, diagram);
  }
}

TEST(SphericalDegenerate, ThePoleIsNotASiteThatAnotherNearlyCovers) {
  // Found by sphere_fuzz. Site 5 touches site 4 from inside and covers all others. As seen from
  // site 4 its circle was of no use, and some of these were visible.
  SphericalDiagram diagram = diagramOf({{-30, 15, std::numbers::pi / 6},
                                        {-30, 15, std::numbers::pi / 6},
                                        {-45, -45, 0.1},
                                        {135, -90, 0},
                                        {-180, 60, 0},
                                        {120, -90, 5 * std::numbers::pi / 6}});
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(-30, 15, 0, id), Error::kNone);
  for (const SiteId site : {0u, 1u, 2u, 3u, 6u}) {
    bool isHidden = false;
    ASSERT_EQ(diagram.isHidden(site, isHidden), Error::kNone);
    EXPECT_TRUE(isHidden) << site;
  }
}

TEST(SphericalDegenerate, ThePoleIsNotASiteThatNearlyCoversOthers) {
  // Found by sphere_fuzz: projected from the first one, the fifth was a circle of which nothing was
  // known, and hidden below the last.
  SphericalSites sites(4, {-30, 15, kPi / 6});
  sites.push_back({-30, -15, 0});
  sites.push_back({-180, -90, 0});
  for (std::size_t k = 0; k < 8; ++k) {
    expectAllInOrder(sites, diagramOf(sites));
    sites.push_back(sites[0]);
  }
}

// Found by sphere_fuzz: the second one, which the first one nearly covers, got all longitudes below
// its ring, and the areas added up to twice the rectangle.
TEST(SphericalDegenerate, CutPolygonsWhereOneNearlyCoversAnother) {
  const SphericalSites sites = {{-30, 15, kPi / 6}, {-30, -15, 0}, {-180, -90, 0}};
  CoverageArrays polygons;
  ASSERT_EQ(diagramOf(sites).cellPolygons(0.1, true, {}, polygons), Error::kNone);
  EXPECT_NEAR(expectRings(polygons), 360 * 180, 1e-2);
}

// Found by sphere_fuzz: an edge between sites 10^-8 radians apart went to the wrong side of the
// pole.
TEST(SphericalDegenerate, CutPolygonsOfSitesOfOneLatitudeThatAreClose) {
  const SphericalSites sites = {{96.705882316455217, 48.35294117647058, 0.765625},
                                {112.87400724611412, 48.35294117647058, 0.765625},
                                {96.70588235294116, -59.930398464022701, 0.765625},
                                {96.70588235294116, 48.35294117647058, 0.765625},
                                {96.093749999999972, 48.35294117647058, 0.765625},
                                {179.99999999979633, 48.352941176477927, 0.765625}};
  CoverageArrays polygons;
  ASSERT_EQ(diagramOf(sites).cellPolygons(0.1, true, {}, polygons), Error::kNone);
  EXPECT_NEAR(expectRings(polygons), 360 * 180, 1e-2);
}

// Found by sphere_fuzz: 12.615 of 12.566.
TEST(SphericalDegenerate, AreasOfTwoSitesARoundingApart) {
  EXPECT_NEAR(sumOfAreas(diagramOf({{179.29687495809046, -89.999999999999702, 0}, {-180, -90, 0}})),
              4 * kPi, 1e-9);
}

// Found by sphere_fuzz: distances that are more than a full turn apart were compared.
TEST(SphericalDegenerate, TwinsAtTheAntipodeOfOneFarLighter) {
  constexpr double kRadius = 0x1p-20;
  SphericalDiagram diagram(kRadius);
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(51.527839211856602, -25.764705882352949, -3.14 * kRadius, id),
            Error::kNone);
  const SphericalCircle twin = {-128.47216078814341, 25.764705882352949, kPi / 6 * kRadius};
  std::vector<SiteId> ids(2);
  ASSERT_EQ(diagram.insertMany(flat({twin, twin}), ids), Error::kNone);
  Violation violation;
  ASSERT_EQ(diagram.validate(violation), Error::kNone);
  EXPECT_EQ(violation.text(), "");
}

TEST(SphericalDegenerate, SetsOfLattices) {
  Random random(52);
  constexpr double kWeights[] = {0, 0, kPi / 12, kPi / 6, 0.1, 1};
  for (int round = 0; round < 150; ++round) {
    SCOPED_TRACE(round);
    const int step = round % 2 == 0 ? 30 : 15;
    SphericalSites sites = {{0, 0, 0}, {120, 10, 0}, {-110, -20, 0}};
    for (std::size_t k = 1 + random.below(std::size_t{10}); k > 0; --k) {
      const double x = std::floor(random.between(-180, 181) / step) * step,
                   y = std::floor(random.between(-90, 91) / step) * step;
      sites.push_back({std::max(x, -180.0), std::max(y, -90.0),
                       kWeights[random.below(round % 3 == 0 ? std::size_t{2} : std::size_t{6})]});
    }
    expectSound(sites, diagramOf(sites));
  }
}

TEST(SphericalDegenerate, ASiteThatNearlyHidesOthersIsInsertedLater) {
  for (const double gap : {1e-6, 1e-5}) {
    for (const double at : {0.0, 180.0}) {
      SphericalSites sites = {{0, 0, 0.5}, {180, 0, 0.5}};
      SphericalDiagram diagram = diagramOf(sites);
      // Three sites that the one at `at`, which may be the pole, covers up to the gap.
      for (int k = 0; k < 3; ++k) {
        sites.push_back({at + 10 * (k - 1) + 5, 0, 0});
        SphericalCircle& site = sites.back();
        site.r = 0.5 - std::abs(10 * (k - 1) + 5) * kPi / 180 + gap;
        SiteId id = kNoSite;
        ASSERT_EQ(diagram.insert(site.lon, site.lat, site.r, id), Error::kNone);
        VertexArrays vertices;
        ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
        for (std::size_t n = 0; n < vertices.clearance.size(); ++n) {
          const SphericalPoint v = {vertices.coordinates[2 * n], vertices.coordinates[2 * n + 1]};
          EXPECT_NEAR(leastDistance(sites, v), vertices.clearance[n], 1e-13);
        }
        EXPECT_NEAR(sumOfAreas(diagram), 4 * kPi, 1e-6);
      }
    }
  }
}

TEST(SphericalDegenerate, WeightsFarApart) {
  const SphericalSites sites = {{0, 0, 3.1}, {175, 0, -3.1}, {180, 0, 0.01}, {-90, 80, -3}};
  const SphericalDiagram diagram = diagramOf(sites);
  expectSound(sites, diagram);
  EXPECT_EQ(diagram.visibleSize(), 2u);
}

// --- The antimeridian

TEST(SphericalDegenerate, EdgesAlongTheAntimeridianAreOnIt) {
  Random random(53);
  for (int round = 0; round < 30; ++round) {
    SphericalSites sites = {{0, 5, 0}};
    for (int k = 0; k < 4; ++k) {
      const double aside = random.between(1, 60), lat = random.between(-80, 80);
      sites.push_back({180 - aside, lat, 0});
      sites.push_back({aside - 180, lat, 0});
    }
    CoverageArrays polygons;
    ASSERT_EQ(diagramOf(sites).cellPolygons(0.01, true, {}, polygons), Error::kNone);
    EXPECT_NEAR(expectRings(polygons), 360 * 180, 1e-6);
    for (std::size_t k = 0; k < polygons.coordinates.size(); k += 2) {
      const double aside = 180 - std::abs(polygons.coordinates[k]);
      EXPECT_TRUE(aside == 0 || aside > 1e-9) << aside;
    }
    // The border is straight: of what an edge along it has of points, rings have the ends at most.
    for (std::size_t ring = 0; ring + 1 < polygons.starts.size(); ++ring) {
      for (std::size_t k = polygons.starts[ring]; k + 2 < polygons.starts[ring + 1]; ++k) {
        const auto lon = [&](std::size_t n) { return polygons.coordinates[2 * n]; };
        EXPECT_FALSE(std::abs(lon(k)) == 180 && lon(k) == lon(k + 1) && lon(k) == lon(k + 2));
      }
    }
  }
}

TEST(SphericalDegenerate, LongitudesOfAnySize) {
  const SphericalDiagram diagram = diagramOf({{std::remainder(1e300, 360), 5, 0}, {0, -50, 0}});
  SiteId id = kNoSite;
  double distance = 1;
  ASSERT_EQ(diagram.find(1e300, 5, id, distance), Error::kNone);
  EXPECT_EQ(id, 0u);
  EXPECT_EQ(distance, 0);
}

// --- Listings

TEST(SphericalDegenerate, ListsAreInTheUnitOfTheRadiusAndAgree) {
  Random random(54);
  for (const NamedSites& set : namedSets(random, 30)) {
    SCOPED_TRACE(set.name);
    SphericalDiagram diagram(6371);
    SphericalSites sites = set.sites;
    for (SphericalCircle& site : sites) site.r *= 6371;
    std::vector<SiteId> ids(sites.size());
    ASSERT_EQ(diagram.insertMany(flat(sites), ids), Error::kNone);
    VertexArrays vertices;
    ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
    for (std::size_t k = 0; k < vertices.clearance.size(); ++k) {
      const SphericalPoint v = {vertices.coordinates[2 * k], vertices.coordinates[2 * k + 1]};
      EXPECT_NEAR(leastDistance(set.sites, v) * 6371, vertices.clearance[k], 1e-9);
    }
    // Both sites of an edge are sites of the vertices at its ends.
    EdgeArrays edges;
    ASSERT_EQ(diagram.edges(edges), Error::kNone);
    for (std::size_t k = 0; k < edges.vertices.size() && vertices.clearance.size() > 0; k += 2) {
      EXPECT_NE(edges.vertices[k], edges.vertices[k + 1]);
      for (const std::size_t end : {k, k + 1}) {
        const auto corners = std::span(vertices.sites).subspan(3 * edges.vertices[end], 3);
        for (const std::size_t side : {k, k + 1})
          EXPECT_NE(std::ranges::find(corners, edges.sites[side]), corners.end());
      }
    }
    for (const SiteId id : ids) {
      std::vector<SiteId> neighbors;
      ASSERT_EQ(diagram.neighbors(id, neighbors), Error::kNone);
      EXPECT_EQ(std::set(neighbors.begin(), neighbors.end()).size(), neighbors.size());
    }
  }
}

TEST(SphericalDegenerate, OfTwoSitesEachIsTheNeighbourOfTheOther) {
  const SphericalDiagram diagram = diagramOf({{12, 34, 0.5}, {-100, 80, 0.1}});
  for (const SiteId id : {0u, 1u}) {
    std::vector<SiteId> neighbors;
    ASSERT_EQ(diagram.neighbors(id, neighbors), Error::kNone);
    EXPECT_EQ(neighbors, std::vector<SiteId>{1 - id});
  }
}

TEST(SphericalDegenerate, TwoSitesWithTwoEdgesAreNeighboursOnce) {
  // The third is in front of the middle of the edge between the first two.
  const SphericalDiagram diagram = diagramOf({{0, 0, 0.3}, {40, 0, 0.3}, {20, 0, 0.05}});
  std::vector<SiteId> neighbors;
  for (const SiteId id : {0u, 1u, 2u}) {
    ASSERT_EQ(diagram.neighbors(id, neighbors), Error::kNone);
    EXPECT_EQ(neighbors.size(), 2u);
  }
}

// --- A walk's way that is barred

TEST(SphericalNearest, IsFoundBehindASiteThatAnotherNearlyHides) {
  // The cell of site 9 narrows between those of sites 2 and 3. There the cell of site 0, which site
  // 9 hides up to rounding, bars it from side to side. Behind it is the cell of site 1: walks from
  // site 9 stayed there, 10^-6 from the right distance.
  constexpr double kDegrees = 180 / std::numbers::pi;
  constexpr double kWeight = 0.2, kAt = 0.1, kNarrow = 0.7, kAngle = 0.03;  // radians
  const double lon = kNarrow - 0.3 * std::cos(kAngle), lat = 0.3 * std::sin(kAngle);
  const auto at = [&](double x, double y, double r) {
    return SphericalCircle{x * kDegrees, y * kDegrees, r};
  };
  const double besides = angleOf(at(lon, lat, 0), at(kNarrow, 0, 0)) - (kNarrow - kWeight);
  for (double gap = 2e-16; gap < 4e-15; gap *= 1.2) {
    const double width = kNarrow * std::sqrt(2 * gap / kAt), length = 0.4 * width / (kAngle / 2);
    const double begin = kNarrow - length, centre = kNarrow + length / 2;
    const SphericalSites sites = {at(kAt, 0, kWeight - kAt + gap),
                                  at(centre, 0, centre - 2 * begin + kWeight),
                                  at(lon, lat, besides),
                                  at(lon, -lat, besides),
                                  {170, 20, 0},
                                  {-170, -30, 0},
                                  {150, 40, 0},
                                  {-160, 10, 0},
                                  {180, -60, 0},
                                  at(0, 0, kWeight)};
    const SphericalDiagram diagram = diagramOf(sites);
    for (int x = -10; x <= 30; ++x) {
      for (int y = -15; y <= 15; ++y) {
        const SphericalPoint p = {(begin + (centre - begin) * x / 10) * kDegrees,
                                  width * y / 10 * kDegrees};
        double least = std::numeric_limits<double>::infinity();
        for (const SphericalCircle& site : sites) least = std::min(least, distanceOf(p, site));
        SiteId id = kNoSite;
        ASSERT_EQ(diagram.find(p.lon, p.lat, id), Error::kNone);
        ASSERT_LE(distanceOf(p, sites[id]), least + 4e-15) << gap << ' ' << x << ' ' << y;
      }
    }
  }
}

// --- Snapshots

TEST(SphericalSnapshots, OfADiagramThatHasBecomeEmptyIsTheSame) {
  // Found by sphere_fuzz.
  SphericalDiagram diagram = diagramOf({{-150, 90, 0.001}}), restored;
  bool removed = false;
  ASSERT_EQ(diagram.remove(0, removed), Error::kNone);
  ASSERT_EQ(restored.fromBytes(saved(diagram)), Error::kNone);
  EXPECT_EQ(saved(restored), saved(diagram));
}

/// A snapshot with some bytes replaced, and the checksum that belongs to that.
template <class Value>
std::vector<std::uint8_t> madeUp(std::vector<std::uint8_t> bytes, std::size_t at, Value value) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(&value);
  std::copy(from, from + sizeof value, bytes.begin() + static_cast<std::ptrdiff_t>(at));
  const std::size_t size = bytes.size() - 8;
  const std::uint64_t sum = internal::checksumOf({bytes.data(), size});
  for (unsigned k = 0; k < 8; ++k) bytes[size + k] = static_cast<std::uint8_t>(sum >> (8 * k));
  return bytes;
}

TEST(SphericalSnapshots, MadeUpCoversAreRefusedOrCover) {
  // Nested sites and twins, also of the pole. In each pair of a hidden site and its cover, each
  // word is replaced by each id.
  SphericalSites sites;
  for (const double lon : {0.0, 90.0, 180.0, -90.0}) {
    for (const double r : {0.3, 0.3, 0.25, 0.25, 0.1}) sites.push_back({lon, 0, r});
  }
  const SphericalDiagram diagram = diagramOf(sites);
  const std::size_t kSites = sites.size(), kHidden = kSites - 4;
  const std::size_t kPairs = 48 + 28 * kSites;
  const std::vector<std::uint8_t> bytes = saved(diagram);
  ASSERT_EQ(bytes.size(), kPairs + 8 * kHidden + 8);
  std::size_t refused = 0;
  for (std::size_t word = 0; word < 2 * kHidden; ++word) {
    for (std::uint32_t id = 0; id <= kSites; ++id) {
      SphericalDiagram restored;
      const Error error = restored.fromBytes(madeUp(bytes, kPairs + 4 * word, id));
      const std::size_t own = kPairs + 8 * (word / 2);
      const bool isBelowItself = word % 2 == 1 && bytes[own] == id;
      ASSERT_TRUE(error == Error::kCorruptSnapshot || !isBelowItself) << id;
      refused += error == Error::kCorruptSnapshot;
      if (error == Error::kCorruptSnapshot) continue;
      ASSERT_EQ(error, Error::kNone);
      Violation violation;
      ASSERT_EQ(restored.validate(violation), Error::kNone);
      ASSERT_EQ(violation.text(), "");
      ASSERT_EQ(restored.visibleSize(), 4u);
    }
  }
  EXPECT_GT(refused, 400u);
}

TEST(SphericalSnapshots, MadeUpOnesAreRefused) {
  // 48 bytes of a header, with the pole at 20; three numbers a site; the ids.
  constexpr std::size_t kPole = 20, kRadius = 40, kSites = 48;
  const SphericalDiagram diagram = diagramOf({{0, 0, 1}, {10, 0, 0.1}, {120, 10, 0}, {-90, 0, 0}});
  constexpr std::size_t kIds = kSites + 4 * 24;
  const std::vector<std::uint8_t> bytes = saved(diagram);
  const auto errorOf = [](const std::vector<std::uint8_t>& snapshot) {
    SphericalDiagram restored;
    return restored.fromBytes(snapshot);
  };
  ASSERT_EQ(errorOf(madeUp(bytes, kSites, 0.25)), Error::kNone);
  EXPECT_EQ(errorOf(madeUp(bytes, kPole, 1u)), Error::kCorruptSnapshot) << "a hidden pole";
  EXPECT_EQ(errorOf(madeUp(bytes, kPole, 4u)), Error::kCorruptSnapshot);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double radius : {0.0, -1.0, nan})
    EXPECT_EQ(errorOf(madeUp(bytes, kRadius, radius)), Error::kCorruptSnapshot);
  EXPECT_EQ(errorOf(madeUp(bytes, kSites, nan)), Error::kCorruptSnapshot) << "a longitude";
  EXPECT_EQ(errorOf(madeUp(bytes, kSites + 8, 90.5)), Error::kCorruptSnapshot) << "a latitude";
  EXPECT_EQ(errorOf(madeUp(bytes, kSites + 16, 3.2)), Error::kCorruptSnapshot) << "a weight";
  EXPECT_EQ(errorOf(madeUp(bytes, kSites + 48 + 8, 90.5)), Error::kCorruptSnapshot)
      << "a latitude of a visible site";
  EXPECT_EQ(errorOf(madeUp(bytes, kIds + 4, 0u)), Error::kCorruptSnapshot) << "an id twice";
  EXPECT_EQ(errorOf(madeUp(bytes, kIds + 4, 4u)), Error::kCorruptSnapshot) << "no id";
  const std::uint64_t swapped = 3 | std::uint64_t{2} << 32;  // the ids 3 and 2
  EXPECT_EQ(errorOf(madeUp(bytes, kIds + 8, swapped)), Error::kCorruptSnapshot) << "not ascending";
  EXPECT_EQ(errorOf(madeUp(bytes, kIds + 16, 2u)), Error::kCorruptSnapshot) << "a visible site";
  EXPECT_EQ(errorOf(madeUp(bytes, kIds + 20, 2u)), Error::kCorruptSnapshot) << "no cover";
  EXPECT_EQ(errorOf(madeUp(bytes, kIds + 20, 1u)), Error::kCorruptSnapshot) << "below itself";
  // Without the hidden site's pair, and with an id twice where no site is hidden.
  constexpr std::size_t kHidden = 28;
  std::vector<std::uint8_t> none = madeUp(bytes, kHidden, 0u);
  none.erase(none.begin() + kIds + 16, none.begin() + kIds + 24);
  EXPECT_EQ(errorOf(madeUp(none, kHidden, 0u)), Error::kCorruptSnapshot) << "a hidden site shown";
  std::vector<std::uint8_t> visible;
  ASSERT_EQ(diagramOf({{10, 0, 0}, {120, 10, 0}, {-90, 5, 0}}).toBytes(visible), Error::kNone);
  EXPECT_EQ(errorOf(madeUp(visible, kSites + 3 * 24 + 4, 0u)), Error::kCorruptSnapshot)
      << "an id twice, none hidden";
  std::vector<std::uint8_t> empty;
  ASSERT_EQ(SphericalDiagram().toBytes(empty), Error::kNone);
  EXPECT_EQ(errorOf(madeUp(empty, kPole, 0u)), Error::kCorruptSnapshot) << "a pole of no site";
  empty.insert(empty.end() - 8, 8, 0);
  EXPECT_EQ(errorOf(madeUp(empty, kHidden, 1u)), Error::kCorruptSnapshot) << "a hidden one of none";
}

}  // namespace
}  // namespace apollonius::test
