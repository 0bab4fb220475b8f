// HiddenForest against a model that keeps each node's children as a list; and as a heap, with its
// questions counted.
#include "diagram/hidden_forest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;
using Node = HiddenForest::Node;
constexpr Node kNone = HiddenForest::kNone;

std::vector<Node> children(const HiddenForest& forest, Node n) {
  std::vector<Node> all;
  for (Node child = forest.firstChild(n); child != kNone; child = forest.nextSibling(child))
    all.push_back(child);
  return all;
}

using List = std::vector<Node>;

/// Nobody covers anybody.
constexpr auto kApart = [](Node, Node) { return false; };

TEST(HiddenForest, ChildrenAreInTheOrderOfAttachment) {
  HiddenForest forest;
  forest.reserve(5);
  forest.reserveChildren(5);
  EXPECT_EQ(children(forest, 0), List{});
  for (const Node child : {3u, 1u, 2u}) forest.attach(child, 0);
  EXPECT_EQ(children(forest, 0), (List{3, 1, 2}));
}

TEST(HiddenForest, ParentsAreKnownNearTheEndOfTheList) {
  HiddenForest forest;
  forest.reserve(50);
  forest.reserveChildren(49);
  for (Node child = 1; child < 50; ++child) forest.attach(child, 0);
  EXPECT_EQ(forest.parentIfNear(49), 0u);
  EXPECT_EQ(forest.parentIfNear(40), 0u);
  EXPECT_EQ(forest.parentIfNear(1), kNone);
}

TEST(HiddenForest, DetachTakesTheSubtreeAlong) {
  HiddenForest forest;
  forest.reserve(6);
  forest.reserveChildren(6);
  for (const Node child : {1u, 2u, 3u}) forest.attach(child, 0);
  forest.attach(4, 2);
  forest.detach(2);
  EXPECT_EQ(children(forest, 0), (List{1, 3}));
  EXPECT_EQ(children(forest, 2), List{4});
  forest.attach(2, 5);
  EXPECT_EQ(children(forest, 5), List{2});
  forest.detach(1);
  forest.detach(3);
  EXPECT_EQ(children(forest, 0), List{});
}

TEST(HiddenForest, DissolveLeavesManyChildrenInItsPlaceAndHangsFewAnew) {
  HiddenForest forest;
  forest.reserve(9);
  forest.reserveChildren(9);
  for (const Node child : {1u, 2u, 3u}) forest.attach(child, 0);
  for (const Node child : {4u, 5u, 8u}) forest.attach(child, 2);
  forest.attach(6, 5);
  forest.dissolve(2, kApart);
  EXPECT_EQ(children(forest, 0), (List{1, 4, 5, 8, 3}));
  EXPECT_EQ(children(forest, 5), List{6});
  EXPECT_EQ(children(forest, 2), List{});
  // At the ends, where links lead to the parent, and alone.
  forest.dissolve(3, kApart);
  forest.dissolve(1, kApart);
  forest.dissolve(4, kApart);
  EXPECT_EQ(children(forest, 0), (List{5, 8}));
  forest.dissolve(5, kApart);
  EXPECT_EQ(children(forest, 0), (List{8, 6}));
  forest.dissolve(8, kApart);
  forest.dissolve(6, kApart);
  EXPECT_EQ(children(forest, 0), List{});
}

TEST(HiddenForest, ClearForgetsAll) {
  HiddenForest forest;
  forest.reserve(3);
  forest.reserveChildren(3);
  forest.attach(1, 0);
  forest.attach(2, 1);
  forest.clear();
  for (Node n = 0; n < 3; ++n) EXPECT_EQ(children(forest, n), List{});
}

TEST(HiddenForest, RecordsAreUsedAgain) {
  constexpr Node kNodes = 1000;
  HiddenForest forest;
  forest.reserve(kNodes);
  forest.reserveChildren(2);  // never more are needed below; records beyond the room would be
                              // written out of bounds (sanitizers)
  for (Node parent = 0; parent + 2 < kNodes; ++parent) {
    forest.attach(parent + 1, parent);
    forest.attach(parent + 2, parent);
    EXPECT_EQ(children(forest, parent), (List{parent + 1, parent + 2}));
    forest.detach(parent + 2);
    forest.dissolve(parent + 1, kApart);
    EXPECT_EQ(children(forest, parent), List{});
  }
}

TEST(HiddenForest, RandomHistoriesAgreeWithTheModel) {
  constexpr Node kNodes = 30;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    HiddenForest forest;
    std::vector<List> childrenOf(kNodes);
    std::vector<Node> parentOf(kNodes, kNone);
    forest.reserve(kNodes / 2);
    forest.reserve(kNodes);
    const auto root = [&](Node n) {
      while (parentOf[n] != kNone) n = parentOf[n];
      return n;
    };
    for (int step = 0; step < 400; ++step) {
      const auto n = static_cast<Node>(random.below(kNodes));
      if (parentOf[n] == kNone) {
        const auto parent = static_cast<Node>(random.below(kNodes));
        if (root(parent) == n) continue;
        forest.reserveChildren(1);
        forest.attach(n, parent);
        childrenOf[parent].push_back(n);
        parentOf[n] = parent;
      } else {
        List& siblings = childrenOf[parentOf[n]];
        const bool isNear = forest.parentIfNear(n) != kNone;
        auto place = siblings.erase(std::find(siblings.begin(), siblings.end(), n));
        if (random.oneIn(2)) {
          forest.detach(n);
        } else {
          forest.dissolve(n, kApart);
          if (isNear && childrenOf[n].size() <= 2) place = siblings.end();
          siblings.insert(place, childrenOf[n].begin(), childrenOf[n].end());
          for (const Node child : childrenOf[n]) parentOf[child] = parentOf[n];
          childrenOf[n].clear();
        }
        parentOf[n] = kNone;
      }
      for (Node k = 0; k < kNodes; ++k)
        ASSERT_EQ(children(forest, k), childrenOf[k]) << "node " << k << ", step " << step;
    }
  }
}

