// The forest of hidden sites: each hangs on a site that covers it, which may be hidden itself. A
// site that becomes hidden keeps what hangs on it, so that covering costs O(1), and removing a site
// concerns only what hangs on it directly. (The paper's lists, section 3.3, hang everything on
// visible sites and pay O(n) for the removal of a hidden one.)
//
// If all new sites were hung on the visible site itself, its removal would have to examine each. So
// link() makes a skew heap of those that cover each other (Sleator and Tarjan, Self-adjusting
// heaps, 1986), which stores only the order of the children: a site that has kFew children compares
// the next one with its last child; the smaller of the two is linked below the larger, which moves
// to the front, so that another child is the last one next time. If neither covers the other, the
// new one becomes another child.
//
// Guarantees after any history, T being the number of insertions since clear():
//  1. In a family in which of any two sites one covers the other (duplicates, concentric circles,
//     circles that touch in one point from inside), no site has more than kFew children. For link()
//     puts a site beside kFew others only if it has compared it with one of them; dissolve() hangs
//     the children of such a site anew; and of the children of a visible site that is removed, the
//     largest gets the others (DiagramCore::detachVisible). This excludes sites that have been
//     moved in place, which may change which of them cover each other.
//  2. link() makes O(log T) comparisons amortised, whatever the family.
//     Proof. Let each site weigh 1 when it comes, and a hidden one that is dissolved leave its
//     weight to its parent. A tree weighs what its sites weigh; a child is heavy if its tree weighs
//     more than half of its parent's. The potential is the number of sites whose last child is
//     heavy. link() goes down two trees, that of the parent and that of the new site, always to a
//     last child. Each step compares the last child of one site, which then is the first child, or
//     has been replaced by the first. If it was heavy, the last one is not heavy now, as the others
//     together weigh less than half and the whole has not become lighter: the potential pays. If it
//     was not, its tree weighs at most half of its parent's: that happens at most log2 T times in
//     each tree, and the potential grows by at most 1. The last comparison and the new link cost
//     O(1). Covering, detaching and dissolving change one list of children each, and no weight
//     above it: the site hung on is then visible, or dissolve's parent, or a child of the site that
//     is being removed. []
// So a removal from such a family costs O(log T) amortised. In general it costs what the m direct
// children cost: they may be m sites that cover no other, and only the diagram of all tells which
// become visible. Each of the others is then hung on a site that covers it, so that it is examined
// again only when that one is removed.
//
// A site may hang on an identical one with a lesser id (DiagramCore::mayHang).
// So of identical sites the one with the least id is visible, if any is. Proof. A site that is
// inserted takes the place of an identical visible one with a larger id. Else let s become visible
// as its parent p is removed, and let t be identical to s. The visible site above t covers t, hence
// s, so that it was p. Let c be t, or what is above t and hangs on p. After the removal c is
// visible or covered by a visible site, which covers s then, and so is s. Hence c is identical to
// s, and so is all between c and t; ids ascend on that way. Of identical children of p only that
// with the least id becomes visible (DiagramCore::reparentNestedChildren): it is s. []
//
// Children form a list with both ends known to the parent; the ends name the parent where there is
// no further sibling, so that replacing a site by its children needs no search.
//
// Most sites neither hide nor are hidden: such a node costs one word. The others have a record, and
// there are at most two records a hidden site: its own, and that of its parent. Records come in
// small blocks, which need no second copy to grow.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/flat_array.h"

namespace apollonius::internal {

class HiddenForest {
 public:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xFFFFFFFFu;

  void reserve(std::size_t nodes) {
    if (records_.size() < nodes) records_.resize(nodes, kNone);
  }
  /// Makes room for this many more children than there are.
  void reserveChildren(std::size_t more);

  [[nodiscard]] Node firstChild(Node n) const { return hasRecord(n) ? links(n).firstChild : kNone; }
  /// Next sibling, or kNone. REQUIRES: a child.
  [[nodiscard]] Node nextSibling(Node n) const {
    return isEnd(links(n).after) ? kNone : links(n).after;
  }

  /// Does a site hang on another?
  [[nodiscard]] bool isChild(Node n) const { return hasRecord(n) && links(n).before != kNone; }

  /// The parent of a node that is not a root, or kNone if it is not found within 16 siblings: the
  /// last sibling knows it.
  [[nodiscard]] Node parentIfNear(Node n) const {
    for (int k = 0; k < 16; ++k, n = links(n).after) {
      if (isEnd(links(n).after)) return links(n).after & ~kEnd;
    }
    return kNone;
  }

  /// Hangs a root on `parent`, as its last child, with all that hangs on it. REQUIRES: room
  /// (reserveChildren).
  void attach(Node child, Node parent) { insertBefore(kEnd | parent, child, parent); }

  /// Hangs a root on `parent` or below, and perhaps a site from below `parent` on the root, as
  /// described above. covers(a, b): may b hang on a? A strict partial order, which must not throw.
  /// REQUIRES: covers(parent, child), and room.
  template <class Covers>
  void link(Node child, Node parent, Covers covers);

  /// Takes a child off its parent, with all that hangs on it.
  void detach(Node child) {
    replace(child, kNone, kNone);
    releaseIfAlone(child);
    --children_;
  }

