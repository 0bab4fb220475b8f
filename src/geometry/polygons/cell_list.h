// The rings of many cells.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/polygons/cell_polygon.h"

namespace apollonius::internal {

struct CellList {
  struct Cell {
    SiteId site;
    Slot slot;
    std::uint32_t firstPart, endPart;
    bool isTraced;  ///< has it raw rings that may cross or touch?
  };

  Rings rings;
  FlatArray<char> isBorder;  ///< by point of raw rings: does a segment of the border start there?
  FlatArray<Cell> cells;     ///< those with rings, by site, ascending

  /// The rings of a cell: from firstRing to before endRing.
  [[nodiscard]] std::uint32_t firstRing(const Cell& cell) const {
    return rings.parts[cell.firstPart];
  }
  [[nodiscard]] std::uint32_t endRing(const Cell& cell) const { return rings.parts[cell.endPart]; }
};

/// Raw rings have the points of edges and border as computed. Neighbours have exactly the same
/// points, but rings cross where rounding has put points out of order.
enum class RingsAre : bool { kPolygons, kRaw };

/// Lists the cells of the sites with ids from `first` to before `end`. Throws std::bad_alloc.
[[nodiscard]] CellList listCells(const DiagramCore& core, PolygonFinder& finder, RingsAre what,
                                 SiteId first, std::size_t end);

}  // namespace apollonius::internal
