#include "geometry/window/ring_nesting.h"

#include <algorithm>
#include <limits>

namespace apollonius::internal {

namespace {

/// So many are asked one by one.
constexpr std::size_t kFew = 4;
/// Boxes are parted by their places if they are this much smaller than all of them together, on the
/// average.
constexpr double kSmaller = 4;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr Rectangle kNothing{kInfinite, kInfinite, -kInfinite, -kInfinite};

void include(Rectangle& box, const Rectangle& other) {
  box.include({other.xmin, other.ymin});
  box.include({other.xmax, other.ymax});
}

bool isApart(const Rectangle& box, Point p) {
  return p.y < box.ymin || p.y > box.ymax || p.x > box.xmax;
}

bool areApart(double from, double to, double height) { return (from > height) != (to > height); }

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
  if (nodes_.empty()) plant(0, entries_.size());
  Search search{p, area};
  this->search(0, 0, entries_.size(), search);
  return search.found;
}

std::uint32_t RingNesting::plant(std::size_t begin, std::size_t end) {
  Node node{kNothing, kInfinite, 0, 0};
  double width = 0, height = 0;
  for (std::size_t k = begin; k < end; ++k) {
    const Entry& entry = entries_[k];
    include(node.box, entry.box);
    node.first = std::min(node.first, entry.area);
    node.last = std::max(node.last, entry.area);
    width += entry.box.width();
    height += entry.box.height();
  }
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(node);
  if (end - begin <= kFew) return number;
  const auto count = static_cast<double>(end - begin);
  const double across = node.box.width() * count, up = node.box.height() * count;
  const bool isAcross = across * height > up * width;
  const bool isByArea = !(isAcross ? across > kSmaller * width : up > kSmaller * height);
  const auto keyOf = [&](const Entry& entry) {
    return isByArea   ? entry.area
           : isAcross ? entry.box.xmin / 2 + entry.box.xmax / 2
                      : entry.box.ymin / 2 + entry.box.ymax / 2;
  };
  const std::size_t middle = begin + (end - begin) / 2;
  Entry* const all = entries_.data();
  std::partial_sort(all + begin, all + middle, all + end,
                    [&](const Entry& a, const Entry& b) { return keyOf(a) < keyOf(b); });
  plant(begin, middle);
  nodes_[number].right = plant(middle, end);
  return number;
}

void RingNesting::search(std::uint32_t number, std::size_t begin, std::size_t end, Search& search) {
  const auto isHopeless = [&](const Rectangle& box, double least, double most) {
    ++looks_;
    return !(most > search.area) || least > search.smallest || !box.holds(search.p);
  };
  const Node node = nodes_[number];  // which a ring's pieces can move
  if (isHopeless(node.box, node.first, node.last)) return;
  if (end - begin > kFew) {
    const std::size_t middle = begin + (end - begin) / 2;
    this->search(number + 1, begin, middle, search);
    this->search(node.right, middle, end, search);
    return;
  }
  for (std::size_t k = begin; k < end; ++k) {
    const Entry& entry = entries_[k];
    if (isHopeless(entry.box, entry.area, entry.area) ||
        (entry.area == search.smallest && entry.ring > search.found) ||
        !rings_.isAround(entry.ring))
      continue;
    search.found = entry.ring;
    search.smallest = entry.area;
  }
}

bool RingNesting::isInside(std::uint32_t ring, Point p) {
  if (ring >= rootOf_.size()) rootOf_.resize(ring + std::size_t{1}, 0);
  const std::size_t count = rings_.pieceCount(ring);
  if (rootOf_[ring] == 0) rootOf_[ring] = plantRow(ring, 0, count);
  return isOdd(rootOf_[ring], ring, 0, count, p);
}

std::uint32_t RingNesting::plantRow(std::uint32_t ring, std::size_t begin, std::size_t end) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({kNothing, 0, 0, 0});
  Node node{kNothing, 0, 0, 0};
  const auto add = [&](const Rectangle& box, double from, double to, bool isFirst) {
    if (isFirst) node.first = from;
    // Rounding can part two pieces. Then no point has all of them on its right.
    if (!isFirst && from != node.last) node.box.xmin = -kInfinite;
    include(node.box, box);
    node.last = to;
  };
  if (end - begin <= kFew) {
    for (std::size_t k = begin; k < end; ++k) {
      const NestedRings::Piece piece = rings_.piece(ring, k);
      add(piece.box, piece.from, piece.to, k == begin);
    }
    looks_ += end - begin;
  } else {
    const std::size_t middle = begin + (end - begin) / 2;
    plantRow(ring, begin, middle);
    node.right = plantRow(ring, middle, end);
    for (const std::uint32_t child : {number + 1, node.right})
      add(nodes_[child].box, nodes_[child].first, nodes_[child].last, child == number + 1);
  }
  nodes_[number] = node;
  return number;
}

bool RingNesting::isOdd(std::uint32_t number, std::uint32_t ring, std::size_t begin,
                        std::size_t end, Point p) {
  const Node& node = nodes_[number];
  ++looks_;
  if (isApart(node.box, p)) return false;
  if (p.x < node.box.xmin) return areApart(node.first, node.last, p.y);
  if (end - begin > kFew) {
    const std::size_t middle = begin + (end - begin) / 2;
    return isOdd(number + 1, ring, begin, middle, p) != isOdd(node.right, ring, middle, end, p);
  }
  bool isOdd = false;
  for (std::size_t k = begin; k < end; ++k) {
    const NestedRings::Piece piece = rings_.piece(ring, k);
    ++looks_;
    if (isApart(piece.box, p)) continue;
    if (p.x < piece.box.xmin ? areApart(piece.from, piece.to, p.y) : rings_.isCrossed(ring, k, p))
      isOdd = !isOdd;
  }
  return isOdd;
}

}  // namespace apollonius::internal
