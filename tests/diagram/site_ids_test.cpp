// SiteIds against a model that keeps each id's state in a map.
#include "diagram/site_ids.h"

#include <gtest/gtest.h>

#include <map>

#include "support/random.h"

namespace apollonius {
namespace {

using test::Random;

SiteId take(SiteIds& ids, SiteState state) {
  const SiteId id = ids.next();
  ids.take(id, state);
  return id;
}

TEST(SiteIds, CountFromZero) {
  SiteIds ids;
  EXPECT_EQ(ids.size(), 0u);
  EXPECT_EQ(ids.state(0), SiteState::kFree);
  EXPECT_EQ(ids.state(kNoSite), SiteState::kFree);
  for (SiteId id = 0; id < 5; ++id) EXPECT_EQ(take(ids, SiteState::kVisible), id);
  EXPECT_EQ(ids.size(), 5u);
}

TEST(SiteIds, NextAloneTakesNothing) {
  SiteIds ids;
  EXPECT_EQ(ids.next(), 0u);
  EXPECT_EQ(ids.next(), 0u);
  EXPECT_EQ(ids.size(), 0u);
  EXPECT_EQ(ids.state(0), SiteState::kFree);
}

TEST(SiteIds, ReleasedOnesAreUsedAgainLastFirst) {
  SiteIds ids;
  for (int k = 0; k < 4; ++k) take(ids, SiteState::kHidden);
  ids.release(1);
  ids.release(3);
  EXPECT_EQ(ids.size(), 2u);
  EXPECT_EQ(ids.slots(), 4u);
  EXPECT_EQ(take(ids, SiteState::kVisible), 3u);
  EXPECT_EQ(take(ids, SiteState::kVisible), 1u);
  EXPECT_EQ(take(ids, SiteState::kVisible), 4u);
}

TEST(SiteIds, ClearStartsFromZeroAgain) {
  SiteIds ids;
  for (int k = 0; k < 4; ++k) take(ids, SiteState::kHidden);
  ids.release(2);
  ids.clear();
  EXPECT_EQ(ids.size(), 0u);
  EXPECT_EQ(ids.slots(), 0u);
  EXPECT_EQ(ids.hiddenCount(), 0u);
  EXPECT_EQ(take(ids, SiteState::kVisible), 0u);
}

TEST(SiteIds, RandomHistoriesAgreeWithTheModel) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    SiteIds ids;
    std::map<SiteId, SiteState> model;
    const auto randomState = [&] { return random.oneIn(2) ? SiteState::kHidden : SiteState::kVisible; };
    for (int step = 0; step < 500; ++step) {
      // Phases of growth and of decline.
      const bool grow = model.empty() || random.integer(0, 99) < (step / 100 % 2 == 0 ? 70 : 30);
      if (grow) {
        const SiteState state = randomState();
        const SiteId id = take(ids, state);
        ASSERT_FALSE(model.contains(id));
        model[id] = state;
      } else {
        auto it = model.begin();
        std::advance(it, static_cast<std::ptrdiff_t>(random.below(model.size())));
        if (random.oneIn(3)) {
          it->second = randomState();
          ids.setState(it->first, it->second);
        } else {
          ids.release(it->first);
          model.erase(it);
        }
      }
      std::size_t hidden = 0;
      for (SiteId id = 0; id < ids.slots() + 2; ++id) {
        const auto it = model.find(id);
        ASSERT_EQ(ids.state(id), it == model.end() ? SiteState::kFree : it->second) << id;
        hidden += ids.state(id) == SiteState::kHidden;
      }
      ASSERT_EQ(ids.size(), model.size());
      ASSERT_EQ(ids.hiddenCount(), hidden);
    }
  }
}

}  // namespace
}  // namespace apollonius
