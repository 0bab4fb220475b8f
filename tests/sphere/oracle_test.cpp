// The diagram of the sphere against brute force, on sets that are named in sphere_sets.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <set>

#include "sphere/sphere_sets.h"

namespace apollonius::test {
namespace {

/// A bound of the rounding of directions, in radians.
constexpr double kRounding = 1e-13;

class SphericalOracle : public testing::Test {
 protected:
  template <class Check>
  void forSets(Check check) {
    for (int round = 0; round < 8; ++round) {
      for (const NamedSites& set : namedSets(random_, 5 + 21 * static_cast<std::size_t>(round))) {
        SCOPED_TRACE(set.name + ", round " + std::to_string(round));
        check(set.sites, diagramOf(set.sites));
      }
    }
  }

  Random random_{41};
};

TEST_F(SphericalOracle, InvariantsHold) {
  forSets([&](const SphericalSites& sites, const SphericalDiagram& diagram) {
    std::string broken;
    Violation violation;
    ASSERT_EQ(diagram.validate(violation), Error::kNone);
    EXPECT_EQ(violation.text(), "");
    EXPECT_EQ(diagram.size(), sites.size());
  });
}

TEST_F(SphericalOracle, HiddenSitesAreThoseThatAnotherCovers) {
  forSets([&](const SphericalSites& sites, const SphericalDiagram& diagram) {
    for (SiteId id = 0; id < sites.size(); ++id) {
      double least = 1;  // how much the angle to another is above the difference of weights
      for (SiteId other = 0; other < sites.size(); ++other) {
        if (other != id)
          least =
              std::min(least, angleOf(sites[id], sites[other]) - (sites[other].r - sites[id].r));
      }
      bool hidden = false;
      ASSERT_EQ(diagram.isHidden(id, hidden), Error::kNone);
      SiteId cover = kNoSite;
      ASSERT_EQ(diagram.coverOf(id, cover), Error::kNone);
      ASSERT_EQ(cover != kNoSite, hidden);
      if (hidden) {
        EXPECT_LE(least, kRounding) << id;
        EXPECT_LE(angleOf(sites[id], sites[cover]), sites[cover].r - sites[id].r + kRounding);
        ASSERT_EQ(diagram.isHidden(cover, hidden), Error::kNone);
        EXPECT_FALSE(hidden);
      } else {
        EXPECT_GE(least, -kRounding) << id;
      }
    }
  });
}

TEST_F(SphericalOracle, FindsTheNearestSite) {
  forSets([&](const SphericalSites& sites, const SphericalDiagram& diagram) {
    std::vector<double> points;
    for (int k = 0; k < 60; ++k) {
      SphericalPoint p = randomPoint(random_);
      if (k % 3 == 0) {  // beside a site
        const SphericalCircle& site = sites[random_.below(sites.size())];
        p = {site.lon + random_.between(-0.1, 0.1),
             std::clamp(site.lat + random_.between(-0.1, 0.1), -90.0, 90.0)};
      }
      if (k < 4) p = {90.0 * k, k % 2 == 0 ? 90.0 : -90.0};
      points.insert(points.end(), {p.lon, p.lat});
      SiteId id = kNoSite;
      double distance = 0;
      ASSERT_EQ(diagram.find(p.lon, p.lat, id, distance), Error::kNone);
      ASSERT_LT(id, sites.size());
      EXPECT_NEAR(distance, distanceOf(p, sites[id]), 1e-14);
      EXPECT_LE(distance, leastDistance(sites, p) + 2e-15) << p.lon << ' ' << p.lat;
      bool inside = false;
      ASSERT_EQ(diagram.contains(id, p.lon, p.lat, kEverywhere, inside), Error::kNone);
      EXPECT_TRUE(inside);
    }
    std::vector<SiteId> ids(points.size() / 2);
    std::vector<double> distances(ids.size());
    ASSERT_EQ(diagram.findMany(points, ids, distances), Error::kNone);
    for (std::size_t k = 0; k < ids.size(); ++k) {
      double distance = 0;
      SiteId id = kNoSite;
      ASSERT_EQ(diagram.find(points[2 * k], points[2 * k + 1], id, distance), Error::kNone);
      EXPECT_NEAR(distances[k], distance, 2e-15);
    }
    // Within the distances themselves, and a little less.
    std::vector<SiteId> some(ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const std::span<const double> point(&points[2 * k], 2);
      for (const double limit : {distances[k], distances[k] - 1e-9}) {
        const bool isNear = distances[k] <= limit;
        SiteId id = 0;
        double distance = 0;
        ASSERT_EQ(diagram.find(point[0], point[1], limit, id, distance), Error::kNone);
        EXPECT_EQ(id, isNear ? ids[k] : kNoSite);
        EXPECT_EQ(std::isinf(distance), !isNear);
        ASSERT_EQ(diagram.find(point[0], point[1], limit, id), Error::kNone);
        EXPECT_EQ(id, isNear ? ids[k] : kNoSite);
        ASSERT_EQ(diagram.findMany(point, limit, std::span(some).first(1), {}), Error::kNone);
        EXPECT_EQ(some[0], id);
      }
    }
  });
}

TEST_F(SphericalOracle, ListsSitesInTheOrderOfTheirDistances) {
  forSets([&](const SphericalSites& sites, const SphericalDiagram& diagram) {
    const SphericalPoint p = randomPoint(random_);
    std::vector<double> expected;
    for (const SphericalCircle& site : sites) expected.push_back(distanceOf(p, site));
    std::ranges::sort(expected);
    std::vector<SiteId> ids;
    constexpr double kAnywhere = std::numeric_limits<double>::infinity();
    ASSERT_EQ(diagram.kNearest(p.lon, p.lat, sites.size() + 1, kAnywhere, ids), Error::kNone);
    ASSERT_EQ(ids.size(), sites.size());
    EXPECT_EQ(std::set<SiteId>(ids.begin(), ids.end()).size(), sites.size());
    for (std::size_t k = 0; k < ids.size(); ++k)
      EXPECT_NEAR(distanceOf(p, sites[ids[k]]), expected[k], 1e-14);
    const std::size_t half = sites.size() / 2;
    ASSERT_EQ(diagram.kNearest(p.lon, p.lat, half, kAnywhere, ids), Error::kNone);
    EXPECT_EQ(ids.size(), half);
    if (half > 0 && expected[half] - expected[half - 1] > 1e-12) {
      const double farthest = (expected[half] + expected[half - 1]) / 2;
      ASSERT_EQ(diagram.kNearest(p.lon, p.lat, sites.size(), farthest, ids), Error::kNone);
      EXPECT_EQ(ids.size(), half);
    }
  });
}

TEST_F(SphericalOracle, VoronoiVerticesAreCentresOfEmptyCaps) {
  forSets([&](const SphericalSites& sites, const SphericalDiagram& diagram) {
    VertexArrays vertices;
    ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
    const std::size_t h = diagram.visibleSize();
    ASSERT_EQ(vertices.clearance.size(), h < 3 ? 0 : 2 * h - 4);
    for (std::size_t k = 0; k < vertices.clearance.size(); ++k) {
      const SphericalPoint v = {vertices.coordinates[2 * k], vertices.coordinates[2 * k + 1]};
      EXPECT_NEAR(leastDistance(sites, v), vertices.clearance[k], kRounding);
      for (std::size_t corner = 0; corner < 3; ++corner)
        EXPECT_NEAR(distanceOf(v, sites[vertices.sites[3 * k + corner]]), vertices.clearance[k],
                    kRounding);
    }
    EdgeArrays edges;
    ASSERT_EQ(diagram.edges(edges), Error::kNone);
    EXPECT_EQ(edges.sites.size() / 2, h < 2 ? 0 : h == 2 ? 1 : 3 * h - 6);
  });
}

// On the way from a site to a point the first other cell is that of a neighbour.
TEST_F(SphericalOracle, NeighboursAreThoseWhoseCellsTouch) {
  forSets([&](const SphericalSites& sites, const SphericalDiagram& diagram) {
    for (int k = 0; k < 8; ++k) {
      const SphericalPoint a = randomPoint(random_), b = randomPoint(random_);
      const LongVector from = longDirection(a.lon, a.lat), to = longDirection(b.lon, b.lat);
      // The two sites at the ends of a short step are the same or neighbours, but near a vertex.
      SiteId before = kNoSite;
      for (int step = 0; step <= 200; ++step) {
        const double t = step / 200.0;
        const double x = static_cast<double>(from.x * (1 - t) + to.x * t),
                     y = static_cast<double>(from.y * (1 - t) + to.y * t),
                     z = static_cast<double>(from.z * (1 - t) + to.z * t);
        const SphericalPoint p = {std::atan2(y, x) * 180 / std::numbers::pi,
                                  std::atan2(z, std::hypot(x, y)) * 180 / std::numbers::pi};
        SiteId id = kNoSite;
        ASSERT_EQ(diagram.find(p.lon, p.lat, id), Error::kNone);
        if (before != kNoSite && id != before) {
          // Both are nearest, up to the length of the step; a third one may be, too.
          std::vector<double> distances;
          for (const SphericalCircle& site : sites) distances.push_back(distanceOf(p, site));
          std::ranges::sort(distances);
          const double second = distanceOf(p, sites[before]);
          const bool isClear = distances.size() < 3 || distances[2] > second + 0.05;
          std::vector<SiteId> neighbors;
          ASSERT_EQ(diagram.neighbors(before, neighbors), Error::kNone);
          if (isClear) {
            EXPECT_NE(std::ranges::find(neighbors, id), neighbors.end())
                << before << " and " << id << " at " << p.lon << ", " << p.lat;
          }
        }
        before = id;
      }
    }
  });
}

TEST_F(SphericalOracle, AreasAddUpToThatOfTheSphere) {
  forSets([&](const SphericalSites& sites, const SphericalDiagram& diagram) {
    std::vector<double> areas;
    ASSERT_EQ(diagram.cellAreas({}, areas), Error::kNone);
    double sum = 0;
    for (SiteId id = 0; id < sites.size(); ++id) {
      double area = -1;
      ASSERT_EQ(diagram.cellArea(id, kEverywhere, area), Error::kNone);
      EXPECT_EQ(area, areas[id]);
      bool hidden = false;
      ASSERT_EQ(diagram.isHidden(id, hidden), Error::kNone);
      EXPECT_TRUE(hidden ? area == 0 : area >= 0);
      sum += area;
    }
    EXPECT_NEAR(sum, 4 * std::numbers::pi, 1e-12);
  });
}

TEST_F(SphericalOracle, AreasAreThoseOfSampledCells) {
  for (const NamedSites& set : namedSets(random_, 12)) {
    SCOPED_TRACE(set.name);
    const SphericalDiagram diagram = diagramOf(set.sites);
    std::vector<double> areas, counts(set.sites.size(), 0);
    ASSERT_EQ(diagram.cellAreas({}, areas), Error::kNone);
    // Points on a spiral, which has the same number of points on equal areas (Vogel).
    constexpr int kPoints = 40000;
    std::vector<std::array<double, 3>> moments(set.sites.size());
    for (int k = 0; k < kPoints; ++k) {
      const double z = 1 - (2 * k + 1.0) / kPoints;
      const double lon = std::remainder(k * 137.50776405003785, 360);
      SiteId id = kNoSite;
      ASSERT_EQ(diagram.find(lon, std::asin(z) * 180 / std::numbers::pi, id), Error::kNone);
      counts[id] += 4 * std::numbers::pi / kPoints;
      const double r = std::sqrt(1 - z * z), a = lon * std::numbers::pi / 180;
      moments[id][0] += r * std::cos(a);
      moments[id][1] += r * std::sin(a);
      moments[id][2] += z;
    }
    for (SiteId id = 0; id < set.sites.size(); ++id) {
      EXPECT_NEAR(areas[id], counts[id], 0.004) << id;
      SphericalPoint centroid = {};
      ASSERT_EQ(diagram.cellCentroid(id, kEverywhere, centroid), Error::kNone);
      const auto [x, y, z] = moments[id];
      if (counts[id] > 0.05 && std::hypot(x, y, z) > kPoints * 0.01 * counts[id]) {
        const SphericalPoint mean = {std::atan2(y, x) * 180 / std::numbers::pi,
                                     std::atan2(z, std::hypot(x, y)) * 180 / std::numbers::pi};
        EXPECT_LT(distanceOf(mean, {centroid.lon, centroid.lat, 0}), 0.02) << id;
      }
    }
  }
}

TEST_F(SphericalOracle, TheRotatedSphereGivesTheSameAnswers) {
  for (const NamedSites& set : namedSets(random_, 60)) {
    if (set.name == "grid" || set.name == "octahedron" || set.name == "twins") continue;
    SCOPED_TRACE(set.name);
    SphericalSites turned = set.sites;
    for (SphericalCircle& site : turned) site.lon += 77.25;
    const SphericalDiagram one = diagramOf(set.sites), other = diagramOf(turned);
    std::vector<double> areas, otherAreas;
    ASSERT_EQ(one.cellAreas({}, areas), Error::kNone);
    ASSERT_EQ(other.cellAreas({}, otherAreas), Error::kNone);
    for (SiteId id = 0; id < set.sites.size(); ++id)
      EXPECT_NEAR(areas[id], otherAreas[id], 1e-10) << id;
  }
}

}  // namespace
}  // namespace apollonius::test
