#include "diagram/hierarchy.h"

#include <new>

namespace apollonius::internal {

Slot Hierarchy::chosen(Slot upper, unsigned level) {
  // Multiplicative hashing; the upper bits are the good ones.
  std::uint64_t z = (upper + 1ull) * 0x9E3779B97F4A7C15ull + level * 0xD1B54A32D192ED03ull;
  z = (z ^ (z >> 32)) * 0xD6E8FEB86659FD93ull;
  return static_cast<Slot>(z >> (64 - kBits));
}

Slot Hierarchy::locateOn(unsigned level, double x, double y) const {
  Slot slot = kNoSlot;
  for (std::size_t k = levelCount_; k > level; --k) {
    const DelaunayGraph& delaunay = *levels_[k - 1];
    if (delaunay.visibleCount() == 0) continue;
    // A level lacks a site of the one above only in an unverified diagram, if that shows a site
    // that another covers.
    const bool isThere = slot != kNoSlot && delaunay.graph().hasVertex(vertexOf(slot));
    const VertexId start = isThere ? vertexOf(slot) : delaunay.anyVisible();
    const VertexId end = stepDown(delaunay, delaunay.locate(x, y, start, walk_), x, y);
    slot = below(slotOf(end), static_cast<unsigned>(k - 1));
  }
  return slot;
}

unsigned Hierarchy::levelsOf(Slot slot) const {
  unsigned level = 0;
  for (; level < levelCount_ && climbs(slot, level); ++level) {
    slot >>= kBits;
    if (!levels_[level]->isVisible(vertexOf(slot))) break;
  }
  return level + 1;
}

/// The nearest site; but a giant among small ones has a high degree below, and nobody knows where
/// to start turning around it. The neighbour in whose sector the point lies leads there: it is
/// taken if, seen from it, the giant's weight dwarfs the distance.
VertexId Hierarchy::stepDown(const DelaunayGraph& delaunay, DelaunayGraph::Located located,
                             double x, double y) {
  if (located.sector == kNoHalfedge) return located.nearest;
  const Graph& links = delaunay.graph();
  VertexId neighbor = links.target(located.sector);
  if (neighbor == kInfinity)
    neighbor =
        links.target(links.rotateCcw(located.sector));  // between two that stick out of the giant
  const Site &giant = delaunay.site(located.nearest), &small = delaunay.site(neighbor);
  const double reach = (absolute(small.x - x) + absolute(small.y - y)) / 4;
  return giant.r - small.r > reach ? neighbor : located.nearest;
}

void Hierarchy::reserveBulk(std::size_t slots) noexcept {
  constexpr std::size_t kFew = 64;  // not worth it
  if (isDropped_) return;
  try {
    for (unsigned level = 0; level < kMostLevels && (slots >>= kBits) > kFew; ++level) {
      DelaunayGraph& delaunay = levelToFill(level);
      delaunay.reserve(slots + 2);
      delaunay.reserveBulk(slots + 1);
    }
  } catch (const std::bad_alloc&) {
    // Nothing is lost: sites that enter ask again.
  }
}

void Hierarchy::insert(Slot slot, const Site& site) noexcept {
  if (isDropped_) return;
  try {
    for (unsigned level = 0; level < kMostLevels && climbs(slot, level); ++level) {
      slot >>= kBits;
      DelaunayGraph& delaunay = levelToFill(level);
      delaunay.reserve(slot + std::size_t{2});
      if (delaunay.isVisible(vertexOf(slot)))
        return drop();  // never: a level with a site twice would be no graph
      delaunay.setSite(vertexOf(slot), site);
      const Slot above = locateOn(level + 1, site.x, site.y);
      delaunay.insert(vertexOf(slot), above == kNoSlot ? kNoVertex : vertexOf(above), walk_);
    }
  } catch (const std::bad_alloc&) {
    drop();
  }
}

/// Sites cannot move one by one: on level 0 all have moved, and of two sites in each other's way,
/// the one that moves first could cover the other one's former place. So each level moves as many
/// of its sites as it can together (SiteMoves). The others are then removed from it and from all
/// other levels, so that the level holds only sites of level 0 where they are now. The levels above
/// are still as before: they, too, hold sites that were visible together. Once no level holds a
/// site in a former place, the sites that were left behind enter anew.
void Hierarchy::move(std::span<const SiteMoves::Move> moves, Remover& remover) noexcept {
  if (levelCount_ == 0) return;
  try {
    moves_.clear();
    slots_.clear();
    behind_.clear();
    for (const SiteMoves::Move& move : moves) {
      const Slot slot = slotOf(move.vertex);
      if (!climbs(slot, 0)) continue;
      moves_.push_back({vertexOf(slot >> kBits), move.to});
      slots_.push_back(slot);
    }
    for (unsigned level = 0; level < levelCount_ && !moves_.empty(); ++level) {
      const std::size_t before = behind_.size();
      followOn(level);
      for (std::size_t k = before; k < behind_.size(); ++k)
        remove(slotOf(behind_[k].vertex), remover);
    }
  } catch (const std::bad_alloc&) {
    drop();
  }
  for (const SiteMoves::Move& move : behind_) insert(slotOf(move.vertex), move.to);
}

/// Moves in place the sites of a level for which that is possible, and keeps in moves_ those that
/// are also on the next level. Appends the others, which are not moved, to behind_.
void Hierarchy::followOn(unsigned level) {
  DelaunayGraph& delaunay = *levels_[level];
  behind_.reserve(behind_.size() +
                  moves_.size());  // from here on only SiteMoves throws, and then nothing has moved
  const auto leave = [&](std::size_t k) { behind_.push_back({vertexOf(slots_[k]), moves_[k].to}); };
  std::size_t count = 0;
  for (std::size_t k = 0; k < moves_.size(); ++k) {
    if (!delaunay.graph().hasVertex(moves_[k].vertex)) {  // the only one there
      leave(k);
      continue;
    }
    moves_[count] = moves_[k];
    slots_[count++] = slots_[k];
  }
  const std::span<const std::uint8_t> isMade =
      siteMoves_.apply(delaunay, {moves_.data(), count}, Flips::kMaybe);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Slot slot = slotOf(moves_[k].vertex);
    if (isMade[k] == 0) {
      leave(k);
    } else if (climbs(slot, level + 1)) {
      moves_[kept] = {vertexOf(slot >> kBits), moves_[k].to};
      slots_[kept++] = slots_[k];
    }
  }
  moves_.resize(kept, {});
  slots_.resize(kept);
}

