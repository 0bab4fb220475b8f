// The polygons of all cells, which tile the window: each segment stands once, and its reverse once
// in the cell beside it or the segment lies on the border; and no two segments cross or touch but
// in common ends.
//
// The first is so because edges are approximated once (chords.h), the second but for rounding: a
// point that is off by its last place can be beyond a segment that it should be next to. So it is
// proved, by exact signs for all pairs of segments that may meet (segment_pairs.h). Where two meet,
// the ends of them that are as close as rounding become one point, in all cells; or the segment
// that passes a point goes through it. This is repeated until nothing meets. If that takes more
// than a few rounds, points farther apart become one in each further round, in the end any points
// of what meets; and the number of rounds is limited.
//
// What has come of it is checked: the areas of all rings add up to the window's.
#pragma once

#include "geometry/polygons/cell_polygon.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

struct Coverage {
  Rings rings;                     ///< of all cells, one after the other
  FlatArray<SiteId> sites;         ///< that have a polygon, ascending
  FlatArray<std::uint32_t> cells;  ///< of each its first part; and the number of parts
  std::size_t work = 0;            ///< segments that were looked at, in all rounds; and meetings
};

/// Replaces the contents. `finder` finds thin parts, too (Parts::kThinToo), and `box` holds the
/// window. Are the areas of the rings together `area`, up to rounding (NaN: that of the cells' own
/// rings, as cells do not fill the window), and do no segments meet? If not, the code has a defect.
/// Cost: that of the polygons one by one, and O(n log n) for n segments, or the pairs of those that
/// are near each other if these are fewer; as often again as rounding has to be undone, which is
/// seldom.
[[nodiscard]] bool coverWindow(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box,
                               double area, Coverage& coverage);

}  // namespace apollonius::internal
