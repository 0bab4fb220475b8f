// Newton's method for a vertex of the sphere (src/sphere/vertices.h).
#include "sphere/vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sphere/sphere_sets.h"

namespace apollonius::test {
namespace {

namespace sphere = internal::sphere;

using Caps = std::array<const sphere::Cap*, 3>;

/// The largest residual of the three equations of a vertex.
double residual(const sphere::SphericalVertex& vertex, const Caps& caps) {
  double largest = 0;
  for (const sphere::Cap* cap : caps)
    largest = std::max(largest,
                       std::abs(sphere::distanceInRadians(vertex.point, *cap) - vertex.clearance));
  return largest;
}

TEST(SphericalVertex, IsNeverFartherThanWhereItStarted) {
  Random random(71);
  for (int round = 0; round < 5000; ++round) {
    // Three sites, close to each other or not, seen from farther away or from among them. From
    // there a step of Newton's method can lead anywhere.
    const double spread = std::pow(10, -random.between(0, 8));
    const double away = round % 2 == 0 ? spread : 1e-13;
    const SphericalPoint about = randomPoint(random);
    const auto beside = [&](double angle) {
      return sphere::LonLat{
          about.lon + 57 * angle * random.between(-1, 1),
          std::clamp(about.lat + 57 * angle * random.between(-1, 1), -90.0, 90.0)};
    };
    std::array<sphere::Cap, 3> sites;
    for (sphere::Cap& site : sites)
      site = sphere::capOf(beside(spread), spread * random.between(-1, 1));
    const Caps caps = {&sites[0], &sites[1], &sites[2]};
    sphere::SphericalVertex vertex = {sphere::directionOf(beside(away)), 0};
    vertex.clearance = sphere::distanceInRadians(vertex.point, sites[0]);
    for (int again = 0; again < 3; ++again) {
      const sphere::SphericalVertex next = refined(vertex, caps);
      ASSERT_LE(residual(next, caps), residual(vertex, caps)) << round;
      vertex = next;
    }
  }
}

TEST(SphericalVertex, AtASitesCentreStaysWhereItIs) {
  // There is no direction to the first site, nor from its antipode.
  const std::array<sphere::Cap, 3> sites = {sphere::capOf({0, 0}, 0), sphere::capOf({90, 0}, 0.1),
                                            sphere::capOf({0, 90}, 0)};
  for (const double lon : {0.0, 180.0}) {
    const sphere::SphericalVertex start = {sphere::directionOf({lon, 0}), 1};
    const sphere::SphericalVertex vertex = refined(start, {&sites[0], &sites[1], &sites[2]});
    EXPECT_EQ(vertex.point.x, start.point.x);
    EXPECT_EQ(vertex.clearance, 1);
  }
}

}  // namespace
}  // namespace apollonius::test
