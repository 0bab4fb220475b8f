// All sites at once: each kind of move of a whole set, there and back, and batches that insert or
// remove most of it. After each step everything is checked: the graph, the levels of the hierarchy,
// the hidden ones, and finds. (Levels that follow moves one by one, a state in the middle that is
// no diagram: nothing else in the tests moves thousands of sites with two levels over them.)
#include <gtest/gtest.h>

#include <algorithm>
#include <initializer_list>
#include <numeric>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/whole_set.h"

namespace apollonius::test {
namespace {

struct Set {
  const char* generator;
  std::size_t n;
  bool isLong = false;  ///< for thorough runs only
};

void PrintTo(const Set& set, std::ostream* out) { *out << set.generator << " " << set.n; }

std::string nameOf(const ::testing::TestParamInfo<Set>& info) {
  return info.param.generator + std::to_string(info.param.n);
}

class WholeSets : public ::testing::TestWithParam<Set> {
 protected:
  void SetUp() override {
    if (GetParam().isLong && !isThorough()) GTEST_SKIP() << "set APOLLONIUS_THOROUGH=1 to run it";
    for (const NamedGenerator& generator : corpus()) {
      if (generator.name == GetParam().generator) circles = generator.make(random, GetParam().n);
    }
    ASSERT_FALSE(circles.empty());
  }

