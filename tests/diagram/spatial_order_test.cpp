// The orders of bulk operations: permutations; a Hilbert curve; rounds of doubling size.
#include "diagram/spatial_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "support/random.h"

namespace apollonius::internal {
namespace {

std::vector<std::uint32_t> listed(const FlatArray<std::uint32_t>& order) {
  return {order.begin(), order.end()};
}
std::vector<std::uint32_t> hilbertOf(PointArray points) { return listed(hilbertOrder(points)); }

using test::Random;

bool isPermutation(std::vector<std::uint32_t> order) {
  std::sort(order.begin(), order.end());
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    if (order[k] != k) return false;
  }
  return true;
}

std::vector<double> randomPoints(Random& random, std::size_t n, std::size_t stride) {
  std::vector<double> values(n * stride);
  for (double& value : values) value = random.between(-1, 1);
  return values;
}

TEST(HilbertOrder, EachStepOnAFullGridIsToAnAdjacentCell) {
  for (int bits = 1; bits <= 6; ++bits) {
    const int side = 1 << bits;
    std::vector<double> values;
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) values.insert(values.end(), {3.0 * x - 7, 3.0 * y + 5});
    }
    const std::vector<std::uint32_t> order = hilbertOf({values, 2});
    ASSERT_TRUE(isPermutation(order));
    for (std::size_t k = 1; k < order.size(); ++k) {
      const double dx = values[2 * order[k]] - values[2 * order[k - 1]];
      const double dy = values[2 * order[k] + 1] - values[2 * order[k - 1] + 1];
      ASSERT_EQ(std::abs(dx) + std::abs(dy), 3) << side << " cells a side, step " << k;
    }
  }
}

TEST(HilbertOrder, ConsecutivePointsAreClose) {
  Random random(1);
  constexpr std::size_t kPoints = 10000;
  const std::vector<double> values = randomPoints(random, kPoints, 2);
  const std::vector<std::uint32_t> order = hilbertOf({values, 2});
  double length = 0;
  for (std::size_t k = 1; k < kPoints; ++k) {
    const double dx = values[2 * order[k]] - values[2 * order[k - 1]],
                 dy = values[2 * order[k] + 1] - values[2 * order[k - 1] + 1];
    length += std::sqrt(dx * dx + dy * dy);
  }
  // About √(area · n); the random order's length is about n.
  EXPECT_LT(length, 2 * std::sqrt(4.0 * kPoints));
}

TEST(HilbertOrder, AnOutlierLeavesTheOthersInTheirOrder) {
  Random random(5);
  constexpr std::uint32_t kPoints = 3000;
  std::vector<double> values = randomPoints(random, kPoints, 2);
  const std::vector<std::uint32_t> without = hilbertOf({values, 2});
  for (const double far : {1e6, 1e50, -1e99}) {
    std::vector<double> all = values;
    all.insert(all.end(), {far, far});
    std::vector<std::uint32_t> order = hilbertOf({all, 2});
    std::erase(order, kPoints);
    EXPECT_EQ(order, without) << far;
  }
}

/// Points that share a cell are ordered as they are alone: a line, and points of which an odd
/// number of digits differs, as the sort goes to and fro between two arrays.
TEST(HilbertOrder, LinesAndPairsBesideAnOutlierAreOrderedAsTheyAreAlone) {
  Random random(8);
  constexpr std::uint32_t kPoints = 40;
  for (int run = 0; run < 3000; ++run) {
    const double x = random.between(-1, 1),
                 places[] = {random.between(-1, 1), random.between(-1, 1)};
    std::vector<double> values;
    for (std::uint32_t k = 0; k < kPoints; ++k) {
      if (run % 10 == 0)
        values.insert(values.end(), {x, random.between(-1, 1)});
      else
        values.insert(values.end(), {k % 2 == 0 ? -1.0 : 1.0, places[k % 2]});
    }
    const std::vector<std::uint32_t> without = hilbertOf({values, 2});
    values.insert(values.end(), {1e9, 1e9});
    std::vector<std::uint32_t> order = hilbertOf({values, 2});
    std::erase(order, kPoints);
    ASSERT_EQ(order, without) << run;
  }
}

/// Towns of towns of towns …: each has its points together, in the order that it has alone.
TEST(HilbertOrder, ATownIsOrderedAsItIsAlone) {
  Random random(6);
  constexpr std::uint32_t kPoints = 500, kTowns = 20;
  std::vector<double> values;
  double scale = 1;
  for (std::uint32_t town = 0; town < kTowns; ++town, scale /= 1e9) {
    for (std::uint32_t k = 0; k < 2 * kPoints; ++k)
      values.push_back(scale * random.between(1, 1 + 1e-6));
  }
  const std::vector<std::uint32_t> order = hilbertOf({values, 2});
  ASSERT_TRUE(isPermutation(order));
  for (std::uint32_t town = 0; town < kTowns; ++town) {
    const auto isHere = [town](std::uint32_t k) { return k / kPoints == town; };
    const auto first = std::find_if(order.begin(), order.end(), isHere);
    ASSERT_TRUE(std::all_of(first, first + kPoints, isHere)) << town;
    std::vector<std::uint32_t> alone =
        hilbertOf({std::span(values).subspan(2 * std::size_t{town} * kPoints, 2 * kPoints), 2});
    for (std::uint32_t& k : alone) k += town * kPoints;
    EXPECT_TRUE(std::equal(alone.begin(), alone.end(), first)) << town;
  }
}

