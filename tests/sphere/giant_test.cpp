// A site with many neighbours does not ask all of them for a nearer one: the plane finds it
// (src/sphere/nearest.cpp). And cells of sites that a giant nearly hides.
#include <gtest/gtest.h>

#include <numbers>

#include "sphere/sphere_sets.h"

namespace apollonius::test {
namespace {

/// A cap of weight 1, and sites about its rim that it nearly hides.
SphericalSites besideAGiant(Random& random, std::size_t n, double gap) {
  SphericalSites sites = {{0, 0, 1}};
  for (std::size_t k = 0; k < n; ++k) {
    const double far = random.between(0.2, 0.7), turn = random.between(0, 2 * std::numbers::pi);
    // At the angle `far` from the giant's centre, in the direction `turn`.
    const double x = std::cos(far), y = std::sin(far) * std::cos(turn),
                 z = std::sin(far) * std::sin(turn);
    sites.push_back({std::atan2(y, x) * 180 / std::numbers::pi,
                     std::asin(z) * 180 / std::numbers::pi, 1 - far + gap});
  }
  return sites;
}

class BesideAGiant : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Gaps, BesideAGiant, testing::Values(0.01, 1e-3, 1e-6, 1e-8));

TEST_P(BesideAGiant, TheNearestSiteIsFound) {
  Random random(31);
  const SphericalSites sites = besideAGiant(random, 60, GetParam());
  const SphericalDiagram diagram = diagramOf(sites);
  std::vector<SiteId> neighbors;
  ASSERT_EQ(diagram.neighbors(0, neighbors), Error::kNone);
  ASSERT_GT(neighbors.size(), 24u);
  for (int k = 0; k < 3000; ++k) {
    SphericalPoint p = randomPoint(random);
    if (k % 2 == 0) p = {random.between(-60, 60), random.between(-60, 60)};
    SiteId id = kNoSite;
    double distance = 0;
    ASSERT_EQ(diagram.find(p.lon, p.lat, id, distance), Error::kNone);
    ASSERT_LE(distance, leastDistance(sites, p) + 2e-15) << p.lon << ' ' << p.lat;
  }
  SiteId atCentre = kNoSite;
  double distance = 0;
  ASSERT_EQ(diagram.find(0, 0, atCentre, distance), Error::kNone);
  EXPECT_EQ(atCentre, 0u);
  EXPECT_EQ(distance, -1);
}

TEST_P(BesideAGiant, AreasAddUp) {
  Random random(32);
  const SphericalSites sites = besideAGiant(random, 60, GetParam());
  const SphericalDiagram diagram = diagramOf(sites);
  std::vector<double> areas;
  ASSERT_EQ(diagram.cellAreas({}, areas), Error::kNone);
  double sum = 0;
  for (const double area : areas) sum += area;
  // Vertices are known the less the closer the site is to being hidden.
  EXPECT_NEAR(sum, 4 * std::numbers::pi, std::max(1e-12, 1e-14 / GetParam()));
}

}  // namespace
}  // namespace apollonius::test
