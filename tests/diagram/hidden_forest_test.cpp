// HiddenForest against a model that keeps each node's children as a list.
#include "diagram/hidden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/random.h"

namespace apollonius {
namespace {

using test::Random;
using Node = HiddenForest::Node;
constexpr Node kNone = HiddenForest::kNone;

std::vector<Node> children(const HiddenForest& forest, Node n) {
  std::vector<Node> all;
  for (Node child = forest.firstChild(n); child != kNone; child = forest.nextSibling(child)) all.push_back(child);
  return all;
}

using List = std::vector<Node>;

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

TEST(HiddenForest, DissolveLeavesTheChildrenInItsPlace) {
  HiddenForest forest;
  forest.reserve(8);
  forest.reserveChildren(8);
  for (const Node child : {1u, 2u, 3u}) forest.attach(child, 0);
  for (const Node child : {4u, 5u}) forest.attach(child, 2);
  forest.attach(6, 5);
  forest.dissolve(2);
  EXPECT_EQ(children(forest, 0), (List{1, 4, 5, 3}));
  EXPECT_EQ(children(forest, 5), List{6});
  EXPECT_EQ(children(forest, 2), List{});
  // At the ends, where links lead to the parent, and alone.
  forest.dissolve(3);
  forest.dissolve(1);
  forest.dissolve(4);
  EXPECT_EQ(children(forest, 0), List{5});
  forest.dissolve(5);
  EXPECT_EQ(children(forest, 0), List{6});
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
  forest.reserveChildren(2);  // what follows has never more; records beyond the room would be written out of bounds (sanitizers)
  for (Node parent = 0; parent + 2 < kNodes; ++parent) {
    forest.attach(parent + 1, parent);
    forest.attach(parent + 2, parent);
    EXPECT_EQ(children(forest, parent), (List{parent + 1, parent + 2}));
    forest.detach(parent + 2);
    forest.dissolve(parent + 1);
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
        auto place = siblings.erase(std::find(siblings.begin(), siblings.end(), n));
        if (random.oneIn(2)) {
          forest.detach(n);
        } else {
          forest.dissolve(n);
          siblings.insert(place, childrenOf[n].begin(), childrenOf[n].end());
          for (const Node child : childrenOf[n]) parentOf[child] = parentOf[n];
          childrenOf[n].clear();
        }
        parentOf[n] = kNone;
      }
      for (Node k = 0; k < kNodes; ++k) ASSERT_EQ(children(forest, k), childrenOf[k]) << "node " << k << ", step " << step;
    }
  }
}

}  // namespace
}  // namespace apollonius
