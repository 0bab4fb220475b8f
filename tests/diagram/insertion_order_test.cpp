// The diagram is a function of the set of sites: every order of insertion ends in the same graph,
// bulk insertion too.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/canonical.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

Canonical buildInOrder(const Circles& circles, const std::vector<std::size_t>& order,
                       Location location, std::string& broken) {
  Circles ordered;
  for (const std::size_t k : order) ordered.push_back(circles[k]);
  return freshBuild(ordered, Build::kOneByOne, location, broken);
}

TEST(InsertionOrder, AllOrdersOfTinySetsGiveTheSameGraph) {
  Random random(211);
  for (int run = 0; run < runs(sized(500, 4000)); ++run) {
    const int side = static_cast<int>(random.integer(1, 5));
    const int heaviest = random.below(4);
    const std::size_t n = 3 + random.below(std::size_t{3});
    const Circles circles = tinyGrid(random, n, side, heaviest);
    const Location location = run % 2 == 0 ? Location::kHierarchy : Location::kWalk;
    std::string broken;
    const Canonical expected = freshBuild(circles, Build::kBulk, location, broken);
    ASSERT_EQ(broken, "") << toText(insertAll(circles));
    std::vector<std::size_t> order(circles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
      const Canonical got = buildInOrder(circles, order, location, broken);
      Circles ordered;
      for (const std::size_t k : order) ordered.push_back(circles[k]);
      ASSERT_EQ(broken, "") << toText(insertAll(ordered));
      ASSERT_TRUE(got == expected) << "run " << run << "\n"
                                   << difference(expected, got) << toText(insertAll(ordered));
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

/// Sites in line and under common tangents, where zeros of vertex conflict involve infinity: the
/// oracle's graph in every order.
TEST(InsertionOrder, AllOrdersOfTinySetsInLineGiveTheOraclesGraph) {
  Random random(214);
  for (int run = 0; run < runs(300); ++run) {
    const std::size_t n = 3 + random.below(std::size_t{3});
    const int heaviest = random.below(4);
    const Circles circles = run % 3 == 0
                                ? collinear(random, n, Line::kRandomSlope, run % 2 == 0, heaviest)
                                : tangentLines(random, n, run % 3, heaviest);
    const Canonical expected = canonicalByOracle(circles);
    std::vector<std::size_t> order(circles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
      std::string broken;
      const Canonical got = buildInOrder(
          circles, order, run % 2 == 0 ? Location::kHierarchy : Location::kWalk, broken);
      Circles ordered;
      for (const std::size_t k : order) ordered.push_back(circles[k]);
      ASSERT_EQ(broken, "") << toText(insertAll(ordered));
      ASSERT_TRUE(got == expected) << "run " << run << "\n"
                                   << difference(expected, got) << toText(insertAll(ordered));
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(InsertionOrder, RandomOrdersOfLargerGridsGiveTheSameGraph) {
  Random random(212);
  for (int run = 0; run < runs(sized(600, 1500)); ++run) {
    const int side = static_cast<int>(random.integer(2, 12));
    const int heaviest = random.below(side + 1);
    const std::size_t n = 8 + random.below(std::size_t{60});
    Circles circles = tinyGrid(random, n, side, heaviest);
    std::string broken;
    const Canonical expected = freshBuild(circles, Build::kBulk, Location::kHierarchy, broken);
    ASSERT_EQ(broken, "") << toText(insertAll(circles));
    for (int order = 0; order < 3; ++order) {
      random.shuffle(circles);
      const Canonical got = freshBuild(circles, Build::kOneByOne,
                                       order == 0 ? Location::kWalk : Location::kHierarchy, broken);
      ASSERT_EQ(broken, "") << toText(insertAll(circles));
      ASSERT_TRUE(got == expected) << "run " << run << "\n"
                                   << difference(expected, got) << toText(insertAll(circles));
    }
  }
}

class InsertionOrderOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(InsertionOrderOn, RandomOrdersAndBulkGiveTheSameGraph) {
  Random random(213);
  const std::size_t n = GetParam().large ? 300 : 20;
  Circles circles = GetParam().make(random, n);
  std::string broken;
  const Canonical expected = freshBuild(circles, Build::kBulk, Location::kHierarchy, broken);
  ASSERT_EQ(broken, "");
  for (int order = 0; order < 4; ++order) {
    random.shuffle(circles);
    if (order == 3) std::sort(circles.begin(), circles.end(), oracleSmaller);
    const Canonical got = freshBuild(circles, Build::kOneByOne,
                                     order == 0 ? Location::kWalk : Location::kHierarchy, broken);
    ASSERT_EQ(broken, "") << "order " << order;
    ASSERT_TRUE(got == expected) << "order " << order << "\n" << difference(expected, got);
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, InsertionOrderOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::test
