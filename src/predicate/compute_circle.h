// The Voronoi circle of one face. Those of many at once: circle_fan.h.
#pragma once

#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// The circle of a counter-clockwise face with an existing circle. The same bits for the same three
/// sites, whichever comes first and on whichever platform: the computation starts from the largest
/// site in the order of precedes().
[[nodiscard]] VoronoiCircle voronoiCircle(Corner i, Corner j, Corner k);

/// The circle as voronoiCircle() computes it, if the counter-clockwise triple of sites has one; at
/// most one of them is infinite, and none covers another. Returns whether it has.
[[nodiscard]] bool findVoronoiCircle(Corner i, Corner j, Corner k, VoronoiCircle& circle);

/// The same in doubles alone: true only if they show that there is a circle.
[[nodiscard]] bool findCertainVoronoiCircle(Corner i, Corner j, Corner k,
                                            VoronoiCircle& circle) noexcept;

}  // namespace apollonius::internal
