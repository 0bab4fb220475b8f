// The smallest surface, and the index arithmetic under all of them.
#include "topology/surface.h"

namespace apollonius::test {

using namespace internal;
namespace {

TEST(Ids, NextAndPreviousStayInTheFace) {
  for (std::uint32_t f = 0; f < 4; ++f) {
    for (unsigned corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = halfedgeOf(FaceId{f}, corner);
      EXPECT_EQ(faceOf(h), FaceId{f});
      EXPECT_EQ(next(h), halfedgeOf(FaceId{f}, (corner + 1) % 3));
      EXPECT_EQ(previous(next(h)), h);
      EXPECT_EQ(next(next(next(h))), h);
    }
  }
}

TEST(Graph, IsEmptyAtFirst) {
  const Graph graph;
  EXPECT_TRUE(graph.isEmpty());
  EXPECT_EQ(graph.faceCount(), 0u);
  EXPECT_FALSE(graph.hasVertex(kInfinity));
  EXPECT_FALSE(graph.hasVertex(vertex(7)));
  EXPECT_EQ(broken(graph), "");
}

TEST(MakePair, IsAClosedSurfaceOfTwoFaces) {
  Graph graph;
  makePair(graph, 5, 3);
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), sorted({{5, 3, 0}, {3, 5, 0}}));
  EXPECT_EQ(graph.vertexSlots(), 6u);
  for (const std::uint32_t v : {0u, 3u, 5u}) EXPECT_EQ(degree(graph, vertex(v)), 2u);
  for (const std::uint32_t v : {1u, 2u, 4u, 6u}) EXPECT_FALSE(graph.hasVertex(vertex(v)));
}

TEST(MakePair, EveryEdgeLiesBetweenTheTwoFaces) {
  Graph graph;
  const auto faces = makePair(graph, 1, 2);
  EXPECT_NE(faces[0], faces[1]);
  for (unsigned corner = 0; corner < 3; ++corner) {
    const HalfedgeId h = halfedgeOf(faces[0], corner);
    EXPECT_EQ(faceOf(graph.twin(h)), faces[1]);
    EXPECT_EQ(graph.target(h), graph.origin(graph.twin(h)));
  }
}

TEST(Graph, ReadsAroundAFaceAndAroundAVertex) {
  Graph graph;
  makePair(graph, 1, 2);
  const HalfedgeId h = halfedge(graph, 1, 2);
  EXPECT_EQ(graph.apex(h), kInfinity);
  EXPECT_EQ(graph.origin(graph.rotateCcw(h)), vertex(1));
  EXPECT_EQ(graph.target(graph.rotateCcw(h)), kInfinity);
  EXPECT_EQ(graph.rotateCw(graph.rotateCcw(h)), h);
}

TEST(Clear, ForgetsAllAndAllowsANewPair) {
  Graph graph;
  makePair(graph, 1, 2);
  splitFace(graph, 3, FaceId{0});
  graph.clear();
  EXPECT_TRUE(graph.isEmpty());
  EXPECT_EQ(graph.vertexSlots(), 4u) << "the room for vertices stays";
  for (std::uint32_t v = 0; v < 4; ++v) EXPECT_FALSE(graph.hasVertex(vertex(v)));
  EXPECT_EQ(broken(graph), "");
  makePair(graph, 3, 2);
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), sorted({{3, 2, 0}, {2, 3, 0}}));
}

}  // namespace
}  // namespace apollonius::test
