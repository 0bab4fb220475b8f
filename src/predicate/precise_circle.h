// Coordinates of Voronoi vertices as they are listed: the last bits of the circle that is kept with
// a face depend on how it came about.
#pragma once

#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// The circle of a face with coordinates that are good whatever the sites: errors of a few units in
/// the last place of the radius and of each coordinate. The centre is correctly rounded for sites
/// whose coordinates and weights are multiples of one unit, no further apart than 2^17 of them.
/// Takes numbers of twice the digits, and then long ones, where voronoiCircle's doubles do not
/// suffice. Coordinates beyond the range of doubles are infinite.
[[nodiscard]] VoronoiCircle preciseVoronoiCircle(Corner i, Corner j, Corner k);

/// The same for a circle that more than three sites touch, with the same bits whichever three of
/// them are given, the largest of all among them: the centre, and its distance from that site, are
/// rounded correctly. (Where the sites' digits range over more than 500 places, they may be as
/// preciseVoronoiCircle's.)
[[nodiscard]] VoronoiCircle commonVoronoiCircle(const Site& first, const Site& second,
                                                const Site& third);

}  // namespace apollonius::internal
