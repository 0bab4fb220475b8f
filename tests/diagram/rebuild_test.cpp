// updateMany rebuilds the diagram if nearly all of its sites move far. A user must not see that:
// given and free ids stay, the other sites are where they were, and the diagram is that of the
// sites.
#include <gtest/gtest.h>

#include <numeric>

#include "apollonius/diagram.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/replay.h"
#include "support/saved.h"

namespace apollonius::test {
namespace {

class Rebuild : public ::testing::TestWithParam<Location> {
 protected:
  Random random{611};
};

std::string validated(const Diagram& diagram) {
  std::string broken;
  EXPECT_EQ(diagram.validate(broken), Error::kNone);
  return broken;
}

TEST_P(Rebuild, KeepsIdsAndSitesThatStay) {
  const auto n = static_cast<std::size_t>(runs(600));
  const Circles before = randomCircles(random, n, Hidden::k20Percent),
                after = randomCircles(random, n, Hidden::k50Percent);
  for (const std::size_t stride : {1u, 2u, 9u}) {  // all, half, some of them go elsewhere
    Diagram diagram(GetParam());
    const std::vector<SiteId> ids = insertInto(diagram, before);
    Circles expected = before;
    std::vector<bool> isThere(n, true);
    bool removed = false;
    for (std::size_t k = 3; k < n; k += 7) {
      ASSERT_EQ(diagram.remove(ids[k], removed), Error::kNone);
      isThere[k] = false;
    }
    std::vector<SiteId> moved;
    Circles to;
    for (std::size_t k = 0; k < n; k += stride) {
      if (!isThere[k]) continue;
      moved.insert(moved.end(), {ids[k], ids[k]});
      to.insert(to.end(), {before[n - 1 - k], after[k]});  // given twice, the last one counts
      expected[k] = after[k];
    }
    Diagram oneByOne(GetParam());
    insertInto(oneByOne, before);
    for (std::size_t k = 3; k < n; k += 7)
      ASSERT_EQ(oneByOne.remove(ids[k], removed), Error::kNone);
    for (std::size_t k = 0; k < moved.size(); ++k) {
      ASSERT_EQ(oneByOne.update(moved[k], to[k].x, to[k].y, to[k].r), Error::kNone);
    }

    ASSERT_EQ(diagram.updateMany(moved, flat(to)), Error::kNone);
    EXPECT_EQ(validated(diagram), "");
    Circle circle{};
    bool isHidden = false, isHiddenThere = false;
    for (std::size_t k = 0; k < n; ++k) {
      ASSERT_EQ(diagram.has(ids[k]), isThere[k]);
      if (!isThere[k]) continue;
      ASSERT_EQ(diagram.site(ids[k], circle), Error::kNone);
      ASSERT_EQ(circle.x, expected[k].x);
      ASSERT_EQ(circle.r, expected[k].r);
      ASSERT_EQ(diagram.isHidden(ids[k], isHidden), Error::kNone);
      ASSERT_EQ(oneByOne.isHidden(ids[k], isHiddenThere), Error::kNone);
      ASSERT_EQ(isHidden, isHiddenThere);
    }
    // The next ids are those that are free, in the same order; and the diagram goes on.
    for (int k = 0; k < 200; ++k) {
      SiteId id = kNoSite, idThere = kNoSite;
      const Circle c = after[static_cast<std::size_t>(k) % n];
      ASSERT_EQ(diagram.insert(c.x, c.y, c.r + 1, id), Error::kNone);
      ASSERT_EQ(oneByOne.insert(c.x, c.y, c.r + 1, idThere), Error::kNone);
      ASSERT_EQ(id, idThere);
    }
    EXPECT_EQ(validated(diagram), "");
  }
}

/// Some ids are free and no slots are: only so a snapshot has an even number of words.
TEST_P(Rebuild, IsSavedWithItsFreeIds) {
  const Circles before = randomCircles(random, 100, Hidden::kNone);
  Diagram diagram(GetParam()), restored(GetParam());
  std::vector<SiteId> ids = insertInto(diagram, before);
  bool removed = false;
  for (SiteId gone = 0; gone < 3; ++gone) {
    ASSERT_EQ(diagram.remove(gone, removed), Error::kNone);
    ids.erase(ids.begin());
    const Circles after = randomCircles(random, ids.size(), Hidden::kNone);
    ASSERT_EQ(diagram.updateMany(ids, flat(after)), Error::kNone);
    ASSERT_EQ(restored.fromBytes(saved(diagram)), Error::kNone);
    EXPECT_EQ(saved(restored), saved(diagram));
    EXPECT_EQ(validated(restored), "");
  }
}

/// Small moves of all are certified and stay; large ones of all are not even tried after a look at
/// a sample. In between, some give up half-way.
TEST_P(Rebuild, WhereverItStartsTheDiagramIsThatOfTheSites) {
  const auto n = static_cast<std::size_t>(runs(sized(500, 1500)));
  const Circles start = randomCircles(random, n, Hidden::k5Percent);
  const double gap = 2e6 / 40;
  Diagram diagram(GetParam());
  const std::vector<SiteId> ids = insertInto(diagram, start);
  Circles now = start;
  for (const double share : {0.001, 0.01, 0.02, 0.03, 0.05, 0.1, 0.3, 1.0, 0.01, 0.001}) {
    for (Circle& c : now)
      c = {c.x + share * gap * random.between(-1, 1), c.y + share * gap * random.between(-1, 1),
           c.r};
    ASSERT_EQ(diagram.updateMany(ids, flat(now)), Error::kNone);
    ASSERT_EQ(validated(diagram), "") << share;
  }
  std::string broken;
  const Canonical form = canonicalForm(diagram, broken);
  EXPECT_EQ(broken, "");
  EXPECT_TRUE(form == freshBuild(now, Build::kBulk, GetParam(), broken));
  EXPECT_EQ(broken, "");
}

INSTANTIATE_TEST_SUITE_P(By, Rebuild, ::testing::Values(Location::kHierarchy, Location::kWalk),
                         [](const auto& parameter) {
                           return parameter.param == Location::kWalk ? "Walk" : "Hierarchy";
                         });

}  // namespace
}  // namespace apollonius::test
