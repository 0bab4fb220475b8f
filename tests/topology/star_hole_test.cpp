// Graph::starHole: the shapes that a hole can have.
#include "topology/surface.h"

namespace apollonius::test {

using namespace internal;
namespace {

/// Faces (1,2,0), (2,1,0); then 3 within the first: (1,2,3), (2,0,3), (0,1,3), (2,1,0).
Graph tetrahedron() {
  Graph graph;
  splitFace(graph, 3, makePair(graph, 1, 2)[0]);
  return graph;
}

TEST(StarHole, OneFace) {
  Graph graph;
  const auto faces = makePair(graph, 1, 2);
  const Starred starred = splitFace(graph, 3, faces[0]);
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), sorted({{1, 2, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 0}}));
  EXPECT_TRUE(starred.lost.empty());
  EXPECT_EQ(degree(graph, vertex(3)), 3u);
}

TEST(StarHole, NewFacesAreInTheOrderOfTheBoundary) {
  Graph graph;
  const auto faces = makePair(graph, 1, 2);
  const std::vector<HalfedgeId> boundary{halfedgeOf(faces[0], 1), halfedgeOf(faces[0], 2),
                                         halfedgeOf(faces[0], 0)};
  const std::vector<std::uint32_t> from{2, 0, 1};
  const Starred starred = starHole(graph, 3, {faces[0]}, boundary);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(graph.origin(halfedgeOf(starred.faces[k], 0)), vertex(from[k]));
    EXPECT_EQ(graph.origin(halfedgeOf(starred.faces[k], 1)), vertex(from[(k + 1) % 3]));
    EXPECT_EQ(graph.origin(halfedgeOf(starred.faces[k], 2)), vertex(3));
  }
}

TEST(StarHole, SeveralFaces) {
  Graph graph = tetrahedron();
  // Around 1 and 2: the faces left and right of the edge 1-2, a quadrangle 3, 1, 0, 2.
  const HalfedgeId left = halfedge(graph, 1, 2, 3), right = graph.twin(left);
  const Starred starred = starHole(graph, 4, {faceOf(left), faceOf(right)},
                                   {next(left), previous(left), next(right), previous(right)});
  EXPECT_EQ(broken(graph), "");
  EXPECT_TRUE(starred.lost.empty());
  EXPECT_EQ(degree(graph, vertex(4)), 4u);
  EXPECT_EQ(triples(graph),
            sorted({{2, 0, 3}, {0, 1, 3}, {2, 3, 4}, {3, 1, 4}, {1, 0, 4}, {0, 2, 4}}));
}

TEST(StarHole, ACycleOfFacesHidesTheVertexWithin) {
  Graph graph = tetrahedron();
  std::vector<FaceId> hole;
  for (const HalfedgeId h : linkOf(graph, vertex(3))) hole.push_back(faceOf(h));
  const std::vector<HalfedgeId> boundary = linkOf(graph, vertex(3));
  const Starred starred = starHole(graph, 4, hole, boundary);
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(starred.lost, std::vector<std::uint32_t>{3});
  EXPECT_FALSE(graph.hasVertex(vertex(3)));
  EXPECT_EQ(triples(graph), sorted({{1, 2, 4}, {2, 0, 4}, {0, 1, 4}, {2, 1, 0}}));
}

TEST(StarHole, TheInteriorOfAnEdgeGivesAVertexOfDegreeTwo) {
  Graph graph;
  makePair(graph, 1, 2);
  const Starred starred = openEdge(graph, 3, halfedge(graph, 1, 2));
  EXPECT_EQ(broken(graph), "");
  EXPECT_TRUE(starred.lost.empty());
  EXPECT_EQ(degree(graph, vertex(3)), 2u);
  // Two edges between 1 and 2 now: a multi-edge, with the new vertex between them.
  EXPECT_EQ(triples(graph), sorted({{1, 2, 0}, {2, 1, 0}, {1, 2, 3}, {2, 1, 3}}));
  EXPECT_EQ(degree(graph, vertex(1)), 4u);
}

TEST(StarHole, AnEdgeAtInfinityIsAnEdgeLikeOthers) {
  Graph graph;
  makePair(graph, 1, 2);
  openEdge(graph, 3, halfedge(graph, 0, 1));
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), sorted({{1, 2, 0}, {2, 1, 0}, {0, 1, 3}, {1, 0, 3}}));
}

