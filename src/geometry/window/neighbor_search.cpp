#include "geometry/window/neighbor_search.h"

#include <algorithm>

#include "base/infinite.h"

namespace apollonius::internal {

namespace {

/// Fewer neighbours are tested one by one, which is quicker.
constexpr std::size_t kManyNeighbors = 64;
/// A tree costs as much as testing all neighbours two or three times, so it is built after that.
constexpr std::size_t kFewTimes = 4;
/// Children of a node, and neighbours of a node of level 1: a power of two.
constexpr unsigned kLogFanout = 2;
constexpr std::size_t kFanout = std::size_t{1} << kLogFanout;
constexpr std::size_t kMostLevels = 16;  // enough for 2^32 neighbours
/// Sites that are farther by this share of the numbers involved are left out (neighbor_search.h).
constexpr double kApart = powerOfTwo(-34);

double sizeOf(Point p) { return absolute(p.x) + absolute(p.y); }
double sizeOf(const Site& site) { return absolute(site.x) + absolute(site.y) + absolute(site.r); }

}  // namespace

/// A segment, seen from the centre of the cell's own site.
struct NeighborSearch::Way {
  Point from, to;
  double reach;  // the farther end's distance
  double size;   // sum of the sizes of the numbers it is computed from

  Way(const Site& own, Point a, Point b)
      : from(a - Point{own.x, own.y}),
        to(b - Point{own.x, own.y}),
        reach(std::max(length(from), length(to))),
        size(sizeOf(own) + sizeOf(a) + sizeOf(b)) {}

  [[nodiscard]] double distanceTo(Point p) const {
    const Point way = to - from;
    const double square = dot(way, way);
    const double at = square > 0 ? std::clamp(dot(way, p - from) / square, 0.0, 1.0) : 0;
    return length(p - (from + at * way));
  }
  /// Is all of it on the side of a line through the centre that `normal` points away from?
  [[nodiscard]] bool isAgainst(Point normal) const {
    return dot(normal, from) < 0 && dot(normal, to) < 0;
  }
};

/// Where the levels of a tree begin.
struct NeighborSearch::Levels {
  std::array<std::size_t, kMostLevels + 1> start;
  unsigned count = 0;

