// Ids: stable while a site lives, used again afterwards, from 0 after clear(); the site table along
// random histories.
#include <gtest/gtest.h>

#include <map>

#include "support/effort.h"
#include "support/insert_into.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

bool same(const Circle& a, const Circle& b) { return a.x == b.x && a.y == b.y && a.r == b.r; }

/// The diagram's table of sites is exactly `expected`.
void expectTable(const Diagram& diagram, const std::map<SiteId, Circle>& expected) {
  ASSERT_EQ(diagram.size(), expected.size());
  ASSERT_EQ(diagram.visibleSize() + diagram.hiddenSize(), expected.size());
  std::vector<SiteId> ids{7};
  ASSERT_EQ(diagram.ids(ids), Error::kNone);
  ASSERT_EQ(ids.size(), expected.size());
  SiteArrays sites{{7}, {7, 7, 7, 7}, {7}};
  ASSERT_EQ(diagram.sites(sites), Error::kNone);
  ASSERT_EQ(sites.ids, ids);
  ASSERT_EQ(sites.xyr.size(), 3 * ids.size());
  ASSERT_EQ(sites.hidden.size(), ids.size());
  std::size_t k = 0;
  for (const auto& [id, circle] : expected) {
    ASSERT_EQ(ids[k], id) << "ascending";
    ASSERT_TRUE(same({sites.xyr[3 * k], sites.xyr[3 * k + 1], sites.xyr[3 * k + 2]}, circle));
    bool isHidden = false;
    ASSERT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
    ASSERT_EQ(sites.hidden[k++], isHidden ? 1 : 0);
    Circle got{};
    ASSERT_TRUE(diagram.has(id));
    ASSERT_EQ(diagram.site(id, got), Error::kNone);
    ASSERT_TRUE(same(got, circle)) << "id " << id;
  }
}

TEST(Ids, TableAlongRandomHistories) {
  Random random(271);
  for (int run = 0; run < runs(100); ++run) {
    Diagram diagram;
    std::map<SiteId, Circle> table;
    SiteId largest = 0;
    std::size_t mostSites = 0;
    for (int step = 0; step < 120; ++step) {
      const Circle c = tinyGrid(random, 1, 10, 5).front();
      if (table.empty() || !random.oneIn(3)) {
        SiteId id = kNoSite;
        ASSERT_EQ(diagram.insert(c.x, c.y, c.r, id), Error::kNone);
        ASSERT_EQ(table.count(id), 0u) << "an id in use was given away";
        table[id] = c;
        largest = std::max(largest, id);
      } else {
        auto chosen = table.begin();
        std::advance(chosen, static_cast<std::ptrdiff_t>(random.below(table.size())));
        if (random.oneIn(2)) {
          ASSERT_EQ(diagram.update(chosen->first, c.x, c.y, c.r), Error::kNone);
          chosen->second = c;
        } else {
          bool removed = false;
          ASSERT_EQ(diagram.remove(chosen->first, removed), Error::kNone);
          ASSERT_TRUE(removed);
          ASSERT_EQ(diagram.remove(chosen->first, removed), Error::kNone);
          ASSERT_FALSE(removed) << "twice";
          table.erase(chosen);
        }
      }
      mostSites = std::max(mostSites, table.size());
      expectTable(diagram, table);
      if (HasFatalFailure()) FAIL() << "run " << run << " step " << step;
    }
    EXPECT_LT(largest, mostSites) << "ids of removed sites are used again";
    EXPECT_EQ(diagram.idLimit(), largest + 1);
  }
}

TEST(Ids, BatchesGiveIdsInTheirOwnOrder) {
  Random random(272);
  const Circles circles = randomCircles(random, 500, Hidden::k20Percent);
  Diagram diagram;
  const std::vector<SiteId> ids = insertInto(diagram, circles);
  std::map<SiteId, Circle> table;
  for (std::size_t k = 0; k < ids.size(); ++k) table[ids[k]] = circles[k];
  expectTable(diagram, table);

  // Update some of them in bulk; the last of repeated ids decides, if ids repeat at all.
  std::vector<SiteId> chosen;
  std::vector<double> moved;
  for (std::size_t k = 0; k < ids.size(); k += 3) {
    const Circle c{circles[k].x / 2, -circles[k].y, circles[k].r + 1};
    chosen.push_back(ids[k]);
    moved.insert(moved.end(), {c.x, c.y, c.r});
    table[ids[k]] = c;
  }
  ASSERT_EQ(diagram.updateMany(chosen, moved), Error::kNone);
  expectTable(diagram, table);
  std::string broken;
  ASSERT_EQ(diagram.validate(broken), Error::kNone);
  ASSERT_EQ(broken, "");
  Circles now;
  for (const auto& [id, circle] : table) now.push_back(circle);
  const Canonical got = canonicalForm(diagram, broken);
  ASSERT_EQ(broken, "");
  const Canonical expected = freshBuild(now, Build::kBulk, Location::kHierarchy, broken);
  EXPECT_TRUE(got == expected) << difference(expected, got);

  // Remove with unknown and repeated ids among them.
  std::vector<SiteId> victims{ids[0], ids[1], ids[0], kNoSite, ids[2], ids[1]};
  std::size_t removed = 0;
  ASSERT_EQ(diagram.removeMany(victims, removed), Error::kNone);
  EXPECT_EQ(removed, 3u);
  for (int k = 0; k < 3; ++k) table.erase(ids[static_cast<std::size_t>(k)]);
  expectTable(diagram, table);
}

TEST(Ids, ClearStartsFromZero) {
  Diagram diagram;
  SiteId id = kNoSite;
  for (int k = 0; k < 5; ++k) ASSERT_EQ(diagram.insert(k, 0, 1, id), Error::kNone);
  diagram.clear();
  expectTable(diagram, {});
  ASSERT_EQ(diagram.insert(9, 9, 1, id), Error::kNone);
  EXPECT_EQ(id, 0u);
  expectTable(diagram, {{0, {9, 9, 1}}});
}

}  // namespace
}  // namespace apollonius::test
