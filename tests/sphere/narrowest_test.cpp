// The narrowest places of the edges of the sphere, by all sites.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "sphere/sphere_sets.h"

namespace apollonius::test {
namespace {

struct Narrowest {
  VertexArrays vertices, places;
  EdgeArrays edges;
  explicit Narrowest(const SphericalDiagram& diagram) {
    EXPECT_EQ(diagram.vertices(vertices), Error::kNone);
    EXPECT_EQ(diagram.edges(edges), Error::kNone);
    EXPECT_EQ(diagram.narrowest(places), Error::kNone);
    EXPECT_EQ(places.clearance.size(), edges.sites.size() / 2);
    EXPECT_EQ(places.coordinates.size(), edges.sites.size());
    EXPECT_TRUE(places.sites.empty());
  }
  [[nodiscard]] SphericalPoint place(std::size_t k) const {
    return {places.coordinates[2 * k], places.coordinates[2 * k + 1]};
  }
};

/// The point at an angle from the first site on the way to the second one.
SphericalPoint onTheWay(const SphericalCircle& from, const SphericalCircle& to, double angle) {
  const LongVector a = longDirection(from.lon, from.lat), b = longDirection(to.lon, to.lat);
  const long double whole = angleOf(a, b), u = std::sin(whole - angle) / std::sin(whole),
                    v = std::sin(static_cast<long double>(angle)) / std::sin(whole);
  const LongVector p{u * a.x + v * b.x, u * a.y + v * b.y, u * a.z + v * b.z};
  constexpr long double kDegree = 180 / kLongPi;
  return {static_cast<double>(std::atan2(p.y, p.x) * kDegree),
          static_cast<double>(std::atan2(p.z, std::sqrt(p.x * p.x + p.y * p.y)) * kDegree)};
}

/// The middle of two sites is on an edge of them if no other is nearer to it; else an end is the
/// narrowest. Where that is decided by less than the tolerance, the edge may go anywhere.
TEST(SphericalNarrowest, IsThatOfAllSites) {
  Random random(6805);
  constexpr double kTolerance = 1e-8;
  for (int round = 0; round < 3; ++round) {
    for (const auto& [name, sites] : namedSets(random, 60)) {
      SCOPED_TRACE(name);
      const SphericalDiagram diagram = diagramOf(sites);
      const Narrowest found(diagram);
      std::map<std::pair<SiteId, SiteId>, std::pair<double, double>> least;  // found, at the ends
      for (std::size_t k = 0; k < found.places.clearance.size(); ++k) {
        const SiteId a = found.edges.sites[2 * k], b = found.edges.sites[2 * k + 1];
        const double clearance = found.places.clearance[k];
        EXPECT_NEAR(distanceOf(found.place(k), sites[a]), clearance, kTolerance);
        EXPECT_NEAR(distanceOf(found.place(k), sites[b]), clearance, kTolerance);
        EXPECT_NEAR(leastDistance(sites, found.place(k)), clearance, kTolerance);
        double ends = std::numeric_limits<double>::infinity();
        for (const std::size_t end : {2 * k, 2 * k + 1}) {
          const std::int32_t row = found.edges.vertices[end];
          if (row >= 0)
            ends = std::min(ends, found.vertices.clearance[static_cast<std::size_t>(row)]);
        }
        EXPECT_LE(clearance, ends);
        const auto [entry, isNew] = least.insert({std::minmax(a, b), {clearance, ends}});
        if (!isNew) {
          entry->second.first = std::min(entry->second.first, clearance);
          entry->second.second = std::min(entry->second.second, ends);
        }
      }
      for (const auto& [pair, both] : least) {
        const SphericalCircle &a = sites[pair.first], &b = sites[pair.second];
        const double angle = angleOf(a, b), between = (angle - a.r - b.r) / 2;
        if (angle > 3.1415) continue;  // no way from one to the other is the shortest
        const SphericalPoint middle = onTheWay(a, b, a.r + between);
        double nearest = std::numeric_limits<double>::infinity();
        for (SiteId id = 0; id < sites.size(); ++id) {
          if (id != pair.first && id != pair.second)
            nearest = std::min(nearest, distanceOf(middle, sites[id]));
        }
        EXPECT_GE(both.first, between - kTolerance);
        if (nearest > between + kTolerance) {
          EXPECT_NEAR(both.first, std::min(between, both.second), kTolerance);
        } else if (nearest < between - kTolerance) {
          EXPECT_EQ(both.first, both.second);
        }
      }
    }
  }
}

TEST(SphericalNarrowest, OfTheClosedEdgeOfTwo) {
  SphericalDiagram diagram(100);
  std::vector<SiteId> ids(2);
  ASSERT_EQ(diagram.insertMany(std::vector<double>{0, 0, 10, 90, 0, 0}, ids), Error::kNone);
  const Narrowest found(diagram);
  ASSERT_EQ(found.places.clearance.size(), 1u);
  const double quarter = 50 * std::numbers::pi;
  EXPECT_NEAR(found.places.clearance[0], (quarter - 10) / 2, 1e-9);
  EXPECT_NEAR(found.place(0).lon, 45 + 9 / std::numbers::pi, 1e-9);
  EXPECT_NEAR(found.place(0).lat, 0, 1e-12);
  SphericalDiagram empty;
  EXPECT_TRUE(Narrowest(empty).places.clearance.empty());
}

}  // namespace
}  // namespace apollonius::test
