// The points of an edge in polygons: as many as are needed, whatever rounding does.
#include "geometry/polygons/chords.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/window/polygon_grid.h"
#include "geometry/window/rectangle_sides.h"

namespace apollonius::test {
namespace {

using namespace internal;

std::size_t countOf(const Conic& curve, Point left, Point right, double tolerance,
                    const Border& border = RectangleSides({-10, -10, 10, 10})) {
  return ChordFinder(border, Tolerance{tolerance}).find({curve, left, right}).size();
}

TEST(Chords, SpanLessThanAQuarterTurnHoweverCoarse) {
  // Half a turn about the left site.
  const Conic first = Conic::arc({0, 0}, 1, {1, 0}, {0, 1});
  EXPECT_GE(countOf(first, {0, 0}, {5, 5}, 100), 3u);
  EXPECT_GE(countOf(first.reversed(), {5, 5}, {0, 0}, 100), 3u) << "about the right one";
  EXPECT_EQ(countOf(first, {-50, -50}, {50, 50}, 100), 2u);
}

TEST(Chords, InARectangleLeaveTheSideOnWhichTheyBeginAndEnd) {
  const auto turned = [](Point p) { return Point{-p.y, p.x}; };
  Conic bulge{{-1, -10}, {0, -9}, 1.5, {1, -10}};
  Point left{0, 40};
  for (int side = 0; side < 4; ++side) {
    EXPECT_GE(countOf(bulge, left, -1 * left, 100), 3u) << side;
    bulge = {turned(bulge.p0), turned(bulge.p1), bulge.w, turned(bulge.p2)};
    left = turned(left);
  }
}

TEST(Chords, InARegionLeaveTheSideOnWhichTheyBeginAndEnd) {
  const double ring[] = {-10, -10, 10, -10, 10, 10, -10, 10};
  const std::uint32_t starts[] = {0, 4};
  const NormalizedPolygon polygon = normalizePolygon(ring, starts);
  const PolygonGrid grid(polygon);
  const Conic bulge{{-1, -10}, {0, -9}, 1.5, {1, -10}};
  for (std::uint32_t side = 0; side < 4; ++side) {  // one of them is the lower one
    ChordFinder finder(grid, Tolerance{100});
    EXPECT_GE(finder.find({bulge, {0, 40}, {0, -40}, side, side}).size(), 3u) << side;
  }
}

TEST(Chords, AlongTheBorderAreNoMoreThanTwoToTheTenth) {
  // Found by regions_fuzz: 2^18 points, seconds of exact signs.
  const double ring[] = {-1, -1, 2, -1, 2, 1e-13, -1, 1e-13};
  const std::uint32_t starts[] = {0, 4};
  const NormalizedPolygon polygon = normalizePolygon(ring, starts);
  const PolygonGrid grid(polygon);
  const Conic curve{{0, 0}, {0.5, 1e-3}, 1, {1, 0}};
  EXPECT_LE(countOf(curve, {0.5, 1e3}, {0.5, -1e3}, 100, grid), 1100u);
  EXPECT_GE(countOf(curve, {0.5, 1e3}, {0.5, -1e3}, 100, grid), 3u);
}

TEST(Chords, ThatRoundingKeepsFromTurningAreFew) {
  // The sites are on the line of the chord: no chord turns, nor do those of its halves.
  const Conic curve{{1e6, 1e6}, {1e6 + 50, 1e6 + 50 + 0x1p-30}, 1.0000001, {1e6 + 100, 1e6 + 100}};
  EXPECT_LE(countOf(curve, {0, 0}, {3e6, 3e6}, 1e-30), 40'000u);
  EXPECT_LE(countOf(curve, {0, 0}, {3e6, 3e6}, 1), 4u);
}

}  // namespace
}  // namespace apollonius::test
