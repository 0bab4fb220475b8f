// Fully dynamic: after any history of insert, remove and update the graph is that of a fresh build
// of the surviving circles. On failure the shortened history is printed in the format of
// tests/data/regressions.
#include <gtest/gtest.h>

#include <numeric>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

TEST(History, ShortOnesOnTinyGrids) {
  Random random(221);
  for (int run = 0; run < runs(sized(8000, 20000)); ++run) {
    const int side = static_cast<int>(random.integer(1, 6));
    const int heaviest = random.below(5);
    const std::size_t poolSize = 6 + random.below(std::size_t{20});
    const Circles pool = tinyGrid(random, poolSize, side, heaviest);
    const std::size_t steps = 4 + random.below(std::size_t{24});
    const History history = randomHistory(random, pool, steps);
    Checks checks;
    checks.location = run % 2 == 0 ? Location::kHierarchy : Location::kWalk;
    checks.oracleUpTo = 7;
    ASSERT_EQ(failureOf(history, checks), "") << "run " << run;
  }
}

TEST(History, ShortOnesInLine) {
  Random random(227);
  for (int run = 0; run < runs(2000); ++run) {
    const int heaviest = random.below(4);
    const std::size_t poolSize = 5 + random.below(std::size_t{8});
    const Circles pool =
        run % 3 == 0 ? collinear(random, poolSize, Line::kRandomSlope, run % 2 == 0, heaviest)
                     : tangentLines(random, poolSize, run % 3, heaviest);
    Checks checks;
    checks.location = run % 2 == 0 ? Location::kHierarchy : Location::kWalk;
    checks.oracleUpTo = 7;
    ASSERT_EQ(failureOf(randomHistory(random, pool, 4 + random.below(std::size_t{20})), checks), "")
        << "run " << run;
  }
}

TEST(History, EveryStepComparedOnTinyGrids) {
  Random random(222);
  for (int run = 0; run < runs(1500); ++run) {
    const int side = static_cast<int>(random.integer(1, 5));
    const Circles pool = tinyGrid(random, 10, side, static_cast<int>(random.integer(0, 4)));
    Checks checks;
    checks.compareEveryStep = true;
    checks.oracleUpTo = 6;
    ASSERT_EQ(failureOf(randomHistory(random, pool, 20), checks), "") << "run " << run;
  }
}

TEST(History, LongOnesOnGrids) {
  Random random(223);
  for (int run = 0; run < runs(60); ++run) {
    const int side = static_cast<int>(random.integer(3, 20));
    const Circles pool = tinyGrid(random, 200, side, static_cast<int>(random.integer(0, side)));
    Checks checks;
    checks.location = run % 2 == 0 ? Location::kHierarchy : Location::kWalk;
    ASSERT_EQ(failureOf(randomHistory(random, pool, 250), checks), "") << "run " << run;
  }
}

TEST(History, NestedFamiliesEveryStepCompared) {
  Random random(230);
  for (int run = 0; run < runs(400); ++run) {
    const Circles pool = nestedFamilies(random, 4 + random.below(std::size_t{30}));
    Checks checks;
    checks.location = run % 2 == 0 ? Location::kHierarchy : Location::kWalk;
    checks.compareEveryStep = true;
    checks.oracleUpTo = 6;
    ASSERT_EQ(failureOf(randomHistory(random, pool, 60), checks), "") << "run " << run;
  }
}

class HistoryOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(HistoryOn, EndsInAFreshBuild) {
  Random random(224);
  for (int run = 0; run < runs(6); ++run) {
    const std::size_t n = GetParam().large ? 60 : 10;
    const Circles pool = GetParam().make(random, n);
    Checks checks;
    checks.location = run % 2 == 0 ? Location::kHierarchy : Location::kWalk;
    ASSERT_EQ(failureOf(randomHistory(random, pool, 2 * n), checks), "") << "run " << run;
  }
}

TEST_P(HistoryOn, RemovingAllInRandomOrder) {
  Random random(225);
  const Circles circles = GetParam().make(random, GetParam().large ? 80 : 12);
  History history = insertAll(circles);
  std::vector<std::size_t> order(circles.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  random.shuffle(order);
  for (const std::size_t k : order) history.push_back({Operation::Kind::kRemove, k, {}});
  // Down to nothing, and up again.
  for (std::size_t k = 0; k < circles.size() && k < 10; ++k)
    history.push_back({Operation::Kind::kInsert, 0, circles[k]});
  ASSERT_EQ(failureOf(history, {}), "");
}

TEST_P(HistoryOn, RemovingHalfInBulk) {
  Random random(226);
  const std::size_t n = GetParam().large ? 400 : 16;
  const Circles circles = GetParam().make(random, n);
  Diagram diagram;
  const std::vector<SiteId> ids = insertInto(diagram, circles);
  Circles rest;
  std::vector<SiteId> victims;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    if (random.oneIn(2)) {
      rest.push_back(circles[k]);
    } else {
      victims.push_back(ids[k]);
    }
  }
  std::size_t removed = 0;
  ASSERT_EQ(diagram.removeMany(victims, removed), Error::kNone);
  EXPECT_EQ(removed, victims.size());
  std::string broken;
  ASSERT_EQ(diagram.validate(broken), Error::kNone);
  ASSERT_EQ(broken, "");
  const Canonical got = canonicalForm(diagram, broken);
  ASSERT_EQ(broken, "");
  const Canonical expected = freshBuild(rest, Build::kBulk, Location::kHierarchy, broken);
  ASSERT_EQ(broken, "");
  ASSERT_TRUE(got == expected) << difference(expected, got);
}

INSTANTIATE_TEST_SUITE_P(Corpus, HistoryOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::test
