#include "geometry/window/ring_nesting.h"

#include <algorithm>
#include <bit>

#include "base/infinite.h"

namespace apollonius::internal {

namespace {

/// Up to this many rings need not be sorted.
constexpr std::size_t kFewRings = 8;
/// Rings are divided by position if their boxes are on average more than this many times smaller
/// than the box of all.
constexpr double kSmaller = 4;

constexpr Rectangle kNothing{kInfinite, kInfinite, -kInfinite, -kInfinite};

void include(Rectangle& box, const Rectangle& other) {
  box.include({other.xmin, other.ymin});
  box.include({other.xmax, other.ymax});
}

}  // namespace

struct RingNesting::Search {
  Point p;
  double area;
  std::uint32_t found = kNoRing;
  double smallest = kInfinite;
};

void RingNesting::clear() {
  entries_.clear();
  nodes_.clear();
  rootOf_.clear();
}

std::uint32_t RingNesting::find(Point p, double area) {
  if (entries_.empty()) return kNoRing;
  if (nodes_.empty()) {
    FlatArray<Keyed> order;
    for (std::uint32_t k = 0; k < entries_.size(); ++k) order.push_back({0, k});
    plant(std::span(order.data(), order.size()));
  }
  Search search{p, area};
  this->search(0, entries_.size(), search);
  return search.found;
}

/// A sort key that grows with x. REQUIRES: x >= 0.
std::uint32_t RingNesting::keyOf(double x) {
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x + 0.0) >> 32);
}

std::uint32_t RingNesting::plant(std::span<Keyed> rings) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  Node node{kNothing, kInfinite, 0, rings[0].value};
  double width = 0, height = 0;
  for (const Keyed& ring : rings) {
    const Entry& entry = entries_[ring.value];
    include(node.box, entry.box);
    node.first = std::min(node.first, entry.area);
    node.last = std::max(node.last, entry.area);
    width += entry.box.width();
    height += entry.box.height();
  }
  nodes_.push_back(node);
  if (rings.size() == 1) return number;
  if (rings.size() > kFewRings) {
    const auto count = static_cast<double>(rings.size());
    const double across = node.box.width() * count / width, up = node.box.height() * count / height;
    for (Keyed& ring : rings) {
      const Entry& entry = entries_[ring.value];
      ring.key = keyOf(!(std::max(across, up) > kSmaller) ? entry.area
                       : across > up                      ? entry.box.xmin - node.box.xmin
                                                          : entry.box.ymin - node.box.ymin);
    }
    FlatArray<Keyed> sorted;
    sorted.assign(rings);
    sortByKey(sorted);
    std::copy(sorted.begin(), sorted.end(), rings.begin());
  }
  const std::size_t half = rings.size() / 2;
  plant(rings.first(half));
  const std::uint32_t right = plant(rings.subspan(half));
  nodes_[number].right = right;
  return number;
}

void RingNesting::search(std::uint32_t number, std::size_t count, Search& search) {
  ++looks_;
  const Node node = nodes_[number];  // a copy: trees of pieces can move the array
  if (!(node.last > search.area) || node.first > search.smallest || !node.box.holds(search.p))
    return;
  if (count > 1) {
    this->search(number + 1, count / 2, search);
    this->search(node.right, count - count / 2, search);
    return;
  }
  const std::uint32_t ring = entries_[node.right].ring;
  if ((node.first == search.smallest && ring > search.found) || !rings_.isAround(ring)) return;
  search.found = ring;
  search.smallest = node.first;
}

bool RingNesting::isInside(std::uint32_t ring, Point p) {
  if (ring >= rootOf_.size()) rootOf_.resize(ring + std::size_t{1}, 0);
  const std::size_t count = rings_.pieceCount(ring);
  if (rootOf_[ring] == 0) rootOf_[ring] = plantRow(ring, 0, count);
  return isOdd(rootOf_[ring], ring, 0, count, p);
}

std::uint32_t RingNesting::plantRow(std::uint32_t ring, std::size_t begin, std::size_t count) {
  ++looks_;
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  if (count == 1) {
    const auto [from, aside, to] = rings_.piece(ring, begin);
    Rectangle box{from.x, from.y, from.x, from.y};
    box.include(aside);
    box.include(to);
    nodes_.push_back({box, from.y, to.y, 0});
    return number;
  }
  nodes_.push_back({});
  plantRow(ring, begin, count / 2);
  const std::uint32_t right = plantRow(ring, begin + count / 2, count - count / 2);
  const Node &a = nodes_[number + 1], &b = nodes_[right];
  Node node{a.box, a.first, b.last, right};
  include(node.box, b.box);
  // Rounding can leave a gap between two pieces. Then no point counts as having all on its right.
  if (a.last != b.first) node.box.xmin = -kInfinite;
  nodes_[number] = node;
  return number;
}

bool RingNesting::isOdd(std::uint32_t number, std::uint32_t ring, std::size_t begin,
                        std::size_t count, Point p) {
  ++looks_;
  const Node& node = nodes_[number];
  if (p.y < node.box.ymin || p.y > node.box.ymax || p.x > node.box.xmax) return false;
  if (p.x < node.box.xmin) return (node.first > p.y) != (node.last > p.y);
  if (count == 1) return rings_.isCrossed(ring, begin, p);
  const std::size_t half = count / 2;
  return isOdd(number + 1, ring, begin, half, p) !=
         isOdd(node.right, ring, begin + half, count - half, p);
}

}  // namespace apollonius::internal
