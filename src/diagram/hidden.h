// The forest of hidden sites: each hangs on a site that covers it, which may be hidden itself. A site that becomes hidden keeps
// what hangs on it, so that covering costs O(1), and removing a site concerns only what hangs on it directly. (The paper's
// lists, section 3.3, hang everything on visible sites and pay O(n) for the removal of a hidden one.)
//
// Children form a list with both ends known to the parent; the ends name the parent where there is no further sibling, so that
// taking a site out, with its children put in its place, needs no search.
//
// Most sites neither hide nor are hidden: such a node costs one word. The others have a record, and there are at most two records
// a hidden site: its own, and that of its parent. Records come in small blocks, which need no second copy to grow.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "memory/flat_array.h"

namespace apollonius {

class HiddenForest {
 public:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xFFFFFFFFu;

  void reserve(std::size_t nodes) {
    if (records_.size() < nodes) records_.resize(nodes, kNone);
  }
  /// Room for so many more children than there are.
  void reserveChildren(std::size_t more);

  [[nodiscard]] Node firstChild(Node n) const { return hasRecord(n) ? links(n).firstChild : kNone; }
  /// Of a child.
  [[nodiscard]] Node nextSibling(Node n) const { return isEnd(links(n).after) ? kNone : links(n).after; }

  /// Does it hang on another?
  [[nodiscard]] bool isChild(Node n) const { return hasRecord(n) && links(n).before != kNone; }

  /// Of a node that is not a root; or kNone, for it is known at the end of a list of siblings only, and that may be far.
  [[nodiscard]] Node parentIfNear(Node n) const {
    for (int k = 0; k < 16; ++k, n = links(n).after) {
      if (isEnd(links(n).after)) return links(n).after & ~kEnd;
    }
    return kNone;
  }

  /// Hangs a root on `parent`, as its last child, with all that hangs on it. REQUIRES: room (reserveChildren).
  void attach(Node child, Node parent);

  /// Takes a child off its parent, with all that hangs on it.
  void detach(Node child) {
    replace(child, kNone, kNone);
    releaseIfAlone(child);
    --children_;
  }

  /// Takes a child off its parent and hangs its own children in its place.
  void dissolve(Node child);

  /// Forgets everything but the room.
  void clear();

 private:
  // A sibling, or the parent with the top bit set at the ends of the list. Ids stay below 2^31.
  static constexpr Node kEnd = 0x80000000u;
  static constexpr bool isEnd(Node link) { return (link & kEnd) != 0; }

  struct Links {
    Node firstChild = kNone;  // of a free record: the next free one
    Node lastChild = kNone;
    Node before = kNone;
    Node after = kNone;
  };

  [[nodiscard]] bool hasRecord(Node n) const { return n < records_.size() && records_[n] != kNone; }
  [[nodiscard]] Links& links(Node n) const { return blocks_[records_[n] / kBlock][records_[n] % kBlock]; }
  void ensureRecord(Node n);
  void releaseIfAlone(Node n);

  /// Puts the list first … last (or nothing) in the place of child.
  void replace(Node child, Node first, Node last);

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

inline void HiddenForest::attach(Node child, Node parent) {
  ensureRecord(child);
  ensureRecord(parent);
  Links& p = links(parent);
  Links& c = links(child);
  c.after = kEnd | parent;
  c.before = p.lastChild != kNone ? p.lastChild : kEnd | parent;
  (p.lastChild != kNone ? links(p.lastChild).after : p.firstChild) = child;
  p.lastChild = child;
  ++children_;
}

inline void HiddenForest::dissolve(Node child) {
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

}  // namespace apollonius
