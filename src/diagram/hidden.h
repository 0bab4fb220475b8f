// The forest of hidden sites: each hangs on a site that covers it, which may be hidden itself. A site that becomes hidden keeps
// what hangs on it, so that covering costs O(1), and removing a site concerns only what hangs on it directly. (The paper's
// lists, section 3.3, hang everything on visible sites and pay O(n) for the removal of a hidden one.)
//
// Children form a list with both ends known to the parent; the ends name the parent where there is no further sibling, so that
// taking a site out, with its children put in its place, needs no search.
#pragma once

#include <cstdint>
#include <vector>

namespace apollonius {

class HiddenForest {
 public:
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xFFFFFFFFu;

  void reserve(std::size_t nodes) {
    if (links_.size() < nodes) links_.resize(nodes);
  }

  [[nodiscard]] Node firstChild(Node n) const { return links_[n].firstChild; }
  [[nodiscard]] Node nextSibling(Node n) const { return isEnd(links_[n].after) ? kNone : links_[n].after; }

  /// Of a node that is not a root; or kNone, for it is known at the end of a list of siblings only, and that may be far.
  [[nodiscard]] Node parentIfNear(Node n) const {
    for (int k = 0; k < 16; ++k, n = links_[n].after) {
      if (isEnd(links_[n].after)) return links_[n].after & ~kEnd;
    }
    return kNone;
  }

  /// Hangs a root on `parent`, as its last child, with all that hangs on it.
  void attach(Node child, Node parent);

  /// Takes a child off its parent, with all that hangs on it.
  void detach(Node child) { replace(child, kNone, kNone); }

  /// Takes a child off its parent and hangs its own children in its place.
  void dissolve(Node child);

  /// Forgets everything but the room.
  void clear() { links_.assign(links_.size(), Links{}); }

 private:
  // A sibling, or the parent with the top bit set at the ends of the list. Ids stay below 2^31.
  static constexpr Node kEnd = 0x80000000u;
  static constexpr bool isEnd(Node link) { return (link & kEnd) != 0; }

  struct Links {
    Node firstChild = kNone;
    Node lastChild = kNone;
    Node before = kNone;
    Node after = kNone;
  };

  /// Puts the list first … last (or nothing) in the place of child.
  void replace(Node child, Node first, Node last);

  std::vector<Links> links_;
};

inline void HiddenForest::attach(Node child, Node parent) {
  Links& p = links_[parent];
  Links& c = links_[child];
  c.after = kEnd | parent;
  c.before = p.lastChild != kNone ? p.lastChild : kEnd | parent;
  (p.lastChild != kNone ? links_[p.lastChild].after : p.firstChild) = child;
  p.lastChild = child;
}

inline void HiddenForest::dissolve(Node child) {
  Links& c = links_[child];
  const Node first = c.firstChild, last = c.lastChild;
  c.firstChild = c.lastChild = kNone;
  replace(child, first, last);
}

inline void HiddenForest::replace(Node child, Node first, Node last) {
  Links& c = links_[child];
  const Node before = c.before, after = c.after;
  c.before = c.after = kNone;
  if (first != kNone) {
    links_[first].before = before;
    links_[last].after = after;
  }
  const bool alone = isEnd(before) && isEnd(after);
  const Node head = first != kNone ? first : alone ? kNone : after;
  const Node tail = last != kNone ? last : alone ? kNone : before;
  (isEnd(before) ? links_[before & ~kEnd].firstChild : links_[before].after) = head;
  (isEnd(after) ? links_[after & ~kEnd].lastChild : links_[after].before) = tail;
}

}  // namespace apollonius
