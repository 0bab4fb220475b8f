// The polygons of all cells, which tile the window: each segment stands once, and its reverse once
// in the cell beside it or the segment lies on the border; and no two segments cross or touch but
// in common ends.
//
// The first is so because edges are approximated once (chords.h), the second but for rounding. So
// it is proved (tiling_proof.h), or what meets is mended until nothing does (mesh.h).
//
// What has come of it is checked: the areas of all rings add up to the window's.
#pragma once

#include "geometry/polygons/cell_list.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

struct Coverage {
  Rings rings;                     ///< of all cells, one after the other
  FlatArray<SiteId> sites;         ///< that have a polygon, ascending
  FlatArray<std::uint32_t> cells;  ///< of each its first part; and the number of parts
  std::size_t work = 0;            ///< segments that were looked at, and pairs
};

/// Cells of a list, raw rings traced. Replaces the contents.
void assemble(const CellList& list, Coverage& coverage);

/// Replaces the contents. `finder` finds thin parts, too (Parts::kThinToo), and `box` holds the
/// window. Are the areas of the rings together `area`, up to rounding (NaN: that of the cells' own
/// rings, as cells do not fill the window), and do no segments meet? If not, the code has a defect.
/// Cost: O(points) where the proof holds, as it does but for rounding; else also what Mesh::mend()
/// says.
[[nodiscard]] bool coverWindow(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box,
                               double area, Coverage& coverage);

}  // namespace apollonius::internal
