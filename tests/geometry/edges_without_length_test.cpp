// Where more than three sites touch one circle, edges of the graph are points. A view does not have
// them: neither as edges, nor for neighbours, nor in drawings; in windows of any kind and up to any
// distance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

using Pairs = std::set<std::pair<SiteId, SiteId>>;

/// The sites on both sides of the edges of a view.
Pairs pairsOfEdges(const Voronoi& view) {
  CurveArrays edges;
  EXPECT_EQ(view.edgeCurves(edges), Error::kNone);
  Pairs pairs;
  for (std::size_t k = 0; k < edges.sites.size(); k += 2) {
    pairs.insert({edges.sites[k], edges.sites[k + 1]});
    pairs.insert({edges.sites[k + 1], edges.sites[k]});
  }
  return pairs;
}

/// Each site with its neighbours. Those of the cell's boundary are among them, and all of them
/// where the cell has an area that doubles know.
Pairs pairsOfCells(const Voronoi& view, std::size_t count) {
  Pairs pairs;
  for (SiteId id = 0; id < count; ++id) {
    std::vector<SiteId> neighbors;
    EXPECT_EQ(view.neighbors(id, neighbors), Error::kNone);
    for (const SiteId neighbor : neighbors) {
      EXPECT_NE(neighbor, id);
      EXPECT_TRUE(pairs.insert({id, neighbor}).second) << "twice";
    }
    CurveArrays boundary;
    EXPECT_EQ(view.cellCurves(id, boundary), Error::kNone);
    for (const SiteId neighbor : boundary.sites) {
      EXPECT_TRUE(neighbor == kNoSite || pairs.contains({id, neighbor}));
    }
  }
  return pairs;
}

std::size_t movesOf(const Path& path) {
  return static_cast<std::size_t>(std::count(path.commands.begin(), path.commands.end(),
                                             static_cast<std::uint8_t>(Command::kMove)));
}

/// visit(name, view) for windows of each kind, with all of a box in them.
template <class Visit>
void inEachWindow(const Diagram& diagram, const Bounds& box, Visit&& visit) {
  const double size = box.xmax - box.xmin;
  Region house;  // the box, with a roof
  const std::vector<double> corners{
      box.xmin,        box.ymin, box.xmax, box.ymin, box.xmax, box.ymax, (box.xmin + box.xmax) / 2,
      box.ymax + size, box.xmin, box.ymax};
  const std::vector<std::uint32_t> starts{0, 5};
  ASSERT_EQ(house.assign(corners, starts), Error::kNone);
  const Reach far(4 * size);
  visit("rectangle", Voronoi(diagram, box));
  visit("region", Voronoi(diagram, house));
  visit("rectangle, up to a distance", Voronoi(diagram, box, &far));
  visit("region, up to a distance", Voronoi(diagram, house, &far));
}

TEST(EdgesWithoutLength, CellsOfALatticeHaveFourNeighbors) {
  constexpr int kColumns = 5;
  for (const double unit : {1.0, 0.1, 7.0, 1e-90, 1e80}) {
    for (const double far : {0.0, 1e6, -0x1p30}) {
      for (const double weight : {0.0, 0.3}) {
        Circles circles;
        for (int k = 0; k < kColumns * kColumns; ++k)
          circles.push_back({unit * (far + k / kColumns), unit * (k % kColumns), unit * weight});
        Diagram diagram;
        insertInto(diagram, circles);
        const Bounds box{unit * (far - 0.5), unit * -0.5, unit * (far + 4.5), unit * 4.5};
        inEachWindow(diagram, box, [&](const char* name, const Voronoi& view) {
          SCOPED_TRACE(testing::Message() << name << " " << unit << " " << far << " " << weight);
          EXPECT_EQ(pairsOfCells(view, circles.size()).size(), 80u);
          EXPECT_EQ(pairsOfEdges(view).size(), 80u);
          CurveArrays edges;
          EXPECT_EQ(view.edgeCurves(edges), Error::kNone);
          EXPECT_EQ(edges.sites.size(), 2 * 40u);
          Path path;
          Portion portion;
          EXPECT_EQ(view.drawEdges(unit / 100, portion, path), Error::kNone);
          EXPECT_EQ(movesOf(path), 40u);
        });
      }
    }
  }
}

