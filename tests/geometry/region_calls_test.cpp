// The calls of regions: refusals, drawings, and that lists, measures and drawings of all cells
// agree with those of each cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "apollonius/region.h"
#include "geometry/shapes.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

using Numbers = std::vector<double>;
using Starts = std::vector<std::uint32_t>;

// A square with a hole, a part that overlaps both, and an island in the hole.
const Numbers kRings{0,  0,  100, 0,   100, 100, 0,  100, 20, 20, 60, 25, 40,
                     70, 90, 40,  150, 50,  90,  60, 35,  35, 45, 35, 40, 45};
const Starts kStarts{0, 4, 7, 10, 13};

Region made(const Numbers& coordinates, const Starts& starts) {
  Region region;
  EXPECT_EQ(region.assign(coordinates, starts), Error::kNone);
  return region;
}

TEST(RegionCalls, BadRingsAreRefusedAndChangeNothing) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(),
                   kInf = std::numeric_limits<double>::infinity();
  const Numbers triangle{0, 0, 4, 0, 0, 4};
  Region region = made(triangle, {0, 3});
  const std::pair<Numbers, Starts> bad[] = {
      {triangle, {}},
      {triangle, {1, 3}},
      {{0, 0, 4, 0, 0, 4, 1}, {0, 3}},
      {triangle, {0, 2}},
      {triangle, {0, 4}},
      {{0, 0, 4, 0}, {0, 2}},
      {{0, 0, 4, 0, 0, 4, 1, 1, 2, 1}, {0, 3, 5}},
      {triangle, {0, 4, 3}},  // descending
      {triangle, {0, 0, 3}},
      {{}, {0}},
      {{0, 0, kNan, 0, 0, 4}, {0, 3}},
      {{0, 0, 4, 0, 0, kInf}, {0, 3}},
      {{0, 0, 1e101, 0, 0, 4}, {0, 3}},
      {{0, 0, 1e-101, 0, 0, 4}, {0, 3}},
      {{0, 0, 4, 0, 2, 0}, {0, 3}},                       // nothing inside: a horizontal line,
      {{0, 0, 0, 4, 0, 2}, {0, 3}},                       // a vertical one,
      {{0, 0, 4, 4, 2, 2}, {0, 3}},                       // a slanted one,
      {{0, 0, 4, 0, 0, 4, 0, 4, 4, 0, 0, 0}, {0, 3, 6}},  // or one ring twice
  };
  for (std::size_t k = 0; k < std::size(bad); ++k) {
    EXPECT_EQ(region.assign(bad[k].first, bad[k].second), Error::kBadBounds) << k;
    EXPECT_EQ(region.area(), 8) << k;
  }
}

TEST(RegionCalls, OneThatHasNotBeenAssignedIsEmpty) {
  const Region region;
  const Bounds box = region.box(), plain;
  EXPECT_EQ(region.area(), 0);
  EXPECT_TRUE(box.xmin == plain.xmin && box.ymin == plain.ymin && box.xmax == plain.xmax &&
              box.ymax == plain.ymax);
  Path path;
  path.line(1, 2);
  EXPECT_EQ(region.draw(path), Error::kNone);
  EXPECT_TRUE(path.commands.empty());
}

