// Walks rings through a diagram, from cell to cell.
//
// In a cell, the line of a segment leaves for a neighbour where it crosses their bisector that way,
// and does so once at most (LineForm); the first of these places ahead is where the cell ends. So
// nothing is asked about Voronoi vertices, and where the line passes one, or runs along an edge,
// any answer is right within rounding. Three rules see to it that rounding stays as small as it is:
//
//   - Which of two places on a bisector is ahead is told by the middle between them. A cell that
//     has been entered is not left for having been entered late. In which order they come is no
//     question of rounding: the cell of the smaller weight is on the convex side. A place that
//     rounding has put behind is taken only if its edge is here.
//   - Where two neighbours come next at nearly the same place, the neighbour across the nearer edge
//   is taken:
//     the place is held to be as far ahead as it is away from the edge; beyond the segment's end,
//     it is taken only if that is in the other cell by more than rounding.
//   - A ring that ends in another cell than it began in goes there over cells as near to its first
//     point, and edges that pass there.
//
// Cost: O(log d) for a segment and a cell of degree d that it passes through, and O(d) for each
// such cell, which is listed a few times before its neighbours are searched (neighbor_search.h);
// more where the segment is about as near to many neighbours as to the boundary. Segments as near
// to a place as the boundary of its cell is far from there cost no more than that.
#pragma once

#include "geometry/window/polygon_clip.h"

namespace apollonius::internal {

/// Appends the crossings of all rings; and rings without any, behind the slot of the cell that each
/// is within. Returns how many neighbours have been asked, which is its work. REQUIRES: a visible
/// site.
std::size_t walkRings(const DiagramCore& core, const NormalizedPolygon& polygon,
                      FlatArray<Crossing>& crossings, FlatArray<Keyed>& interiorRings);

}  // namespace apollonius::internal
