// Turned about any axis, the diagram of the sphere is the same. The turned longitudes and latitudes
// are rounded, so answers are compared up to that; nothing in the code is to prefer the axis of the
// Earth, but poles and the meridian of 180 degrees are where coordinates go wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "sphere/sphere_sets.h"

namespace apollonius::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// A rotation as three images of the axes.
class Rotation {
 public:
  /// The rotation by Euler's angles in degrees: about z, about y, about z again.
  Rotation(double first, double tilt, double second)
      : about_{{{second, 0, 1}, {tilt, 2, 0}, {first, 0, 1}}} {}
  /// A rotation that takes a point to another.
  Rotation(const SphericalPoint& from, const SphericalPoint& to)
      : Rotation(-from.lon, from.lat - to.lat, to.lon) {}

  [[nodiscard]] SphericalPoint operator()(const SphericalPoint& p) const {
    const LongVector v = longDirection(p.lon, p.lat);
    std::array<long double, 3> x = {v.x, v.y, v.z};
    for (std::size_t k = about_.size(); k-- > 0;) {
      const auto [degrees, a, b] = about_[k];
      const long double angle = degrees * kLongPi / 180;
      const long double c = std::cos(angle), s = std::sin(angle), was = x[a];
      x[a] = c * was - s * x[b];
      x[b] = s * was + c * x[b];
    }
    constexpr long double kDegree = kLongPi / 180;
    // A point that is a rounding from a pole or from the meridian of 180 degrees is there.
    constexpr long double kNear = 1e-17L;
    const long double aside = std::hypot(x[0], x[1]);
    if (aside < kNear) return {0, x[2] > 0 ? 90.0 : -90.0};
    if (std::abs(x[1]) < kNear) x[1] = 0;
    return {static_cast<double>(std::atan2(x[1], x[0]) / kDegree),
            static_cast<double>(std::atan2(x[2], aside) / kDegree)};
  }
  [[nodiscard]] SphericalSites operator()(SphericalSites sites) const {
    for (SphericalCircle& site : sites) {
      const auto [lon, lat] = (*this)({site.lon, site.lat});
      site.lon = lon;
      site.lat = lat;
    }
    return sites;
  }

 private:
  struct Turn {
    double degrees;
    std::size_t from, to;
  };
  std::array<Turn, 3> about_;
};

/// May rounding decide whether a site is hidden, and which neighbours it has?
bool isDegenerate(const std::string& name) {
  constexpr std::array kNames = {"grid",          "octahedron",     "twins", "about the pole",
                                 "on a meridian", "on the equator", "towns"};
  return std::ranges::find(kNames, name) != kNames.end();
}

void expectSame(const SphericalSites& sites, const SphericalSites& turned, const Rotation& rotation,
                bool hasTies, Random& random) {
  const SphericalDiagram one = diagramOf(sites), other = diagramOf(turned);
  Violation violation;
  ASSERT_EQ(other.validate(violation), Error::kNone);
  ASSERT_EQ(violation.text(), "");
  std::vector<double> areas, otherAreas;
  ASSERT_EQ(one.cellAreas({}, areas), Error::kNone);
  ASSERT_EQ(other.cellAreas({}, otherAreas), Error::kNone);
  double sum = 0;
  for (const double area : otherAreas) sum += area;
  EXPECT_NEAR(sum, 4 * kPi, 1e-9);
  for (int k = 0; k < 50; ++k) {
    const SphericalPoint p = randomPoint(random), q = rotation(p);
    SiteId id = kNoSite, otherId = kNoSite;
    double distance = 0, otherDistance = 0;
    ASSERT_EQ(one.find(p.lon, p.lat, id, distance), Error::kNone);
    ASSERT_EQ(other.find(q.lon, q.lat, otherId, otherDistance), Error::kNone);
    EXPECT_NEAR(distance, otherDistance, 1e-14);
    std::vector<double> distances;
    for (const SphericalCircle& site : sites) distances.push_back(distanceOf(p, site));
    std::ranges::sort(distances);
    if (distances.size() == 1 || distances[1] - distances[0] > 1e-13) {
      EXPECT_EQ(id, otherId);
    }
  }
  for (const bool isCut : {false, true}) {
    CoverageArrays polygons;
    ASSERT_EQ(other.cellPolygons(0.01, isCut, {}, polygons), Error::kNone);
    EXPECT_EQ(polygons.sites.size(), other.visibleSize());
  }
  if (hasTies) return;
  for (SiteId id = 0; id < sites.size(); ++id) {
    EXPECT_NEAR(areas[id], otherAreas[id], 1e-9) << id;
    std::vector<SiteId> neighbors, otherNeighbors;
    ASSERT_EQ(one.neighbors(id, neighbors), Error::kNone);
    ASSERT_EQ(other.neighbors(id, otherNeighbors), Error::kNone);
    EXPECT_EQ(std::set(neighbors.begin(), neighbors.end()),
              std::set(otherNeighbors.begin(), otherNeighbors.end()))
        << id;
    if (areas[id] > 0) {
      SphericalPoint centroid = {}, otherCentroid = {};
      ASSERT_EQ(one.cellCentroid(id, kEverywhere, centroid), Error::kNone);
      ASSERT_EQ(other.cellCentroid(id, kEverywhere, otherCentroid), Error::kNone);
      const SphericalPoint expected = rotation(centroid);
      // The centroid of a small cell is known as well as its moment.
      if (areas[id] > 1e-3 && areas[id] < 6) {
        EXPECT_LT(distanceOf(otherCentroid, {expected.lon, expected.lat, 0}), 1e-9) << id;
      }
    }
  }
}

