// Circles of the plane as circles of the sphere.
#include "sphere/projection.h"

#include <gtest/gtest.h>

#include <numbers>

namespace apollonius::test {
namespace {

using namespace internal::sphere;

TEST(SphericalProjection, ACircleAboutTheOriginIsACapAboutTheAntipodeOfThePole) {
  const Projection projection(capOf({0, 90}, 0));
  const Projection::EmptyCap cap = projection.fromCircle(0, 0, 1, {2, 0, 1});
  EXPECT_EQ(cap.centre.x, 0);
  EXPECT_EQ(cap.centre.y, 0);
  EXPECT_EQ(cap.centre.z, -1);
  EXPECT_NEAR(cap.radius, std::numbers::pi / 2, 1e-15);
}

}  // namespace
}  // namespace apollonius::test
