// Mending of rings that cross (src/geometry/polygons/mesh.h).
#include "geometry/polygons/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/window/segment_sweep.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

using namespace internal;

constexpr Rectangle kWindow{0, 0, 100, 60};
/// A length less than rounding can move a point of this window.
constexpr double kLittle = 0x1p-36;

/// Rings as those of cells of one site, each of a cell. On the right side of the window is the
/// border.
struct Given {
  explicit Given(const std::vector<std::vector<Point>>& rings) : core(Location::kWalk) {
    (void)core.insert({50, 30, 0});
    for (std::uint32_t k = 0; k < rings.size(); ++k) {
      for (std::size_t m = 0; m <= rings[k].size(); ++m) {
        const Point p = rings[k][m % rings[k].size()], next = rings[k][(m + 1) % rings[k].size()];
        list.rings.add(p);
        list.isBorder.push_back(m < rings[k].size() && p.x == 100 && next.x == 100 ? 1 : 0);
      }
      list.rings.endRing();
      list.rings.endPart();
      list.cells.push_back({0, 0, k, k + 1, false});
    }
  }

  DiagramCore core;
  CellList list;
};

std::vector<Point> cornersOf(const Rings& rings) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < rings.ringCount(); ++k) {
    for (std::uint32_t m = 0; m < rings.corners(k).size(); ++m)
      points.push_back(rings.corners(k)[m]);
  }
  return points;
}

bool has(const std::vector<Point>& points, Point p) {
  return std::find(points.begin(), points.end(), p) != points.end();
}

void expectNoneMeet(const Rings& rings) {
  PointNumbers numbers;
  std::vector<Segment> segments;
  for (std::size_t k = 0; k < rings.ringCount(); ++k) {
    const Corners corners = rings.corners(k);
    for (std::uint32_t m = 0; m < corners.size(); ++m) {
      const std::uint32_t from = numbers.add(corners[m]), to = numbers.add(corners[m + 1]);
      if (from != to) segments.push_back({from, to});
    }
  }
  for (std::size_t k = 0; k < segments.size(); ++k) {
    for (std::size_t m = 0; m < k; ++m)
      ASSERT_FALSE(doMeet(numbers.points(), segments[k], segments[m])) << k << " " << m;
  }
}

TEST(Mesh, EndsHoweverManySegmentsMeet) {
  Random random(671);
  int widened = 0;
  for (int run = 0; run < runs(200); ++run) {
    // On a grid many overlap.
    const double grid = run % 2 == 0 ? 10 : 0x1p-20;
    std::vector<Point> ring;
    for (int k = 3 + random.below(30); k > 0; --k) {
      const double x = grid * std::round(random.between(0, 90) / grid),
                   y = grid * std::round(random.between(0, 60) / grid);
      if (ring.empty() || !(ring.back() == Point{x, y})) ring.push_back({x, y});
    }
    if (ring.size() < 3 || ring.front() == ring.back()) continue;
    const std::vector<Point> beside(ring.rbegin(), ring.rend());
    Given given({ring, beside});
    Mesh mesh(given.core, kWindow, given.list);
    ASSERT_TRUE(mesh.mend()) << run;
    widened += mesh.closeness() > 1 ? 1 : 0;
    expectNoneMeet(given.list.rings);
    for (const Point p : cornersOf(given.list.rings)) EXPECT_TRUE(has(ring, p)) << run;
  }
  EXPECT_GT(widened, 0);
}

TEST(Mesh, ACellThatRoundingHasTurnedHasNoArea) {
  Given given({{{20, 20}, {20, 20 + kLittle}, {20 + kLittle, 20}}});
  ASSERT_TRUE(Mesh(given.core, kWindow, given.list).mend());
  EXPECT_LT(cornersOf(given.list.rings).size(), 3u);
  EXPECT_TRUE(given.list.cells[0].isTraced);
}

TEST(Mesh, ALargeCellThatIsTurnedStays) {
  const std::vector<Point> ring{{20, 20}, {20, 30}, {30, 20}};
  Given given({ring});
  ASSERT_TRUE(Mesh(given.core, kWindow, given.list).mend());
  EXPECT_EQ(cornersOf(given.list.rings), ring);
  EXPECT_FALSE(given.list.cells[0].isTraced);
}

TEST(Mesh, PointsOfTheBorderStay) {
  const Point inside{100 - kLittle, 30 - kLittle / 4}, corner{100, 30};
  Given given({{{50, 20}, {100, 20}, corner, {50, 30}}, {inside, {100, 40}, {50, 40}}});
  ASSERT_TRUE(Mesh(given.core, kWindow, given.list).mend());
  const std::vector<Point> corners = cornersOf(given.list.rings);
  EXPECT_TRUE(has(corners, corner));
  EXPECT_FALSE(has(corners, inside));
  expectNoneMeet(given.list.rings);
}

}  // namespace
}  // namespace apollonius::test
