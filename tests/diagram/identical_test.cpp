// Identical circles: the one with the least id is visible, after any history. (All histories of the
// other tests are checked for that, too: support/canonical.cpp.)
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

#include "support/effort.h"
#include "support/insert_into.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

class IdenticalSites : public testing::Test {
 protected:
  /// One of 24 circles: many are identical, nested, or in line.
  [[nodiscard]] Circle someCircle() {
    const auto whole = [this](std::size_t below) {
      return static_cast<double>(random_.below(below));
    };
    return {whole(3), whole(2), random_.below(4) == 0 ? 3 : whole(2)};
  }
  [[nodiscard]] SiteId someId() {
    return std::next(circles_.begin(), static_cast<std::ptrdiff_t>(random_.below(circles_.size())))
        ->first;
  }

  void insertOne() {
    const Circle c = someCircle();
    SiteId id = kNoSite;
    ASSERT_EQ(diagram_.insert(c.x, c.y, c.r, id), Error::kNone);
    circles_[id] = c;
  }
  void insertSeveral() {
    Circles more;
    for (std::size_t k = random_.below(12); k > 0; --k) more.push_back(someCircle());
    const std::vector<SiteId> ids = insertInto(diagram_, more);
    for (std::size_t k = 0; k < ids.size(); ++k) circles_[ids[k]] = more[k];
  }
  void removeSome(std::size_t most) {
    std::vector<SiteId> ids;
    for (std::size_t k = 0; k < most && !circles_.empty(); ++k) {
      ids.push_back(someId());
      circles_.erase(ids.back());
    }
    std::size_t removed = 0;
    ASSERT_EQ(diagram_.removeMany(ids, removed), Error::kNone);
    ASSERT_EQ(removed, ids.size());
  }
  void moveSome(std::size_t most) {
    if (circles_.empty()) return;
    std::vector<SiteId> ids;
    std::vector<double> xyr;
    for (std::size_t k = 0; k < most; ++k) {
      const Circle c = someCircle();
      ids.push_back(someId());
      xyr.insert(xyr.end(), {c.x, c.y, c.r});
      circles_[ids.back()] = c;
    }
    ASSERT_EQ(diagram_.updateMany(ids, xyr), Error::kNone);
  }
  void restore() {
    std::vector<std::uint8_t> bytes;
    ASSERT_EQ(diagram_.toBytes(bytes), Error::kNone);
    Diagram restored;
    ASSERT_EQ(restored.fromBytes(bytes), Error::kNone);
    std::swap(diagram_, restored);
  }

  void expectLeastIds() {
    std::map<std::array<double, 3>, SiteId> first;
    for (const auto& [id, c] : circles_) first.try_emplace({c.x, c.y, c.r}, id);
    for (const auto& [id, c] : circles_) {
      bool isHidden = false;
      ASSERT_EQ(diagram_.isHidden(id, isHidden), Error::kNone);
      ASSERT_TRUE(isHidden || first.at({c.x, c.y, c.r}) == id) << "site " << id;
    }
    // A fresh diagram, whose ids have the same order, says the same of each.
    Diagram fresh;
    for (const auto& [id, c] : circles_) {
      SiteId there = kNoSite;
      ASSERT_EQ(fresh.insert(c.x, c.y, c.r, there), Error::kNone);
    }
    SiteId there = 0;
    for (const auto& [id, c] : circles_) {
      bool isHidden = false, isHiddenThere = false;
      ASSERT_EQ(diagram_.isHidden(id, isHidden), Error::kNone);
      ASSERT_EQ(fresh.isHidden(there++, isHiddenThere), Error::kNone);
      ASSERT_EQ(isHidden, isHiddenThere) << "site " << id;
    }
    // All sites around a point: identical ones together, ascending.
    std::vector<SiteId> sites;
    ASSERT_EQ(diagram_.kNearest(0.25, 0.5, circles_.size(), sites), Error::kNone);
    ASSERT_EQ(sites.size(), circles_.size());
    for (std::size_t k = 1; k < sites.size(); ++k) {
      const Circle &a = circles_.at(sites[k - 1]), &b = circles_.at(sites[k]);
      const bool areIdentical = a.x == b.x && a.y == b.y && a.r == b.r;
      ASSERT_TRUE(!areIdentical || sites[k - 1] < sites[k]);
    }
    std::string broken;
    ASSERT_EQ(diagram_.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
  }

  Random random_{67};
  Diagram diagram_;
  std::map<SiteId, Circle> circles_;
};

TEST_F(IdenticalSites, TheLeastIdIsVisibleAfterAnyHistory) {
  for (int round = 0; round < sized(60, 2000); ++round) {
    SCOPED_TRACE(round);
    diagram_.clear();
    circles_.clear();
    for (int step = 0; step < 40; ++step) {
      switch (random_.below(7)) {
        case 0:
        case 1:
          insertOne();
          break;
        case 2:
          insertSeveral();
          break;
        case 3:
          removeSome(1);
          break;
        case 4:
          removeSome(4);
          break;
        case 5:
          moveSome(1 + random_.below(3));
          break;
        default:
          if (random_.below(4) == 0) {
            restore();
          } else {
            moveSome(circles_.size());
          }
      }
      expectLeastIds();
      if (HasFatalFailure()) return;
    }
  }
}

TEST_F(IdenticalSites, AFreedIdTakesThePlaceOfALargerOne) {
  (void)insertInto(diagram_, {{9, 9, 1}, {0, 0, 1}, {5, 0, 1}, {0, 5, 2}});
  bool removed = false, isHidden = true;
  ASSERT_EQ(diagram_.remove(0, removed), Error::kNone);
  SiteId id = kNoSite;
  ASSERT_EQ(diagram_.insert(0, 0, 1, id), Error::kNone);
  ASSERT_EQ(id, 0u);
  ASSERT_EQ(diagram_.isHidden(0, isHidden), Error::kNone);
  EXPECT_FALSE(isHidden);
  SiteId cover = kNoSite;
  ASSERT_EQ(diagram_.coverOf(1, cover), Error::kNone);
  EXPECT_EQ(cover, 0u);
  ASSERT_EQ(diagram_.remove(0, removed), Error::kNone);
  ASSERT_EQ(diagram_.isHidden(1, isHidden), Error::kNone);
  EXPECT_FALSE(isHidden);
}

}  // namespace
}  // namespace apollonius::test
