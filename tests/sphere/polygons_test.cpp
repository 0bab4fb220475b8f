// Polygons of the sphere's cells: cut ones are a coverage of the plane of longitude and latitude,
// others have the area of the cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "geometry/coverage_judge.h"
#include "sphere/sphere_sets.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

constexpr double kTolerances[] = {1e-5, 1e-3, 0.1};

bool isOnMapsBorder(const Place& a, const Place& b) {
  return (std::abs(a.first) == 180 && a.first == b.first) ||
         (std::abs(a.second) == 90 && a.second == b.second);
}

TEST(SphericalPolygons, CutOnesCoverTheRectangleOnce) {
  Random random(11);
  for (int round = 0; round < sized(3, 6); ++round) {
    for (const NamedSites& set : namedSets(random, 4 + 9 * static_cast<std::size_t>(round))) {
      const SphericalDiagram diagram = diagramOf(set.sites);
      for (const double tolerance : kTolerances) {
        SCOPED_TRACE(set.name + ", round " + std::to_string(round) + ", tolerance " +
                     std::to_string(tolerance));
        CoverageArrays polygons;
        ASSERT_EQ(diagram.cellPolygons(tolerance, true, {}, polygons), Error::kNone);
        CoverageJudge judge(polygons, 360.0 * 180);
        judge.expectPairs(isOnMapsBorder);
        if (polygons.coordinates.size() < 2000) judge.expectNoCrossings();
        EXPECT_EQ(judge.complaints(), "");
        RingArrays single;
        ASSERT_EQ(diagram.cellPolygon(polygons.sites[0], tolerance, true, kEverywhere, single),
                  Error::kNone);
        EXPECT_TRUE(std::equal(single.coordinates.begin(), single.coordinates.end(),
                               polygons.coordinates.begin()));
      }
    }
  }
}

/// The cells of sites, cut, cover the map once, no line crosses another, and no ring has more than
/// `mostPoints`.
void expectCover(const SphericalSites& sites, double tolerance, std::size_t mostPoints) {
  std::ostringstream name;
  name.precision(17);
  name << "tolerance " << tolerance;
  for (const SphericalCircle& s : sites) name << ", " << s.lon << ' ' << s.lat << ' ' << s.r;
  SCOPED_TRACE(name.str());
  CoverageArrays polygons;
  ASSERT_EQ(diagramOf(sites).cellPolygons(tolerance, true, {}, polygons), Error::kNone);
  CoverageJudge judge(polygons, 360.0 * 180);
  judge.expectPairs(isOnMapsBorder);
  if (polygons.coordinates.size() < 2000) judge.expectNoCrossings();
  ASSERT_EQ(judge.complaints(), "");
  for (std::size_t ring = 0; ring + 1 < polygons.starts.size(); ++ring)
    ASSERT_LE(polygons.starts[ring + 1] - polygons.starts[ring], mostPoints);
}

double wrapped(double lon) { return lon > 180 ? lon - 360 : lon <= -180 ? lon + 360 : lon; }

/// Longitude beside a pole is rounding, and a chain that follows it does not end: it had thousands
/// of points, and crossed itself. A border that passes a pole is halved until it is there, which
/// leaves two points at most for each power of 2 of the way, on both sides; a great circle has a
/// few more. So the tolerance does not matter, and there are at most 2 (2 * 37 + 8) points.
TEST(SphericalPolygons, BordersAlongMeridiansHaveFewPointsAtAnyTolerance) {
  Random random(21);
  for (int lat = -88; lat <= 88; lat += sized(11, 1)) {
    for (int lon = -180; lon < 180; lon += sized(30, 7)) {
      const double way = std::floor(random.between(1, 180)), r = random.below(2u) * 0.25;
      const double latitude = lat, first = lon, second = wrapped(first + way);
      for (const double tolerance : {1e-9, 1e-3, 1.0})
        expectCover({{first, latitude, r}, {second, latitude, r}}, tolerance, 164);
    }
  }
  constexpr std::size_t most = 164;
  for (const double meridian : {0.0, 180.0, 17.0}) {
    const double a = wrapped(meridian - 20), b = wrapped(meridian + 20);
    expectCover({{a, -20, 0}, {b, -20, 0}, {b, 20, 0}, {a, 20, 0}}, 1e-3, most);
    expectCover({{a, 50, 0}, {b, 50, 0}, {meridian, 10, 0}, {wrapped(meridian + 180), -80, 0}},
                1e-3, most);
  }
}