/// A window whose sides run along edges, or through vertices: both cells say the same.
TEST(EdgesWithoutLength, CellsAndEdgesAgreeWhereTheWindowRunsAlongEdges) {
  for (const double unit : {1.0, 0.1, 7.0, 1.0 / 3}) {
    for (const double far : {0.0, 10.0, -1e6}) {
      Circles circles;
      for (int k = 0; k < 25; ++k)
        circles.push_back({unit * (far + k / 5), unit * (k % 5), 0.01 * unit});
      Diagram diagram;
      insertInto(diagram, circles);
      const auto boxOf = [&](double xmin, double ymin, double xmax, double ymax) {
        return Bounds{unit * (far + xmin), unit * ymin, unit * (far + xmax), unit * ymax};
      };
      for (const Bounds& box : {boxOf(0.5, 0.5, 3.5, 3.5), boxOf(0.5, 1, 3, 2.5),
                                boxOf(-0.5, 0.5, 0.5, 1.5), boxOf(0.5, 0.5, 1.25, 1.25)}) {
        inEachWindow(diagram, box, [&](const char* name, const Voronoi& view) {
          SCOPED_TRACE(testing::Message() << name << " " << unit << " " << box.xmin);
          EXPECT_EQ(pairsOfCells(view, circles.size()), pairsOfEdges(view));
        });
      }
    }
  }
}

/// By rounding, a side can be beyond an edge, with a sliver between them that has no area.
TEST(EdgesWithoutLength, CellsAndEdgesAgreeWhereTheWindowTouchesAnEdge) {
  struct Scene {
    Circles circles;
    Bounds box;
  };
  std::vector<Scene> scenes{
      {{{0, 0, 6}, {10, -3, 1}}, {0, -9, 7, 9}},  // at (7, -5.25)
      {{{0.4, 0, 0.1}, {0.8, 0, 0.1}}, {0.5, -0.8, 0.6000000000000001, -0.3}},
      {{{0.4, 0, 0.1}, {0.8, 0, 0.1}, {0.6, 0.5, 0}}, {0.5, -0.8, 0.6000000000000001, -0.3}},
  };
  // Windows that end where an edge is farthest to a side.
  Random random(3303);
  for (int run = 0; run < runs(sized(200, 5000)); ++run) {
    Circles circles;
    const double far = run % 2 == 0 ? 0 : 0x1p20, unit = run % 3 == 0 ? 1 : 1.0 / 3;
    const auto at = [&](double x) { return far + unit * x; };
    for (int k = 0; k < 3; ++k)
      circles.push_back(
          {at(random.between(-10, 10)), at(random.between(-10, 10)), unit * random.between(0, 4)});
    Diagram diagram;
    insertInto(diagram, circles);
    CurveArrays edges;
    ASSERT_EQ(Voronoi(diagram, {at(-40), at(-40), at(40), at(40)}).edgeCurves(edges), Error::kNone);
    double xmax = at(-40);
    for (std::size_t k = 0; k + 7 <= edges.curves.size(); k += 7) {
      const double* const c = &edges.curves[k];
      const double middle = (c[0] + 2 * c[4] * c[2] + c[5]) / (2 + 2 * c[4]);
      xmax = std::max({xmax, std::min({c[0], middle, c[5]})});
    }
    if (xmax > at(-39)) scenes.push_back({circles, {at(-40), at(-40), xmax, at(40)}});
  }
  for (const Scene& scene : scenes) {
    Diagram diagram;
    insertInto(diagram, scene.circles);
    inEachWindow(diagram, scene.box, [&](const char* name, const Voronoi& view) {
      SCOPED_TRACE(testing::Message() << name << " " << scene.box.xmax);
      const Pairs pairs = pairsOfCells(view, scene.circles.size());
      EXPECT_EQ(pairs, pairsOfEdges(view));
      for (const auto& [a, b] : pairs) EXPECT_TRUE(pairs.contains({b, a}));
    });
  }
}

/// Cells that end before they meet others than the four around them, and some before these.
TEST(EdgesWithoutLength, NorUpToADistance) {
  Circles circles;
  for (int k = 0; k < 25; ++k) circles.push_back({1.0 * (k / 5), 1.0 * (k % 5), 0});
  Diagram diagram;
  insertInto(diagram, circles);
  for (const auto& [distance, expected] :
       {std::pair(0.49, 0u), {0.5, 0u}, {0.51, 80u}, {std::sqrt(0.5), 80u}, {0.75, 80u}}) {
    const Reach reach(distance);
    const Voronoi view(diagram, {-1, -1, 5, 5}, &reach);
    EXPECT_EQ(pairsOfCells(view, 25).size(), expected) << distance;
    EXPECT_EQ(pairsOfEdges(view).size(), expected) << distance;
  }
}

