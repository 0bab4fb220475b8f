// Graph::replaceStar: the shapes that the star of a removed vertex and its patch can have.
#include "topology/surface.h"

namespace apollonius::test {

using namespace internal;
namespace {

using Patch = std::vector<Graph::PatchFace>;

Graph::PatchFace face(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                      std::array<std::uint32_t, 3> across) {
  return {{vertex(a), vertex(b), vertex(c)}, across};
}

/// link rotated so that it starts with the half-edge from a.
std::vector<HalfedgeId> linkFrom(const Graph& graph, std::uint32_t v, std::uint32_t a) {
  std::vector<HalfedgeId> link = linkOf(graph, vertex(v));
  const auto first = std::find_if(link.begin(), link.end(),
                                  [&](HalfedgeId h) { return graph.origin(h) == vertex(a); });
  EXPECT_NE(first, link.end());
  std::rotate(link.begin(), first, link.end());
  return link;
}

TEST(ReplaceStar, DegreeTwoIsSewnUp) {
  Graph graph;
  makePair(graph, 1, 2);
  const std::vector<Triple> before = triples(graph);
  openEdge(graph, 3, halfedge(graph, 1, 2));
  replaceStar(graph, 3, linkOf(graph, vertex(3)), {});
  EXPECT_EQ(broken(graph), "");
  EXPECT_FALSE(graph.hasVertex(vertex(3)));
  EXPECT_EQ(triples(graph), before);
  EXPECT_EQ(graph.faceSlots() - graph.faceCount(), 2u);
}

TEST(ReplaceStar, DegreeThreeBecomesAFace) {
  Graph graph;
  const auto faces = makePair(graph, 1, 2);
  const std::vector<Triple> before = triples(graph);
  splitFace(graph, 3, faces[0]);
  const auto link = linkOf(graph, vertex(3));
  const auto made =
      replaceStar(graph, 3, link,
                  {{{graph.origin(link[0]), graph.origin(link[1]), graph.origin(link[2])},
                    {outside(0), outside(1), outside(2)}}});
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), before);
  EXPECT_EQ(triple(graph, made[0]), triple(1, 2, 0));
}

/// 3 within (1,2,0), then 4 within the quadrangle 3, 1, 0, 2 around the edge 1-2.
Graph withDegreeFour() {
  Graph graph;
  splitFace(graph, 3, makePair(graph, 1, 2)[0]);
  const HalfedgeId left = halfedge(graph, 1, 2, 3), right = graph.twin(left);
  starHole(graph, 4, {faceOf(left), faceOf(right)},
           {next(left), previous(left), next(right), previous(right)});
  return graph;
}

TEST(ReplaceStar, AQuadrangleByEitherDiagonal) {
  {
    Graph graph = withDegreeFour();
    const auto link = linkFrom(graph, 4, 1);  // 1→0, 0→2, 2→3, 3→1
    replaceStar(graph, 4, link,
                Patch{face(1, 0, 2, {outside(0), outside(1), inside(1, 2)}),
                      face(2, 3, 1, {outside(2), outside(3), inside(0, 2)})});
    EXPECT_EQ(broken(graph), "");
    EXPECT_EQ(triples(graph), sorted({{1, 0, 2}, {2, 3, 1}, {2, 0, 3}, {0, 1, 3}}));
  }
  {
    Graph graph = withDegreeFour();
    const auto link = linkFrom(graph, 4, 1);
    replaceStar(graph, 4, link,
                Patch{face(1, 0, 3, {outside(0), inside(1, 2), outside(3)}),
                      face(0, 2, 3, {outside(1), outside(2), inside(0, 1)})});
    EXPECT_EQ(broken(graph), "");
    EXPECT_EQ(degree(graph, vertex(1)), 2u) << "1 hangs between 0 and 3";
    EXPECT_EQ(triples(graph), sorted({{1, 0, 3}, {0, 2, 3}, {2, 0, 3}, {0, 1, 3}}));
  }
}

TEST(ReplaceStar, APatchWithARevivedVertex) {
  Graph graph = withDegreeFour();
  const auto link = linkFrom(graph, 4, 1);  // 1→0, 0→2, 2→3, 3→1
  // 7 comes to life: next to 1, 0, 2 (degree 3), within the triangle that the diagonal 1-2 cuts
  // off.
  const auto made = replaceStar(graph, 4, link,
                                Patch{face(1, 0, 7, {outside(0), inside(1, 2), inside(2, 1)}),
                                      face(0, 2, 7, {outside(1), inside(2, 2), inside(0, 1)}),
                                      face(1, 7, 2, {inside(0, 2), inside(1, 1), inside(3, 2)}),
                                      face(2, 3, 1, {outside(2), outside(3), inside(2, 2)})});
  // The faces' sides were numbered by hand: the check below is of the numbering, too.
  EXPECT_EQ(triple(graph, made[3]), triple(2, 3, 1));
  EXPECT_EQ(triples(graph),
            sorted({{1, 0, 7}, {0, 2, 7}, {1, 7, 2}, {2, 3, 1}, {2, 0, 3}, {0, 1, 3}}));
  EXPECT_TRUE(graph.hasVertex(vertex(7)));
  EXPECT_EQ(broken(graph), "");
}

