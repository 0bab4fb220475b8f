// Cells inside windows against brute force: who is nearest at each point of a raster, areas by
// summation, by polygon and by counting.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

constexpr double kShares[] = {0.0, -0.3, 0.4, 3.0};

class CellsOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(CellsOn, AreasAddUpToTheWindow) {
  Random random(521);
  for (int run = 0; run < runs(sized(5, 12)); ++run) {
    const Circles circles =
        GetParam().make(random, GetParam().large ? 5 + 25 * static_cast<std::size_t>(run)
                                                 : 4 + static_cast<std::size_t>(run % 6));
    Diagram diagram;
    insertInto(diagram, circles);
    for (const double share : kShares) {
      Bounds bounds;
      if (!windowAround(circles, share, bounds)) continue;
      const Voronoi voronoi(diagram, bounds);
      std::vector<double> areas;
      ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
      const double whole = areaOf(bounds);
      double sum = 0;
      for (SiteId id = 0; id < areas.size(); ++id) {
        sum += areas[id];
        CellMeasures one;
        ASSERT_EQ(voronoi.cellMeasures(id, one), Error::kNone);
        ASSERT_NEAR(one.area / whole, areas[id] / whole, 1e-13)
            << "site " << id << " run " << run << " share " << share;
      }
      ASSERT_NEAR(sum / whole, 1, 1e-12) << "run " << run << " share " << share;
    }
  }
}

TEST_P(CellsOn, RasterAgreesWithTheNearestSite) {
  Random random(522);
  for (int run = 0; run < runs(3); ++run) {
    const Circles circles = GetParam().make(random, GetParam().large ? 30 : 8);
    Diagram diagram;
    insertInto(diagram, circles);
    for (const double share : kShares) {
      Bounds bounds;
      if (!windowAround(circles, share, bounds)) continue;
      const Voronoi voronoi(diagram, bounds);
      const double size = bounds.xmax - bounds.xmin, tolerance = size * 1e-4;
      std::vector<RingArrays> rings(circles.size());
      double sum = 0;
      for (SiteId id = 0; id < rings.size(); ++id) {
        ASSERT_EQ(voronoi.cellPolygon(id, tolerance, rings[id]), Error::kNone);
        sum += areaOf(rings[id]);
      }
      ASSERT_NEAR(sum / areaOf(bounds), 1, 0.01);
      for (int k = 0; k < 40; ++k) {
        const double x = random.between(bounds.xmin, bounds.xmax),
                     y = random.between(bounds.ymin, bounds.ymax);
        if (std::abs(x) < kSmallestMagnitude || std::abs(y) < kSmallestMagnitude) continue;
        SiteId nearest = kNoSite;
        double distance = 0, second = std::numeric_limits<double>::infinity();
        ASSERT_EQ(diagram.find(x, y, nearest, distance), Error::kNone);
        for (SiteId id = 0; id < circles.size(); ++id) {
          if (id != nearest) second = std::min(second, distanceTo(circles[id], x, y));
        }
        // A polygon is at most the tolerance off, and moving by that much changes a difference of
        // distances by twice that.
        if (!(second - distance > 2.5 * tolerance)) continue;
        for (SiteId id = 0; id < circles.size(); ++id) {
          ASSERT_EQ(isInside(rings[id], x, y), id == nearest)
              << "site " << id << " at " << x << " " << y << " run " << run << " share " << share;
        }
      }
    }
  }
}

