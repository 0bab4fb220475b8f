// A region of a cell as a closed polyline that does not cross itself.
//
// A cell is star-shaped about its site's centre, so along all curves of a region the direction from
// the centre turns counter-clockwise; what is not a curve is the window's border, which is convex.
// Two properties of the polyline follow from those of the region, whatever the tolerance: chords
// are inside the window as their ends are, and if each chord turns counter-clockwise, too, no two
// of them meet. So curves are halved until their chords do, even where one would be near enough (a
// small cell all around its centre), and a point that rounding has put before its predecessor, as
// happens where vertices are as close as doubles are, is left out. Both are decided exactly.
#pragma once

#include <span>
#include <vector>

#include "geometry/cell.h"

namespace apollonius::internal {

/// Appends the points of a ring of the cell about `center`, the first one again at the end; at
/// least three different ones. If there are none, because what it bounds is as small as the
/// distance of doubles, nothing is appended: false. `window` is null in regions that are none.
bool appendRing(std::span<const BoundaryPiece> boundary, Point center, const Window* window,
                bool isHole, double tolerance, std::vector<double>& points);

}  // namespace apollonius::internal
