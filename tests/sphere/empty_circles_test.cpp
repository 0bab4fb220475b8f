// The largest empty circles of the sphere, against all sites and against points all over it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sphere/sphere_sets.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

constexpr double kRounding = 1e-9, kPi = 3.14159265358979323846;

VertexArrays emptyCirclesOf(const SphericalDiagram& diagram, std::size_t most) {
  VertexArrays circles;
  EXPECT_EQ(diagram.emptyCircles(most, circles), Error::kNone);
  EXPECT_EQ(circles.sites.size(), circles.clearance.size());
  return circles;
}

SphericalPoint centreOf(const VertexArrays& circles, std::size_t k) {
  return {circles.coordinates[2 * k], circles.coordinates[2 * k + 1]};
}

/// Expects that no site reaches into the circles, and that each touches its site; that the largest
/// come first, and none has its centre in one before it.
void expectEmptyAndApart(const SphericalSites& sites, const VertexArrays& circles) {
  for (std::size_t k = 0; k < circles.clearance.size(); ++k) {
    const SphericalPoint p = centreOf(circles, k);
    const double r = circles.clearance[k];
    EXPECT_NEAR(leastDistance(sites, p), r, kRounding) << k;
    ASSERT_LT(circles.sites[k], sites.size());
    EXPECT_NEAR(distanceOf(p, sites[circles.sites[k]]), r, kRounding) << k;
    EXPECT_LE(r, circles.clearance[k > 0 ? k - 1 : 0]);
    for (std::size_t before = 0; before < k; ++before) {
      const SphericalPoint other = centreOf(circles, before);
      EXPECT_GE(distanceOf(p, {other.lon, other.lat, 0}), circles.clearance[before] - kRounding);
    }
  }
}

TEST(SphericalEmptyCircles, AreEmptyAndTheLargestThereAre) {
  Random random(81);
  for (int round = 0; round < sized(3, 20); ++round) {
    for (const NamedSites& set : namedSets(random, 3 + 20 * static_cast<std::size_t>(round))) {
      SCOPED_TRACE(set.name);
      const SphericalDiagram diagram = diagramOf(set.sites);
      const VertexArrays circles = emptyCirclesOf(diagram, 12);
      ASSERT_FALSE(circles.clearance.empty());
      EXPECT_LE(circles.clearance.size(), 12u);
      expectEmptyAndApart(set.sites, circles);
      for (int k = 0; k < 200; ++k)
        EXPECT_LE(leastDistance(set.sites, randomPoint(random)), circles.clearance[0] + kRounding);
      VertexArrays vertices;
      ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
      for (const double clearance : vertices.clearance)
        EXPECT_LE(clearance, circles.clearance[0] + kRounding);
      // Fewer of them are the first of them.
      const VertexArrays some = emptyCirclesOf(diagram, 3);
      ASSERT_EQ(some.clearance.size(), std::min<std::size_t>(3, circles.clearance.size()));
      EXPECT_TRUE(std::equal(some.coordinates.begin(), some.coordinates.end(),
                             circles.coordinates.begin()));
      EXPECT_TRUE(emptyCirclesOf(diagram, 0).clearance.empty());
    }
  }
}

TEST(SphericalEmptyCircles, OfNoneOneAndTwoSites) {
  EXPECT_TRUE(emptyCirclesOf(SphericalDiagram(), 3).clearance.empty());
  for (const double r : {0.0, 0.5, -0.25}) {
    const VertexArrays one = emptyCirclesOf(diagramOf({{30, 40, r}}), 3);
    ASSERT_EQ(one.clearance.size(), 1u);
    EXPECT_NEAR(one.clearance[0], kPi - r, kRounding);
    EXPECT_NEAR(one.coordinates[0], -150, kRounding);
    EXPECT_NEAR(one.coordinates[1], -40, kRounding);
  }
  const VertexArrays two = emptyCirclesOf(diagramOf({{0, 0, 0}, {90, 0, 0.2}}), 3);
  ASSERT_EQ(two.clearance.size(), 1u);
  EXPECT_NEAR(two.clearance[0], 3 * kPi / 4 - 0.1, kRounding);
  expectEmptyAndApart({{0, 0, 0}, {90, 0, 0.2}}, two);
}

TEST(SphericalEmptyCircles, HaveNegativeRadiiWhereTheSphereIsCovered) {
  const SphericalSites sites = {{0, 0, 2}, {120, 0, 2}, {-120, 0, 2}, {0, 90, 2}, {0, -90, 2}};
  const VertexArrays circles = emptyCirclesOf(diagramOf(sites), 4);
  ASSERT_FALSE(circles.clearance.empty());
  EXPECT_LT(circles.clearance[0], 0);
  expectEmptyAndApart(sites, circles);
}

}  // namespace
}  // namespace apollonius::test