TEST_P(CellsOn, BoundariesAreClosedAndShared) {
  Random random(523);
  const Circles circles = GetParam().make(random, GetParam().large ? 120 : 9);
  Diagram diagram;
  insertInto(diagram, circles);
  for (const double share : kShares) {
    Bounds bounds;
    if (!windowAround(circles, share, bounds)) continue;
    const Voronoi voronoi(diagram, bounds);
    // Curves whose reverse, a curve of the cell beyond, has not been seen.
    std::multiset<std::vector<double>> seen;
    for (SiteId id = 0; id < circles.size(); ++id) {
      CurveArrays cell;
      ASSERT_EQ(voronoi.cellCurves(id, cell), Error::kNone);
      for (std::size_t region = 0; region + 1 < cell.starts.size(); ++region) {
        const std::uint32_t begin = cell.starts[region], end = cell.starts[region + 1];
        for (std::uint32_t k = begin; k < end; ++k) {
          const double *c = &cell.curves[7 * k],
                       *following = &cell.curves[7 * (k + 1 < end ? k + 1 : begin)];
          ASSERT_TRUE(c[5] == following[0] && c[6] == following[1])
              << "a gap after curve " << k << " of site " << id;
          if (cell.sites[k] == kNoSite) continue;
          const std::vector<double> forward{c[0], c[1], c[2], c[3], c[4], c[5], c[6]},
              backward{c[5], c[6], c[2], c[3], c[4], c[0], c[1]};
          if (const auto other = seen.find(backward); other != seen.end()) {
            seen.erase(other);
          } else {
            seen.insert(forward);
          }
        }
      }
    }
    // The remaining edges belong to regions whose partner was only a touch.
    for (const std::vector<double>& c : seen) {
      const double size = std::abs(c[5] - c[0]) + std::abs(c[6] - c[1]);
      const bool onBorder = std::min({std::abs(c[0] - bounds.xmin), std::abs(c[0] - bounds.xmax),
                                      std::abs(c[1] - bounds.ymin), std::abs(c[1] - bounds.ymax)}) <
                            1e-7 * (bounds.xmax - bounds.xmin);
      ASSERT_TRUE(onBorder || size < 1e-7 * (bounds.xmax - bounds.xmin))
          << c[0] << " " << c[1] << " share " << share;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, CellsOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Cells, MeasuresAgreeWithCounting) {
  Random random(524);
  Circles circles = randomCircles(random, 12, Hidden::k20Percent);
  Diagram diagram;
  insertInto(diagram, circles);
  Bounds bounds;
  ASSERT_TRUE(windowAround(circles, -0.1, bounds));
  const Voronoi voronoi(diagram, bounds);
  constexpr int kSide = 400;
  const double step = (bounds.xmax - bounds.xmin) / kSide,
               height = (bounds.ymax - bounds.ymin) / kSide;
  std::vector<double> area(circles.size(), 0), x(circles.size(), 0), y(circles.size(), 0);
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double px = bounds.xmin + (i + 0.5) * step, py = bounds.ymin + (j + 0.5) * height;
      std::size_t best = 0;
      for (std::size_t id = 1; id < circles.size(); ++id) {
        if (distanceTo(circles[id], px, py) < distanceTo(circles[best], px, py)) best = id;
      }
      area[best] += step * height;
      x[best] += step * height * px;
      y[best] += step * height * py;
    }
  }
  for (SiteId id = 0; id < circles.size(); ++id) {
    CellMeasures measures;
    ASSERT_EQ(voronoi.cellMeasures(id, measures), Error::kNone);
    EXPECT_NEAR(measures.area / areaOf(bounds), area[id] / areaOf(bounds), 1e-3);
    EXPECT_EQ(measures.isEmpty, measures.area == 0);
    if (measures.area < 0.01 * areaOf(bounds)) continue;
    EXPECT_NEAR(measures.centroidX, x[id] / area[id], 2e-3 * (bounds.xmax - bounds.xmin));
    EXPECT_NEAR(measures.centroidY, y[id] / area[id], 2e-3 * (bounds.xmax - bounds.xmin));
    RingArrays rings;
    ASSERT_EQ(voronoi.cellPolygon(id, 1e-7 * (bounds.xmax - bounds.xmin), rings), Error::kNone);
    EXPECT_NEAR(areaOf(rings) / measures.area, 1, 1e-5);
    double perimeter = 0;
    for (std::size_t k = 0; k + 1 < rings.coordinates.size() / 2; ++k) {
      if (rings.starts.size() > 2) break;
      const double* p = &rings.coordinates[2 * k];
      perimeter += std::sqrt((p[2] - p[0]) * (p[2] - p[0]) + (p[3] - p[1]) * (p[3] - p[1]));
    }
    if (rings.starts.size() == 2) {
      EXPECT_NEAR(measures.perimeter / perimeter, 1, 1e-6);
    }
  }
}

std::vector<double> areasOf(const Circles& circles, const Bounds& bounds) {
  Diagram diagram;
  insertInto(diagram, circles);
  std::vector<double> areas;
  EXPECT_EQ(Voronoi(diagram, bounds).cellAreas(areas), Error::kNone);
  return areas;
}

TEST(Cells, NoneOneAndTwoSites) {
  EXPECT_TRUE(areasOf({}, {0, 0, 10, 5}).empty());
  EXPECT_EQ(areasOf({{100, 100, 3}}, {0, 0, 10, 5}), (std::vector<double>{50}));
  EXPECT_EQ(areasOf({{0, 0, 1}, {10, 0, 1}}, {0, 0, 10, 5}), (std::vector<double>{25, 25}));
  EXPECT_EQ(areasOf({{0, 0, 1}, {100, 0, 1}}, {0, 0, 10, 5}), (std::vector<double>{50, 0}));
  EXPECT_EQ(areasOf({{0, 0, 5}, {1, 0, 1}}, {0, 0, 10, 5}), (std::vector<double>{50, 0}))
      << "hidden";
  const std::vector<double> curved = areasOf({{0, 0, 3}, {10, 0, 1}}, {-20, -20, 20, 20});
  EXPECT_NEAR(curved[0] + curved[1], 1600, 1e-10);
  EXPECT_NEAR(curved[0], 1094.42, 0.01);
}

