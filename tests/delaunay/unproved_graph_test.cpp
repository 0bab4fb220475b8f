// Trusted bytes whose graph is a surface and whose sites are others: whatever is inserted, moved
// and removed, an operation finds out and gives the diagram up, or leaves a surface again.
#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <vector>

#include "diagram/diagram_core.h"
#include "predicate/shadow_check.h"
#include "support/effort.h"
#include "support/random.h"
#include "support/snapshots.h"

namespace apollonius::internal {
namespace {

using test::Random;
using Bytes = std::vector<std::uint8_t>;

/// Points, circles, a small grid, or a few giants.
Site someSite(Random& random, int family) {
  const auto whole = [&](int most) { return static_cast<double>(random.below(most)); };
  const double x = random.unit(), y = random.unit(), r = random.unit();
  if (family == 0) return {x, y, 0};
  if (family == 1) return {x, y, r / 5};
  if (family == 2) return {whole(8), whole(8), whole(3)};
  return {x, y, r * r * r * r * r * r};
}

void setSite(Bytes& bytes, std::size_t slot, const Site& site) {
  const std::size_t at = test::kNumbersAt + 6 * slot;
  test::setNumber(bytes, at, site.x);
  test::setNumber(bytes, at + 2, site.y);
  test::setNumber(bytes, at + 4, site.r);
}

/// A snapshot of up to 35 sites, of which one to four, or all, are elsewhere.
Bytes withWrongSites(Random& random, int family) {
  DiagramCore honest(Location::kWalk);
  for (std::uint64_t n = 6 + random.below(30u); n > 0; --n)
    (void)honest.insert(someSite(random, family));
  Bytes bytes;
  honest.save(bytes);
  const auto slots = static_cast<std::size_t>(honest.ids().slots());
  const bool isAll = random.oneIn(4);
  for (std::size_t k = isAll ? slots : 1 + random.below(4u); k-- > 0;) {
    const Site site = someSite(random, family);
    setSite(bytes, isAll ? k : random.below(slots), site);
  }
  return test::withChecksum(bytes);
}

enum class End { kRefused, kFoundOut, kSurface, kNoSurface };

End play(std::uint64_t seed) {
  Random random(seed);
  const int family = static_cast<int>(random.below(4u));
  const Bytes bytes = withWrongSites(random, family);
  DiagramCore core(Location::kWalk);
  if (!core.restore(bytes, Source::kTrusted)) return End::kRefused;
  for (int step = 0; step < 20; ++step) {
    const auto id = static_cast<SiteId>(random.below(core.ids().idLimit()));
    const Site site = someSite(random, family);
    const std::uint64_t operation = random.below(3u);
    try {
      if (operation == 0) {
        (void)core.insert(site);
      } else if (core.ids().slotOf(id) != kNoSlot) {
        if (operation == 1) {
          (void)core.remove(id);
        } else {
          core.update(id, site);
        }
      }
    } catch (const std::bad_alloc&) {
      return End::kFoundOut;
    }
    if (core.isBroken()) return End::kFoundOut;
    const Graph& graph = core.delaunay().graph();
    std::uint32_t where = 0;
    if (!graph.isEmpty() && graph.check(where) != nullptr) return End::kNoSurface;
  }
  return End::kSurface;
}

TEST(UnprovedGraph, LeaveASurfaceOrAreFoundOut) {
  // On an invalid graph a filter may contradict the exact stage.
  if (kShadowCheck) GTEST_SKIP() << "with the shadow check";
  int foundOut = 0, surfaces = 0;
  for (int seed = 0; seed < test::runs(20000); ++seed) {
    const End end = play(static_cast<std::uint64_t>(seed));
    ASSERT_NE(end, End::kNoSurface) << "seed " << seed;
    foundOut += end == End::kFoundOut;
    surfaces += end == End::kSurface;
  }
  EXPECT_GT(foundOut, test::runs(1000));
  EXPECT_GT(surfaces, test::runs(1000));
}

/// Found by a search: an insertion's region would be a disk if its boundary were in order.
TEST(UnprovedGraph, WithARegionThatWindsAreFoundOut) {
  if (kShadowCheck) GTEST_SKIP() << "with the shadow check";
  for (const std::uint64_t seed : {92509u, 109882u, 139353u})
    EXPECT_EQ(play(seed), End::kFoundOut) << "seed " << seed;
}

}  // namespace
}  // namespace apollonius::internal