/// Borders around the sphere are as long on the map as that is wide, or longer. Halving makes at
/// most twice as many pieces as the tolerance asks for, and a hundredth of the tolerance takes ten
/// times as many.
TEST(SphericalPolygons, NumbersOfPointsGoWithTheRootOfTheTolerance) {
  for (double lat = -85; lat <= 85; lat += sized(17, 1)) {
    for (const double r : {0.0, 0.3}) {
      SphericalSites sites = {{-138, lat, 0}, {42, -lat, 0}};
      if (r > 0) sites = {{-165, lat, 0}, {15, lat, 0}, {0, 90, r}};
      expectCover(sites, 1e-2, 110);
      expectCover(sites, 1e-4, 600);
      expectCover(sites, 1e-6, 6000);
    }
  }
}

/// Sets that are symmetric about a meridian have borders along it, and vertices at poles.
TEST(SphericalPolygons, OfSetsThatAreSymmetricAboutAMeridianCoverTheMap) {
  Random random(22);
  for (int round = 0; round < sized(60, 1000); ++round) {
    const double meridian = round % 3 == 0 ? 180 : std::floor(random.between(-180, 180));
    const double heaviest = round % 2 * 0.2;
    SphericalSites sites;
    for (std::size_t k = 1 + random.below(std::size_t{5}); k > 0; --k) {
      const double aside = std::floor(random.between(1, 90)),
                   lat = std::floor(random.between(-89, 90));
      const double r = random.between(0, heaviest);
      sites.push_back({wrapped(meridian + aside), lat, r});
      sites.push_back({wrapped(meridian - aside), lat, r});
    }
    expectCover(sites, 1e-3, 500);
  }
  for (std::size_t n = 2; n < 12; ++n) {  // about the poles
    SphericalSites sites;
    for (std::size_t k = 0; k < n; ++k)
      sites.push_back({wrapped(360.0 * static_cast<double>(k) / static_cast<double>(n)), 35, 0.1});
    expectCover(sites, 1e-3, 164);
  }
}

/// Cells there are as small as their distance from the pole, and on the map as wide as it is.
TEST(SphericalPolygons, OfSitesBesideAPoleCoverTheMap) {
  Random random(23);
  for (int round = 0; round < sized(60, 1000); ++round) {
    const double pole = round % 2 == 0 ? 90 : -90;
    const auto besidePole = [&](double degrees) {
      return SphericalCircle{std::floor(random.between(-180, 180)),
                             pole - std::copysign(degrees, pole), 0};
    };
    const double degrees = std::pow(10, -random.between(0, 12));
    const SphericalCircle first = besidePole(degrees);
    SphericalCircle other = besidePole(degrees);
    if (other.lon == first.lon) other.lon = wrapped(first.lon + 90);
    for (const double tolerance : {1e-4, 1e-2}) {
      expectCover({first, other}, tolerance, 500);
      SphericalSites sites = randomSites(random, 4, 0.3);
      sites.push_back(first);
      sites.push_back(other);
      expectCover(sites, tolerance, 1500);
      sites.clear();
      for (int k = 0; k < 16; ++k) sites.push_back(besidePole(std::pow(10, -random.between(0, 9))));
      expectCover(sites, tolerance, 500);
    }
  }
}

/// Seen from one of two sites that are a few roundings apart, all of their border is within a
/// rounding of two directions. It is halved until it is at the poles and at both sites' turns.
TEST(SphericalPolygons, OfTwinsWhoseBorderPassesThePolesCoverTheMap) {
  Random random(24);
  for (int round = 0; round < sized(60, 1000); ++round) {
    const double aside = std::pow(10, -random.between(6, 12));
    const double lon = std::floor(random.between(-179, 179)),
                 lat = std::floor(random.between(-80, 80));
    SphericalSites sites = {{lon - aside, lat, 0}, {lon + aside, lat, 0}};
    expectCover(sites, 1e-3, 300);
    for (const SphericalCircle& site : randomSites(random, 2, 0)) sites.push_back(site);
    expectCover(sites, 1e-2, 500);
  }
}