  /// Takes a child off its parent and hangs its own children there: in its place, or one by one if
  /// there are few. Cost: O(1), or that of hanging these.
  template <class Covers>
  void dissolve(Node child, Covers covers);

  /// Forgets everything but the room.
  void clear();

 private:
  // A sibling, or the parent with the top bit set at the ends of the list. Ids stay below 2^31.
  static constexpr Node kEnd = 0x80000000u;
  static constexpr bool isEnd(Node link) { return (link & kEnd) != 0; }

  struct Links {
    Node firstChild = kNone;  // in a free record: the next free one
    Node lastChild = kNone;
    Node before = kNone;
    Node after = kNone;
  };

  [[nodiscard]] bool hasRecord(Node n) const { return n < records_.size() && records_[n] != kNone; }
  [[nodiscard]] Links& links(Node n) const {
    return blocks_[records_[n] / kBlock][records_[n] % kBlock];
  }
  void ensureRecord(Node n);
  void releaseIfAlone(Node n);

  /// Hangs a root on `parent`, before the child `sibling`, or as the last one if that is kEnd |
  /// parent.
  void insertBefore(Node sibling, Node child, Node parent);

  /// Replaces a child by the list first … last, or by nothing.
  void replace(Node child, Node first, Node last);

  /// Number of children that a site takes without comparing them.
  static constexpr int kFew = 2;
  [[nodiscard]] bool hasFew(Node parent, int few) const {
    for (Node child = firstChild(parent); child != kNone; child = nextSibling(child)) {
      if (few-- == 0) return false;
    }
    return true;
  }

  static constexpr std::uint32_t kBlock = 128;

  FlatArray<std::uint32_t> records_;  // by node, or kNone
  std::vector<std::unique_ptr<Links[]>> blocks_;
  std::uint32_t taken_ = 0;  // records from here on have never been used since clear()
  std::uint32_t firstFree_ = kNone;
  std::size_t children_ = 0;
};

inline void HiddenForest::reserveChildren(std::size_t more) {
  const std::size_t needed = std::min(records_.size(), 2 * (children_ + more));
  while (blocks_.size() * kBlock < needed) blocks_.push_back(std::make_unique<Links[]>(kBlock));
}

inline void HiddenForest::ensureRecord(Node n) {
  if (hasRecord(n)) return;
  if (firstFree_ == kNone) {
    records_[n] = taken_++;
  } else {
    records_[n] = firstFree_;
    firstFree_ = links(n).firstChild;
  }
  links(n) = Links{};
}

inline void HiddenForest::releaseIfAlone(Node n) {
  Links& l = links(n);
  if (l.firstChild != kNone || l.before != kNone) return;
  l.firstChild = firstFree_;
  firstFree_ = records_[n];
  records_[n] = kNone;
}

inline void HiddenForest::insertBefore(Node sibling, Node child, Node parent) {
  ensureRecord(child);
  ensureRecord(parent);
  Links& c = links(child);
  Node& behind = isEnd(sibling) ? links(parent).lastChild
                                : links(sibling).before;  // names the node before child now
  c.after = sibling;
  c.before = behind != kNone ? behind : kEnd | parent;
  behind = child;
  (isEnd(c.before) ? links(parent).firstChild : links(c.before).after) = child;
  ++children_;
}

template <class Covers>
void HiddenForest::link(Node child, Node parent, Covers covers) {
  while (!hasFew(parent, kFew - 1)) {
    const Node last = links(parent).lastChild;
    if (covers(child, last)) {
      detach(last);
      insertBefore(firstChild(parent), child, parent);
      parent = child;
      child = last;
    } else if (covers(last, child)) {
      detach(last);
      insertBefore(firstChild(parent), last, parent);
      parent = last;
    } else {
      break;
    }
  }
  attach(child, parent);
}

template <class Covers>
void HiddenForest::dissolve(Node child, Covers covers) {
  const Node parent = hasFew(child, kFew) ? parentIfNear(child) : kNone;
  if (parent != kNone) {
    detach(child);
    for (Node first = firstChild(child); first != kNone; first = firstChild(child)) {
      detach(first);
      link(first, parent, covers);
    }
    return;
  }
  Links& c = links(child);
  const Node first = c.firstChild, last = c.lastChild;
  c.firstChild = c.lastChild = kNone;
  replace(child, first, last);
  releaseIfAlone(child);
  --children_;
}

inline void HiddenForest::replace(Node child, Node first, Node last) {
  Links& c = links(child);
  const Node before = c.before, after = c.after;
  c.before = c.after = kNone;
  if (first != kNone) {
    links(first).before = before;
    links(last).after = after;
  }
  const bool alone = isEnd(before) && isEnd(after);
  const Node head = first != kNone ? first : alone ? kNone : after;
  const Node tail = last != kNone ? last : alone ? kNone : before;
  (isEnd(before) ? links(before & ~kEnd).firstChild : links(before).after) = head;
  (isEnd(after) ? links(after & ~kEnd).lastChild : links(after).before) = tail;
  if (head == kNone) releaseIfAlone(before & ~kEnd);
}

inline void HiddenForest::clear() {
  records_.assign(records_.size(), kNone);
  taken_ = 0;
  firstFree_ = kNone;
  children_ = 0;
}

}  // namespace apollonius::internal