void expectSameForSets(Random& random, std::size_t n, auto rotationFor) {
  for (const NamedSites& set : namedSets(random, n)) {
    SCOPED_TRACE(set.name);
    const Rotation rotation = rotationFor(set.sites);
    expectSame(set.sites, rotation(set.sites), rotation, isDegenerate(set.name), random);
  }
}

TEST(SphericalRotations, AboutAnyAxis) {
  Random random(91);
  for (int round = 0; round < 5; ++round) {
    expectSameForSets(random, 40, [&](const SphericalSites&) {
      return Rotation(random.between(-180, 180), random.between(-180, 180),
                      random.between(-180, 180));
    });
  }
}

TEST(SphericalRotations, ThatPutASiteOnAPole) {
  Random random(92);
  for (const double pole : {90.0, -90.0}) {
    expectSameForSets(random, 40, [&](const SphericalSites& sites) {
      const SphericalCircle& site = sites[random.below(sites.size())];
      return Rotation({site.lon, site.lat}, {random.between(-180, 180), pole});
    });
  }
}

TEST(SphericalRotations, ThatPutASiteOnTheAntimeridian) {
  Random random(93);
  for (int round = 0; round < 4; ++round) {
    expectSameForSets(random, 40, [&](const SphericalSites& sites) {
      const SphericalCircle& site = sites[random.below(sites.size())];
      return Rotation({site.lon, site.lat}, {180, random.between(-89, 89)});
    });
  }
}

TEST(SphericalRotations, ThatPutAVertexOnAPoleOrTheAntimeridian) {
  Random random(94);
  for (const SphericalPoint to : {SphericalPoint{0, 90}, {0, -90}, {180, 0}, {180, 35}}) {
    for (const NamedSites& set : namedSets(random, 40)) {
      if (isDegenerate(set.name)) continue;
      SCOPED_TRACE(set.name);
      VertexArrays vertices;
      ASSERT_EQ(diagramOf(set.sites).vertices(vertices), Error::kNone);
      if (vertices.clearance.empty()) continue;
      const std::size_t k = random.below(vertices.clearance.size());
      const Rotation rotation({vertices.coordinates[2 * k], vertices.coordinates[2 * k + 1]}, to);
      expectSame(set.sites, rotation(set.sites), rotation, false, random);
    }
  }
}

/// Quarter turns of the octahedron and of the grid only change the names.
TEST(SphericalRotations, ByAQuarterTurnOfTheOctahedron) {
  Random random(95);
  const SphericalSites sites = {{0, 0, 0},   {90, 0, 0}, {180, 0, 0},
                                {-90, 0, 0}, {0, 90, 0}, {0, -90, 0}};
  for (const Rotation& rotation : {Rotation(90, 0, 0), Rotation(0, 90, 0), Rotation(90, 90, 0)})
    expectSame(sites, rotation(sites), rotation, true, random);
}

}  // namespace
}  // namespace apollonius::test