TEST(Cells, ContactsThatAreNoCuts) {
  // The bisector x = 5 on the window's right and left side, and through corners.
  const Circles pair{{0, 0, 1}, {10, 0, 1}};
  EXPECT_EQ(areasOf(pair, {0, -1, 5, 1}), (std::vector<double>{10, 0}));
  EXPECT_EQ(areasOf(pair, {5, -1, 9, 1}), (std::vector<double>{0, 8}));
  const Circles cross{
      {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};  // bisectors through all four corners
  EXPECT_EQ(areasOf(cross, {-2, -2, 2, 2}), (std::vector<double>{4, 4, 4, 4}));
  EXPECT_EQ(areasOf(cross, {0, 0, 2, 2}), (std::vector<double>{2, 2, 0, 0}))
      << "the vertex is a corner";
  EXPECT_EQ(areasOf(cross, {-2, 0, 2, 2}), (std::vector<double>{2, 4, 2, 0}))
      << "the vertex is on a side";
  // A grid whose cells end exactly on the border.
  Circles grid;
  for (int k = 0; k < 25; ++k)
    grid.push_back({static_cast<double>(k % 5), static_cast<double>(k / 5), 0});
  const std::vector<double> areas = areasOf(grid, {0.5, 0.5, 3.5, 3.5});
  for (int k = 0; k < 25; ++k) {
    const bool inner = k % 5 > 0 && k % 5 < 4 && k / 5 > 0 && k / 5 < 4;
    EXPECT_EQ(areas[static_cast<std::size_t>(k)], inner ? 1 : 0) << k;
  }
  Diagram diagram;
  insertInto(diagram, grid);
  CurveArrays cell;
  EXPECT_EQ(Voronoi(diagram, {0.5, 0.5, 3.5, 3.5}).cellCurves(0, cell), Error::kNone);
  EXPECT_TRUE(cell.curves.empty()) << "a cell that only touches the window";
}

TEST(Cells, IntegerCirclesInWindowsThatEndOnTheirEdgesAndVertices) {
  // Asymptotes and edges along the border, vertices on it, corners on edges: nearly every run has
  // some. Once as they are and once times 0.1, where rounding puts everything next to where it
  // should be.
  Random random(526);
  for (int run = 0; run < runs(8000); ++run) {
    const int size = 1 + 2 * random.below(5);
    Circles circles = tinyGrid(random, 1 + random.below(std::size_t{9}), size, random.below(5));
    const double unit = random.oneIn(2) ? 1 : 0.1, step = random.oneIn(2) ? 1 : 0.25;
    for (Circle& c : circles) c = {c.x * unit, c.y * unit, c.r * unit};
    const auto coordinate = [&] {
      return unit * step *
             static_cast<double>(random.integer(-2, static_cast<int>((size + 2) / step)));
    };
    Bounds bounds{coordinate(), coordinate(), coordinate(), coordinate()};
    if (bounds.xmin > bounds.xmax) std::swap(bounds.xmin, bounds.xmax);
    if (bounds.ymin > bounds.ymax) std::swap(bounds.ymin, bounds.ymax);
    if (bounds.xmin == bounds.xmax || bounds.ymin == bounds.ymax) continue;
    Diagram diagram;
    insertInto(diagram, circles);
    const Voronoi voronoi(diagram, bounds);
    std::vector<double> areas;
    ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
    const double whole = areaOf(bounds), tolerance = 1e-3 * unit;
    double sum = 0;
    std::vector<RingArrays> rings(areas.size());
    for (SiteId id = 0; id < areas.size(); ++id) {
      CellMeasures measures;
      ASSERT_EQ(voronoi.cellMeasures(id, measures), Error::kNone);
      ASSERT_NEAR(measures.area / whole, areas[id] / whole, 1e-12) << "run " << run;
      ASSERT_EQ(voronoi.cellPolygon(id, tolerance, rings[id]), Error::kNone);
      sum += areas[id];
    }
    ASSERT_NEAR(sum / whole, 1, 1e-12) << "run " << run;
    for (int k = 0; k < 4; ++k) {
      const double x = random.between(bounds.xmin, bounds.xmax),
                   y = random.between(bounds.ymin, bounds.ymax);
      SiteId nearest = kNoSite;
      double distance = 0, second = std::numeric_limits<double>::infinity();
      ASSERT_EQ(diagram.find(x, y, nearest, distance), Error::kNone);
      for (SiteId id = 0; id < circles.size(); ++id) {
        bool hidden = false;
        ASSERT_EQ(diagram.isHidden(id, hidden), Error::kNone);
        if (id != nearest && !hidden) second = std::min(second, distanceTo(circles[id], x, y));
      }
      if (!(second - distance > 2.5 * tolerance)) continue;
      for (SiteId id = 0; id < circles.size(); ++id)
        ASSERT_EQ(isInside(rings[id], x, y), id == nearest) << "run " << run;
    }
  }
}

TEST(Cells, SeveralRegionsOfOneCell) {
  // A large circle left of the window reaches around a small one into both of the window's left
  // corners.
  const Circles circles{{-60, 50, 58}, {50, 50, 0}};
  Diagram diagram;
  insertInto(diagram, circles);
  const Voronoi voronoi(diagram, {30, 0, 100, 100});
  CurveArrays cell;
  ASSERT_EQ(voronoi.cellCurves(0, cell), Error::kNone);
  EXPECT_EQ(cell.starts.size(), 3u);
  RingArrays rings;
  ASSERT_EQ(voronoi.cellPolygon(0, 1e-3, rings), Error::kNone);
  ASSERT_EQ(rings.starts.size(), 3u);
  CellMeasures large, small;
  ASSERT_EQ(voronoi.cellMeasures(0, large), Error::kNone);
  ASSERT_EQ(voronoi.cellMeasures(1, small), Error::kNone);
  EXPECT_NEAR(large.area + small.area, 7000, 1e-10);
  EXPECT_NEAR(areaOf(rings), large.area, 0.1);
  EXPECT_NEAR(large.centroidY, 50, 1e-9) << "symmetric";
}

TEST(Cells, WindowThatCutsAHyperbolaTwice) {
  // The apex of the branch sticks out of the window: (6, 0) with the window beginning at x = 6.5.
  const std::vector<double> areas = areasOf({{0, 0, 3}, {10, 0, 1}}, {6.5, -20, 20, 20});
  EXPECT_NEAR(areas[0] + areas[1], 540, 1e-10);
  Diagram diagram;
  insertInto(diagram, {{0, 0, 3}, {10, 0, 1}});
  CurveArrays edges;
  ASSERT_EQ(Voronoi(diagram, {6.5, -20, 20, 20}).edgeCurves(edges), Error::kNone);
  EXPECT_EQ(edges.sites.size(), 4u) << "two pieces of one edge";
}

TEST(Cells, WithinARadius) {
  const double pi = std::acos(-1.0);
  Diagram diagram;
  insertInto(diagram, {{0, 0, 1}, {10, 0, 1}, {200, 0, 1}});
  EXPECT_NEAR(measuresWithin(diagram, 0, 3).area, 9 * pi, 1e-13);
  EXPECT_NEAR(measuresWithin(diagram, 0, 3).perimeter, 6 * pi, 1e-12);
  const CellMeasures measures = measuresWithin(diagram, 0, 7);
  const double half = std::acos(5.0 / 7), segment = 49 * (half - std::sin(half) * std::cos(half));
  EXPECT_NEAR(measures.area, 49 * pi - segment, 1e-11);
  EXPECT_LT(measures.centroidX, 0);
  EXPECT_NEAR(measures.centroidY, 0, 1e-13);

  // Against clipping: a radius beyond a bounded cell gives the whole of it.
  Random random(525);
  const Circles circles = randomCircles(random, 60, Hidden::k20Percent);
  Diagram many;
  insertInto(many, circles);
  const Voronoi wide(many, {-1e8, -1e8, 1e8, 1e8});
  int whole = 0;
  for (SiteId id = 0; id < circles.size(); ++id) {
    CellMeasures cell;
    ASSERT_EQ(wide.cellMeasures(id, cell), Error::kNone);
    double before = 0;
    for (const double radius : {1e5, 3e5, 1e6, 5e6}) {
      const double area = measuresWithin(many, id, radius).area;
      ASSERT_GE(area, before * (1 - 1e-12));
      ASSERT_LE(area, std::min(cell.area, pi * radius * radius) * (1 + 1e-9));
      before = area;
    }
    if (cell.area > 0 && std::abs(before / cell.area - 1) < 1e-9) ++whole;
  }
  EXPECT_GT(whole, 20);
}

}  // namespace
}  // namespace apollonius::test