/// Two sites that are close are seen from afar in nearly one direction, which leaves the vertex of
/// two such pairs, mirrored, to rounding. It was two, on the wrong sides of each other, and what
/// was computed as the edge between them crossed others.
TEST(SphericalPolygons, OfClosePairsThatMirrorEachOtherCoverTheMap) {
  expectCover({{10, 45, 0}, {10.1, 45, 0}, {10, 89, 0}, {10.1, 89, 0}}, 1e-4, 300);
  expectCover({{0, 0, 0}, {0.001, 0, 0}, {0, 30, 0}, {0.001, 30, 0}}, 1e-4, 300);
  expectCover({{-75, 80, 0}, {-74.9, 80, 0}, {-75, -80, 0}, {-74.9, -80, 0}}, 1e-4, 300);
  Random random(25);
  for (int round = 0; round < sized(200, 4000); ++round) {
    const double apart = std::pow(10, -random.between(0, 6)), r = random.below(2u) * 0.1;
    const double lon = std::floor(random.between(-180, 180)), next = wrapped(lon + apart);
    const double lat = std::floor(random.between(-89, 89)), across = random.below(2u) * 180.0;
    const double other = round % 2 == 0 ? -lat : std::floor(random.between(-89, 89));
    if (other == lat && across == 0) continue;
    expectCover({{lon, lat, r},
                 {next, lat, r},
                 {wrapped(lon + across), other, r},
                 {wrapped(next + across), other, r}},
                1e-4, 400);
    // Beside a meridian, in a meridian's direction.
    const double up = lat + (lat > 0 ? -apart : apart);
    if (lon != -180 && lon != 0)
      expectCover({{lon, lat, r}, {lon, up, r}, {-lon, lat, r}, {-lon, up, r}}, 1e-4, 400);
  }
}

/// An edge that crosses the equator is an S on the map, whose middle says nothing; of a chord that
/// crosses the antimeridian both parts are as close to the edge as the whole.
TEST(SphericalPolygons, LinesOfTheMapAreWithinTheToleranceOfEdges) {
  Random random(14);
  for (int round = 0; round < sized(60, 2000); ++round) {
    SCOPED_TRACE(round);
    const bool isSymmetric = round % 2 == 0;
    SphericalSites sites = randomSites(random, 2 + random.below(std::size_t{5}), 0.3);
    if (isSymmetric) {
      for (std::size_t k = sites.size(); k-- > 0;)
        sites.push_back({-sites[k].lon, -sites[k].lat, sites[k].r});
    }
    const SphericalDiagram diagram = diagramOf(sites);
    for (const double tolerance : {0.03, 1e-3}) {
      CoverageArrays polygons;
      ASSERT_EQ(diagram.cellPolygons(tolerance, true, {}, polygons), Error::kNone);
      for (std::size_t ring = 0; ring + 1 < polygons.starts.size(); ++ring) {
        for (std::uint32_t k = polygons.starts[ring]; k + 1 < polygons.starts[ring + 1]; ++k) {
          const double* p = &polygons.coordinates[std::size_t{2} * k];
          const auto isOnBorder = [&](std::size_t at, double border) {
            return std::abs(p[at]) == border && p[at] == p[at + 2];
          };
          if (isOnBorder(0, 180) || isOnBorder(1, 90)) continue;
          for (const double part : {0.15, 0.5, 0.8}) {
            const SphericalPoint at{p[0] + part * (p[2] - p[0]), p[1] + part * (p[3] - p[1])};
            std::vector<double> distances;
            for (const SphericalCircle& site : sites) distances.push_back(distanceOf(at, site));
            std::ranges::nth_element(distances, distances.begin() + 1);
            const double nearest = std::min(distances[0], distances[1]);
            // Twice the way to the edge, or less.
            ASSERT_LE(std::abs(distances[0] + distances[1] - 2 * nearest), 2.2 * tolerance)
                << at.lon << ' ' << at.lat;
          }
        }
      }
    }
  }
}

TEST(SphericalPolygons, OfNeedlesThinnerThanTheToleranceAcrossTheAntimeridian) {
  // Such a needle's sides may cross the border in the wrong order, and then its polygon was all but
  // the needle: the sum of areas was twice the rectangle's.
  const SphericalSites scenes[] = {{{49.00446310718624, 65.258375601714221, 0.7506228592111599},
                                    {-168.056810873197, 90, 0.31880022291821603},
                                    {-132.853098685431, 88.161478298204898, 0.28702275301740376},
                                    {94.895265862911629, -19.874262328597414, 0.1089989510205728}},
                                   {{34.931570836794691, 46.9493423022329, 0.69040219558056115},
                                    {57.413367145577013, 73.51896941905764, 0.23066335494135659},
                                    {17.156088558242665, 90, -0.05698444921488173},
                                    {-99.526457087583537, 66.236298335732798, 0.7746662940487673},
                                    {-66.120147219541877, 81.945552997193971, 0.51058575726224298},
                                    {179.93000277818828, 90, 0.37001024638215751},
                                    {44.39924128064348, 68.887258649964167, 0.48487589607710158},
                                    {63.140881226167551, 90, 0.11638905467209734},
                                    {13.259117940262342, 53.401130840424301, 0.73699251876919192}}};
  for (const SphericalSites& sites : scenes) {
    const SphericalDiagram diagram = diagramOf(sites);
    for (const double tolerance : {0.3, 0.1, 0.05, 0.01}) {
      SCOPED_TRACE(tolerance);
      CoverageArrays polygons;
      ASSERT_EQ(diagram.cellPolygons(tolerance, true, {}, polygons), Error::kNone);
      EXPECT_EQ(CoverageJudge(polygons, 360.0 * 180).complaints(), "");
    }
  }
}

