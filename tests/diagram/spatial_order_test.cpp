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
  // From 513 points on a radix sort orders them; a subset that spans the same box must keep its
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

TEST(RandomizedRounds, HaveDoublingSizes) {
  const auto roundsOf = [](std::size_t n) {
    std::vector<std::uint32_t> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return listed(brioOrder(numbers));
  };
  for (const std::size_t n : {0u, 1u, 2u, 3u, 10u}) EXPECT_TRUE(isPermutation(roundsOf(n))) << n;
  constexpr std::size_t kNumbers = 1 << 14;
  const std::vector<std::uint32_t> order = roundsOf(kNumbers);
  ASSERT_TRUE(isPermutation(order));
  // In a round numbers rise; where they fall, another begins.
  std::vector<std::size_t> rounds{1};
  for (std::size_t k = 1; k < kNumbers; ++k) {
    if (order[k] < order[k - 1]) rounds.push_back(0);
    ++rounds.back();
  }
  EXPECT_LE(rounds.size(), 18u);
  for (std::size_t k = rounds.size(); k-- > rounds.size() - 5;) {
    const double expected = std::ldexp(kNumbers, -static_cast<int>(rounds.size() - k));
    EXPECT_NEAR(static_cast<double>(rounds[k]), expected, 0.2 * expected) << "round " << k;
  }
}

}  // namespace
}  // namespace apollonius::internal
