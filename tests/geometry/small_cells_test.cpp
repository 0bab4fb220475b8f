// At the default tolerance polygons have the areas of their cells, within 0.5 %, however small a
// cell is in its window, and however little of it the window shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/shapes.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

constexpr double kDefault = 0;
constexpr double kMostOff = 0.005;

/// The points of all polygons; expects their areas.
std::size_t pointsOf(const Voronoi& view, std::size_t count, double thinnest = 0) {
  CoverageArrays all;
  EXPECT_EQ(view.cellPolygons(kDefault, all), Error::kNone);  // which proves that they tile
  std::vector<double> areas(count, 0.0);
  for (std::size_t k = 0; k < all.sites.size(); ++k) {
    RingArrays rings;
    rings.coordinates = all.coordinates;
    const auto first = all.starts.begin() + all.parts[all.cells[k]],
               end = all.starts.begin() + all.parts[all.cells[k + 1]];
    rings.starts.assign(first, end + 1);
    areas[all.sites[k]] = areaOf(rings);
  }
  for (SiteId id = 0; id < count; ++id) {
    CellMoments moments;
    RingArrays rings;
    EXPECT_EQ(view.cellMoments(id, moments), Error::kNone);
    EXPECT_EQ(view.cellPolygon(id, kDefault, rings), Error::kNone);
    const double allowed = kMostOff * moments.area + thinnest;
    EXPECT_NEAR(areas[id], moments.area, allowed) << "site " << id;
    EXPECT_NEAR(areaOf(rings), moments.area, allowed) << "site " << id;
  }
  return all.coordinates.size() / 2;
}

TEST(SmallCells, CellsThatEndAtADistance) {
  Diagram diagram;
  insertInto(diagram, {{500, 300, 0}, {520, 300, 0}, {10, 10, 3}});
  for (const double distance : {1e-6, 0.01, 0.1, 1.0, 5.0, 20.0, 80.0}) {
    SCOPED_TRACE(distance);
    const Reach reach(distance);
    const Voronoi view(diagram, {0, 0, 1000, 600}, &reach);
    EXPECT_LE(pointsOf(view, 3), 3 * 100u);
    Path path;
    EXPECT_EQ(view.drawCell(0, kDefault, path), Error::kNone);
    const auto curves = std::count(path.commands.begin(), path.commands.end(),
                                   static_cast<std::uint8_t>(Command::kCurve));
    EXPECT_GE(curves, 2);
    EXPECT_LE(path.commands.size(), 12u);
    Portion portion;
    EXPECT_EQ(view.drawSites(kDefault, portion, path), Error::kNone);
    EXPECT_EQ(path.commands.size(), 6u) << "a circle of four curves";
  }
}

/// Sites in a part of the window, of any size beside it, and any of them beside its sides.
TEST(SmallCells, CellsInWindowsOfAnySize) {
  Random random(3401);
  for (int run = 0; run < runs(sized(40, 400)); ++run) {
    Circles circles;
    const int count = 2 + static_cast<int>(random.below(30));
    for (int k = 0; k < count; ++k) {
      const double r = random.oneIn(3)   ? 0
                       : random.oneIn(5) ? random.between(0, 30)
                                         : 3 * random.unit();
      circles.push_back({random.between(0, 100), random.between(0, 100), r});
    }
    Diagram diagram;
    insertInto(diagram, circles);
    const double size = std::exp2(random.between(-8, 20));
    const double x = random.between(0, 100), y = random.between(0, 100);
    const Bounds box{x - size * random.unit(), y - size * random.unit(), x + size, y + size};
    const double step = (box.xmax - box.xmin) / 4;
    // A comb, whose teeth run along cells, with a hole.
    const std::vector<double> corners{box.xmin,
                                      box.ymin,
                                      box.xmax,
                                      box.ymin,
                                      box.xmax,
                                      box.ymax,
                                      x + 0.7 * size,
                                      y + size / 9,
                                      x + size / 2,
                                      box.ymax,
                                      x + size / 3,
                                      y + size / 8,
                                      box.xmin,
                                      box.ymax,
                                      box.xmin + step / 9,
                                      box.ymin + step / 9,
                                      box.xmin + step / 3,
                                      box.ymin + step / 8,
                                      box.xmin + step / 4,
                                      box.ymin + step / 3};
    const std::vector<std::uint32_t> starts{0, 7, 10};
    Region comb;
    ASSERT_EQ(comb.assign(corners, starts), Error::kNone);
    const Reach reach(random.between(0, 30));
    std::size_t most = 0;
    // Cells with less than this share of the window are rounding.
    const double thinnest = 1e-12 * areaOf(box);
    for (const Voronoi& view : {Voronoi(diagram, box), Voronoi(diagram, comb),
                                Voronoi(diagram, box, &reach), Voronoi(diagram, comb, &reach)}) {
      SCOPED_TRACE(testing::Message() << "run " << run << " window " << size);
      most = std::max(most, pointsOf(view, circles.size(), thinnest));
      if (HasFailure()) return;
    }
    EXPECT_LT(most, 100 * circles.size() + 300) << "run " << run;
  }
}

