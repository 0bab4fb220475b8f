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
    bool isTraced;  ///< raw rings that may cross or touch
  };

  Rings rings;
  FlatArray<char> isBorder;  ///< of raw rings, by point: does a segment of the border start there
  FlatArray<Cell> cells;     ///< those that have rings, by site, ascending

  /// The numbers of a cell's rings: from one to before another.
  [[nodiscard]] std::uint32_t firstRing(const Cell& cell) const {
    return rings.parts[cell.firstPart];
  }
  [[nodiscard]] std::uint32_t endRing(const Cell& cell) const { return rings.parts[cell.endPart]; }
};

/// Raw rings are the points of edges and border as computed. Neighbours share them exactly, but
/// where rounding has put points out of order, rings cross.
enum class RingsAre : bool { kPolygons, kRaw };

/// Of the sites with ids from `first` to before `end`. Throws std::bad_alloc.
[[nodiscard]] CellList listCells(const DiagramCore& core, PolygonFinder& finder, RingsAre what,
                                 SiteId first, std::size_t end);

}  // namespace apollonius::internal
