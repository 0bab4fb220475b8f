// Walks rings through a diagram, from cell to cell.
//
// In a cell, the line of a segment leaves for a neighbour where it crosses their bisector in that
// direction, and does so at most once (LineForm); the cell ends at the first such crossing ahead.
// So no Voronoi vertex is ever tested, and where the line passes one, or runs along an edge, any
// answer is right within rounding. Three rules keep the effect of rounding as small as rounding
// itself:
//
//   - The middle between two crossings of a bisector tells which one is ahead. A cell that has been
//     entered is not left for having been entered late. The order of the crossings does not depend
//     on rounding: the cell of the smaller weight is on the convex side. A crossing that rounding
//     has put behind is taken only if its edge is here.
//   - Where two neighbours come next at nearly the same place, the neighbour across the nearer edge
//     is taken: the crossing counts as further ahead by its distance from the edge. Beyond the
//     segment's end, it is taken only if the end is in the other cell by more than rounding.
//   - A ring that ends in another cell than it began in is led back to its first cell: over cells
//     that are as near to its first point, and edges that pass that point.
//
// Cost: O(log d) for a segment and a cell of degree d that it passes through, and O(d) for each
// such cell, which is listed a few times before its neighbours are searched (neighbor_search.h);
// more where the segment is about as near to many neighbours as to the boundary. Segments near a
// point cost no more while they are closer to it than the boundary of its cell.
#pragma once

#include "geometry/window/polygon_clip.h"

namespace apollonius::internal {

/// Appends the crossings of all rings. Rings without any are appended to interiorRings, with the
/// slot of the cell around each for its key. Returns the number of neighbours examined, which
/// measures the work. REQUIRES: a visible site.
std::size_t walkRings(const DiagramCore& core, const NormalizedPolygon& polygon,
                      FlatArray<Crossing>& crossings, FlatArray<Keyed>& interiorRings);

}  // namespace apollonius::internal