TEST(SphericalPolygons, OfOneCellAreThoseAmongAllCells) {
  // Whatever has been asked before; and of cells with more vertices than there is room at first.
  Random random(13);
  for (const NamedSites& set : namedSets(random, 100)) {
    SCOPED_TRACE(set.name);
    const SphericalDiagram diagram = diagramOf(set.sites);
    for (const bool isCut : {false, true}) {
      CoverageArrays all;
      ASSERT_EQ(diagram.cellPolygons(0.1, isCut, {}, all), Error::kNone);
      for (std::size_t k = 0; k < all.sites.size(); ++k) {
        RingArrays one;
        ASSERT_EQ(diagram.cellPolygon(all.sites[k], 0.1, isCut, kEverywhere, one), Error::kNone);
        const auto begin = all.starts[all.parts[all.cells[k]]];
        const auto end = all.starts[all.parts[all.cells[k + 1]]];
        const std::vector<double> expected(all.coordinates.begin() + 2 * begin,
                                           all.coordinates.begin() + 2 * end);
        ASSERT_EQ(one.coordinates, expected) << all.sites[k];
      }
    }
  }
}

/// Area of a ring of arcs of great circles that has less than a hemisphere at its left: by the
/// triangles of its sides with a point (Oosterom and Strackee).
double areaOfRing(const std::vector<double>& coordinates, const SphericalCircle& site) {
  const LongVector u = longDirection(site.lon, site.lat);
  double area = 0;
  for (std::size_t k = 0; k + 3 < coordinates.size(); k += 2) {
    const LongVector a = longDirection(coordinates[k], coordinates[k + 1]),
                     b = longDirection(coordinates[k + 2], coordinates[k + 3]);
    const auto dot = [](const LongVector& p, const LongVector& q) {
      return p.x * q.x + p.y * q.y + p.z * q.z;
    };
    const long double volume = u.x * (a.y * b.z - a.z * b.y) - u.y * (a.x * b.z - a.z * b.x) +
                               u.z * (a.x * b.y - a.y * b.x);
    area += static_cast<double>(2 * std::atan2(volume, 1 + dot(u, a) + dot(a, b) + dot(b, u)));
  }
  return area;
}

TEST(SphericalPolygons, HaveTheAreasOfTheCells) {
  Random random(12);
  for (const NamedSites& set : namedSets(random, 40)) {
    SCOPED_TRACE(set.name);
    const SphericalDiagram diagram = diagramOf(set.sites);
    CoverageArrays polygons;
    ASSERT_EQ(diagram.cellPolygons(1e-5, false, {}, polygons), Error::kNone);
    std::vector<double> areas;
    ASSERT_EQ(diagram.cellAreas({}, areas), Error::kNone);
    EXPECT_EQ(polygons.sites.size(), diagram.visibleSize());
    for (std::size_t k = 0; k < polygons.sites.size(); ++k) {
      const SiteId id = polygons.sites[k];
      if (diagram.visibleSize() == 1) {
        EXPECT_TRUE(polygons.coordinates.empty());
        continue;
      }
      ASSERT_EQ(polygons.cells[k + 1], polygons.cells[k] + 1);
      const std::size_t part = polygons.cells[k];
      ASSERT_EQ(polygons.parts[part + 1], polygons.parts[part] + 1);
      const std::size_t ring = polygons.parts[part];
      const std::vector<double> coordinates(
          polygons.coordinates.begin() + 2 * polygons.starts[ring],
          polygons.coordinates.begin() + 2 * polygons.starts[ring + 1]);
      EXPECT_NEAR(areaOfRing(coordinates, set.sites[id]), areas[id], 2e-4) << id;
    }
  }
}

}  // namespace
}  // namespace apollonius::test
