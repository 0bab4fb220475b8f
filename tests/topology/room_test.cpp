// Room and reuse: the operations allocate nothing once room is made, and freed faces are used
// again.

#include "support/allocation_count.h"
#include "topology/surface.h"

namespace apollonius::test {

using namespace internal;
namespace {

/// Allocations of an operation.
template <class Operation>
std::size_t allocationsOf(Operation&& operation) {
  const std::size_t before = allocationCount;
  operation();
  return allocationCount - before;
}

TEST(Room, TheCounterCounts) {
  // Called by name: clang++ leaves out a pair of new and delete without an effect.
  EXPECT_EQ(allocationsOf([] { ::operator delete(::operator new(8)); }), 1u);
}

TEST(Room, MakePairAllocatesNothingAfterReserve) {
  Graph graph;
  graph.reserveVertices(3);
  graph.reserveFaces(0, 2);
  std::array<FaceId, 2> faces{};
  EXPECT_EQ(allocationsOf([&] { graph.makePair(vertex(1), vertex(2), faces); }), 0u);
  EXPECT_EQ(broken(graph), "");
}

TEST(Room, StarHoleAllocatesNothingAfterReserve) {
  Graph graph;
  FaceId f = makePair(graph, 1, 2)[0];
  for (std::uint32_t w = 3; w < 200; ++w) {
    // By turns into a face, into an edge, and over the whole star of the vertex before.
    std::vector<FaceId> hole;
    std::vector<HalfedgeId> boundary;
    if (w % 3 == 0) {
      hole = {f};
      boundary = {halfedgeOf(f, 0), halfedgeOf(f, 1), halfedgeOf(f, 2)};
    } else if (w % 3 == 1) {
      boundary = {halfedgeOf(f, 1), graph.twin(halfedgeOf(f, 1))};
    } else {
      boundary = linkOf(graph, vertex(w - 1));
      for (const HalfedgeId h : boundary) hole.push_back(faceOf(h));
    }
    std::vector<FaceId> faces(boundary.size());
    graph.reserveVertices(w + 1);
    graph.reserveFaces(hole.size(), boundary.size());
    ASSERT_EQ(allocationsOf([&] { (void)graph.starHole(vertex(w), hole, boundary, faces); }), 0u);
    ASSERT_EQ(broken(graph), "");
    f = faces[0];
  }
}

TEST(Room, ReplaceStarAllocatesNothingAfterReserve) {
  Graph graph;
  splitFace(graph, 3, makePair(graph, 1, 2)[0]);
  const auto link = linkOf(graph, vertex(3));
  // Five faces in the place of three, with two new vertices: see
  // ReplaceStar.MoreFacesThanTheStarHad.
  std::uint32_t first = 0;
  while (graph.origin(link[first]) != vertex(1)) ++first;
  const auto side = [&](std::uint32_t k) { return outside((first + k) % 3); };
  const std::vector<Graph::PatchFace> patch{
      {{vertex(1), vertex(2), vertex(4)}, {side(0), inside(1, 2), inside(4, 1)}},
      {{vertex(2), vertex(0), vertex(4)}, {side(1), inside(2, 2), inside(0, 1)}},
      {{vertex(0), vertex(5), vertex(4)}, {inside(3, 2), inside(4, 2), inside(1, 1)}},
      {{vertex(0), vertex(1), vertex(5)}, {side(2), inside(4, 0), inside(2, 0)}},
      {{vertex(5), vertex(1), vertex(4)}, {inside(3, 1), inside(0, 2), inside(2, 1)}}};
  std::vector<FaceId> faces(patch.size());
  graph.reserveVertices(6);
  graph.reserveFaces(link.size(), patch.size());
  EXPECT_EQ(allocationsOf([&] { graph.replaceStar(vertex(3), link, patch, faces); }), 0u);
  EXPECT_EQ(broken(graph), "");
}

TEST(Room, ReserveForWhatIsThereAllocatesNothing) {
  Graph graph;
  makePair(graph, 1, 2);
  openEdge(graph, 3, halfedge(graph, 1, 2));
  replaceStar(graph, 3, linkOf(graph, vertex(3)), {});
  // Two faces are free.
  EXPECT_EQ(allocationsOf([&] { graph.reserveFaces(0, 2); }), 0u);
  EXPECT_EQ(allocationsOf([&] { graph.reserveVertices(2); }), 0u);
}

TEST(Room, GrowsGeometrically) {
  // One by one, as insertions do: few reallocations, not one each.
  Graph graph;
  FaceId f = makePair(graph, 1, 2)[0];
  constexpr std::uint32_t kVertices = 3000;
  graph.reserveVertices(kVertices);
  const std::size_t counted = allocationsOf([&] {
    std::vector<FaceId> faces(3);
    for (std::uint32_t w = 3; w < kVertices; ++w) {
      const std::array<FaceId, 1> hole{f};
      const std::array<HalfedgeId, 3> boundary{halfedgeOf(f, 0), halfedgeOf(f, 1),
                                               halfedgeOf(f, 2)};
      graph.reserveFaces(1, 3);
      (void)graph.starHole(vertex(w), hole, boundary, faces);
      f = faces[w % 3];
    }
  });
  EXPECT_EQ(broken(graph), "");
  EXPECT_LT(counted, 60u);
}

TEST(FreeFaces, AreUsedAgainBeforeNewOnes) {
  Graph graph;
  makePair(graph, 1, 2);
  openEdge(graph, 3, halfedge(graph, 1, 2));
  const std::size_t slots = graph.faceSlots();
  for (int round = 0; round < 5; ++round) {
    replaceStar(graph, 3, linkOf(graph, vertex(3)), {});
    EXPECT_EQ(graph.faceCount(), slots - 2);
    ASSERT_EQ(broken(graph), "");
    openEdge(graph, 3, halfedge(graph, 0, 1));
    EXPECT_EQ(graph.faceSlots(), slots);
    EXPECT_EQ(graph.faceCount(), slots);
    ASSERT_EQ(broken(graph), "");
  }
}

TEST(FreeFaces, OfAHoleAreUsedInPlace) {
  Graph graph;
  const auto faces = makePair(graph, 1, 2);
  const Starred starred = splitFace(graph, 3, faces[0]);
  EXPECT_EQ(starred.faces[0], faces[0]);
  EXPECT_EQ(graph.faceSlots(), 4u);
}

TEST(FreeFaces, AreForgottenByClear) {
  Graph graph;
  makePair(graph, 1, 2);
  openEdge(graph, 3, halfedge(graph, 1, 2));
  replaceStar(graph, 3, linkOf(graph, vertex(3)), {});
  graph.clear();
  EXPECT_EQ(graph.faceSlots(), 0u);
  EXPECT_EQ(broken(graph), "");
}

}  // namespace
}  // namespace apollonius::test
