// FlatArray against std::vector: the same contents after the same random operations, and its own
// promises.
#include "base/flat_array.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using namespace test;

struct Pair {
  std::uint32_t a = 7;
  double b = 0.5;
  bool operator==(const Pair&) const = default;
};

void expectSame(const FlatArray<Pair>& array, const std::vector<Pair>& expected) {
  ASSERT_EQ(array.size(), expected.size());
  ASSERT_EQ(array.empty(), expected.empty());
  ASSERT_GE(array.capacity(), array.size());
  for (std::size_t k = 0; k < expected.size(); ++k) ASSERT_TRUE(array[k] == expected[k]) << k;
}

TEST(FlatArray, BehavesAsAVector) {
  Random random(401);
  for (int run = 0; run < runs(200); ++run) {
    FlatArray<Pair> array, other;
    std::vector<Pair> expected, otherExpected;
    for (std::uint32_t step = 0; step < 60; ++step) {
      const Pair value{step, 0.25 * step};
      const std::size_t n = random.below(std::size_t{70});
      switch (random.below(10)) {
        case 0:
          array.resize(n), expected.resize(n);
          break;
        case 1:
          array.resize(n, value), expected.resize(n, value);
          break;
        case 2:
          array.assign(n, value), expected.assign(n, value);
          break;
        case 3:
          array.clear(), expected.clear();
          break;
        case 4:
          array.swap(other), expected.swap(otherExpected);
          break;
        case 5:
          if (step % 2 == 0) {
            other.assign(array), otherExpected = expected;
          } else if (other.size() < 1000) {
            other.append(array),
                otherExpected.insert(otherExpected.end(), expected.begin(), expected.end());
          }
          break;
        case 6:
          array.reserve(n), expected.reserve(n);
          break;
        case 7:
          if (array.empty()) break;
          array.erase(n % array.size()),
              expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(n % expected.size()));
          break;
        case 8:
          if (array.empty()) break;
          array.pop_back(), expected.pop_back();
          break;
        default:
          array.push_back(value), expected.push_back(value);
      }
      expectSame(array, expected);
      expectSame(other, otherExpected);
      if (HasFatalFailure()) FAIL() << "run " << run << ", step " << step;
    }
  }
}

TEST(FlatArray, TakesElementsOfItself) {
  FlatArray<Pair> array{{1, 1}, {2, 2}};
  for (int k = 0; k < 100; ++k) array.push_back(array[1]);
  EXPECT_TRUE(array.back() == (Pair{2, 2}));
  array.resize(array.capacity() + 1, array[0]);
  EXPECT_TRUE(array.back() == (Pair{1, 1}));
  array.assign(array.capacity() + 1, array[1]);
  EXPECT_TRUE(array.back() == (Pair{2, 2}));
}

TEST(FlatArray, CopiesAndMoves) {
  FlatArray<Pair> array{{1, 1}, {2, 2}};
  const FlatArray<Pair> copy = array;
  const Pair* const place = array.data();
  FlatArray<Pair> moved = std::move(array);
  EXPECT_EQ(moved.data(), place);
  EXPECT_TRUE(array.empty());  // NOLINT: a moved one is empty
  array = moved;
  expectSame(array, {{1, 1}, {2, 2}});
  array = std::move(moved);
  EXPECT_EQ(array.data(), place);
  expectSame(copy, {{1, 1}, {2, 2}});
}

TEST(FlatArray, BecomesItselfUnharmed) {
  FlatArray<Pair> array{{1, 1}, {2, 2}};
  const FlatArray<Pair>& same = array;
  array = same;
  expectSame(array, {{1, 1}, {2, 2}});
}

TEST(FlatArray, NoRoomChangesNothing) {
  FlatArray<Pair> array{{1, 1}, {2, 2}};
  EXPECT_THROW(array.reserve(SIZE_MAX / 4), std::bad_alloc);
  EXPECT_THROW(array.resize(SIZE_MAX), std::bad_alloc);
  EXPECT_THROW(array.assign(SIZE_MAX / 16, {}), std::bad_alloc);
  expectSame(array, {{1, 1}, {2, 2}});
}

TEST(FlatArray, KeepsItsRoom) {
  FlatArray<Pair> array(100);
  const Pair* const place = array.data();
  array.clear();
  array.assign(100, {3, 3});
  array.resize(5);
  array.resize(100);
  EXPECT_EQ(array.data(), place);
  EXPECT_TRUE(array[4] == (Pair{3, 3}) && array[5] == Pair{});
}

// A room of which the bytes cannot be counted: their number must not wrap around to a small one.
TEST(FlatArray, NoRoomIsTooLargeToBeRefused) {
  FlatArray<Pair> array(3);
  EXPECT_THROW(array.reserve(SIZE_MAX / sizeof(Pair) + 2), std::bad_alloc);
  EXPECT_THROW(array.reserve(SIZE_MAX / 2), std::bad_alloc);
  expectSame(array, std::vector<Pair>(3));
}

TEST(FlatBytes, WithRoomEnoughStayWhereTheyAre) {
  FlatBytes bytes;
  bytes.growTo(10, 8);
  void* const place = bytes.data;
  bytes.growTo(10, 8);
  EXPECT_EQ(bytes.data, place);
  EXPECT_EQ(bytes.room, 10u);
}

}  // namespace
}  // namespace apollonius::internal
