// The cell of a site inside the window, as closed boundaries of conic pieces: counter-clockwise,
// and clockwise around the holes that only windows of other shapes than rectangles make.
//
// A cell is star-shaped about its site's centre (docs/PREDICATES.md, section 2) and so in one
// piece, without holes; the window is convex, so a clipped cell is any number of *regions*, each
// without holes, that meet the window's border.
#pragma once

#include <cstdint>
#include <span>

#include "diagram/diagram_core.h"
#include "geometry/border.h"
#include "geometry/clip.h"
#include "geometry/outline.h"
#include "memory/flat_array.h"

namespace apollonius::internal {

/// A piece of a cell's boundary, the cell on its left.
struct BoundaryPiece {
  Conic curve;
  SiteId neighbor = kNoSite;  ///< whose cell is on the right; kNoSite along the window's border
  /// Of an edge's piece in a region: the segments of its outline that it starts and ends on.
  std::uint32_t fromSegment = kNoSegment, toSegment = kNoSegment;
};

struct Cell {
  FlatArray<BoundaryPiece> pieces;
  FlatArray<std::uint32_t> starts;  ///< of each ring, its first piece; and the number of pieces
  /// Of each region its first ring, which is around it; further ones are holes. And the number of
  /// rings. (In a window regions have no holes.)
  FlatArray<std::uint32_t> outers;

  [[nodiscard]] std::size_t ringCount() const { return starts.size() - 1; }
  [[nodiscard]] std::span<const BoundaryPiece> ring(std::size_t k) const {
    return std::span(pieces).subspan(starts[k], starts[k + 1] - starts[k]);
  }
  [[nodiscard]] std::size_t partCount() const { return outers.size() - 1; }
};

/// Finds cells; keeps its scratch memory from one to the next.
class CellFinder {
 public:
  /// `keepsThin`: regions without area up to rounding, too, so that each curve is there twice.
  CellFinder(const DiagramCore& core, const Window& window, bool keepsThin = false)
      : core_(core), window_(window), keepsThin_(keepsThin) {}

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
  void wholeWindow();
  void addBorder(const BorderArc& arc);
  /// Ends a region; takes it back if its area is 0 up to rounding, as when a cell only touches the
  /// window.
  void closeRegion();

  const DiagramCore& core_;
  Window window_;
  bool keepsThin_;
  Cell cell_;
  FlatArray<Piece> pieces_;
  FlatArray<BorderContact> contacts_;
  FlatArray<BorderArc> arcs_;
  FlatArray<std::uint32_t> arcAfter_;  // by piece: the border arc that follows it
  FlatArray<char> isUsed_;             // by piece
};

}  // namespace apollonius::internal
