// The polygons of all cells, which tile the window: each segment stands once, and its reverse once
// in the cell beside it or the segment lies on the border; and no two segments cross or touch but
// in common ends.
//
// The first is so because edges are approximated once (chords.h), the second but for rounding: a
// point that is off by its last place can be beyond a segment that it should be next to. So it is
// proved, by exact signs for all pairs of segments that may meet (segment_pairs.h). Where two meet,
// the ends of them that are as close as rounding become one point, in all cells; or the segment
// that passes a point goes through it. This is repeated until nothing meets. It ends: after some
// rounds, points are only united, and there are fewer of them each time.
#pragma once

#include "geometry/polygons/cell_polygon.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

struct Coverage {
  Rings rings;                     ///< of all cells, one after the other
  FlatArray<SiteId> sites;         ///< that have a polygon, ascending
  FlatArray<std::uint32_t> cells;  ///< of each its first part; and the number of parts
};

/// Replaces the contents. `finder` finds thin parts, too (Parts::kThinToo), and `box` holds the
/// window. Cost: that of the polygons one by one, and of the pairs of their segments; as often
/// again as rounding has to be undone, which is seldom.
void coverWindow(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box,
                 Coverage& coverage);

}  // namespace apollonius::internal
