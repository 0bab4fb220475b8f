// Structures broken on purpose: whatever one part says of another, no walk leaves the arrays.
// The levels of the hierarchy, the grid and hints only say where to start, so with wrong ones the
// answers are still right; where the parts contradict each other about a site, the program ends
// with the name of the invariant, before anything is touched. (Under AddressSanitizer this says
// most.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "delaunay/diagram_breaker.h"
#include "diagram/bulk_insertion.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using Breaker = DiagramBreaker;
using test::Random;

class BrokenParts : public ::testing::Test {
 protected:
  static constexpr std::size_t kSites = 3000;  // two levels

  BrokenParts() {
    std::vector<double> xyr;
    for (std::size_t k = 0; k < kSites; ++k) {
      sites.push_back({random.between(-100, 100), random.between(-100, 100), random.between(0, 1)});
      xyr.insert(xyr.end(), {sites[k].x, sites[k].y, sites[k].r});
    }
    ids.resize(kSites);
    insertAll(core, xyr, ids);
    EXPECT_GE(Breaker::levelCount(core), 2u);
  }

  /// Finds, inserts, moves and removes all over the place; answers are those of all pairs.
  void expectRightAnswers() {
    for (int k = 0; k < 300; ++k) {
      const double x = random.between(-110, 110), y = random.between(-110, 110);
      const auto distanceTo = [&](const Site& s) { return std::hypot(s.x - x, s.y - y) - s.r; };
      double least = distanceTo(sites[0]);
      for (const Site& site : sites) least = std::min(least, distanceTo(site));
      ASSERT_NEAR(distanceTo(core.site(core.nearest(x, y))), least, 1e-9);
      const std::size_t at = random.below(sites.size());
      const Site site{random.between(-100, 100), random.between(-100, 100), random.between(0, 1)};
      if (k % 3 == 0) {
        ids.push_back(core.insert(site));
        sites.push_back(site);
      } else if (k % 3 == 1) {
        core.update(ids[at], site);
        sites[at] = site;
      } else {
        ASSERT_TRUE(core.remove(ids[at]));
        ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(at));
        sites.erase(sites.begin() + static_cast<std::ptrdiff_t>(at));
      }
    }
    std::uint32_t where = 0;
    EXPECT_EQ(core.delaunay().check(where), nullptr);
  }

  /// A visible vertex of a level.
  VertexId someOf(const DelaunayGraph& level) {
    for (;;) {
      const VertexId v{random.below(static_cast<std::uint32_t>(level.graph().vertexSlots()))};
      if (v != kInfinity && level.isVisible(v)) return v;
    }
  }

  Random random{411};
  DiagramCore core{Location::kHierarchy};
  std::vector<Site> sites;
  std::vector<SiteId> ids;
};

TEST_F(BrokenParts, NothingIsBroken) { expectRightAnswers(); }

TEST_F(BrokenParts, ALevelLacksSitesOfTheOneAbove) {
  Remover remover;
  DelaunayGraph& level = Breaker::level(core, 0);
  while (level.visibleCount() > 3) (void)remover.remove(level, someOf(level), {});
  Breaker::dropGrid(core);
  expectRightAnswers();
}

TEST_F(BrokenParts, LevelsHoldSitesThatAreNotVisibleBelow) {
  Remover remover;
  DelaunayGraph& base = Breaker::delaunay(core);
  // Behind the back of the diagram, which forgets a third of its sites.
  std::vector<Site> rest;
  std::vector<SiteId> restIds;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    const Slot slot = core.ids().slotOf(ids[k]);
    if (k % 3 == 0 && base.isVisible(vertexOf(slot))) {
      Breaker::forget(core, slot);
    } else {
      rest.push_back(sites[k]);
      restIds.push_back(ids[k]);
    }
  }
  sites = rest;
  ids = restIds;
  Breaker::dropGrid(core);
  expectRightAnswers();
}