TEST(StarHole, ABoundaryWithAnEdgeOnBothSides) {
  // Both faces of a pair go, but not all of the edge 1-2: the boundary is 2→0, 0→1, 1→0', 0'→2 ...
  // of the one face, then of the other, with 1→2 and 2→1 left in it: both ends of the edge are
  // taken and its middle is not.
  Graph graph;
  const auto faces = makePair(graph, 1, 2);
  const HalfedgeId front = halfedgeOf(faces[0], 0), back = graph.twin(front);  // 1→2 of either face
  // From the front face across 2→0 into the back one: 1→2, (2→1, 1→0 of the back), 0→1. The edge
  // 0-1 occurs with both sides, next to each other: its other end 0 is on the boundary all the
  // same.
  const HalfedgeId crossed = next(front);  // 2→0
  ASSERT_EQ(faceOf(graph.twin(crossed)), faces[1]);
  const HalfedgeId beyond = graph.twin(crossed);  // 0→2
  const std::vector<HalfedgeId> boundary{front, next(beyond), previous(beyond), previous(front)};
  ASSERT_EQ(next(beyond), back);
  const Starred starred = starHole(graph, 3, {faces[0], faces[1]}, boundary);
  EXPECT_EQ(broken(graph), "");
  EXPECT_TRUE(starred.lost.empty());
  // 1→2 and 2→1 are the two sides of one edge, and so the new faces on them are neighbours; 1→0 and
  // 0→1 alike.
  EXPECT_EQ(triples(graph), sorted({{1, 2, 3}, {2, 1, 3}, {1, 0, 3}, {0, 1, 3}}));
  EXPECT_EQ(graph.twin(halfedgeOf(starred.faces[0], 0)), halfedgeOf(starred.faces[1], 0));
  EXPECT_EQ(graph.twin(halfedgeOf(starred.faces[2], 0)), halfedgeOf(starred.faces[3], 0));
  EXPECT_EQ(degree(graph, vertex(2)), 2u);
  EXPECT_EQ(degree(graph, vertex(1)), 4u);
}

TEST(StarHole, AHoleThatLosesAVertexAndKeepsAnEdgeOnBothSides) {
  // All four faces of the tetrahedron but not the edge 0-1: vertices 2 and 3 are lost, the new one
  // has degree 2.
  Graph graph = tetrahedron();
  const HalfedgeId kept = halfedge(graph, 0, 1);
  const Starred starred = starHole(graph, 4, liveFaces(graph), {kept, graph.twin(kept)});
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(starred.lost, (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(triples(graph), sorted({{0, 1, 4}, {1, 0, 4}}));
  EXPECT_EQ(graph.faceCount(), 2u);
  EXPECT_EQ(graph.faceSlots(), 4u) << "surplus faces of the hole go to the free list";
}

TEST(StarHole, AVertexTwiceOnTheBoundaryIsNotLost) {
  // Open 1-2 for 3: two edges 1-2. A hole made of the two old faces, glued along 0-1 only, has 1 on
  // its boundary twice... and 0 once.
  Graph graph;
  makePair(graph, 1, 2);
  openEdge(graph, 3, halfedge(graph, 1, 2));
  const HalfedgeId crossed = halfedge(graph, 0, 1, 2), beyond = graph.twin(crossed);
  const Starred starred =
      starHole(graph, 4, {faceOf(crossed), faceOf(beyond)},
               {next(crossed), previous(crossed), next(beyond), previous(beyond)});
  EXPECT_EQ(broken(graph), "");
  EXPECT_TRUE(starred.lost.empty());
  EXPECT_EQ(graph.faceCount(), 6u);
  EXPECT_EQ(degree(graph, vertex(4)), 4u);
  // 4 meets 2 in two edges, which lie on either side of 0.
  std::size_t edgesTo2 = 0;
  for (const HalfedgeId h : linkOf(graph, vertex(4))) edgesTo2 += graph.origin(h) == vertex(2);
  EXPECT_EQ(edgesTo2, 2u);
}

TEST(StarHole, FacesOutsideKeepTheirIds) {
  Graph graph = tetrahedron();
  const HalfedgeId keep = halfedge(graph, 2, 1, 0);
  splitFace(graph, 4, faceOf(halfedge(graph, 1, 2, 3)));
  EXPECT_EQ(triple(graph, faceOf(keep)), triple(2, 1, 0));
  EXPECT_EQ(faceOf(graph.twin(keep)), faceOf(halfedge(graph, 1, 2, 4)));
}

}  // namespace
}  // namespace apollonius::test
