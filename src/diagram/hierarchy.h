// The hierarchy of Delaunay graphs for location (paper, section 4): level k + 1 holds a sample of
// the sites of level k, every thirty-second on average, and a search walks on each level from where
// it ended on the one above. Level 0 is the diagram itself.
//
// Which sites a level holds is a function of their slots: of each 32 consecutive slots of a level,
// one, chosen by a hash of their common number, is a slot of the next. So nothing is stored to get
// from a slot on one level to the same site's on another, and sites that are revived or moved
// return to their levels.
//
// A level holds sites that are visible together on level 0: now, or, while it has yet to follow a
// change, before the change; never some of both. Sites that leave are first removed from all of
// their levels, then new ones enter. So no site is ever covered on a level: its cover there would
// cover it on level 0 as well. (This is necessary: a site hidden on a level would be lost for it,
// as levels have no forest to bring it back from.)
//
// The hierarchy is an accelerator: if it runs out of memory it is dropped until the diagram is
// cleared, and searches walk from afar.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"
#include "delaunay/moves.h"
#include "delaunay/remove.h"
#include "diagram/id_pool.h"

namespace apollonius::internal {

class Hierarchy {
 public:
  explicit Hierarchy(Walk walk) : walk_(walk) {}

  /// The slot of the site to start from on level 0 for (x, y), or kNoSlot if the levels are empty.
  [[nodiscard]] Slot locate(double x, double y) const { return locateOn(0, x, y); }

  /// Number of levels of a site that is visible on level 0, including that one.
  [[nodiscard]] unsigned levelsOf(Slot slot) const;

  /// Makes room on the levels for the visible sites of this many slots, in one piece, if there is
  /// memory.
  void reserveBulk(std::size_t slots) noexcept;

  /// Enters a site that is visible on level 0 and is not on its levels yet.
  void insert(Slot slot, const Site& site) noexcept;

  /// Removes a site from its levels, if it is on any.
  void remove(Slot slot, Remover& remover) noexcept;

  /// Follows moves that did not change the graph of level 0; all that were made together at once.
  /// Each names a vertex of level 0 and its site's present place.
  void move(std::span<const SiteMoves::Move> moves, Remover& remover) noexcept;

  void clear() noexcept {
    drop();
    isDropped_ = false;
  }

  /// The first broken invariant, or nullptr; `levelZero` is the diagram's own graph, in which slot
  /// s has the vertex s + 1.
  [[nodiscard]] const char* check(const DelaunayGraph& levelZero, std::uint32_t& where,
                                  std::uint32_t& level) const;

 private:
  friend class DiagramBreaker;  // tests break a structure on purpose

  static constexpr unsigned kBits =
      5;  // few sites pay for a level; most searches start from the grid (hint_grid.h) anyway
  static constexpr unsigned kMostLevels = 8;  // the top one holds 32 of 2^29 sites
  static constexpr Slot kMask = (Slot{1} << kBits) - 1;

  /// Is slot s of `level` a slot of the next one, too? Then it is s >> kBits there.
  [[nodiscard]] static bool climbs(Slot s, unsigned level) {
    return (s & kMask) == chosen(s >> kBits, level);
  }
  [[nodiscard]] static Slot below(Slot upper, unsigned level) {
    return upper << kBits | chosen(upper, level);
  }
  [[nodiscard]] static Slot chosen(Slot upper, unsigned level);
  void followOn(unsigned level);

  /// The slot on `level` to start from.
  [[nodiscard]] Slot locateOn(unsigned level, double x, double y) const;

  /// The vertex to go down with from where a search on one level ended.
  [[nodiscard]] static VertexId stepDown(const DelaunayGraph& delaunay,
                                         DelaunayGraph::Located located, double x, double y);

  Walk walk_;
  void drop() noexcept {
    for (; levelCount_ > 0; --levelCount_) levels_[levelCount_ - 1].reset();
    isDropped_ = true;
  }

  /// Opens the next level if that is `level`.
  DelaunayGraph& levelToFill(unsigned level) {
    if (levelCount_ == level) {
      levels_[level] = std::make_unique<DelaunayGraph>();
      ++levelCount_;
    }
    return *levels_[level];
  }

  std::array<std::unique_ptr<DelaunayGraph>, kMostLevels> levels_;  // [k] is level k + 1
  unsigned levelCount_ = 0;
  SiteMoves siteMoves_;
  // Scratch of move(): for the sites that are on the current level and follow the moves, the move
  // there, and the slot on level 0. Sites that stay behind are listed in behind_.
  FlatArray<SiteMoves::Move> moves_;
  FlatArray<Slot> slots_;
  FlatArray<SiteMoves::Move> behind_;
  bool isDropped_ = false;
};

}  // namespace apollonius::internal