TEST_F(BrokenParts, ALevelHoldsSitesBeyondAllSlots) {
  DelaunayGraph& level = Breaker::level(core, 0);
  const auto many = static_cast<std::uint32_t>(100000);
  level.reserve(many + 1);
  for (std::uint32_t v = many; v > many - 40; --v) {
    level.setSite(VertexId{v}, {random.between(-100, 100), random.between(-100, 100), 0.5});
    level.insert(VertexId{v}, kNoVertex);
  }
  Breaker::dropGrid(core);
  expectRightAnswers();
}

TEST_F(BrokenParts, LevelsHaveTheirSitesElsewhere) {
  Remover remover;
  for (unsigned k = 0; k < 2; ++k) {
    DelaunayGraph& level = Breaker::level(core, k);
    for (int moved = 0; moved < 20; ++moved) {
      const VertexId v = someOf(level);
      if (level.visibleCount() < 3) break;
      (void)remover.remove(level, v, {});
      level.setSite(v, {random.between(-100, 100), random.between(-100, 100),
                        random.between(0, 30)});  // covers others, too
      level.insert(v, kNoVertex);
    }
  }
  Breaker::dropGrid(core);
  expectRightAnswers();
}

TEST_F(BrokenParts, ALevelHoldsASiteThatEnters) {
  // Its slot is free on level 0 and not on level 1: the levels are given up.
  Remover remover;
  DelaunayGraph& level = Breaker::level(core, 0);
  const VertexId copy = someOf(level);
  const Site site = level.site(copy);
  Slot slot = 0;
  while (core.site(slot).x != site.x || core.site(slot).y != site.y) ++slot;
  const SiteId id = core.ids().idOf(slot);
  const auto at = static_cast<std::ptrdiff_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
  sites.erase(sites.begin() + at);
  ids.erase(ids.begin() + at);
  ASSERT_TRUE(core.remove(id));
  level.setSite(copy, site);
  level.insert(copy, kNoVertex);
  ids.push_back(core.insert({1, 2, 0.25}));
  sites.push_back({1, 2, 0.25});
  EXPECT_EQ(core.ids().slotOf(ids.back()), slot);
  EXPECT_EQ(Breaker::levelCount(core), 0u);
  expectRightAnswers();
}

TEST_F(BrokenParts, GridThatNamesWhatIsNotThere) {
  Breaker::fillGrid(core, [&] { return random.below(Slot{1} << 29); });
  expectRightAnswers();
  Breaker::fillGrid(core, [&] { return random.below(Slot{4000}); });
  expectRightAnswers();
}

TEST_F(BrokenParts, HintsThatAreNoSites) {
  for (const Slot hint : {Slot{4000}, Slot{1} << 29, Slot{0xFFFFFFFE}}) {
    EXPECT_EQ(core.nearest(3, 4, hint), core.nearest(3, 4));
  }
}

#ifdef GTEST_HAS_DEATH_TEST
using BrokenPartsDeathTest = BrokenParts;

TEST_F(BrokenPartsDeathTest, PartsThatContradictEachOtherAboutASite) {
  const Slot slot = core.ids().slotOf(ids[0]);
  const Slot visible = slotOf(core.delaunay().anyVisible());
  EXPECT_DEATH(
      {
        Breaker::ids(core).setState(visible, SiteState::kHidden);
        core.remove(core.ids().idOf(visible));
      },
      "a hidden site hangs on another");
  EXPECT_DEATH(
      {
        Breaker::ids(core).setState(visible, SiteState::kHidden);
        core.update(core.ids().idOf(visible), {1, 2, 3});
      },
      "a hidden site hangs on another");
  EXPECT_DEATH(
      {
        Remover remover;
        (void)remover.remove(Breaker::delaunay(core), vertexOf(visible), {});
        core.remove(core.ids().idOf(visible));
      },
      "a site that is removed from a graph is there");
  EXPECT_DEATH(Breaker::delaunay(core).insert(vertexOf(visible), kNoVertex),
               "a site enters a graph once");
  EXPECT_DEATH(Breaker::ids(core).setState(Slot{1} << 29, SiteState::kHidden),
               "only a slot in use has a state");
  EXPECT_EQ(core.ids().idOf(Slot{1} << 29), kNoSite);
  EXPECT_TRUE(core.ids().state(slot) != SiteState::kFree);
}
#endif

}  // namespace
}  // namespace apollonius::internal
