// Bytes of no closed surface: twins are mutual and stars close, but all together it is not one
// triangulated sphere.
#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "base/byte_stream.h"
#include "topology/graph.h"

namespace apollonius::internal {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFu;

/// Restores twins, and one half-edge of each vertex; without free faces.
bool isRestored(std::initializer_list<std::uint32_t> twins,
                std::initializer_list<std::uint32_t> outgoing) {
  std::vector<std::uint8_t> bytes(4 * (1 + twins.size() + outgoing.size()));
  WordWriter out(bytes);
  out.word(kNone);
  for (const std::uint32_t h : twins) out.word(h);
  for (const std::uint32_t h : outgoing) out.word(h);
  WordReader in(bytes);
  Graph graph;
  return graph.restore(in, outgoing.size(), twins.size() / 3);
}

TEST(Restore, TwoSites) { EXPECT_TRUE(isRestored({3, 5, 4, 0, 2, 1}, {5, 4, 3})); }

TEST(Restore, TwoSpheresAreRefused) {
  EXPECT_FALSE(isRestored({3, 5, 4, 0, 2, 1, 9, 11, 10, 6, 8, 7}, {5, 4, 3, 11, 10, 9}));
}

/// Faces (0, 1, 0) and (0, 2, 0), with an edge from infinity to itself between them: a sphere, and
/// Euler's formula holds.
TEST(Restore, ALoopIsRefused) { EXPECT_FALSE(isRestored({1, 0, 5, 4, 3, 2}, {0, 1, 4})); }

/// The loop takes the place of each of the three sides.
TEST(Restore, ALoopIsRefusedOnEachSide) {
  EXPECT_FALSE(isRestored({5, 2, 1, 4, 3, 0}, {0, 2, 4}));
  EXPECT_FALSE(isRestored({2, 5, 0, 4, 3, 1}, {1, 0, 4}));
}

}  // namespace
}  // namespace apollonius::internal
