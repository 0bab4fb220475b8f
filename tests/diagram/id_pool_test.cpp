// IdPool against a model that keeps each id's state and slot in a map.
#include "diagram/id_pool.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <vector>

#include "base/byte_stream.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

SiteId take(IdPool& ids, SiteState state) {
  (void)ids.next();
  return ids.take(state);
}
void release(IdPool& ids, SiteId id) { ids.release(ids.slotOf(id)); }

TEST(IdPool, CountFromZero) {
  IdPool ids;
  EXPECT_EQ(ids.size(), 0u);
  EXPECT_EQ(ids.slotOf(0), kNoSlot);
  EXPECT_EQ(ids.slotOf(kNoSite), kNoSlot);
  EXPECT_EQ(ids.state(0), SiteState::kFree);
  EXPECT_EQ(ids.state(kNoSlot), SiteState::kFree);
  for (SiteId id = 0; id < 5; ++id) {
    EXPECT_EQ(take(ids, SiteState::kVisible), id);
    EXPECT_EQ(ids.slotOf(id), id);
    EXPECT_EQ(ids.idOf(id), id);
  }
  EXPECT_EQ(ids.size(), 5u);
}

TEST(IdPool, NextAloneTakesNothing) {
  IdPool ids;
  EXPECT_EQ(ids.next(), 0u);
  EXPECT_EQ(ids.next(), 0u);
  EXPECT_EQ(ids.size(), 0u);
  EXPECT_EQ(ids.state(0), SiteState::kFree);
  EXPECT_EQ(ids.slotOf(0), kNoSlot);
}

TEST(IdPool, ReleasedOnesAreUsedAgainLastFirst) {
  IdPool ids;
  for (int k = 0; k < 4; ++k) take(ids, SiteState::kHidden);
  release(ids, 1);
  release(ids, 3);
  EXPECT_EQ(ids.size(), 2u);
  EXPECT_EQ(ids.slots(), 4u);
  EXPECT_EQ(take(ids, SiteState::kVisible), 3u);
  EXPECT_EQ(take(ids, SiteState::kVisible), 1u);
  EXPECT_EQ(take(ids, SiteState::kVisible), 4u);
}

TEST(IdPool, IdsAndSlotsInDifferentOrders) {
  IdPool ids;
  take(ids, SiteState::kVisible);
  take(ids, SiteState::kVisible);
  release(ids, 0);
  const SiteId a = ids.takeId(), b = ids.takeId(), c = ids.takeId();
  EXPECT_EQ(a, 0u);
  EXPECT_EQ(b, 2u);
  EXPECT_EQ(c, 3u);
  EXPECT_EQ(ids.slotOf(b), kNoSlot);
  EXPECT_EQ(ids.takeSlot(c, SiteState::kPending), 0u);
  EXPECT_EQ(ids.takeSlot(a, SiteState::kPending), 2u);
  EXPECT_EQ(ids.takeSlot(b, SiteState::kHidden), 3u);
  EXPECT_EQ(ids.slotOf(c), 0u);
  EXPECT_EQ(ids.idOf(2), a);
  EXPECT_EQ(ids.hiddenCount(), 1u);
  EXPECT_EQ(ids.size(), 4u);
  ids.release(0);
  EXPECT_EQ(ids.slotOf(c), kNoSlot);
  EXPECT_EQ(take(ids, SiteState::kVisible), c);
}