TEST(RegionCalls, ContainsItsInsideAndItsBorder) {
  // A square with a square hole and a triangle in that.
  const Region region =
      made({0, 0, 9, 0, 9, 9, 0, 9, 2, 2, 7, 2, 7, 7, 2, 7, 3, 3, 6, 3, 3, 6}, {0, 4, 8, 11});
  const std::pair<double, double> inside[] = {{1, 1}, {8, 5}, {4, 4}, {0, 0}, {9, 9},     {0, 5},
                                              {5, 0}, {2, 5}, {7, 7}, {3, 3}, {4.5, 4.5}, {5, 3}};
  for (const auto& [x, y] : inside) EXPECT_TRUE(region.contains(x, y)) << x << ' ' << y;
  const std::pair<double, double> outside[] = {{-1, 0},  {10, 9}, {5, -1},  {5, 10},
                                               {2.5, 5}, {5, 5},  {6.5, 3}, {2.5, 2.5}};
  for (const auto& [x, y] : outside) EXPECT_FALSE(region.contains(x, y)) << x << ' ' << y;
  EXPECT_FALSE(region.contains(std::nan(""), 1));
  EXPECT_FALSE(region.contains(1, std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(Region().contains(0, 0));
}

TEST(RegionCalls, MovedOnesAreWhatTheyWere) {
  Region first = made(kRings, kStarts);
  const double area = first.area();
  Region second(std::move(first));
  EXPECT_EQ(second.area(), area);
  Region third;
  third = std::move(second);
  EXPECT_EQ(third.area(), area);
}

/// visit(from, to) for the straight lines of a drawing, those that close a figure among them.
template <class Visit>
void visitLines(const Path& path, Visit&& visit) {
  Point first{}, last{};
  std::size_t at = 0;
  for (const std::uint8_t code : path.commands) {
    const auto command = static_cast<Command>(code);
    Point next = first;
    if (command != Command::kClose) {
      next = {path.coordinates[at], path.coordinates[at + 1]};
      at += 2;
    }
    if (command == Command::kMove) {
      first = next;
    } else {
      visit(last, next);
    }
    last = next;
  }
}

TEST(RegionCalls, DrawnWithTheInsideOnTheLeft) {
  const Region region = made(kRings, kStarts);
  Path path;
  ASSERT_EQ(region.draw(path), Error::kNone);
  double area = 0;
  visitLines(path, [&](Point from, Point to) { area += cross(from, to) / 2; });
  EXPECT_NEAR(area, region.area(), 1e-9);
  const auto figures = std::count(path.commands.begin(), path.commands.end(),
                                  static_cast<std::uint8_t>(Command::kClose));
  EXPECT_GE(figures, 3);
  EXPECT_EQ(figures, std::count(path.commands.begin(), path.commands.end(),
                                static_cast<std::uint8_t>(Command::kMove)));
}

Circles circlesIn(Random& random, std::size_t n) {
  Circles circles;
  for (std::size_t k = 0; k < n; ++k)
    circles.push_back({random.between(-20, 160), random.between(-20, 120), random.between(0, 9)});
  return circles;
}

double lengthOf(const Path& path) {
  double sum = 0;
  visitLines(path, [&](Point from, Point to) { sum += length(to - from); });
  return sum;
}

// Each edge inside is on the border of two cells, and the rest of their borders is the region's.
TEST(RegionCalls, EdgesAndBorderAreTheBordersOfAllCells) {
  Random random(921);
  for (int run = 0; run < runs(40); ++run) {
    Diagram diagram;
    insertInto(diagram, circlesIn(random, 1 + random.below(std::size_t{30})));
    const Region region = made(kRings, kStarts);
    const Voronoi voronoi(diagram, region);
    Numbers perimeters;
    CurveArrays edges;
    Path border;
    ASSERT_EQ(voronoi.cellPerimeters(perimeters), Error::kNone);
    ASSERT_EQ(voronoi.edgeCurves(edges), Error::kNone);
    ASSERT_EQ(region.draw(border), Error::kNone);
    double all = 0;
    for (const double perimeter : perimeters) all += perimeter;
    ASSERT_NEAR(2 * lengthOfCurves(edges) + lengthOf(border), all, 1e-7 * all) << "run " << run;
    ASSERT_EQ(edges.sites.size(), edges.curves.size() / 7 * 2);
  }
}

TEST(RegionCalls, DrawnEdgesAreTheListedOnesInPortionsOfAnySize) {
  Random random(922);
  for (int run = 0; run < runs(20); ++run) {
    Circles circles = circlesIn(random, 40);
    for (Circle& c : circles) c.r = 0;  // straight edges: lengths of drawings are theirs
    Diagram diagram;
    insertInto(diagram, circles);
    const Region region = made(kRings, kStarts);
    const Voronoi voronoi(diagram, region);
    CurveArrays edges;
    ASSERT_EQ(voronoi.edgeCurves(edges), Error::kNone);
    Path whole;
    drawEdgesInPortions(voronoi, 1e-3, 8, whole);
    EXPECT_NEAR(lengthOf(whole), lengthOfCurves(edges), 1e-6) << "run " << run;
  }
}

// In rectangles that cut many cells, and in those within one, that has no edge inside.
TEST(VoronoiCalls, MeasuresOfAllCellsAreThoseOfEach) {
  Random random(923);
  for (int run = 0; run < runs(60); ++run) {
    const Circles circles = circlesIn(random, 1 + random.below(std::size_t{40}));
    Diagram diagram;
    insertInto(diagram, circles);
    const double size = run % 3 == 0 ? 1e-6 : run % 3 == 1 ? 40 : 400;
    const double x = circles[0].x + 1e-3, y = circles[0].y;
    const Voronoi voronoi(diagram, Bounds{x, y, x + size, y + size / 2});
    Numbers areas, centroids, perimeters;
    ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
    ASSERT_EQ(voronoi.cellCentroids(centroids), Error::kNone);
    ASSERT_EQ(voronoi.cellPerimeters(perimeters), Error::kNone);
    for (SiteId id = 0; id < circles.size(); ++id) {
      CellMeasures one;
      ASSERT_EQ(voronoi.cellMeasures(id, one), Error::kNone);
      ASSERT_NEAR(areas[id], one.area, 1e-9 * size * size) << "run " << run << " site " << id;
      ASSERT_NEAR(perimeters[id], one.perimeter, 1e-9 * size) << "run " << run << " site " << id;
      ASSERT_EQ(std::isnan(centroids[2 * id]), one.isEmpty) << "run " << run << " site " << id;
      if (one.area < 1e-6 * size * size) continue;
      ASSERT_NEAR(centroids[2 * id], one.centroidX, 1e-6 * size) << "run " << run;
      ASSERT_NEAR(centroids[2 * id + 1], one.centroidY, 1e-6 * size) << "run " << run;
    }
  }
}

}  // namespace
}  // namespace apollonius::test
