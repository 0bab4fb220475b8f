// Starts of searches: a grid of sites by their places, and a hierarchy of Delaunay graphs (paper,
// section 4) where the grid gives none. Both are only hints: from any start, a search ends at the
// nearest site.
//
// The index follows the diagram's graph, which is an argument of each call: entered(), left() and
// moved() report its changes. No call throws: without memory, levels are dropped and the grid stays
// as coarse as it is.
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

  /// Enters a site that has become visible.
  void entered(const DelaunayGraph& delaunay, Slot slot) noexcept;
  /// Removes a site that is no longer visible; `site` is its former place.
  void left(Slot slot, const Site& site, Remover& remover) noexcept;
  /// Follows the move of a visible site that left the graph as it was. For the levels,
  /// followMoves() has to be called.
  void moved(Slot slot, const Site& from, const Site& to) { grid_.move(slot, from, to); }
  /// Updates the levels after moves; all that were made together.
  void followMoves(const DelaunayGraph& delaunay, std::span<const SiteMoves::Move> moves,
                   Remover& remover) noexcept;

  // A bulk insertion begins: its walks start at adjacent sites, so the grid is not updated until
  // the end.
  void beginBulk() noexcept { isBulk_ = true; }
  [[nodiscard]] bool isBulk() const { return isBulk_; }
  /// Makes room on the levels for the visible sites of this many slots, if there is memory.
  void reserveBulk(std::size_t slots) noexcept {
    if (hasLevels() && !areLevelsDue_) levels_.reserveBulk(slots);
  }
  void endBulk(const DelaunayGraph& delaunay) noexcept {
    if (std::exchange(isBulk_, false)) rebuildGrid(delaunay);
  }

  /// Begins undoing. The levels would need room for it: they are dropped, which frees some, and are
  /// built anew when they are needed.
  void beginUndo() noexcept {
    levels_.clear();
    areLevelsDue_ = false;
    isUndoing_ = true;
  }
  void endUndo() noexcept {
    isUndoing_ = false;
    areLevelsDue_ = hasLevels();
  }

  /// Rebuilds the index for another graph.
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
  mutable bool areLevelsDue_ = false;  // they are built when they are first needed, and not updated
                                       // until then
  mutable Hierarchy levels_;
  HintGrid grid_;
};

}  // namespace apollonius::internal
