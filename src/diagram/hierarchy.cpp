#include "diagram/hierarchy.h"


namespace apollonius {

Slot Hierarchy::chosen(Slot upper, unsigned level) {
  // Multiplicative hashing; the upper bits are the good ones.
  std::uint64_t z = (upper + 1ull) * 0x9E3779B97F4A7C15ull + level * 0xD1B54A32D192ED03ull;
  z = (z ^ (z >> 32)) * 0xD6E8FEB86659FD93ull;
  return static_cast<Slot>(z >> (64 - kBits));
}

Slot Hierarchy::locateOn(unsigned level, double x, double y) const {
  Slot slot = kNoSlot;
  for (std::size_t k = levelCount_; k > level; --k) {
    const DelaunayGraph& graph = *levels_[k - 1];
    if (graph.visibleCount() == 0) continue;
    // A level lacks a site of the one above only if the diagram, which nobody has proved, shows one that another
    // covers.
    const bool isThere = slot != kNoSlot && graph.graph().hasVertex(vertexOf(slot));
    const VertexId start = isThere ? vertexOf(slot) : graph.anyVisible();
    const VertexId end = stepDown(graph, graph.locate(x, y, start, walk_), x, y);
    slot = below(slotOf(end), static_cast<unsigned>(k - 1));
  }
  return slot;
}

/// The nearest site; but a giant among small ones has a high degree below, and nobody knows where to start turning around it. The
/// neighbour in whose sector the point lies leads there: it is taken if, seen from it, the giant's weight dwarfs the distance.
VertexId Hierarchy::stepDown(const DelaunayGraph& graph, DelaunayGraph::Located located, double x, double y) {
  if (located.sector == kNoHalfedge) return located.nearest;
  const VertexId neighbor = graph.graph().target(located.sector);
  if (neighbor == kInfinity) return located.nearest;
  const Site &giant = graph.site(located.nearest), &small = graph.site(neighbor);
  const double reach = (absolute(small.x - x) + absolute(small.y - y)) / 4;
  return giant.r - small.r > reach ? neighbor : located.nearest;
}

void Hierarchy::reserveBulk(std::size_t slots) noexcept {
  constexpr std::size_t kFew = 64;  // not worth it
  if (isDropped_) return;
  try {
    for (unsigned level = 0; level < kMostLevels && (slots >>= kBits) > kFew; ++level) {
      DelaunayGraph& graph = levelToFill(level);
      graph.reserve(slots + 2);
      graph.reserveBulk(slots + 1);
    }
  } catch (...) {
    // Nothing is lost: sites that enter ask again.
  }
}

void Hierarchy::insert(Slot slot, const Site& site) noexcept {
  if (isDropped_) return;
  try {
    for (unsigned level = 0; level < kMostLevels && climbs(slot, level); ++level) {
      slot >>= kBits;
      DelaunayGraph& graph = levelToFill(level);
      graph.reserve(slot + std::size_t{2});
      graph.setSite(vertexOf(slot), site);
      const Slot above = locateOn(level + 1, site.x, site.y);
      const bool isThere = above != kNoSlot && graph.graph().hasVertex(vertexOf(above));  // see locateOn
      (void)graph.insert(vertexOf(slot), isThere ? vertexOf(above) : kNoVertex, walk_);
      // What the new site covers is hidden on level 0 as well; the diagram takes it off the other levels.
    }
  } catch (...) {
    drop();
  }
}

bool Hierarchy::moveInPlace(Slot slot, const Site& to) noexcept {
  try {
    for (unsigned level = 0; level < levelCount_ && climbs(slot, level); ++level) {
      slot >>= kBits;
      const SiteMoves::Move move{vertexOf(slot), to};
      if (!levels_[level]->graph().hasVertex(move.vertex) || moves_.apply(*levels_[level], {&move, 1})[0] == 0) return false;
    }
    return true;
  } catch (...) {
    return false;
  }
}

void Hierarchy::remove(Slot slot, Remover& remover) noexcept {
  try {
    for (unsigned level = 0; level < levelCount_ && climbs(slot, level); ++level) {
      slot >>= kBits;
      DelaunayGraph& graph = *levels_[level];
      if (index(vertexOf(slot)) < graph.graph().vertexSlots() && graph.isVisible(vertexOf(slot))) {
        (void)remover.remove(graph, vertexOf(slot), {});
      }
    }
  } catch (...) {
    drop();
  }
}

const char* Hierarchy::check(const DelaunayGraph& base, std::uint32_t& where, std::uint32_t& level) const {
  const DelaunayGraph* lower = &base;
  for (unsigned below = 0; below < levelCount_; ++below) {
    const DelaunayGraph& graph = *levels_[below];
    level = below + 1;
    if (const char* broken = graph.check(where)) return broken;
    std::size_t expected = 0;
    for (std::size_t v = 1; v < lower->graph().vertexSlots(); ++v) {
      const VertexId vertex{static_cast<std::uint32_t>(v)};
      const Slot slot = slotOf(vertex);
      if (!climbs(slot, below) || !lower->isVisible(vertex)) continue;
      ++expected;
      where = slot;
      const VertexId copy = vertexOf(slot >> kBits);
      if (index(copy) >= graph.graph().vertexSlots() || !graph.isVisible(copy)) return "it lacks a site: slot below";
      const Site &a = graph.site(copy), &b = lower->site(vertex);
      if (a.x != b.x || a.y != b.y || a.r != b.r) return "levels differ about a site: slot below";
    }
    where = static_cast<std::uint32_t>(expected);
    if (expected != graph.visibleCount()) return "it holds sites that the level below does not: expected";
    lower = &graph;
  }
  level = 0;
  return nullptr;
}

}  // namespace apollonius