// --- As a heap

/// A family of nested sites under one visible one, as the diagram treats it: a number covers the
/// numbers that are not larger.
class Chain {
 public:
  explicit Chain(Node nodes) : value_(nodes, 0) {
    forest_.reserve(nodes);
    forest_.reserveChildren(nodes);
    for (Node n = nodes; n-- > 0;) free_.push_back(n);
  }

  void insert(int value) {
    const Node n = free_.back();
    free_.pop_back();
    value_[n] = value;
    if (top_ == kNone || value > value_[top_]) {
      if (top_ != kNone) {
        forest_.attach(top_, n);
        hidden_.push_back(top_);
      }
      top_ = n;
    } else {
      link(n, top_);
      hidden_.push_back(n);
    }
    values_.insert(value);
  }

  void removeTop() {
    ASSERT_EQ(value_[top_], *values_.rbegin());
    values_.erase(std::prev(values_.end()));
    List heirs = children(forest_, top_);
    const auto isSmaller = [&](Node a, Node b) { return value_[a] < value_[b]; };
    if (!heirs.empty())
      std::iter_swap(heirs.begin(), std::max_element(heirs.begin(), heirs.end(), isSmaller));
    for (const Node heir : heirs) forest_.detach(heir);
    for (std::size_t k = 1; k < heirs.size(); ++k) link(heirs[k], heirs[0]);
    free_.push_back(top_);
    top_ = heirs.empty() ? kNone : heirs[0];
    hidden_.erase(std::remove(hidden_.begin(), hidden_.end(), top_), hidden_.end());
  }

  void removeHidden(std::size_t k) {
    const Node n = hidden_[k];
    hidden_.erase(hidden_.begin() + static_cast<std::ptrdiff_t>(k));
    values_.erase(values_.find(value_[n]));
    forest_.dissolve(n, [this](Node a, Node b) { return covers(a, b); });
    hung_ += 2;
    free_.push_back(n);
  }

  [[nodiscard]] std::size_t hiddenCount() const { return hidden_.size(); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] double questionsPerSite() const {
    return static_cast<double>(questions_) / static_cast<double>(hung_);
  }

  /// Every site is reached, no one has more than two children, and parents cover them.
  void check() const {
    List reached;
    if (top_ != kNone) reached.push_back(top_);
    for (std::size_t k = 0; k < reached.size(); ++k) {
      const List below = children(forest_, reached[k]);
      ASSERT_LE(below.size(), 2u);
      for (const Node n : below) ASSERT_LE(value_[n], value_[reached[k]]);
      reached.insert(reached.end(), below.begin(), below.end());
      ASSERT_LE(reached.size(), values_.size());
    }
    ASSERT_EQ(reached.size(), values_.size());
  }

 private:
  bool covers(Node a, Node b) {
    ++questions_;
    return value_[a] >= value_[b];
  }
  void link(Node n, Node parent) {
    ++hung_;
    forest_.link(n, parent, [this](Node a, Node b) { return covers(a, b); });
  }

  HiddenForest forest_;
  std::vector<int> value_;
  List free_, hidden_;
  Node top_ = kNone;
  std::multiset<int> values_;
  std::size_t questions_ = 0, hung_ = 1;
};

TEST(HiddenForest, NestedSitesHaveTwoChildrenAfterAnyHistory) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Chain chain(60);
    const int values = seed % 3 == 0 ? 1 : seed % 3 == 1 ? 10 : 1000;
    for (int step = 0; step < 300; ++step) {
      const bool grows = chain.size() < 60 &&
                         (chain.size() < 3 || random.below(step / 50 % 2 == 0 ? 10u : 20u) < 7);
      if (grows) {
        chain.insert(static_cast<int>(random.below(values)));
      } else if (random.oneIn(2)) {
        chain.removeTop();
      } else if (chain.hiddenCount() > 0) {
        chain.removeHidden(random.below(chain.hiddenCount()));
      }
      chain.check();
      if (HasFatalFailure()) FAIL() << "step " << step;
    }
  }
}

// The bound of hidden_forest.h with its constant: 2 log2 T light steps and as many paid by the
// potential, two questions each.
TEST(HiddenForest, NestedSitesAskLogarithmicallyManyQuestions) {
  for (const int order : {0, 1, 2, 3}) {
    for (const Node n : {1000u, 2000u, 16000u}) {
      Random random(n);
      Chain chain(n);
      std::vector<int> values;
      for (Node k = 0; k < n; ++k)
        values.push_back(order == 3 ? 7 : static_cast<int>(order == 1 ? n - k : k));
      if (order == 2) random.shuffle(values);
      for (const int value : values) chain.insert(value);
      chain.check();
      for (Node k = 0; k < n / 4; ++k) chain.removeHidden(random.below(chain.hiddenCount()));
      for (Node k = 0; k < n / 4; ++k) chain.removeTop();
      chain.check();
      while (chain.size() > 1) {  // for two that go one comes, as the smallest
        chain.removeTop();
        chain.removeTop();
        chain.insert(-static_cast<int>(chain.size()));
      }
      if (HasFatalFailure()) return;
      EXPECT_LT(chain.questionsPerSite(), 4 * std::log2(n)) << "order " << order << ", n " << n;
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
