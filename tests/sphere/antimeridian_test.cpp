// Rings of the sphere cut at the meridian of 180 degrees.
#include "sphere/antimeridian.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

namespace apollonius::test {
namespace {

using namespace internal::sphere;

LonLatRings cut(const std::vector<LonLat>& ring, double areaOfCell) {
  std::vector<MapPoint> points;
  for (const LonLat& p : ring) {
    const Direction snapped = snappedToBorder(directionOf(p));
    points.push_back({snapped, lonLatOf(snapped)});
  }
  AntimeridianCutter cutter(0.01);
  LonLatRings rings;
  cutter.cut(points, [&] { return areaOfCell; }, rings);
  return rings;
}

/// The area of what becomes of a ring, in square degrees.
double areaOfCut(const std::vector<LonLat>& ring, double areaOfCell) {
  const LonLatRings rings = cut(ring, areaOfCell);
  double twice = 0;
  for (std::size_t k = 0; k + 1 < rings.starts.size(); ++k) {
    for (std::size_t m = rings.starts[k]; m + 1 < rings.starts[k + 1]; ++m) {
      const double* p = &rings.coordinates[2 * m];
      twice += p[0] * p[3] - p[2] * p[1];
    }
  }
  return twice / 2;
}

TEST(Antimeridian, ARingThatTouchesItInAPointHasTheCellInsideOrOutside) {
  constexpr double kSphere = 4 * std::numbers::pi, kMap = 360.0 * 180, kDiamond = 200;
  const LonLat east{180, 0}, north{170, 10}, west{160, 0}, south{170, -10};
  EXPECT_NEAR(areaOfCut({east, north, west, south}, 0.06), kDiamond, 1e-9);
  EXPECT_NEAR(areaOfCut({east, south, west, north}, kSphere - 0.06), kMap - kDiamond, 1e-9);
}

TEST(Antimeridian, ARingThatDoesNotComeToItHasTheCellInsideOrOutside) {
  constexpr double kSphere = 4 * std::numbers::pi, kMap = 360.0 * 180, kDiamond = 200;
  const LonLat east{20, 0}, north{10, 10}, west{0, 0}, south{10, -10};
  EXPECT_NEAR(areaOfCut({east, north, west, south}, 0.06), kDiamond, 1e-9);
  EXPECT_NEAR(areaOfCut({east, south, west, north}, kSphere - 0.06), kMap - kDiamond, 1e-9);
  // Thinner than the tolerance and turned over by it, as the sides of a needle may be.
  const LonLat above{10, 0.001}, below{10, -0.001};
  EXPECT_NEAR(areaOfCut({east, below, west, above}, 1e-6), 0, 0.1);
  // A hole of two points.
  EXPECT_NEAR(areaOfCut({north, west}, kSphere - 1e-6), kMap, 1e-9);
}

TEST(Antimeridian, APointThatARingRepeatsIsWrittenOnce) {
  const LonLatRings rings = cut({{10, 10}, {20, 10}, {20, 10}, {20, 20}, {10, 10}}, 0.015);
  ASSERT_EQ(rings.starts.size(), 2u);
  EXPECT_EQ(rings.starts[1], 4u) << "three points, and the first again";
}

TEST(Antimeridian, ARingAlongItHasTheWholeMapAtItsLeftOrNothing) {
  constexpr double kSphere = 4 * std::numbers::pi, kMap = 360.0 * 180;
  EXPECT_EQ(areaOfCut({{180, 60}, {0, 90}}, 1e-8), 0);
  EXPECT_NEAR(areaOfCut({{180, 60}, {0, 90}}, kSphere - 1e-8), kMap, 1e-9);
  EXPECT_NEAR(areaOfCut({{180, 60}, {180, 20}, {180, 40}}, kSphere - 1e-8), kMap, 1e-9);
}

TEST(Antimeridian, ARingThroughAPoleGoesThereOnTwoLongitudes) {
  EXPECT_NEAR(areaOfCut({{0, 90}, {0, 60}, {40, 60}}, 0.0935), 40 * 30, 1e-9);
  EXPECT_NEAR(areaOfCut({{0, -90}, {40, -60}, {0, -60}}, 0.0935), 40 * 30, 1e-9);
}

TEST(Antimeridian, ARingWithoutAreaThatComesToItIsNone) {
  EXPECT_EQ(cut({{180, 0}, {170, 0}, {160, 0}, {175, 0}}, 0).starts.size(), 1u);
}

TEST(Antimeridian, ARightAngleOnItHasAnArea) {
  // All points have the longitude or the latitude of the first, as those of a ring without area do.
  EXPECT_NEAR(areaOfCut({{180, 0}, {170, 0}, {180, -10}}, 0.015), 50, 1e-9);
}

}  // namespace
}  // namespace apollonius::test
