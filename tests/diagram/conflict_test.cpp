// From which cells a new circle would take something: against inserting it.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "apollonius/diagram.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"

namespace apollonius::test {
namespace {

class ConflictWith : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(ConflictWith, IsWhatInsertionChanges) {
  Random random(681);
  for (int run = 0; run < runs(2); ++run) {
    const Circles circles = GetParam().make(random, GetParam().large ? 40 : 12);
    for (std::size_t last = circles.size() / 2; last < circles.size(); ++last) {
      Diagram diagram;
      insertInto(diagram, {circles.begin(), circles.begin() + static_cast<std::ptrdiff_t>(last)});
      const Circle& next = circles[last];
      std::vector<SiteId> sites, neighbors;
      bool isCovered = false, isHidden = false;
      ASSERT_EQ(diagram.conflict(next.x, next.y, next.r, sites, isCovered), Error::kNone);
      std::vector<bool> wasVisible;
      for (SiteId id = 0; id < last; ++id) {
        ASSERT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
        wasVisible.push_back(!isHidden);
      }
      SiteId id = kNoSite;
      ASSERT_EQ(diagram.insert(next.x, next.y, next.r, id), Error::kNone);
      ASSERT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
      ASSERT_EQ(isCovered, isHidden);
      if (isCovered) {
        EXPECT_EQ(sites.size(), 1u);
        continue;
      }
      // Its neighbours, and the sites that it has hidden.
      ASSERT_EQ(diagram.neighbors(id, neighbors), Error::kNone);
      for (SiteId other = 0; other < last; ++other) {
        ASSERT_EQ(diagram.isHidden(other, isHidden), Error::kNone);
        if (wasVisible[other] && isHidden) neighbors.push_back(other);
      }
      std::sort(neighbors.begin(), neighbors.end());
      std::sort(sites.begin(), sites.end());
      EXPECT_EQ(sites, neighbors) << "run " << run << " site " << last;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, ConflictWith, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Conflict, WithACircleThatCoversAllIsWithAll) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 1}, {10, 0, 1}, {0, 10, 2}, {10, 11, 0}, {0, 1, 0}});
  std::vector<SiteId> sites;
  bool isCovered = true;
  ASSERT_EQ(diagram.conflict(5, 5, 100, sites, isCovered), Error::kNone);
  EXPECT_FALSE(isCovered);
  std::sort(sites.begin(), sites.end());
  EXPECT_EQ(sites, (std::vector<SiteId>{0, 1, 2, 3})) << "but for the hidden one";
}

TEST(Conflict, OfNoSiteAndOfBadNumbers) {
  Diagram diagram;
  std::vector<SiteId> sites{7};
  bool isCovered = true;
  ASSERT_EQ(diagram.conflict(0, 0, 0, sites, isCovered), Error::kNone);
  EXPECT_TRUE(sites.empty());
  EXPECT_FALSE(isCovered);
  EXPECT_EQ(diagram.conflict(0, 0, 1e300, sites, isCovered), Error::kOutOfRange);
}

}  // namespace
}  // namespace apollonius::test
