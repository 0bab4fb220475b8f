// Edges as curves: their ends come in their order along the bisector, also where four decimals are
// on one circle but for rounding, and the edge between them is shorter than that.
#include "geometry/edge.h"

#include <gtest/gtest.h>

#include "diagram/bulk_insertion.h"
#include "support/corpus.h"
#include "support/effort.h"

namespace apollonius::internal {
namespace {

class EdgesOn : public ::testing::TestWithParam<test::NamedGenerator> {};

TEST_P(EdgesOn, EndInTheOrderOfTheirParameters) {
  test::Random random(241);
  for (int run = 0; run < test::runs(4); ++run) {
    const test::Circles circles = GetParam().make(random, GetParam().large ? 60 : 12);
    std::vector<double> xyr;
    for (const Circle& c : circles) xyr.insert(xyr.end(), {c.x, c.y, c.r});
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
        for (const Bits bits : {Bits::kCached, Bits::kCanonical}) {
          const Edge edge(delaunay, h, bits);
          ASSERT_LE(edge.e0, edge.e1) << "run " << run;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, EdgesOn, ::testing::ValuesIn(test::corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::internal
