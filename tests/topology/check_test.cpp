// Graph::check names each kind of damage: every message of src/topology/check.cpp is provoked here.
#include "topology/graph_breaker.h"
#include "topology/surface.h"

namespace apollonius::test {

using namespace internal;
namespace {

class GraphCheck : public ::testing::Test {
 protected:
  GraphCheck() {
    // Six faces: 3 within (1,2,0), 4 within (1,2,3).
    splitFace(graph, 3, makePair(graph, 1, 2)[0]);
    splitFace(graph, 4, faceOf(halfedge(graph, 1, 2, 3)));
    EXPECT_EQ(broken(graph), "");
  }

  /// Takes vertex 4 out again, so that there are two free faces.
  void freeTwoFaces() {
    const auto link = linkOf(graph, vertex(4));
    replaceStar(graph, 4, link,
                {{{graph.origin(link[0]), graph.origin(link[1]), graph.origin(link[2])},
                  {outside(0), outside(1), outside(2)}}});
    ASSERT_EQ(broken(graph), "");
    ASSERT_EQ(graph.faceSlots() - graph.faceCount(), 2u);
  }

  void expectBroken(const std::string& message) {
    EXPECT_EQ(broken(graph).substr(0, message.size()), message) << broken(graph);
  }
  void expectBroken(const std::string& message, std::size_t where) {
    EXPECT_EQ(broken(graph), message + " " + std::to_string(where));
  }

