// The rings of all cells as edges and border give them: whether they tile the window is not known
// yet (tiling_proof.h), and where rounding has exchanged points they do not (mesh.h).
#pragma once

#include <cstdint>
#include <span>

#include "geometry/polygons/cell_polygon.h"

namespace apollonius::internal {

struct RawRings {
  struct Ring {
    std::uint32_t first, count;  ///< of the points
  };
  struct Cell {
    SiteId site;
    Slot slot;
    std::uint32_t firstRing, ringCount;
    bool isTraced;  ///< its rings may cross or touch
  };

  FlatArray<Point> points;   ///< ring by ring, the first one not again at the end
  FlatArray<char> isBorder;  ///< by point: does a segment of the border start there
  FlatArray<Ring> rings;
  FlatArray<Cell> cells;  ///< those that have rings, by site, ascending

  [[nodiscard]] std::span<const Ring> ringsOf(const Cell& cell) const {
    return std::span(rings).subspan(cell.firstRing, cell.ringCount);
  }
  [[nodiscard]] std::span<const Point> pointsOf(const Ring& ring) const {
    return std::span(points).subspan(ring.first, ring.count);
  }
};

/// Of all cells. Throws std::bad_alloc.
[[nodiscard]] RawRings listRawRings(const DiagramCore& core, PolygonFinder& finder);

}  // namespace apollonius::internal
