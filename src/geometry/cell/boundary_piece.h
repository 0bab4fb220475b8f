// The boundary of a cell inside a window: closed rings of conic pieces, counter-clockwise, and
// clockwise around holes.
#pragma once

#include <cstdint>
#include <span>

#include "apollonius/types.h"
#include "base/flat_array.h"
#include "geometry/curve/conic.h"
#include "geometry/window/polygon.h"

namespace apollonius::internal {

/// A piece of a cell's boundary, the cell on its left.
struct BoundaryPiece {
  Conic curve;
  SiteId neighbor = kNoSite;  ///< the site on the right; kNoSite along the window's border
  /// In a region: the segments of its polygon that the piece starts and ends on.
  std::uint32_t fromSegment = kNoSegment, toSegment = kNoSegment;
  /// Is nothing on the right, because the site's reach ends there, or the neighbor's
  /// (reach_cell.h)?
  bool isAtReach = false;
  /// Does it exist by rounding only, since the edge merely touches the window's border or is a
  /// point (DelaunayGraph::isPoint)?
  bool isTouch = false;

  /// The site on the right, or kNoSite.
  [[nodiscard]] SiteId sharedWith() const { return isAtReach || isTouch ? kNoSite : neighbor; }
};

struct Cell {
  FlatArray<BoundaryPiece> pieces;
  FlatArray<std::uint32_t> starts;  ///< the first piece of each ring, and the number of pieces
  /// The first ring of each part, which is around it; further ones are its holes. Then the number
  /// of rings. (In a rectangle, parts have no holes.)
  FlatArray<std::uint32_t> outers;

  [[nodiscard]] std::size_t ringCount() const { return starts.size() - 1; }
  [[nodiscard]] std::span<const BoundaryPiece> ring(std::size_t k) const {
    return std::span(pieces).subspan(starts[k], starts[k + 1] - starts[k]);
  }
  [[nodiscard]] std::size_t partCount() const { return outers.size() - 1; }
  /// Leaves no parts.
  void clear() {
    pieces.clear();
    starts.assign(1, 0);
    outers.assign(1, 0);
  }
};

/// Computes the area inside a counter-clockwise boundary. Its `rounding` bounds the errors of this
/// computation only. `origin` should be near the boundary.
[[nodiscard]] Area areaOf(std::span<const BoundaryPiece> boundary, Point origin);

}  // namespace apollonius::internal
