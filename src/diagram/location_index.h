// Where searches start: a grid of sites by their places, and a hierarchy of Delaunay graphs (paper,
// section 4) where the grid does not tell. Both are hints only: whatever they say, a search from
// there ends at the nearest site.
//
// The index follows the diagram's graph, which each call is given: entered(), left() and moved()
// say what has changed there. None of it throws: without memory, levels are dropped and the grid
// stays as coarse as it is.
#pragma once

#include <span>
#include <utility>

#include "apollonius/types.h"
#include "delaunay/delaunay_graph.h"
#include "delaunay/moves.h"
#include "delaunay/remove.h"
#include "diagram/hierarchy.h"
#include "diagram/hint_grid.h"
#include "diagram/id_pool.h"

namespace apollonius::internal {

class LocationIndex {
 public:
  explicit LocationIndex(Location location)
      : location_(location),
        walk_(location == Location::kHierarchy ? Walk::kSectors : Walk::kAllNeighbors),
        levels_(walk_) {}

  [[nodiscard]] Location location() const { return location_; }
  [[nodiscard]] Walk walk() const { return walk_; }

  /// A visible vertex to start a search for (x, y) from, or kNoVertex.
  [[nodiscard]] VertexId startFor(const DelaunayGraph& delaunay, double x, double y) const;

  /// A site has become visible.
  void entered(const DelaunayGraph& delaunay, Slot slot) noexcept;
  /// A site, which was here, is visible no more.
  void left(Slot slot, const Site& site, Remover& remover) noexcept;
  /// A visible site has moved, and the graph is as it was. followMoves() has the levels follow.
  void moved(Slot slot, const Site& from, const Site& to) { grid_.move(slot, from, to); }
  /// All moves that were made together.
  void followMoves(const DelaunayGraph& delaunay, std::span<const SiteMoves::Move> moves,
                   Remover& remover) noexcept;

  // Many are about to enter: walks start beside, so the grid is left alone until they have.
  void beginBulk() noexcept { isBulk_ = true; }
  [[nodiscard]] bool isBulk() const { return isBulk_; }
  /// Room on the levels for the visible ones of this many slots, if there is memory.
  void reserveBulk(std::size_t slots) noexcept {
    if (hasLevels() && !areLevelsDue_) levels_.reserveBulk(slots);
  }
  void endBulk(const DelaunayGraph& delaunay) noexcept {
    if (std::exchange(isBulk_, false)) rebuildGrid(delaunay);
  }

  /// The levels would need room of their own while something is undone. They go, which makes some,
  /// and are made anew when they are asked for.
  void beginUndo() noexcept {
    levels_.clear();
    areLevelsDue_ = false;
    isUndoing_ = true;
  }
  void endUndo() noexcept {
    isUndoing_ = false;
    areLevelsDue_ = hasLevels();
  }

  /// The graph is another one.
  void rebuild(const DelaunayGraph& delaunay) noexcept {
    areLevelsDue_ = hasLevels();
    rebuildGrid(delaunay);
  }
  void clear() noexcept {
    levels_.clear();
    areLevelsDue_ = isBulk_ = false;
    grid_.clear();
  }

  [[nodiscard]] const Hierarchy& levels() const { return levels_; }
  /// Returns the levels; builds them first if that is due.
  [[nodiscard]] const Hierarchy& filledLevels(const DelaunayGraph& delaunay) const {
    if (areLevelsDue_) buildLevels(delaunay);
    return levels_;
  }

 private:
  friend class DiagramBreaker;  // tests break a structure on purpose

  [[nodiscard]] bool hasLevels() const { return location_ != Location::kWalk; }
  [[nodiscard]] bool hasGrid() const { return walk_ == Walk::kSectors; }
  void buildLevels(const DelaunayGraph& delaunay) const noexcept;
  void rebuildGrid(const DelaunayGraph& delaunay) noexcept;
  void rebuildOutgrownGrid(const DelaunayGraph& delaunay) noexcept;

  Location location_;
  Walk walk_;
  bool isUndoing_ = false;
  bool isBulk_ = false;
  mutable bool areLevelsDue_ = false;  // they are made when they are asked first, and left alone
                                       // until then
  mutable Hierarchy levels_;
  HintGrid grid_;
};

}  // namespace apollonius::internal
