// Coordinates of Voronoi vertices for output: the last bits of the circle that is kept with a face
// depend on how it was computed.
#pragma once

#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// The circle of a face, accurate for any sites: the errors of the radius and of each coordinate
/// are a few units in the last place. The centre is correctly rounded for sites whose coordinates
/// and weights are multiples of one unit, no further apart than 2^17 units. Uses numbers of twice
/// the digits, and then long ones, where voronoiCircle's doubles do not suffice. Coordinates beyond
/// the range of doubles are infinite.
[[nodiscard]] VoronoiCircle preciseVoronoiCircle(Corner i, Corner j, Corner k);

/// The circle that more than three sites touch. Gives the same bits for any three of them that
/// include the largest of all: the centre, and its distance from that site, are rounded correctly.
/// (Where the sites' digits range over more than 500 places, it may be only as accurate as
/// preciseVoronoiCircle.)
[[nodiscard]] VoronoiCircle commonVoronoiCircle(const Site& first, const Site& second,
                                                const Site& third);

}  // namespace apollonius::internal