/// A cell that shows a thin cap beside a side of its window, and one that wraps around a ray.
TEST(SmallCells, ThinOnes) {
  for (const double shown : {10.0, 1.0, 1e-2, 1e-4}) {
    SCOPED_TRACE(shown);
    Diagram diagram;
    insertInto(diagram, {{0, 0, 0}, {0, 200, 100}});
    // The edge is lowest at y = 50.
    const Reach reach(50);
    for (const Voronoi& view : {Voronoi(diagram, {-500, -500, 500, 50 + shown}),
                                Voronoi(diagram, {-20, 50 - shown, 20, 400}),
                                Voronoi(diagram, {-60, -60, 60, -50 + shown}, &reach)})
      EXPECT_LT(pointsOf(view, 2, 1e-9), 700u);
  }
  for (const double gap : {10.0, 1.0, 1e-3, 1e-6}) {
    SCOPED_TRACE(gap);
    Diagram diagram;
    insertInto(diagram, {{0, 0, 100}, {100 - gap, 0, 2 * gap}, {-100, 0, 0}});
    EXPECT_LT(pointsOf(Voronoi(diagram, {-1e4, -1e4, 1e4, 1e4}), 3), 700u);
  }
}

/// Cells of which a side of the window leaves a strip beside a curve: from where the two touch, and
/// beside a cell far smaller than its edges are long.
TEST(SmallCells, StripsBesideACurve) {
  struct Scene {
    Circles circles;
    Bounds box;
  };
  std::vector<Scene> scenes{
      {{{0, 0, 8e-5}, {1, 0, 0}}, {0.50003, -0.1, 0.50005, 0.05}},
      {{{5, 1, 2}, {4, 2, 1}, {-5, 3, 0}, {-1, -1, 0}}, {-1e8, -1e8, 1e8, 1e8}},
  };
  for (int k = 1; k <= 17; ++k) {  // the last strips are 10^-10 wide
    const double e = std::exp2(-k);
    scenes.push_back({{{4, 0, 0}, {2, 0, 1}}, {3.5, -2 * e, 3.5 + e, e}});
    scenes.push_back({{{4, 0, 0}, {2, 0, 1}}, {3.5 + e * e / 9, -2 * e, 3.5 + e, e}});
  }
  for (const auto& [circles, box] : scenes) {
    Diagram diagram;
    insertInto(diagram, circles);
    Region region;
    const std::vector<double> corners{box.xmin, box.ymin, box.xmax, box.ymin,
                                      box.xmax, box.ymax, box.xmin, box.ymax};
    ASSERT_EQ(region.assign(corners, std::vector<std::uint32_t>{0, 4}), Error::kNone);
    for (const Voronoi& view : {Voronoi(diagram, box), Voronoi(diagram, region)}) {
      SCOPED_TRACE(testing::Message() << "from " << box.xmin << ", " << box.ymin);
      EXPECT_LT(pointsOf(view, circles.size()), 700u);
    }
  }
}

/// A window whose corner cuts off a sliver of a cell that is as thin as doubles.
TEST(SmallCells, SliversOfRounding) {
  Diagram diagram;
  insertInto(
      diagram,
      {{0.4, -0.3, 0.2}, {1.2000000000000002, 0.5, 1}, {0.8, 1.5, 1.4000000000000001}, {1, -1, 0}});
  const double x = 0.30000000000000004;
  Region region;
  ASSERT_EQ(
      region.assign(std::vector<double>{-0.8, 0, x, 0, x, x}, std::vector<std::uint32_t>{0, 3}),
      Error::kNone);
  EXPECT_LT(pointsOf(Voronoi(diagram, region), 4, 1e-15), 200u);
}

/// The number of points fits the drawing: none for straight edges, some for each curved one.
TEST(SmallCells, PointsAreInProportion) {
  Random random(3402);
  const auto points = [&](std::size_t count, double weight) {
    Circles circles;
    for (std::size_t k = 0; k < count; ++k)
      circles.push_back({random.between(0, 1), random.between(0, 1), weight * random.unit()});
    Diagram diagram;
    insertInto(diagram, circles);
    CoverageArrays all;
    EXPECT_EQ(Voronoi(diagram, {0, 0, 1, 1}).cellPolygons(kDefault, all), Error::kNone);
    return static_cast<double>(all.coordinates.size()) / 2 / static_cast<double>(count);
  };
  EXPECT_LT(points(2000, 0), 8);
  EXPECT_LT(points(2000, 0.5 / std::sqrt(2000)), 40);
  EXPECT_LT(points(8000, 0.5 / std::sqrt(8000)), 40);
}

}  // namespace
}  // namespace apollonius::test
