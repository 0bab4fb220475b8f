// Reserved room is never allocated again: so an operation can be undone where memory ran out.
#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "delaunay/ears.h"
#include "delaunay/moves.h"
#include "delaunay/remove.h"
#include "support/allocation_count.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

VertexId vertex(std::size_t k) { return VertexId{static_cast<std::uint32_t>(k + 1)}; }

/// A site, and others around it on a circle, with different weights.
DelaunayGraph wheel(std::size_t spokes) {
  DelaunayGraph graph;
  graph.reserve(spokes + 2);
  graph.setSite(vertex(0), {0, 0, 0});
  graph.insert(vertex(0), kNoVertex);
  for (std::size_t k = 0; k < spokes; ++k) {
    // Once around, by tangents of half angles.
    const double t = (static_cast<double>(k) + 0.5) / static_cast<double>(spokes) * 4 - 2;
    const double half = t < -1 ? -1 / (t + 2) : t > 1 ? -1 / (t - 2) : t, norm = 1 + half * half;
    graph.setSite(vertex(k + 1), {(1 - half * half) / norm, 2 * half / norm, 1e-6 * t});
    graph.insert(vertex(k + 1), kNoVertex);
  }
  return graph;
}

TEST(Room, EarsOfAnyHoleThatTheyFillAllocateNothing) {
  const DelaunayGraph graph = wheel(EarClipper::kMostCorners);
  std::vector<HalfedgeId> link;
  for (const HalfedgeId h : graph.graph().star(vertex(0))) link.push_back(next(h));
  ASSERT_EQ(link.size(), EarClipper::kMostCorners);
  EarClipper ears;
  ears.reserve();
  const std::size_t before = allocationCount;
  ASSERT_TRUE(ears.fill(graph, vertex(0), link));
  EXPECT_EQ(allocationCount, before);
}

/// However many neighbours it has: when these came, they took little room each.
TEST(Room, ASiteThatMayReturnReturnsWithoutAllocating) {
  DelaunayGraph graph = wheel(150);
  Remover remover;
  (void)remover.remove(graph, vertex(0), {}, true);
  const std::size_t before = allocationCount;
  graph.insert(vertex(0), kNoVertex);
  EXPECT_EQ(allocationCount, before);
  EXPECT_EQ(graph.visibleCount(), 151u);
}

TEST(Room, MovesThatFlipEdgesAllocateNothingOnceTheyHaveRoom) {
  test::Random random(61);
  DelaunayGraph graph;
  graph.reserve(401);
  std::vector<SiteMoves::Move> moves(400);
  for (std::size_t k = 0; k < moves.size(); ++k) {
    graph.setSite(vertex(k), {random.between(0, 20), random.between(0, 20), 0});
    graph.insert(vertex(k), kNoVertex);
  }
  SiteMoves siteMoves;
  int framesWithFlips = 0;
  for (int frame = 0; frame < 5; ++frame) {
    for (std::size_t k = 0; k < moves.size(); ++k) {
      const Site& site = graph.site(vertex(k));
      const double x = random.between(-0.01, 0.01), y = random.between(-0.01, 0.01);
      moves[k] = {vertex(k), {site.x + x, site.y + y, 0}};
    }
    const std::size_t before = allocationCount;
    (void)siteMoves.apply(graph, moves, Flips::kMaybe);
    if (frame > 0) {
      EXPECT_EQ(allocationCount, before);
    }
    framesWithFlips += static_cast<int>(siteMoves.hasFlipped());
  }
  EXPECT_EQ(framesWithFlips, 5);
}

}  // namespace
}  // namespace apollonius::internal
