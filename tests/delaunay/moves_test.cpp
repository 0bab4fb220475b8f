// Moves that flip edges (delaunay/moves.h): counted, and the graph that they leave.
#include "delaunay/moves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;
using test::runs;

VertexId vertex(std::size_t k) { return VertexId{static_cast<std::uint32_t>(k + 1)}; }

/// Points at mean distance 1, of which `graph` is the diagram.
class Crowd {
 public:
  Crowd(Random& random, std::size_t n) : random_(random) {
    const double side = std::sqrt(static_cast<double>(n));
    graph.reserve(n + 1);
    for (std::size_t k = 0; k < n; ++k) {
      graph.setSite(vertex(k), {random.between(0, side), random.between(0, side), 0});
      graph.insert(vertex(k), kNoVertex);
    }
  }

  /// All of them, by up to this much each; how many were made.
  std::size_t move(double step, Flips flips,
                   std::size_t mostLeft = std::numeric_limits<std::size_t>::max()) {
    moves_.clear();
    moves_.reserve(graph.visibleCount());
    for (std::size_t k = 0; k < graph.visibleCount(); ++k) {
      const Site& site = graph.site(vertex(k));
      const double x = random_.between(-step, step), y = random_.between(-step, step);
      moves_.push_back({vertex(k), {site.x + x, site.y + y, 0}});
    }
    std::size_t made = 0;
    for (const std::uint8_t isMade : siteMoves.apply(graph, moves_, flips, mostLeft))
      made += isMade;
    return made;
  }

  [[nodiscard]] const char* check() const {
    std::uint32_t where = 0;
    return graph.check(where);
  }

  DelaunayGraph graph;
  SiteMoves siteMoves;

 private:
  Random& random_;
  std::vector<SiteMoves::Move> moves_;
};

TEST(SiteMoves, FlipWhereAFewEdgesChange) {
  Random random(41);
  const auto n = static_cast<std::size_t>(runs(1000));
  Crowd crowd(random, n);
  for (int frame = 0; frame < 5; ++frame) {
    const std::size_t made = crowd.move(0.01, Flips::kMaybe, n / 48);
    EXPECT_TRUE(crowd.siteMoves.hasFlipped());
    EXPECT_GE(made + n / 48, n);
    ASSERT_EQ(crowd.check(), nullptr) << "frame " << frame;
  }
}

TEST(SiteMoves, AreNotTriedWhereMostEdgesChange) {
  Random random(42);
  const auto n = static_cast<std::size_t>(runs(1000));
  Crowd crowd(random, n);
  EXPECT_EQ(crowd.move(5, Flips::kMaybe, n / 48), 0u);
  EXPECT_FALSE(crowd.siteMoves.hasFlipped());
  EXPECT_EQ(crowd.check(), nullptr);
}

TEST(SiteMoves, DoNotFlipUnlessTheyMay) {
  Random random(43);
  const auto n = static_cast<std::size_t>(runs(1000));
  Crowd crowd(random, n);
  EXPECT_LT(crowd.move(0.01, Flips::kNone), n);
  EXPECT_FALSE(crowd.siteMoves.hasFlipped());
  EXPECT_EQ(crowd.check(), nullptr);
}

/// Whatever moves are given up, a diagram is left. Steps are of all sizes; the largest ones are so
/// large that a diagram is better rebuilt.
TEST(SiteMoves, LeaveADiagramAfterStepsOfAnySize) {
  Random random(44);
  for (int run = 0; run < runs(20); ++run) {
    Crowd crowd(random, 20 + random.below(std::size_t{200}));
    for (const double step : {0.0001, 0.01, 0.03, 0.1, 0.3, 1.0}) {
      (void)crowd.move(step, Flips::kMaybe);
      ASSERT_EQ(crowd.check(), nullptr) << "run " << run << ", step " << step;
    }
  }
}

TEST(SiteMoves, FlipsAreTakenBackToTheSameHalfedges) {
  Random random(45);
  const auto n = static_cast<std::size_t>(runs(1000));
  Crowd crowd(random, n);
  const Graph before = crowd.graph.graph();
  (void)crowd.move(0.02, Flips::kMaybe);
  ASSERT_TRUE(crowd.siteMoves.hasFlipped());
  Graph after = crowd.graph.graph();
  crowd.siteMoves.takeFlipsBack(after);
  ASSERT_EQ(after.faceSlots(), before.faceSlots());
  for (std::uint32_t h = 0; h < 3 * before.faceSlots(); ++h) {
    ASSERT_EQ(after.origin(HalfedgeId{h}), before.origin(HalfedgeId{h}));
    ASSERT_EQ(after.twin(HalfedgeId{h}), before.twin(HalfedgeId{h}));
  }
}

}  // namespace
}  // namespace apollonius::internal
