// The oracle checked against itself and against cases that can be drawn by hand: it is what
// everything else is measured with.
#include "support/oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "support/operations.h"

namespace apollonius::test {
namespace {

/// Euler's formula for the dual triangulation with its vertex at infinity, and every directed edge
/// as often as its twin.
void expectClosedSurface(const Circles& circles, const OracleDiagram& diagram) {
  std::size_t visible = 0;
  for (const bool flag : diagram.visible) visible += flag;
  std::vector<Triple> unbounded;
  for (const auto& [i, j] : diagram.unboundedEdges) unbounded.push_back({kInfinity, i, j});
  std::vector<Triple> withInfinity = diagram.triples;
  withInfinity.erase(std::remove_if(withInfinity.begin(), withInfinity.end(),
                                    [](const Triple& t) { return t[0] != kInfinity; }),
                     withInfinity.end());
  EXPECT_EQ(withInfinity, unbounded) << toText(insertAll(circles));
  const std::size_t expected = visible < 2 ? 0 : 2 * visible - 2;
  EXPECT_EQ(diagram.triples.size(), expected) << toText(insertAll(circles));
  std::map<std::pair<int, int>, int> excess;
  for (const Triple& t : diagram.triples) {
    for (int side = 0; side < 3; ++side) {
      ++excess[{t[side], t[(side + 1) % 3]}];
      --excess[{t[(side + 1) % 3], t[side]}];
    }
  }
  for (const auto& [edge, count] : excess) {
    EXPECT_EQ(count, 0) << "edge " << edge.first << " " << edge.second << "\n"
                        << toText(insertAll(circles));
  }
}

TEST(Oracle, ClosedSurfaceOnTinyGrids) {
  Random random(1);
  for (int run = 0; run < 600; ++run) {
    const int side = static_cast<int>(random.integer(1, 5));
    const int heaviest = random.below(4);
    const std::size_t n = random.below(std::size_t{8});
    const Circles circles = tinyGrid(random, n, side, heaviest);
    expectClosedSurface(circles, oracleDiagram(circles));
    if (HasFailure()) return;
  }
}

TEST(Oracle, ClosedSurfaceOnEveryGenerator) {
  Random random(2);
  for (int run = 0; run < 8; ++run) {
    for (const Circles& circles :
         {randomCircles(random, 9, Hidden::k20Percent), powerLaw(random, 9), giantDisk(random, 8),
          lattice(random, 3, 3, 0.1, 1), equalRadii(random, 9), tangentOutside(random, 9),
          tangentInside(random, 9), concentric(random, 9),
          collinear(random, 8, Line::kRandomSlope, run % 2 == 0, run % 3),
          cocircularPoints(random, 8), commonTangent(random, 8, 20), giantDiskExact(random, 8),
          rangeEnds(random, 6, Range::kHuge), rangeEnds(random, 6, Range::kTiny),
          rangeEnds(random, 5, Range::kMixed), oneUlpApart(random, 8)}) {
      expectClosedSurface(circles, oracleDiagram(circles));
      if (HasFailure()) return;
    }
  }
}

TEST(Oracle, PerturbationIsSmallEnough) {
  // All weights perturbed from the start and by other amounts: the same diagram.
  Random random(3);
  for (int run = 0; run < 60; ++run) {
    const int side = 1 + random.below(4);
    const Circles circles = tinyGrid(random, 6, side, random.below(3));
    EXPECT_EQ(oracleDiagram(circles).triples, oracleDiagram(circles, Perturb::kEverything).triples)
        << toText(insertAll(circles));
    const Circles lines = tangentLines(random, 5, 1 + run % 2, run % 3);
    EXPECT_EQ(oracleDiagram(lines).triples, oracleDiagram(lines, Perturb::kEverything).triples)
        << toText(insertAll(lines));
  }
}

TEST(Oracle, NoneOneAndTwoSites) {
  EXPECT_TRUE(oracleDiagram({}).triples.empty());
  EXPECT_TRUE(oracleDiagram({{1, 2, 3}}).triples.empty());
  const std::vector<Triple> two{{kInfinity, 0, 1}, {kInfinity, 1, 0}};
  EXPECT_EQ(oracleDiagram({{0, 0, 1}, {5, 0, 2}}).triples, two);
}

TEST(Oracle, Triangle) {
  const OracleDiagram diagram = oracleDiagram({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}});
  const std::vector<Triple> expected{
      {kInfinity, 0, 2}, {kInfinity, 1, 0}, {kInfinity, 2, 1}, {0, 1, 2}};
  EXPECT_EQ(diagram.triples, expected);
}

TEST(Oracle, SmallCircleBetweenTwoLargeOnesHasTwoVerticesWithThem) {
  // The bisector of the large circles is cut open by the small one: both orientations of the triple
  // occur.
  const OracleDiagram diagram = oracleDiagram({{-10, 0, 5}, {10, 0, 5}, {0, 0, 1}});
  const std::vector<Triple> expected{{kInfinity, 0, 1}, {kInfinity, 1, 0}, {0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(diagram.triples, expected);
}

TEST(Oracle, SmallCircleAtARimHasDegreeTwo) {
  const OracleDiagram diagram = oracleDiagram({{0, 0, 10}, {10, 0, 1}, {30, 0, 1}});
  // Circle 1 sticks out of circle 0 only towards circle 2 and is a lens between the two.
  const std::vector<Triple> expected{{kInfinity, 0, 2}, {kInfinity, 2, 0}, {0, 1, 2}, {0, 2, 1}};
  EXPECT_EQ(diagram.triples, expected);
}

TEST(Oracle, SquareIsSplitByTheLargestSite) {
  // Four cocircular points: the diagonal that ends in the largest by x, then y, which is (1, 1), is
  // an edge.
  const OracleDiagram diagram = oracleDiagram({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const std::vector<Triple> expected{{kInfinity, 0, 3}, {kInfinity, 1, 0}, {kInfinity, 2, 1},
                                     {kInfinity, 3, 2}, {0, 1, 2},         {0, 2, 3}};
  EXPECT_EQ(diagram.triples, expected);
}

TEST(Oracle, AllThatTouchTheHullAreOnIt) {
  // Points in line, out of order: there and back.
  const std::vector<Triple> there{
      {kInfinity, 0, 2}, {kInfinity, 1, 2}, {kInfinity, 2, 0}, {kInfinity, 2, 1}};
  EXPECT_EQ(oracleDiagram({{0, 0, 0}, {5, 0, 0}, {2, 0, 0}}).triples, there);
  // Three circles touch a line from above; the middle one is as high as the others together are
  // not.
  const OracleDiagram diagram = oracleDiagram({{0, 1, 1}, {20, 1, 1}, {10, 5, 5}});
  const std::vector<Triple> expected{
      {kInfinity, 0, 2}, {kInfinity, 1, 2}, {kInfinity, 2, 0}, {kInfinity, 2, 1}};
  EXPECT_EQ(diagram.triples, expected);
}

TEST(Oracle, Visibility) {
  // Contained, internally tangent, identical twice, overlapping.
  const OracleDiagram diagram =
      oracleDiagram({{0, 0, 5}, {1, 0, 1}, {3, 0, 2}, {4, 0, 2}, {4, 0, 2}});
  EXPECT_EQ(diagram.visible, (std::vector<bool>{true, false, false, true, false}));
}

TEST(Oracle, NearestSite) {
  const Circles circles{{0, 0, 1}, {10, 0, 3}, {5, 8, 0}};
  EXPECT_EQ(oracleNearest(circles, 0, 0), 0);
  EXPECT_EQ(oracleNearest(circles, 4.5, 0), 1);
  EXPECT_EQ(oracleNearest(circles, 4, 0), 1) << "a tie goes to the larger weight";
  EXPECT_EQ(oracleNearest(circles, 5, 8), 2);
  EXPECT_EQ(oracleNearest({{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, 0, 0), 0)
      << "a tie goes to the larger x";
  EXPECT_EQ(oracleNearest({}, 0, 0), -1);
}

}  // namespace
}  // namespace apollonius::test