TEST(IdPool, GivenIdsAreTakenAndFreedInAnyOrder) {
  IdPool ids(Naming::kGiven);
  ids.reserveIds(8);
  EXPECT_EQ(ids.size(), 0u);
  for (const SiteId id : {5u, 2u, 7u}) {
    EXPECT_EQ(ids.slotOf(id), kNoSlot);
    const Slot slot = ids.next();
    EXPECT_EQ(ids.take(SiteState::kVisible, id), id);
    EXPECT_EQ(ids.slotOf(id), slot);
    EXPECT_EQ(ids.idOf(slot), id);
  }
  release(ids, 2);
  release(ids, 5);
  EXPECT_EQ(ids.slotOf(2), kNoSlot);
  for (const SiteId id : {2u, 0u}) {
    (void)ids.next();
    EXPECT_EQ(ids.take(SiteState::kHidden, id), id);
  }
  EXPECT_EQ(ids.size(), 3u);
  EXPECT_EQ(ids.hiddenCount(), 2u);
  EXPECT_EQ(ids.slotOf(5), kNoSlot);
  EXPECT_EQ(ids.idLimit(), 8u);
}

TEST(IdPool, ASnapshotWithFewerSitesThanItSaysIsNone) {
  // Three slots, of which one has a site; the other two are listed as free.
  std::vector<std::uint8_t> bytes(5 * 4);
  WordWriter out(bytes);
  for (const std::uint32_t word : {0u, kNoSite, kNoSite, 1u, 2u}) out.word(word);
  for (const std::size_t size : {1, 2, 3}) {
    IdPool ids;
    WordReader in(bytes);
    EXPECT_EQ(ids.restore(in, 3, size, size), size == 1) << size;
  }
}

TEST(IdPool, ClearStartsFromZeroAgain) {
  IdPool ids;
  for (int k = 0; k < 4; ++k) take(ids, SiteState::kHidden);
  release(ids, 2);
  ids.clear();
  EXPECT_EQ(ids.size(), 0u);
  EXPECT_EQ(ids.slots(), 0u);
  EXPECT_EQ(ids.hiddenCount(), 0u);
  EXPECT_EQ(take(ids, SiteState::kVisible), 0u);
}

TEST(IdPool, RandomHistoriesAgreeWithTheModel) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    IdPool ids;
    std::map<SiteId, SiteState> model;
    const auto randomState = [&] {
      return random.oneIn(2) ? SiteState::kHidden : SiteState::kVisible;
    };
    for (int step = 0; step < 500; ++step) {
      // Phases of growth and of decline.
      const bool grow = model.empty() || random.integer(0, 99) < (step / 100 % 2 == 0 ? 70 : 30);
      if (grow && random.oneIn(10)) {  // several at once, their slots in the reverse order
        std::vector<SiteId> taken;
        for (int k = 0; k < 3; ++k) taken.push_back(ids.takeId());
        while (!taken.empty()) {
          const SiteState state = randomState();
          ASSERT_FALSE(model.contains(taken.back()));
          (void)ids.takeSlot(taken.back(), state);
          model[taken.back()] = state;
          taken.pop_back();
        }
      } else if (grow) {
        const SiteState state = randomState();
        const SiteId id = take(ids, state);
        ASSERT_FALSE(model.contains(id));
        model[id] = state;
      } else {
        auto it = model.begin();
        std::advance(it, static_cast<std::ptrdiff_t>(random.below(model.size())));
        if (random.oneIn(3)) {
          it->second = randomState();
          ids.setState(ids.slotOf(it->first), it->second);
        } else {
          release(ids, it->first);
          model.erase(it);
        }
      }
      std::size_t hidden = 0, used = 0;
      for (SiteId id = 0; id < ids.idLimit() + 2; ++id) {
        const auto it = model.find(id);
        const Slot slot = ids.slotOf(id);
        ASSERT_EQ(slot != kNoSlot, it != model.end()) << id;
        if (slot == kNoSlot) continue;
        ASSERT_EQ(ids.idOf(slot), id);
        ASSERT_EQ(ids.state(slot), it->second) << id;
        hidden += it->second == SiteState::kHidden;
      }
      for (Slot slot = 0; slot < ids.slots() + 2; ++slot)
        used += ids.state(slot) != SiteState::kFree;
      ASSERT_EQ(ids.size(), model.size());
      ASSERT_EQ(used, model.size());
      ASSERT_EQ(ids.hiddenCount(), hidden);
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
