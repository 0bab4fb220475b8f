// Hidden sites: the flags against brute force, coverOf, revival, duplicates, and a site that covers
// everything.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

bool same(const Circle& a, const Circle& b) { return a.x == b.x && a.y == b.y && a.r == b.r; }

bool hidden(const Diagram& diagram, SiteId id) {
  bool result = false;
  EXPECT_EQ(diagram.isHidden(id, result), Error::kNone);
  return result;
}

SiteId coverOf(const Diagram& diagram, SiteId id) {
  SiteId cover = kNoSite;
  EXPECT_EQ(diagram.coverOf(id, cover), Error::kNone);
  return cover;
}

std::string validated(const Diagram& diagram) {
  std::string broken;
  EXPECT_EQ(diagram.validate(broken), Error::kNone);
  return broken;
}

/// Flags and covers of all sites against their definition.
void expectRightCovers(const Diagram& diagram, const Circles& circles,
                       const std::vector<SiteId>& ids) {
  for (std::size_t k = 0; k < circles.size(); ++k) {
    bool covered = false;  // by a circle that is not identical
    bool isFirst = true;   // among identical ones
    for (std::size_t other = 0; other < circles.size(); ++other) {
      if (same(circles[k], circles[other])) {
        isFirst = isFirst && ids[k] <= ids[other];
      } else {
        covered = covered || oracleCovers(circles[other], circles[k]);
      }
    }
    ASSERT_EQ(hidden(diagram, ids[k]), covered || !isFirst)
        << "site " << k << ": of identical sites the one with the least id is visible";
    const SiteId cover = coverOf(diagram, ids[k]);
    ASSERT_EQ(cover == kNoSite, !hidden(diagram, ids[k]));
    if (cover == kNoSite) continue;
    Circle by{};
    ASSERT_EQ(diagram.site(cover, by), Error::kNone);
    ASSERT_FALSE(hidden(diagram, cover)) << "a cover is visible";
    ASSERT_TRUE(oracleCovers(by, circles[k])) << "a cover covers";
    const int nearest = oracleNearest(circles, circles[k].x, circles[k].y);
    ASSERT_TRUE(same(by, circles[static_cast<std::size_t>(nearest)]))
        << "the cover is the site nearest to the hidden one's centre";
    std::vector<SiteId> neighbors{0};
    ASSERT_EQ(diagram.neighbors(ids[k], neighbors), Error::kNone);
    ASSERT_TRUE(neighbors.empty()) << "a hidden site has no neighbours";
  }
}

class HiddenOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(HiddenOn, FlagsAndCovers) {
  Random random(241);
  const Circles circles = GetParam().make(random, GetParam().large ? 60 : 12);
  Diagram diagram;
  const std::vector<SiteId> ids = insertInto(diagram, circles);
  expectRightCovers(diagram, circles, ids);
}

INSTANTIATE_TEST_SUITE_P(Corpus, HiddenOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Hidden, FlagsAndCoversAlongRandomHistories) {
  Random random(242);
  for (int run = 0; run < runs(400); ++run) {
    const Circles pool = tinyGrid(random, 12, 4, 5);
    Diagram diagram;
    Circles circles;
    std::vector<SiteId> ids;
    for (int step = 0; step < 25; ++step) {
      if (circles.size() > 2 && random.oneIn(3)) {
        const std::size_t victim = random.below(circles.size());
        bool removed = false;
        ASSERT_EQ(diagram.remove(ids[victim], removed), Error::kNone);
        circles.erase(circles.begin() + static_cast<std::ptrdiff_t>(victim));
        ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(victim));
      } else {
        circles.push_back(pool[random.below(pool.size())]);
        ids.push_back(0);
        ASSERT_EQ(diagram.insert(circles.back().x, circles.back().y, circles.back().r, ids.back()),
                  Error::kNone);
      }
    }
    expectRightCovers(diagram, circles, ids);
    if (HasFatalFailure()) FAIL() << "run " << run << "\n" << toText(insertAll(circles));
  }
}

TEST(Hidden, ASiteThatCoversEverythingLeavesOneVisible) {
  for (const NamedGenerator& generator : corpus()) {
    if (!generator.large || generator.name == "Huge" || generator.name == "Tiny") continue;
    SCOPED_TRACE(generator.name);
    Random random(243);
    const Circles circles = generator.make(random, 40);
    std::string broken;
    const Canonical before = freshBuild(circles, Build::kBulk, Location::kHierarchy, broken);
    Diagram diagram;
    (void)insertInto(diagram, circles);
    SiteId giant = kNoSite;
    ASSERT_EQ(diagram.insert(0, 0, 1e14, giant), Error::kNone);
    ASSERT_EQ(validated(diagram), "");
    EXPECT_EQ(diagram.visibleSize(), 1u);
    EXPECT_EQ(diagram.hiddenSize(), circles.size());
    std::vector<SiteId> faces{0};
    ASSERT_EQ(diagram.faces(faces), Error::kNone);
    EXPECT_TRUE(faces.empty());
    bool removed = false;
    ASSERT_EQ(diagram.remove(giant, removed), Error::kNone);
    ASSERT_EQ(validated(diagram), "");
    const Canonical after = canonicalForm(diagram, broken);
    EXPECT_EQ(broken, "");
    EXPECT_TRUE(before == after) << difference(before, after);
  }
}

TEST(Hidden, NestedCirclesReviveOneByOne) {
  // Radii 100 … 1 about one centre: removing the largest brings the next one out, thirty times.
  Diagram diagram;
  std::vector<SiteId> ids;
  for (int r = 1; r <= 30; ++r) {
    ids.push_back(0);
    ASSERT_EQ(diagram.insert(0, 0, r, ids.back()), Error::kNone);
  }
  EXPECT_EQ(diagram.visibleSize(), 1u);
  for (int r = 30; r > 1; --r) {
    bool removed = false;
    ASSERT_EQ(diagram.remove(ids[static_cast<std::size_t>(r) - 1], removed), Error::kNone);
    ASSERT_FALSE(hidden(diagram, ids[static_cast<std::size_t>(r) - 2]));
    ASSERT_EQ(diagram.visibleSize(), 1u);
    ASSERT_EQ(validated(diagram), "");
  }
}

TEST(Hidden, DuplicatesAreSitesOfTheirOwn) {
  Diagram diagram;
  std::vector<SiteId> identical = insertInto(diagram, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}});
  (void)insertInto(diagram, {{10, 0, 1}});
  EXPECT_EQ(diagram.size(), 4u);
  while (!identical.empty()) {
    EXPECT_EQ(diagram.visibleSize(), 2u);
    EXPECT_EQ(validated(diagram), "");
    ASSERT_FALSE(hidden(diagram, identical.front()));
    bool removed = false;
    ASSERT_EQ(diagram.remove(identical.front(), removed), Error::kNone);
    ASSERT_TRUE(removed);
    identical.erase(identical.begin());
  }
  EXPECT_EQ(diagram.visibleSize(), 1u);
}

TEST(Hidden, OfIdenticalSitesTheFirstIsVisible) {
  Diagram diagram;
  SiteId first = kNoSite, second = kNoSite;
  ASSERT_EQ(diagram.insert(1, 2, 3, first), Error::kNone);
  ASSERT_EQ(diagram.insert(1, 2, 3, second), Error::kNone);
  EXPECT_FALSE(hidden(diagram, first));
  EXPECT_TRUE(hidden(diagram, second));
  EXPECT_EQ(coverOf(diagram, second), first);
}

}  // namespace
}  // namespace apollonius::test
