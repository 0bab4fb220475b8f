// The polygons of all cells, which tile the window: each segment occurs once, and its reverse once
// in the cell beside it, unless the segment is on the border; and no two segments cross or touch
// except in common ends.
//
// The first holds because each edge is approximated once (chords.h), the second up to rounding. So
// the second is proved (tiling_proof.h), or segments that meet are mended until none do (mesh.h).
//
// The result is checked: the areas of all rings add up to the window's.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/polygons/cell_list.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

struct Coverage {
  Rings rings;                     ///< those of all cells, one after the other
  FlatArray<SiteId> sites;         ///< those with a polygon, or groups of sites; ascending
  FlatArray<std::uint32_t> cells;  ///< the first part of each cell, and the number of parts
  std::size_t work = 0;            ///< number of segments and pairs examined
};

/// Assembles the cells of a list, with their raw rings traced. Cells that follow each other and
/// have one number are united: a segment between two of them and its reverse cancel each other,
/// exactly. Replaces the contents.
void assemble(const CellList& list, Coverage& coverage);

/// Finds the polygons of all cells and replaces the contents. REQUIRES: `finder` finds thin parts,
/// too (Parts::kThinToo), and `box` holds the window. True if the areas of the rings add up to
/// `area`, up to rounding (NaN: to that of the cells' own rings, as cells do not fill the window),
/// and no segments meet. If false, the code has a defect. Cost: O(points) where the proof holds, as
/// it does unless rounding prevents it; else also what Mesh::mend() says.
///
/// If `groups` is not empty, it has the number of a group, or kNoGroup, by id: then the cells of a
/// group are united, and their areas add up to the group's, too.
[[nodiscard]] bool coverWindow(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box,
                               double area, std::span<const std::uint32_t> groups,
                               Coverage& coverage);

}  // namespace apollonius::internal
