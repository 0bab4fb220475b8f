// Diagrams of small sets against the brute-force oracle: visible sites and Voronoi vertices must be
// the same, in degenerate position too.
#include <gtest/gtest.h>

#include "support/canonical.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

void expectOraclesDiagram(const Circles& circles, Location location) {
  const Canonical expected = canonicalByOracle(circles);
  for (const Build build : {Build::kOneByOne, Build::kBulk}) {
    std::string broken;
    const Canonical got = freshBuild(circles, build, location, broken);
    ASSERT_EQ(broken, "") << toText(insertAll(circles));
    ASSERT_TRUE(got == expected) << difference(expected, got) << toText(insertAll(circles));
  }
}

TEST(DiagramAndOracle, AgreeOnTinyGrids) {
  Random random(201);
  for (int run = 0; run < runs(sized(12000, 30000)); ++run) {
    const int side = static_cast<int>(random.integer(1, 6));
    const int heaviest = static_cast<int>(random.integer(0, 4));
    const std::size_t n = random.below(std::size_t{9});
    const Circles circles = tinyGrid(random, n, side, heaviest);
    expectOraclesDiagram(circles, run % 2 == 0 ? Location::kHierarchy : Location::kWalk);
    if (HasFatalFailure()) FAIL() << "run " << run;
  }
}

TEST(DiagramAndOracle, AgreeOnAllTriplesOfATinyGrid) {
  // 27 circles with coordinates and radii in 0..2: all sets of up to three.
  Circles grid;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int r = 0; r < 3; ++r) grid.push_back({x * 1.0, y * 1.0, r * 1.0});
    }
  }
  expectOraclesDiagram({}, Location::kHierarchy);
  for (std::size_t a = 0; a < grid.size(); ++a) {
    expectOraclesDiagram({grid[a]}, Location::kHierarchy);
    for (std::size_t b = a; b < grid.size(); ++b) {
      expectOraclesDiagram({grid[a], grid[b]}, Location::kHierarchy);
      for (std::size_t c = b; c < grid.size(); ++c) {
        expectOraclesDiagram({grid[a], grid[b], grid[c]}, Location::kHierarchy);
        if (HasFatalFailure()) return;
      }
    }
  }
}

class DiagramAndOracleOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(DiagramAndOracleOn, Agree) {
  Random random(202);
  const int count = runs(GetParam().large ? 150 : 15);
  for (int run = 0; run < count; ++run) {
    const std::size_t n = 2 + random.below(GetParam().large ? std::size_t{9} : std::size_t{5});
    expectOraclesDiagram(GetParam().make(random, n),
                         run % 2 == 0 ? Location::kHierarchy : Location::kWalk);
    if (HasFatalFailure()) FAIL() << "run " << run;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, DiagramAndOracleOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::test