TEST(ReplaceStar, MoreFacesThanTheStarHad) {
  Graph graph;
  const auto faces = makePair(graph, 1, 2);
  splitFace(graph, 3, faces[0]);
  // The star of 3 is three faces; two revived vertices, the one within the other's star, make five.
  const auto link = linkFrom(graph, 3, 1);  // 1→2, 2→0, 0→1
  replaceStar(graph, 3, link,
              Patch{face(1, 2, 4, {outside(0), inside(1, 2), inside(4, 1)}),
                    face(2, 0, 4, {outside(1), inside(2, 2), inside(0, 1)}),
                    face(0, 5, 4, {inside(3, 2), inside(4, 2), inside(1, 1)}),
                    face(0, 1, 5, {outside(2), inside(4, 0), inside(2, 0)}),
                    face(5, 1, 4, {inside(3, 1), inside(0, 2), inside(2, 1)})});
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(graph.faceCount(), 6u);
  EXPECT_EQ(triples(graph),
            sorted({{1, 2, 4}, {2, 0, 4}, {0, 5, 4}, {0, 1, 5}, {5, 1, 4}, {2, 1, 0}}));
}

TEST(ReplaceStar, ALinkEdgeWithTheStarOnBothSidesStaysSewnToItsPartner) {
  // The boundary of ABoundaryWithAnEdgeOnBothSides (star_hole_test.cpp): 3's link is 1→2, 2→1, 1→0,
  // 0→1.
  Graph graph;
  const auto faces = makePair(graph, 1, 2);
  const std::vector<Triple> before = triples(graph);
  const HalfedgeId front = halfedgeOf(faces[0], 0), beyond = graph.twin(next(front));
  starHole(graph, 3, {faces[0], faces[1]},
           {front, next(beyond), previous(beyond), previous(front)});
  ASSERT_EQ(broken(graph), "");
  const auto link = linkFrom(graph, 3, 2);  // 2→1, 1→0, 0→1, 1→2
  ASSERT_EQ(graph.twin(link[0]), link[3]);
  ASSERT_EQ(graph.twin(link[1]), link[2]);
  replaceStar(graph, 3, link,
              Patch{face(2, 1, 0, {outside(0), outside(1), inside(1, 1)}),
                    face(1, 2, 0, {outside(3), inside(0, 2), outside(2)})});
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), before);
}

TEST(ReplaceStar, TheWholeSphereByAnEmptyLink) {
  // A single visible site is not in the graph; the sites that it hid become a pair.
  Graph graph;
  graph.reserveVertices(2);
  const auto made = replaceStar(graph, 1, {},
                                Patch{face(2, 3, 0, {inside(1, 0), inside(1, 2), inside(1, 1)}),
                                      face(3, 2, 0, {inside(0, 0), inside(0, 2), inside(0, 1)})});
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), sorted({{2, 3, 0}, {3, 2, 0}}));
  EXPECT_FALSE(graph.hasVertex(vertex(1)));
  EXPECT_NE(made[0], made[1]);
}

TEST(ReplaceStar, ALinkOfTwoSidesOfOneEdge) {
  // 2 has degree 2 and its link is both sides of the edge 0-1: the star is the whole sphere. It is
  // replaced by another's.
  Graph graph;
  makePair(graph, 1, 2);
  const auto link = linkFrom(graph, 2, 0);  // 0→1, 1→0
  ASSERT_EQ(graph.twin(link[0]), link[1]);
  replaceStar(graph, 2, link,
              Patch{face(0, 1, 9, {outside(0), inside(1, 2), inside(1, 1)}),
                    face(1, 0, 9, {outside(1), inside(0, 2), inside(0, 1)})});
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), sorted({{0, 1, 9}, {1, 0, 9}}));
}

TEST(ReplaceStar, UndoesStarHole) {
  // Hole and star are each other's reverse, ids of vertices and all: insert 9 into a hole of three
  // faces, and put them back.
  Graph graph = withDegreeFour();
  const std::vector<Triple> before = triples(graph);
  // 1→0, 0→2, 2→3 around 4: the faces (1,0,4), (0,2,4), (2,3,4), open at 3→4 and 4→1.
  const auto star = linkFrom(graph, 4, 1);
  const std::vector<FaceId> hole{faceOf(star[0]), faceOf(star[1]), faceOf(star[2])};
  const std::vector<HalfedgeId> boundary{star[0], star[1], star[2], next(star[2]),
                                         previous(star[0])};
  starHole(graph, 9, hole, boundary);
  ASSERT_EQ(broken(graph), "");
  const auto link = linkFrom(graph, 9, 1);
  replaceStar(graph, 9, link,
              Patch{face(1, 0, 4, {outside(0), inside(1, 2), outside(4)}),
                    face(0, 2, 4, {outside(1), inside(2, 2), inside(0, 1)}),
                    face(2, 3, 4, {outside(2), outside(3), inside(1, 1)})});
  EXPECT_EQ(broken(graph), "");
  EXPECT_EQ(triples(graph), before);
}

}  // namespace
}  // namespace apollonius::test