/// As many levels of cells as numbers allow, with more points on each than are left as they are.
TEST(HilbertOrder, EndsAtTheSmallestDifferences) {
  std::vector<double> values;
  double x = 1e100;
  for (; x > 1e-99; x = std::ldexp(x, -16)) {
    for (const double sign : {-1.0, 1.0}) values.insert(values.end(), {sign * x, x});
  }
  for (double last = x, k = 0; k < 20; ++k, last = std::nextafter(last, 1))
    values.insert(values.end(), {last, -x});
  EXPECT_TRUE(isPermutation(hilbertOf({values, 2})));
}

TEST(HilbertOrder, IsTheSameInSteps) {
  Random random(7);
  std::vector<double> values = randomPoints(random, 400, 2);
  for (int k = 0; k < 400; ++k) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.integer(-100, 100)));
    const double place = scale * random.between(-1, 1);
    values.insert(values.end(), {place, random.oneIn(3) ? place : scale});
  }
  const std::vector<std::uint32_t> expected = hilbertOf({values, 2});
  for (const std::size_t most : {std::size_t{1}, std::size_t{7}, std::size_t{500}}) {
    HilbertSort sort({values, 2});
    while (!sort.advance(most)) {
    }
    EXPECT_TRUE(sort.advance(most)) << "sorted already";
    EXPECT_EQ(listed(sort.order()), expected) << most;
  }
}

TEST(HilbertOrder, ReadsWithAStride) {
  Random random(2);
  const std::vector<double> triples = randomPoints(random, 100, 3);
  std::vector<double> pairs;
  for (std::size_t k = 0; k < 100; ++k)
    pairs.insert(pairs.end(), {triples[3 * k], triples[3 * k + 1]});
  EXPECT_EQ(hilbertOf({triples, 3}), hilbertOf({pairs, 2}));
}

TEST(SpatialOrder, DegenerateInput) {
  const std::vector<std::vector<double>> inputs{
      {},
      {4, 5},
      {1, 1, 1, 1, 1, 1},                               // one place
      {0, 3, 0, 1, 0, 2, 0, 4},                         // a vertical line
      {-1e100, -1e100, 1e100, 1e100, 0, 0, 1e-100, 0},  // both ends of the range
      {1e-100, 1e-100, 2e-100, 3e-100, 0, 0},
      {1, 1, std::nextafter(1, 2), 1},
  };
  for (const std::vector<double>& values : inputs) {
    EXPECT_TRUE(isPermutation(hilbertOf({values, 2})));
    EXPECT_EQ(hilbertOf({values, 2}).size(), values.size() / 2);
  }
}

TEST(HilbertOrder, TiesKeepTheOrderOfTheInput) {
  const std::vector<double> values(20, 1.0);
  std::vector<std::uint32_t> expected(10);
  for (std::uint32_t k = 0; k < 10; ++k) expected[k] = k;
  EXPECT_EQ(hilbertOf({values, 2}), expected);
}

TEST(HilbertOrder, ManyPointsAreOrderedAsFew) {
  // From 33 points on a radix sort orders them; a subset that spans the same box must keep its
  // order.
  Random random(4);
  std::vector<double> values = randomPoints(random, 5000, 2);
  for (const double corner : {-1.0, -1.0, 1.0, 1.0}) values.push_back(corner);
  std::vector<std::uint32_t> few;
  for (const std::uint32_t k : hilbertOf({values, 2})) {
    if (k >= 4800) few.push_back(k - 4800);
  }
  EXPECT_EQ(few, hilbertOf({std::span(values).subspan(2 * 4800), 2}));
}

TEST(RandomizedRounds, HaveGrowingSizes) {
  const auto roundsOf = [](std::size_t n) {
    std::vector<std::uint32_t> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return listed(brioOrder(numbers));
  };
  for (const std::size_t n : {0u, 1u, 2u, 3u, 10u}) EXPECT_TRUE(isPermutation(roundsOf(n))) << n;
  struct Case {
    std::size_t numbers;
    double growth;        ///< factor by which a round raises the number of sites
    std::size_t checked;  ///< rounds, from the last on; earlier ones are small
  };
  for (const auto& [numbers, growth, checked] : {Case{8000, 2, 5}, Case{1 << 16, 8, 3}}) {
    const std::vector<std::uint32_t> order = roundsOf(numbers);
    ASSERT_TRUE(isPermutation(order));
    // In a round numbers rise; where they fall, another begins.
    std::vector<double> rounds{1};
    for (std::size_t k = 1; k < numbers; ++k) {
      if (order[k] < order[k - 1]) rounds.push_back(0);
      ++rounds.back();
    }
    ASSERT_LE(rounds.size(), 18u);
    double left = static_cast<double>(numbers);
    for (std::size_t k = 0; k < checked; ++k) {
      const double expected = left * (1 - 1 / growth);
      EXPECT_NEAR(rounds[rounds.size() - 1 - k], expected, 0.2 * expected) << "round " << k;
      left -= expected;
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
