// The grid of segments: those that meet have a cell in common, and combs do not fill it.
#include "geometry/window/segment_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "predicate/orientation.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

using namespace internal;

bool doCross(Point a, Point b, Point c, Point d) {
  const auto areApart = [](Sign s, Sign t) { return s * t == Sign::kNegative; };
  return areApart(orient2d(a, b, c), orient2d(a, b, d)) &&
         areApart(orient2d(c, d, a), orient2d(c, d, b));
}

std::set<std::size_t> cellsOf(const SegmentGrid& grid, Point a, Point b) {
  FlatArray<std::uint32_t> cells;
  grid.listCells(a, b, cells);
  return {cells.begin(), cells.end()};
}

TEST(SegmentGrid, SegmentsThatCrossShareACell) {
  Random random(661);
  int crossings = 0;
  for (int run = 0; run < runs(60); ++run) {
    // Boxes of all shapes, some far from the origin for their size.
    const double width = random.oneIn(3) ? 1e6 : 1, height = random.oneIn(3) ? 1e-6 : 1;
    const double x0 = random.oneIn(3) ? 1e9 : 0, y0 = random.oneIn(3) ? -1e5 : 0;
    const Rectangle box{x0, y0, x0 + width, y0 + height};
    std::vector<Point> points;
    std::vector<Segment> segments;
    for (std::uint32_t k = 0; k < 40; ++k) {
      points.push_back({x0 + width * random.unit(), y0 + height * random.unit()});
      if (k % 2 == 1) segments.push_back({k - 1, k});
    }
    const SegmentGrid grid(points, segments, box);
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const Point a = points[segments[k].from], b = points[segments[k].to];
      const auto cells = cellsOf(grid, a, b);
      for (std::size_t m = 0; m < k; ++m) {
        const Point c = points[segments[m].from], d = points[segments[m].to];
        if (!doCross(a, b, c, d)) continue;
        ++crossings;
        bool isFound = false;
        for (const std::size_t cell : cells) {
          for (const std::uint32_t other : grid.at(cell)) isFound = isFound || other == m;
        }
        ASSERT_TRUE(isFound) << "run " << run << " segments " << k << " and " << m;
      }
    }
  }
  EXPECT_GT(crossings, runs(600));
}

TEST(SegmentGrid, DiagonalsAreInTheCellsAlongThem) {
  // Not in all cells of the rows that they pass.
  constexpr std::uint32_t kDiagonals = 1000;
  std::vector<Point> points;
  std::vector<Segment> segments;
  for (std::uint32_t k = 0; k < kDiagonals; ++k) {
    const double aside = 0.1 * k / kDiagonals;
    points.push_back({aside, 0});
    points.push_back({0.9 + aside, 1});
    segments.push_back({2 * k, 2 * k + 1});
  }
  const SegmentGrid grid(points, segments, {0, 0, 1, 1});
  EXPECT_LT(cellsOf(grid, {0, 0}, {0.9, 1}).size(), 6 * std::sqrt(kDiagonals));
}

TEST(SegmentGrid, CombsAreInAsManyCellsAsTheyHaveTeeth) {
  // In a grid of as many rows as columns each tooth is in all of its rows: n^1.5 cells.
  for (const bool isUpright : {true, false}) {
    const std::uint32_t teeth = 4000;
    std::vector<Point> points;
    std::vector<Segment> segments;
    for (std::uint32_t k = 0; k <= 2 * teeth; ++k) {
      const double along = k, up = k % 2 == 0 ? 0 : 1000;
      points.push_back(isUpright ? Point{along, up} : Point{up, along});
      if (k > 0) segments.push_back({k - 1, k});
    }
    const double length = 2 * teeth;
    const Rectangle box = isUpright ? Rectangle{0, 0, length, 1000} : Rectangle{0, 0, 1000, length};
    const SegmentGrid grid(points, segments, box);
    std::size_t visits = 0;
    FlatArray<std::uint32_t> cells;
    for (const Segment& s : segments) {
      grid.listCells(points[s.from], points[s.to], cells);
      visits += cells.size();
    }
    EXPECT_LT(visits, 8 * segments.size());
  }
}

}  // namespace
}  // namespace apollonius::test
