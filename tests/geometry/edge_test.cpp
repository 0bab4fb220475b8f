// Edges as curves: their ends are in order along the bisector, also where four points with decimals
// are on one circle up to rounding, and the edge between them is shorter than that.
#include "geometry/curve/edge.h"

#include <gtest/gtest.h>

#include <cmath>

#include "apollonius/voronoi.h"
#include "diagram/bulk_insertion.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"

namespace apollonius::internal {
namespace {

class EdgesOn : public ::testing::TestWithParam<test::NamedGenerator> {};

TEST_P(EdgesOn, EndInTheOrderOfTheirParameters) {
  test::Random random(241);
  for (int run = 0; run < test::runs(4); ++run) {
    const test::Circles circles = GetParam().make(random, GetParam().large ? 60 : 12);
    const std::vector<double> xyr = test::flat(circles);
    std::vector<SiteId> ids(circles.size());
    DiagramCore core(Location::kHierarchy);
    insertAll(core, xyr, ids);
    const DelaunayGraph& delaunay = core.delaunay();
    const Graph& graph = delaunay.graph();
    for (const FaceId f : graph.faces()) {
      for (unsigned c = 0; c < 3; ++c) {
        const HalfedgeId h = halfedgeOf(f, c);
        if (graph.origin(h) == kInfinity || graph.target(h) == kInfinity ||
            !startsAtReference(delaunay, h))
          continue;
        for (const VertexPrecision precision :
             {VertexPrecision::kFast, VertexPrecision::kReproducible}) {
          const Edge edge(delaunay, h, precision);
          ASSERT_LE(edge.e0, edge.e1) << "run " << run;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, EdgesOn, ::testing::ValuesIn(test::corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

/// Three sites in line up to one double: their circle is larger than any double, straight above or
/// beside them.
TEST(Edges, ToVerticesBeyondAllDoubles) {
  const double low = 1e-100, high = std::nextafter(low, 1);
  for (const bool isUpright : {false, true}) {
    const auto at = [&](double x, double y) {
      return isUpright ? Circle{y, x, 0} : Circle{x, y, 0};
    };
    Diagram diagram;
    test::insertInto(diagram, {at(-1e100, low), at(0, high), at(1e100, low)});
    std::vector<double> areas;
    ASSERT_EQ(Voronoi(diagram, Bounds{-10, -10, 10, 10}).cellAreas(areas), Error::kNone);
    EXPECT_EQ(areas, (std::vector<double>{0, 400, 0}));
    CurveArrays edges;
    ASSERT_EQ(Voronoi(diagram, Bounds{-9e99, -9e99, 9e99, 9e99}).edgeCurves(edges), Error::kNone);
    EXPECT_EQ(edges.curves.size(), 14u);
    for (const double number : edges.curves) EXPECT_TRUE(std::isfinite(number));
  }
}

}  // namespace
}  // namespace apollonius::internal
