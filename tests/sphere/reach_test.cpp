// Cells of the sphere that end at a distance from their sites: measures against samples, polygons
// against measures, and the points that neighbours have in common.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "sphere/sphere_sets.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDistances[] = {-0.05, 0, 1e-3, 0.1, 0.4, 1, 2, 3.1};

/// Named sets, and sites so close that their edges come from afar, turn beside them, and go back.
std::vector<NamedSites> setsOf(Random& random, std::size_t n) {
  std::vector<NamedSites> sets = namedSets(random, n);
  SphericalSites pairs;
  for (std::size_t k = 0; k < 5; ++k) {
    const SphericalPoint p = k == 0 ? SphericalPoint{180, -39} : randomPoint(random);
    pairs.push_back({p.lon, p.lat, 0});
    pairs.push_back({p.lon, p.lat + std::pow(10, -static_cast<double>(k) - 1), 0});
  }
  sets.push_back({"pairs", pairs});
  // Also edges as narrow as rounding, seen from their sites.
  SphericalSites clusters = randomSites(random, 6, 0.2);
  for (int k = 4; k < 12; k += 2) {
    const SphericalPoint p = randomPoint(random);
    const double size = std::pow(10, -k);
    for (int site = 0; site < 4; ++site)
      clusters.push_back(
          {p.lon, p.lat + random.between(0, size), site * random.between(0, size / 99)});
  }
  sets.push_back({"clusters", clusters});
  return sets;
}

/// Random distances; some sites are unlimited, some have nothing.
std::vector<double> distancesById(Random& random, std::size_t n) {
  std::vector<double> distances;
  for (std::size_t k = 0; k < n; ++k)
    distances.push_back(k % 5 == 4 ? kEverywhere : random.between(-0.1, 1));
  return distances;
}

using Distances = std::vector<double>;  // as the calls take them

struct Measured {
  std::vector<double> areas, perimeters;
};

Measured measured(const SphericalDiagram& diagram, const Distances& distances) {
  Measured all;
  EXPECT_EQ(diagram.cellAreas(distances, all.areas), Error::kNone);
  EXPECT_EQ(diagram.cellPerimeters(distances, all.perimeters), Error::kNone);
  return all;
}

