// The cell of a site inside the window, as closed boundaries of conic pieces, counter-clockwise.
//
// A cell is star-shaped about its site's centre (docs/PREDICATES.md, section 2) and so in one
// piece, without holes; the window is convex, so a clipped cell is any number of *regions*, each
// without holes, that meet the window's border.
#pragma once

#include <cstdint>

#include "diagram/diagram_core.h"
#include "geometry/border.h"
#include "geometry/clip.h"
#include "memory/flat_array.h"

namespace apollonius::internal {

/// A piece of a cell's boundary, the cell on its left.
struct BoundaryPiece {
  Conic curve;
  SiteId neighbor = kNoSite;  ///< whose cell is on the right; kNoSite along the window's border
};

struct Cell {
  FlatArray<BoundaryPiece> pieces;
  FlatArray<std::uint32_t> starts;  ///< of each region, its first piece; and the number of pieces

  [[nodiscard]] std::size_t regionCount() const { return starts.size() - 1; }
};

/// Finds cells; keeps its scratch memory from one to the next.
class CellFinder {
 public:
  CellFinder(const DiagramCore& core, const Window& window) : core_(core), window_(window) {}

  /// The cell of a site, without regions if it is hidden or does not meet the window. Valid until
  /// the next call. Cost: O(d log d).
  const Cell& find(Slot site);

 private:
  struct Piece {
    ClippedPiece clipped;
    SiteId neighbor;
  };

  void clipEdges(Slot site);
  void link(Slot site);
  /// ownerOfWindow, found once.
  Slot wholeOwner();
  void wholeWindow();
  void addBorder(const BorderArc& arc);
  /// Ends a region; takes it back if its area is 0 up to rounding, as when a cell only touches the
  /// window.
  void closeRegion();

  const DiagramCore& core_;
  Window window_;
  Cell cell_;
  Slot owner_ = kNoSlot;
  bool isOwnerKnown_ = false;
  FlatArray<Piece> pieces_;
  FlatArray<BorderContact> contacts_;
  FlatArray<BorderArc> arcs_;
  FlatArray<std::uint32_t> arcAfter_;  // by piece: the border arc that follows it
  FlatArray<char> isUsed_;             // by piece
};

}  // namespace apollonius::internal