/// Points on one circle: each cell has the two beside it.
TEST(EdgesWithoutLength, CellsAroundOneVertexHaveTwoNeighbors) {
  Random random(3301);
  for (const std::size_t n : {4u, 5u, 30u, 300u}) {
    const Circles circles = cocircularPoints(random, n);
    std::set<std::pair<double, double>> places;
    for (const Circle& c : circles) places.insert({c.x, c.y});
    Diagram diagram;
    insertInto(diagram, circles);
    // A vertex in the middle of a window, and windows in which rounding has not moved that.
    inEachWindow(diagram, {-4e4, -4e4, 4e4, 4e4}, [&](const char* name, const Voronoi& view) {
      SCOPED_TRACE(testing::Message() << name << " " << n);
      EXPECT_EQ(pairsOfEdges(view).size(), 2 * places.size());
      EXPECT_EQ(pairsOfCells(view, circles.size()).size(), 2 * places.size());
    });
  }
}

/// Circles in a row that all touch the same two circles, above and below: edges go from one to the
/// other, and both their ends are vertices of all sites.
TEST(EdgesWithoutLength, NorWhereSitesHaveTwoVerticesInCommon) {
  const Circles all{{-35, 0, 33}, {-16, 0, 16}, {-9, 0, 11}, {-5, 0, 9},
                    {5, 0, 9},    {9, 0, 11},   {16, 0, 16}, {35, 0, 33}};  // touch (0, ±12, 4)
  for (std::size_t n = 3; n <= all.size(); ++n) {
    for (std::size_t first = 0; first + n <= all.size(); ++first) {
      for (const bool isUpright : {false, true}) {
        Circles circles;
        for (std::size_t k = 0; k < n; ++k) {
          const Circle& c = all[first + k];
          circles.push_back(isUpright ? Circle{c.y, c.x, c.r} : c);
        }
        Diagram diagram;
        insertInto(diagram, circles);
        inEachWindow(diagram, {-100, -100, 100, 100}, [&](const char* name, const Voronoi& view) {
          SCOPED_TRACE(testing::Message() << name << " " << first << " " << n);
          // Those beside each other, and the outermost two on both sides.
          EXPECT_EQ(pairsOfEdges(view).size(), 2 * n);
          EXPECT_EQ(pairsOfCells(view, n).size(), 2 * n);
          CurveArrays edges;
          EXPECT_EQ(view.edgeCurves(edges), Error::kNone);
          EXPECT_EQ(edges.sites.size(), 2 * (n + 1));
        });
      }
    }
  }
}

class PositiveEdgesOn : public ::testing::TestWithParam<NamedGenerator> {};

/// In a window that holds them all, edges are those of the graph that are no points, and both cells
/// know them.
TEST_P(PositiveEdgesOn, AreTheSameInAllWindowsAndForBothCells) {
  Random random(3302);
  for (int run = 0; run < runs(sized(3, 20)); ++run) {
    const Circles circles = GetParam().make(random, GetParam().large ? 60 : 12);
    Diagram diagram;
    insertInto(diagram, circles);
    Bounds bounds;
    if (!windowAround(circles, 0.6, bounds)) continue;
    const Voronoi rectangle(diagram, bounds);
    const Pairs pairs = pairsOfEdges(rectangle);
    const Reach far(kLargestMagnitude);
    Region same;
    const std::vector<double> corners{bounds.xmin, bounds.ymin, bounds.xmax, bounds.ymin,
                                      bounds.xmax, bounds.ymax, bounds.xmin, bounds.ymax};
    const std::vector<std::uint32_t> starts{0, 4};
    ASSERT_EQ(same.assign(corners, starts), Error::kNone);
    EXPECT_EQ(pairsOfEdges(Voronoi(diagram, bounds, &far)), pairs) << "run " << run;
    EXPECT_EQ(pairsOfEdges(Voronoi(diagram, same)), pairs) << "run " << run;
    for (const auto& [a, b] : pairs)
      ASSERT_TRUE(pairs.contains({b, a})) << a << " " << b << " run " << run;
    for (const Voronoi& view : {rectangle, Voronoi(diagram, same)})
      EXPECT_EQ(pairsOfCells(view, circles.size()), pairs) << "run " << run;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, PositiveEdgesOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::test