  Graph graph;
  GraphBreaker breaker{graph};
};

TEST_F(GraphCheck, NoWholeNumberOfFaces) {
  breaker.truncateHalfedges();
  expectBroken("half-edges are not three a face: half-edges", 17);
}

TEST_F(GraphCheck, FreeFaceWithACorner) {
  freeTwoFaces();
  const HalfedgeId h = next(breaker.firstFree());
  breaker.origin(h) = vertex(1);
  expectBroken("a free face has a corner: half-edge", index(h));
}

TEST_F(GraphCheck, CornerThatIsNoVertex) {
  breaker.origin(HalfedgeId{0}) = vertex(99);
  expectBroken("a corner is no vertex: half-edge", 0);
}

TEST_F(GraphCheck, HalfLiveFace) {
  breaker.origin(HalfedgeId{1}) = kNoVertex;
  expectBroken("ends differ from the twin's: half-edge", 0);
}

TEST_F(GraphCheck, TwinOutOfTheArrays) {
  breaker.twin(HalfedgeId{4}) = HalfedgeId{1000};
  expectBroken("no live twin: half-edge", 4);
}

TEST_F(GraphCheck, TwinOfItself) {
  breaker.twin(HalfedgeId{5}) = HalfedgeId{5};
  expectBroken("no live twin: half-edge", 5);
}

TEST_F(GraphCheck, TwinInAFreeFace) {
  freeTwoFaces();
  HalfedgeId h = halfedge(graph, 0, 1);
  h = std::min(h, graph.twin(h));  // or its twin would be found first
  breaker.twin(h) = breaker.firstFree();
  expectBroken("no live twin: half-edge", index(h));
}

TEST_F(GraphCheck, TwinThatIsAnotherOnesTwin) {
  const HalfedgeId h = halfedge(graph, 1, 2), g = halfedge(graph, 2, 0);
  breaker.twin(h) = graph.twin(g);
  expectBroken("the twin's twin is another: half-edge");
}

TEST_F(GraphCheck, TwinsWithOtherEnds) {
  const HalfedgeId h = halfedge(graph, 1, 2), g = halfedge(graph, 2, 0);
  const HalfedgeId hTwin = graph.twin(h), gTwin = graph.twin(g);
  breaker.sew(h, gTwin);
  breaker.sew(g, hTwin);
  expectBroken("ends differ from the twin's: half-edge");
}

TEST_F(GraphCheck, TwinsThatRunTheSameWay) {
  // A multi-edge sewn the wrong way round: both halves from 1 to 2.
  Graph pair;
  makePair(pair, 1, 2);
  openEdge(pair, 3, halfedge(pair, 1, 2));
  GraphBreaker other{pair};
  const HalfedgeId a = halfedge(pair, 1, 2, 0), b = halfedge(pair, 1, 2, 3);
  const HalfedgeId aTwin = pair.twin(a), bTwin = pair.twin(b);
  other.sew(a, b);
  other.sew(aTwin, bTwin);
  EXPECT_EQ(broken(pair).substr(0, 22), "ends differ from the t");
}

TEST_F(GraphCheck, Loop) {
  // Vertex 2 renamed to 1 everywhere: twins still fit, the edge 1-2 has become a loop.
  for (std::uint32_t i = 0; i < 18; ++i) {
    if (graph.origin(HalfedgeId{i}) == vertex(2)) breaker.origin(HalfedgeId{i}) = vertex(1);
  }
  expectBroken("a loop: half-edge");
}

TEST_F(GraphCheck, VertexWithoutAPlace) {
  breaker.outgoing(vertex(3)) = kNoHalfedge;
  expectBroken("half-edges start at a vertex that has none: vertex", 3);
}

TEST_F(GraphCheck, OutgoingThatStartsElsewhere) {
  breaker.outgoing(vertex(3)) = halfedge(graph, 1, 2);
  expectBroken("its half-edge starts elsewhere: vertex", 3);
}

TEST_F(GraphCheck, OutgoingOutOfTheArrays) {
  breaker.outgoing(vertex(3)) = HalfedgeId{18};
  expectBroken("its half-edge starts elsewhere: vertex", 3);
}

TEST_F(GraphCheck, VertexWithTwoStars) {
  // Vertices 4 and 0 have no edge in common: giving both the name 4 leaves every edge in order and
  // 4 with two stars.
  for (std::uint32_t i = 0; i < 18; ++i) {
    if (graph.origin(HalfedgeId{i}) == kInfinity) breaker.origin(HalfedgeId{i}) = vertex(4);
  }
  breaker.outgoing(kInfinity) = kNoHalfedge;
  expectBroken("turning around it does not visit its half-edges once: vertex", 4);
}

TEST_F(GraphCheck, TwoSurfaces) {
  // A second closed surface of vertices of its own.
  graph.reserveVertices(9);
  graph.reserveFaces(0, 2);
  const FaceId f = breaker.addFace(vertex(5), vertex(6), vertex(7)),
               g = breaker.addFace(vertex(6), vertex(5), vertex(7));
  breaker.sew(halfedgeOf(f, 0), halfedgeOf(g, 0));
  breaker.sew(halfedgeOf(f, 1), halfedgeOf(g, 2));
  breaker.sew(halfedgeOf(f, 2), halfedgeOf(g, 1));
  expectBroken("not connected: faces reached");
}

TEST(GraphCheckTorus, IsNotASphere) {
  // Möbius' torus of seven vertices and fourteen faces: (i, i+1, i+3) and (i, i+3, i+2) modulo 7.
  Graph graph;
  GraphBreaker breaker{graph};
  graph.reserveVertices(7);
  graph.reserveFaces(0, 14);
  for (std::uint32_t i = 0; i < 7; ++i) {
    breaker.addFace(vertex(i), vertex((i + 1) % 7), vertex((i + 3) % 7));
    breaker.addFace(vertex(i), vertex((i + 3) % 7), vertex((i + 2) % 7));
  }
  for (std::uint32_t i = 0; i < 42; ++i) {
    const HalfedgeId h{i};
    breaker.sew(h, halfedge(graph, number(graph.target(h)), number(graph.origin(h))));
  }
  EXPECT_EQ(broken(graph), "not a sphere: vertices 7");
}

TEST_F(GraphCheck, SurfaceWithoutInfinity) {
  graph.reserveVertices(6);
  for (std::uint32_t i = 0; i < 18; ++i) {
    if (graph.origin(HalfedgeId{i}) == kInfinity) breaker.origin(HalfedgeId{i}) = vertex(5);
  }
  breaker.outgoing(vertex(5)) = graph.outgoing(kInfinity);
  breaker.outgoing(kInfinity) = kNoHalfedge;
  expectBroken("infinity is not in the graph: vertex", 0);
}

TEST_F(GraphCheck, FreeListIntoALiveFace) {
  freeTwoFaces();
  breaker.firstFree() = halfedge(graph, 1, 2);
  expectBroken("the free list leads to a live face: half-edge");
}

TEST_F(GraphCheck, FreeListOutOfTheArrays) {
  freeTwoFaces();
  breaker.twin(breaker.firstFree()) = HalfedgeId{500};
  expectBroken("the free list leads to a live face: half-edge", 500);
}

TEST_F(GraphCheck, FreeListThatEndsEarly) {
  freeTwoFaces();
  breaker.twin(breaker.firstFree()) = kNoHalfedge;
  expectBroken("free faces are lost: listed", 1);
}

TEST_F(GraphCheck, FreeListInACircle) {
  freeTwoFaces();
  const HalfedgeId first = breaker.firstFree();
  breaker.twin(graph.twin(first)) = first;
  expectBroken("free faces are lost: listed");
}

TEST_F(GraphCheck, WrongCountOfFreeFaces) {
  freeTwoFaces();
  --breaker.freeFaces();
  expectBroken("free faces are lost: listed");
}

TEST_F(GraphCheck, FreeFaceThatTheListHasLost) {
  freeTwoFaces();
  breaker.twin(breaker.firstFree()) = kNoHalfedge;
  --breaker.freeFaces();
  expectBroken("free faces are lost: listed", 1);
}

TEST(GraphCheckEmpty, AVertexOfNoFaceIsNamed) {
  // No message of its own: the half-edge that such a vertex names does not exist, or is free.
  Graph graph;
  graph.reserveVertices(3);
  GraphBreaker{graph}.outgoing(vertex(2)) = HalfedgeId{0};
  EXPECT_EQ(broken(graph), "its half-edge starts elsewhere: vertex 2");
}

TEST_F(GraphCheck, AVertexOfDegreeOneIsALoop) {
  // No message of its own: a face with two adjacent sides sewn to each other has a loop for its
  // third side.
  graph.reserveFaces(0, 2);
  const FaceId f = breaker.addFace(vertex(4), vertex(1), vertex(1));
  breaker.sew(halfedgeOf(f, 0), halfedgeOf(f, 2));
  const FaceId g = breaker.addFace(vertex(1), vertex(1), vertex(3));
  breaker.sew(halfedgeOf(f, 1), halfedgeOf(g, 0));
  breaker.sew(halfedgeOf(g, 1), halfedgeOf(g, 2));
  expectBroken("a loop: half-edge");
}

}  // namespace
}  // namespace apollonius::test