  Random random{421};
  Circles circles;
};

/// There, on from there by another move, and back to the beginning.
TEST_P(WholeSets, MoveThereAndBack) {
  const Way ways[] = {Way::kTogether, Way::kOneByOne, Way::kInParts, Way::kRestored};
  const std::vector<WholeMove>& moves = wholeMoves();
  const bool isSmall = GetParam().n <= 40;
  // Else some of the moves for each set, others for others.
  const std::size_t stride = isThorough() ? 1 : kEffortDivisor * (isSmall ? 4 : 6);
  for (int round = 0; round < (isThorough() && isSmall ? 5 : 1); ++round) {
    for (std::size_t k = circles.size() % stride; k < moves.size(); k += stride) {
      WholeSet set(circles);
      const WholeMove &first = moves[k], &second = moves[random.below(moves.size())];
      const auto step = [&](const Circles& next, const char* name) {
        // Moving all together is the most at risk, most of all for large sets.
        const Way way = !isSmall && random.oneIn(2) ? Way::kTogether : ways[random.below(4)];
        std::string wrong = set.moveTo(next, way, random);
        if (wrong.empty()) wrong = set.check(random);
        if (wrong.empty()) return true;
        ADD_FAILURE() << first.name << ", " << second.name << ": at " << name << ", way "
                      << static_cast<int>(way) << ": " << wrong;
        return false;
      };
      if (!step(first.make(circles, random), "the first move")) break;
      if (isSmall && !step(second.make(set.circles(), random), "the second move")) break;
      if (!step(circles, "the way back")) break;
    }
  }
}

/// Discs that grow until they overlap, all at once.
TEST(WholeSetsOfPoints, GrowAtOnce) {
  for (const std::size_t n : {1000u, 2100u}) {  // one level and two
    Random random(422);
    Circles points(n);
    for (Circle& c : points) c = {random.unit(), random.unit(), 0};
    WholeSet set(points);
    Circles next = points;
    for (const double r : {0.5, 0.001, 0.02, 0.0}) {
      for (Circle& c : next) c.r = r;
      ASSERT_EQ(set.moveTo(next, Way::kTogether, random), "");
      std::string broken;
      ASSERT_EQ(set.diagram().validate(broken), Error::kNone);
      ASSERT_EQ(broken, "") << n << " sites, r = " << r;
    }
    ASSERT_EQ(set.check(random), "");
  }
}

TEST_P(WholeSets, BatchesThatInsertAndRemoveMostOfThem) {
  const std::size_t n = circles.size();
  const auto half = circles.begin() + static_cast<std::ptrdiff_t>(n / 2);
  WholeSet set(Circles(circles.begin(), half));
  const auto expectRight = [&](std::string wrong, const char* step) {
    if (wrong.empty()) wrong = set.check(random);
    EXPECT_EQ(wrong, "") << step;
  };
  const auto some = [&](std::size_t count) {
    std::vector<std::size_t> positions(set.circles().size());
    std::iota(positions.begin(), positions.end(), std::size_t{0});
    random.shuffle(positions);
    positions.resize(std::min(count, positions.size()));
    return positions;
  };
  expectRight(set.insert(Circles(half, circles.end())), "the other half");
  expectRight(set.remove(some(n / 2)), "less by half");
  expectRight(set.insert(circles), "a set more");
  expectRight(set.restore(), "restored");
  expectRight(set.remove(some(n)), "less by a set");
  expectRight(set.insert(Circles(circles.begin(), half)), "half a set more");
  expectRight(set.remove(some(set.circles().size() - 1)), "but one");
  expectRight(set.insert(circles), "a set beside the one");
  expectRight(set.remove(some(set.circles().size())), "all");
  expectRight(set.insert(circles), "a set again");
  const Circles before = set.circles();
  // Prefixes of a batch, each on this diagram.
  for (const std::size_t prefix : {std::size_t{1}, n / 3, n - 1}) {
    WholeSet copy(before);
    std::vector<std::size_t> positions(std::min(prefix, n));
    std::iota(positions.begin(), positions.end(), std::size_t{0});
    std::string wrong = copy.remove(positions);
    if (wrong.empty()) wrong = copy.check(random);
    EXPECT_EQ(wrong, "") << "prefix of " << prefix;
  }
}

const char* const kKinds[] = {
    "Points",         "Hidden20Percent", "Hidden95Percent", "PowerLaw",      "Grid6Radius3",
    "Grid20Radius10", "IntegerLattice",  "TangentOutside",  "TangentInside", "Concentric",
    "CommonTangent",  "GiantDiskExact",  "GiantDisk",       "EqualRadii",    "DiagonalLine",
    "OneUlpApart",    "NestedClusters",  "CocircularPoints"};

std::vector<Set> all(std::size_t n) {
  std::vector<Set> sets;
  for (const char* kind : kKinds) sets.push_back({kind, n});
  return sets;
}

std::vector<Set> forThoroughRuns(std::initializer_list<Set> sets) {
  std::vector<Set> result(sets);
  for (Set& set : result) set.isLong = true;
  return result;
}

INSTANTIATE_TEST_SUITE_P(Small, WholeSets, ::testing::ValuesIn(all(40)), nameOf);
INSTANTIATE_TEST_SUITE_P(OneLevel, WholeSets,
                         ::testing::Values(Set{"Points", 300}, Set{"Hidden50Percent", 300},
                                           Set{"IntegerLattice", 300}),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(OneLevelMore, WholeSets,
                         ::testing::ValuesIn(forThoroughRuns({{"TangentOutside", 300},
                                                              {"Hidden95Percent", 300},
                                                              {"Grid20Radius10", 300},
                                                              {"PowerLaw", 300}})),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(TwoLevels, WholeSets,
                         ::testing::ValuesIn(forThoroughRuns({{"Points", 2000},
                                                              {"Hidden50Percent", 2000},
                                                              {"Hidden95Percent", 3000},
                                                              {"IntegerLattice", 1500},
                                                              {"Grid20Radius10", 1500},
                                                              {"TangentOutside", 1500},
                                                              {"PowerLaw", 2000},
                                                              {"GiantDisk", 1500},
                                                              {"CommonTangent", 1500}})),
                         nameOf);
INSTANTIATE_TEST_SUITE_P(ThreeLevels, WholeSets,
                         ::testing::ValuesIn(forThoroughRuns({{"Points", 36000},
                                                              {"Hidden20Percent", 36000},
                                                              {"Hidden95Percent", 20000},
                                                              {"IntegerLattice", 20000},
                                                              {"GiantDisk", 20000}})),
                         nameOf);

}  // namespace
}  // namespace apollonius::test