void Hierarchy::remove(Slot slot, Remover& remover) noexcept {
  try {
    for (unsigned level = 0; level < levelCount_ && climbs(slot, level); ++level) {
      slot >>= kBits;
      DelaunayGraph& delaunay = *levels_[level];
      if (delaunay.isVisible(vertexOf(slot))) (void)remover.remove(delaunay, vertexOf(slot), {});
    }
  } catch (const std::bad_alloc&) {
    drop();
  }
}

const char* Hierarchy::check(const DelaunayGraph& levelZero, std::uint32_t& where,
                             std::uint32_t& level) const {
  const DelaunayGraph* lower = &levelZero;
  for (unsigned below = 0; below < levelCount_; ++below) {
    const DelaunayGraph& delaunay = *levels_[below];
    level = below + 1;
    if (const char* broken = delaunay.check(where)) return broken;
    std::size_t expected = 0;
    for (std::size_t v = 1; v < lower->graph().vertexSlots(); ++v) {
      const VertexId vertex{static_cast<std::uint32_t>(v)};
      const Slot slot = slotOf(vertex);
      if (!climbs(slot, below) || !lower->isVisible(vertex)) continue;
      ++expected;
      where = slot;
      const VertexId copy = vertexOf(slot >> kBits);
      if (index(copy) >= delaunay.graph().vertexSlots() || !delaunay.isVisible(copy))
        return "it lacks a site: slot below";
      const Site &a = delaunay.site(copy), &b = lower->site(vertex);
      if (a.x != b.x || a.y != b.y || a.r != b.r) return "levels differ about a site: slot below";
    }
    where = static_cast<std::uint32_t>(expected);
    if (expected != delaunay.visibleCount())
      return "it holds sites that the level below does not: expected";
    lower = &delaunay;
  }
  level = 0;
  return nullptr;
}

}  // namespace apollonius::internal
