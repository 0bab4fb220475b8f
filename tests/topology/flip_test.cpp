// Graph::flip: the other diagonal of two faces, also where that leaves a vertex with degree 2.
#include <cstdint>

#include "support/random.h"
#include "topology/surface.h"

namespace apollonius::test {
namespace {

/// Vertices 1 and 2, and others put into faces at random.
Graph someSurface(Random& random, std::uint32_t vertices) {
  Graph graph;
  makePair(graph, 1, 2);
  for (std::uint32_t v = 3; v <= vertices; ++v) {
    splitFace(graph, v, FaceId{static_cast<std::uint32_t>(random.below(graph.faceSlots()))});
  }
  return graph;
}

TEST(Flip, TakesTheOtherDiagonal) {
  Graph graph;
  makePair(graph, 1, 2);
  splitFace(graph, 3, faceOf(graph.outgoing(vertex(1))));
  const HalfedgeId h = halfedge(graph, 3, 1);
  const std::uint32_t i = 3, j = 1, k = number(graph.apex(h)),
                      l = number(graph.apex(graph.twin(h)));
  const FaceId left = faceOf(h), right = faceOf(graph.twin(h));
  graph.flip(h);
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(number(graph.origin(h)), l);
  EXPECT_EQ(number(graph.target(h)), k);
  EXPECT_EQ(triple(graph, left), triple(l, k, i));
  EXPECT_EQ(triple(graph, right), triple(k, l, j));
  EXPECT_EQ(degree(graph, vertex(3)), 2u);
}

TEST(Flip, FourTimesIsNone) {
  Random random(31);
  for (int run = 0; run < 200; ++run) {
    Graph graph = someSurface(random, 3 + static_cast<std::uint32_t>(random.below(std::size_t{9})));
    for (int step = 0; step < 20; ++step) {
      const HalfedgeId h{static_cast<std::uint32_t>(random.below(3 * graph.faceSlots()))};
      if (graph.apex(h) == graph.apex(graph.twin(h))) continue;
      const Graph before = graph;
      for (int quarter = 0; quarter < 4; ++quarter) {
        graph.flip(h);
        ASSERT_EQ(broken(graph), "") << "run " << run;
      }
      for (std::uint32_t g = 0; g < 3 * graph.faceSlots(); ++g) {
        ASSERT_EQ(graph.origin(HalfedgeId{g}), before.origin(HalfedgeId{g})) << "run " << run;
        ASSERT_EQ(graph.twin(HalfedgeId{g}), before.twin(HalfedgeId{g})) << "run " << run;
      }
      graph.flip(h);
    }
  }
}

}  // namespace
}  // namespace apollonius::test