using Vector = std::array<double, 3>;
Vector vectorAt(const std::vector<double>& coordinates, std::size_t k) {
  const auto [x, y, z] = longDirection(coordinates[2 * k], coordinates[2 * k + 1]);
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}
double dotOf(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector crossOf(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double lengthBetween(const Vector& a, const Vector& b) {
  return std::atan2(std::sqrt(dotOf(crossOf(a, b), crossOf(a, b))), dotOf(a, b));
}

/// Area and length of a ring of great arcs, the area by triangles with its site.
std::pair<double, double> ofRing(const std::vector<double>& coordinates, std::size_t begin,
                                 std::size_t end, const Vector& site) {
  double area = 0, length = 0;
  for (std::size_t k = begin; k + 1 < end; ++k) {
    const Vector a = vectorAt(coordinates, k), b = vectorAt(coordinates, k + 1);
    length += lengthBetween(a, b);
    area += 2 * std::atan2(dotOf(site, crossOf(a, b)),
                           1 + dotOf(site, a) + dotOf(a, b) + dotOf(b, site));
  }
  return {area, length};
}

TEST(SphericalReach, MeasuresOfOneCapAndOfTwoAreTheirs) {
  const SphericalDiagram one = diagramOf({{12, 34, 0.5}});
  for (const double distance : kDistances) {
    const double angle = std::min(0.5 + distance, kPi);
    double area = 0, perimeter = 0;
    ASSERT_EQ(one.cellArea(0, distance, area), Error::kNone);
    ASSERT_EQ(one.cellPerimeter(0, distance, perimeter), Error::kNone);
    EXPECT_NEAR(area, 2 * kPi * (1 - std::cos(angle)), 1e-14) << distance;
    EXPECT_NEAR(perimeter, 2 * kPi * std::sin(angle), 1e-14) << distance;
  }
  // Equal opposite caps: their common edge is the great circle between.
  const SphericalDiagram two = diagramOf({{0, 90, 0.25}, {0, -90, 0.25}});
  const Measured whole = measured(two, {}), cut = measured(two, {1});
  EXPECT_NEAR(whole.perimeters[0], 2 * kPi, 1e-14);
  EXPECT_NEAR(whole.areas[1], 2 * kPi, 1e-14);
  EXPECT_NEAR(cut.areas[0], 2 * kPi * (1 - std::cos(1.25)), 1e-14);
  EXPECT_NEAR(cut.perimeters[1], 2 * kPi * std::sin(1.25), 1e-14);
}

TEST(SphericalReach, AreasAreThoseOfSampledCells) {
  Random random(21);
  for (const NamedSites& set : namedSets(random, 12)) {
    SCOPED_TRACE(set.name);
    const SphericalDiagram diagram = diagramOf(set.sites);
    const std::vector<double> distances = distancesById(random, set.sites.size());
    std::vector<double> areas, counts(set.sites.size(), 0);
    ASSERT_EQ(diagram.cellAreas(distances, areas), Error::kNone);
    constexpr int kPoints = 20000;  // on Vogel's spiral
    for (int k = 0; k < kPoints; ++k) {
      const double z = 1 - (2 * k + 1.0) / kPoints;
      SiteId id = kNoSite;
      double distance = 0;
      ASSERT_EQ(diagram.find(std::remainder(k * 137.50776405003785, 360), std::asin(z) * 180 / kPi,
                             id, distance),
                Error::kNone);
      const bool isWithin = distance <= distances[id];
      if (isWithin) counts[id] += 4 * kPi / kPoints;
      if (k % 10 != 0) continue;
      bool isInside = !isWithin;
      ASSERT_EQ(diagram.contains(id, std::remainder(k * 137.50776405003785, 360),
                                 std::asin(z) * 180 / kPi, distances[id], isInside),
                Error::kNone);
      EXPECT_EQ(isInside, isWithin) << id;
    }
    for (SiteId id = 0; id < set.sites.size(); ++id) {
      EXPECT_NEAR(areas[id], counts[id], 0.008) << id;
      double area = -1;
      ASSERT_EQ(diagram.cellArea(id, distances[id], area), Error::kNone);
      EXPECT_EQ(area, areas[id]);
    }
  }
}

TEST(SphericalReach, NeighboursAreAsNearAsTheirEdges) {
  Random random(23);
  for (const NamedSites& set : namedSets(random, 12)) {
    SCOPED_TRACE(set.name);
    const SphericalDiagram diagram = diagramOf(set.sites);
    for (SiteId id = 0; id < set.sites.size(); ++id) {
      std::vector<SiteId> all, neighbors, others;
      std::vector<double> distances, theirs;
      ASSERT_EQ(diagram.neighbors(id, all), Error::kNone);
      ASSERT_EQ(diagram.cellNeighbors(id, neighbors, distances), Error::kNone);
      ASSERT_EQ(neighbors.size(), distances.size());
      EXPECT_EQ(std::set<SiteId>(neighbors.begin(), neighbors.end()),
                std::set<SiteId>(all.begin(), all.end()));
      for (std::size_t k = 0; k < neighbors.size(); ++k) {
        // Both sites say the same of their edge, and no edge is nearer than halfway.
        ASSERT_EQ(diagram.cellNeighbors(neighbors[k], others, theirs), Error::kNone);
        bool isFound = false;
        for (std::size_t m = 0; m < others.size(); ++m)
          isFound = isFound || (others[m] == id && theirs[m] == distances[k]);
        EXPECT_TRUE(isFound) << id << " " << neighbors[k];
        double centre = 0;
        SiteId nearest = kNoSite;
        const SphericalCircle& site = set.sites[neighbors[k]];
        const SphericalDiagram one = diagramOf({set.sites[id]});
        ASSERT_EQ(one.find(site.lon, site.lat, nearest, centre), Error::kNone);
        EXPECT_GE(distances[k], (centre - site.r) / 2 - 1e-12);
        EXPECT_GE(distances[k], -std::min(site.r, set.sites[id].r) - 1e-12);
      }
    }
  }
}

TEST(SphericalReach, PolygonsHaveTheAreaAndTheLengthOfTheirCells) {
  Random random(22);
  for (const NamedSites& set : setsOf(random, static_cast<std::size_t>(sized(20, 200)))) {
    const SphericalDiagram diagram = diagramOf(set.sites);
    std::vector<Distances> reaches = {{}, distancesById(random, set.sites.size())};
    for (const double distance : kDistances) reaches.push_back({distance});
    for (std::size_t k = 0; k < reaches.size(); ++k) {
      SCOPED_TRACE(set.name + ", reach " + std::to_string(k));
      const auto [areas, perimeters] = measured(diagram, reaches[k]);
      CoverageArrays polygons;
      ASSERT_EQ(diagram.cellPolygons(1e-6, false, reaches[k], polygons), Error::kNone);
      std::set<SiteId> shown;
      for (std::size_t c = 0; c < polygons.sites.size(); ++c) {
        const SiteId id = polygons.sites[c];
        shown.insert(id);
        if (polygons.cells[c] == polygons.cells[c + 1]) {
          EXPECT_NEAR(areas[id], 4 * kPi, 1e-12);
          continue;
        }
        ASSERT_EQ(polygons.cells[c] + 1, polygons.cells[c + 1]);
        const std::uint32_t ring = polygons.parts[polygons.cells[c]];
        const Vector site = vectorAt({set.sites[id].lon, set.sites[id].lat}, 0);
        auto [area, length] =
            ofRing(polygons.coordinates, polygons.starts[ring], polygons.starts[ring + 1], site);
        if (area < -1e-9) area += 4 * kPi;  // less is rounding
        EXPECT_NEAR(area, areas[id], 2e-5) << id;
        EXPECT_NEAR(length, perimeters[id], 1e-4 * perimeters[id] + 1e-5) << id;
      }
      for (SiteId id = 0; id < areas.size(); ++id) {
        if (shown.contains(id)) continue;
        EXPECT_LT(areas[id], 1e-15) << id;
      }
    }
  }
}

TEST(SphericalReach, NeighboursHaveThePointsOfTheirEdgesInCommon) {
  Random random(23);
  for (const NamedSites& set : namedSets(random, 30)) {
    if (set.name == "twins") continue;  // three sites are equally near along some of its edges
    const SphericalDiagram diagram = diagramOf(set.sites);
    const std::vector<double> byId = distancesById(random, set.sites.size());
    for (const bool isById : {false, true}) {
      SCOPED_TRACE(set.name + (isById ? ", by id" : ""));
      CoverageArrays polygons;
      const Distances distances = isById ? byId : Distances(set.sites.size(), 0.3);
      ASSERT_EQ(diagram.cellPolygons(1e-3, false, distances, polygons), Error::kNone);
      using Segment = std::array<double, 4>;
      std::set<Segment> segments;
      const auto visit = [&](auto&& call) {
        for (std::size_t c = 0; c < polygons.sites.size(); ++c) {
          for (std::uint32_t part = polygons.cells[c]; part < polygons.cells[c + 1]; ++part) {
            const std::uint32_t ring = polygons.parts[part];
            for (std::uint32_t k = polygons.starts[ring]; k + 1 < polygons.starts[ring + 1]; ++k) {
              const double* p = &polygons.coordinates[std::size_t{2} * k];
              call(polygons.sites[c], Segment{p[0], p[1], p[2], p[3]});
            }
          }
        }
      };
      visit([&](SiteId, const Segment& s) { segments.insert(s); });
      visit([&](SiteId own, const Segment& s) {
        // Inside an edge with another site that reaches as far, on both ends.
        constexpr double kEqual = 1e-9;
        const SphericalPoint ends[] = {{s[0], s[1]}, {s[2], s[3]}};
        std::vector<SiteId> partners;
        for (SiteId other = 0; other < set.sites.size(); ++other) {
          if (other == own) continue;
          const bool isShared = std::ranges::all_of(ends, [&](const SphericalPoint& p) {
            const double distance = distanceOf(p, set.sites[other]);
            return std::abs(distance - distanceOf(p, set.sites[own])) < kEqual &&
                   distance < distances[other] - kEqual;
          });
          if (isShared) partners.push_back(other);
        }
        if (partners.size() != 1) return;
        EXPECT_TRUE(segments.contains({s[2], s[3], s[0], s[1]}))
            << own << " and " << partners[0] << " from " << s[0] << ", " << s[1];
      });
    }
  }
}

/// The area on the sphere of a cell's polygon with straight lines on the map.
double areaOnMap(const CoverageArrays& polygons, std::size_t c) {
  double area = 0;
  const std::uint32_t first = polygons.parts[polygons.cells[c]];
  const std::uint32_t last = polygons.parts[polygons.cells[c + 1]];
  for (std::uint32_t ring = first; ring < last; ++ring) {
    for (std::uint32_t k = polygons.starts[ring]; k + 1 < polygons.starts[ring + 1]; ++k) {
      const double* p = &polygons.coordinates[std::size_t{2} * k];
      const double middle = (p[1] + p[3]) / 2 * kPi / 180;
      const double half = (p[3] - p[1]) / 2 * kPi / 180;
      const double height = std::sin(middle) * (half == 0 ? 1 : std::sin(half) / half);
      area += (p[0] - p[2]) * kPi / 180 * height;
    }
  }
  return area;
}

TEST(SphericalReach, CutPolygonsAreThoseOfTheCells) {
  Random random(24);
  constexpr double kTolerance = 1e-4;
  for (const NamedSites& set : setsOf(random, 20)) {
    const SphericalDiagram diagram = diagramOf(set.sites);
    for (const double distance : {-0.05, 0.0, 1e-3, 0.1, 0.4, 1.0, 2.0, 3.1, kEverywhere}) {
      SCOPED_TRACE(set.name + ", distance " + std::to_string(distance));
      CoverageArrays polygons;
      const auto [areas, perimeters] = measured(diagram, {distance});
      ASSERT_EQ(diagram.cellPolygons(kTolerance, true, {&distance, 1}, polygons), Error::kNone);
      for (std::size_t c = 0; c < polygons.sites.size(); ++c) {
        const SiteId id = polygons.sites[c];
        EXPECT_NEAR(areaOnMap(polygons, c), areas[id], kTolerance * perimeters[id] + 1e-9) << id;
      }
    }
  }
}

/// Far from two sites that are close to each other, here some metres of the Earth, their edge goes
/// straight away from them. On the map that is a curve, of which pieces were missing.
TEST(SphericalReach, EdgesThatGoStraightAwayFromTheirSitesAreCurvesOfTheMap) {
  const SphericalSites scenes[] = {
      {{108.74296331860751, -17.548908974891795, 0.15748555030490086},
       {-108.78320209851283, -42.366673905805882, 0.04783530017311486},
       {71.543618108660212, 7.8906486445896409, 0},
       {71.543618108660212, 7.8910815179810223, 7.5543104172875743e-06}},
      {{137.02814476546394, 68.703605219987907, 0.076381204778909306},
       {15.22185612026783, -40.170258837667483, 0.023695202238860437},
       {-91.5307380796838, -68.037291450300145, 0.13236794639206684},
       {-135.06982919357793, 37.065396517945366, 0.16223554013383901},
       {29.435368021512545, 76.939462307539273, 0.065266835440724799},
       {18.262018290950692, 5.4790244143458446, 0},
       {18.262018290950692, 5.4790400698426849, 1.3661998294886815e-07}}};
  for (const SphericalSites& sites : scenes) {
    const SphericalDiagram diagram = diagramOf(sites);
    const auto [areas, perimeters] = measured(diagram, {});
    for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
      SCOPED_TRACE(tolerance);
      CoverageArrays polygons;
      ASSERT_EQ(diagram.cellPolygons(tolerance, true, {}, polygons), Error::kNone);
      for (std::size_t c = 0; c < polygons.sites.size(); ++c) {
        const SiteId id = polygons.sites[c];
        EXPECT_NEAR(areaOnMap(polygons, c), areas[id], tolerance * perimeters[id]) << id;
      }
    }
  }
}

TEST(SphericalReach, OfASphereWithARadiusIsInItsUnit) {
  SphericalDiagram earth(6371);
  SiteId id = 0;
  ASSERT_EQ(earth.insert(10, 50, 100, id), Error::kNone);
  ASSERT_EQ(earth.insert(11, 51, 20, id), Error::kNone);
  double area = 0, perimeter = 0;
  ASSERT_EQ(earth.cellArea(1, 10, area), Error::kNone);
  ASSERT_EQ(earth.cellPerimeter(1, 10, perimeter), Error::kNone);
  EXPECT_GT(area, 0.9 * kPi * 30 * 30 / 2);
  EXPECT_LT(area, kPi * 30 * 30);
  EXPECT_LT(perimeter, 2 * kPi * 30);
}

TEST(SphericalReach, RefusesWhatIsNoDistance) {
  const SphericalDiagram diagram = diagramOf({{0, 0, 0}, {90, 0, 0}});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  double number = 7;
  std::vector<double> numbers = {7};
  EXPECT_EQ(diagram.cellArea(0, nan, number), Error::kNotFinite);
  EXPECT_EQ(diagram.cellPerimeter(0, 1e200, number), Error::kOutOfRange);
  EXPECT_EQ(diagram.cellPerimeter(2, 1, number), Error::kUnknownSite);
  EXPECT_EQ(diagram.cellAreas(Distances{1, 2, 3}, numbers), Error::kBadLength);
  EXPECT_EQ(diagram.cellPerimeters(Distances{-kEverywhere}, numbers), Error::kOutOfRange);
  CoverageArrays polygons;
  EXPECT_EQ(diagram.cellPolygons(0.1, true, Distances{1, 2, 3}, polygons), Error::kBadLength);
  EXPECT_EQ(number, 7);
  EXPECT_EQ(numbers, std::vector<double>{7});
  SphericalPoint centroid = {};
  ASSERT_EQ(diagram.cellCentroid(0, -1, centroid), Error::kNone);
  EXPECT_TRUE(std::isnan(centroid.lon));
}

}  // namespace
}  // namespace apollonius::test