  explicit Levels(const Tree& tree) {
    std::size_t at = tree.firstNode, size = tree.count;
    do {
      size = (size + kFanout - 1) / kFanout;
      start[count++] = at;
      at += size;
    } while (size > 1);
    start[count] = at;
  }
  [[nodiscard]] std::size_t size(unsigned level) const { return start[level] - start[level - 1]; }
};

const NeighborSearch::Tree* NeighborSearch::treeOf(VertexId cell) const {
  const std::uint32_t number = treeNumbers_.empty() ? 0 : treeNumbers_[index(cell)];
  return number != 0 && trees_[number - 1].count != 0 ? &trees_[number - 1] : nullptr;
}

bool NeighborSearch::list(VertexId cell, const CellPlace& place, Point from, Point to,
                          FlatArray<HalfedgeId>& found) {
  found.clear();
  const Tree* const tree = treeOf(cell);
  if (tree == nullptr) {
    for (const HalfedgeId h : delaunay_.graph().star(cell)) {
      if (delaunay_.graph().target(h) != kInfinity) found.push_back(h);
    }
    asked_ += found.size();
    if (found.size() >= kManyNeighbors) countListing(cell, found);
    return true;
  }
  Way way(place.own, place.at, to);
  way.size += sizeOf(from);  // points along the segment are computed from it
  listNear(*tree, way, way.reach - place.own.r, found);
  return false;
}

bool NeighborSearch::surelyHolds(VertexId cell, Point p) {
  return treeOf(cell) != nullptr && leastExtra(cell, {delaunay_.site(cell), p}) > 0;
}

double NeighborSearch::leastExtra(VertexId cell, const CellPlace& place) {
  const Tree& tree = *treeOf(cell);
  const Way way(place.own, place.at, place.at);
  double least = kInfinite;
  const auto ask = [&](HalfedgeId h) {
    ++asked_;
    const Site& other = delaunay_.site(delaunay_.graph().target(h));
    least = std::min(least, place.extraOf(other, place.roundingOf(other)));
  };
  // Nodes with smaller bounds first, so that few of the others can hold a nearer neighbour.
  struct Open {
    double least;  // the bound on its extra distances
    unsigned level;
    std::size_t at;
  };
  const Levels levels(tree);
  std::array<Open, kMostLevels * kFanout> open;
  std::size_t count = 0;
  open[count++] = {-kInfinite, levels.count, 0};
  while (count > 0) {
    const Open next = open[--count];
    if (next.least > least) continue;
    const std::size_t begin = next.at * kFanout;
    if (next.level == 1) {
      const std::size_t end = std::min(begin + kFanout, tree.count);
      for (std::size_t k = begin; k < end; ++k) ask(neighbors_[tree.firstNeighbor + k]);
      continue;
    }
    const unsigned level = next.level - 1;
    const std::size_t end = std::min(begin + kFanout, levels.size(level)), kept = count;
    for (std::size_t k = begin; k < end; ++k) {
      const double lower = bound(nodes_[levels.start[level - 1] + k], way) - place.distance;
      std::size_t at = count++;
      for (; at > kept && open[at - 1].least < lower; --at) open[at] = open[at - 1];
      open[at] = {lower, level, k};
    }
  }
  return least;
}

/// Lists the neighbours of a tree, in their order, except those of nodes that are far.
void NeighborSearch::listNear(const Tree& tree, const Way& way, double most,
                              FlatArray<HalfedgeId>& found) {
  const Levels levels(tree);
  for (std::size_t k = 0; k < tree.count;) {
    // Tries the nodes that begin with neighbour k, the largest first, until one is far.
    unsigned level = 1;
    while (level < levels.count && (k >> kLogFanout * level) % kFanout == 0) ++level;
    while (level > 0 &&
           !(bound(nodes_[levels.start[level - 1] + (k >> kLogFanout * level)], way) > most))
      --level;
    const std::size_t end =
        std::min(k + (std::size_t{1} << kLogFanout * std::max(level, 1u)), tree.count);
    if (level == 0) {
      found.append(std::span(neighbors_).subspan(tree.firstNeighbor + k, end - k));
      asked_ += end - k;
    }
    k = end;
  }
}

/// A lower bound of the distance of a node's circles from the segment, whatever rounding does.
double NeighborSearch::bound(const Node& node, const Way& way) {
  ++asked_;
  const double slack = kApart * (way.size + node.size);
  // The sector is within three half-planes: on the left of `first`, on the right of `last`, and
  // ahead. A segment outside of one of these is outside of the sector. Where there is no arc, all
  // three normals are 0, and no segment is outside.
  if (!way.isAgainst(leftOf(node.first)) && !way.isAgainst(leftOf(-1 * node.last)) &&
      !way.isAgainst(node.first + node.last))
    return node.near - way.reach - slack;
  const double toEnd =
      std::min(way.distanceTo(node.radius * node.first), way.distanceTo(node.radius * node.last));
  return toEnd - (node.radius - node.near) - slack;
}

void NeighborSearch::countListing(VertexId cell, const FlatArray<HalfedgeId>& all) {
  if (treeNumbers_.empty()) treeNumbers_.assign(delaunay_.graph().vertexSlots(), 0);
  std::uint32_t& number = treeNumbers_[index(cell)];
  if (number == 0) {
    trees_.push_back({});
    number = static_cast<std::uint32_t>(trees_.size());
  }
  Tree& tree = trees_[number - 1];
  if (++tree.timesListed == kFewTimes) plant(tree, cell, all);
}

void NeighborSearch::plant(Tree& tree, VertexId cell, const FlatArray<HalfedgeId>& all) {
  asked_ += all.size();
  tree.firstNeighbor = neighbors_.size();
  tree.count = all.size();
  tree.firstNode = nodes_.size();
  neighbors_.append(all);
  const Site& own = delaunay_.site(cell);
  std::array<Node, kFanout> parts;
  for (std::size_t k = 0; k < all.size(); k += kFanout) {
    const std::size_t count = std::min(kFanout, all.size() - k);
    for (std::size_t n = 0; n < count; ++n)
      parts[n] = nodeOf(own, delaunay_.site(delaunay_.graph().target(all[k + n])));
    nodes_.push_back(unite(std::span(parts).first(count)));
  }
  for (std::size_t begin = tree.firstNode, end = nodes_.size(); end - begin > 1;) {
    for (std::size_t k = begin; k < end; k += kFanout)
      nodes_.push_back(unite(std::span(nodes_).subspan(k, std::min(kFanout, end - k))));
    begin = end;
    end = nodes_.size();
  }
}

NeighborSearch::Node NeighborSearch::nodeOf(const Site& own, const Site& other) {
  const Point way{other.x - own.x, other.y - own.y}, direction = unit(way);
  const double radius = length(way);
  return {direction, direction, radius, radius - other.r, sizeOf(other)};
}

NeighborSearch::Node NeighborSearch::unite(std::span<const Node> parts) {
  Node whole{{}, {}, 0, kInfinite, 0};
  Point middle;
  for (const Node& part : parts) {
    middle = middle + part.first + part.last;
    whole.radius = std::max(whole.radius, part.radius);
    whole.near = std::min(whole.near, part.near);
    whole.size = std::max(whole.size, part.size);
  }
  double rightmost = kInfinite, leftmost = -kInfinite;
  for (const Node& part : parts) {
    for (const Point direction : {part.first, part.last}) {
      // Up to 63 degrees to either side, sines order directions as accurately as these are known.
      const double sine = cross(middle, direction);
      if (!(dot(middle, direction) > absolute(sine) / 2)) {
        whole.first = whole.last = {};
        return whole;
      }
      if (sine < rightmost) {
        rightmost = sine;
        whole.first = direction;
      }
      if (sine > leftmost) {
        leftmost = sine;
        whole.last = direction;
      }
    }
  }
  return whole;
}

}  // namespace apollonius::internal
