// The Voronoi circle of one face. For many at once: circle_fan.h.
#pragma once

#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// Computes the circle of a counter-clockwise face with an existing circle. The same three sites
/// give the same bits, whichever comes first and on any platform: the computation starts from the
/// largest site in the order of precedes().
[[nodiscard]] VoronoiCircle voronoiCircle(Corner i, Corner j, Corner k);

/// Computes the circle as voronoiCircle() does, if the counter-clockwise triple of sites has one;
/// false otherwise. REQUIRES: at most one of them is infinite, and none covers another.
[[nodiscard]] bool findVoronoiCircle(Corner i, Corner j, Corner k, VoronoiCircle& circle);

/// Computes the circle in doubles alone: true only if they show that there is one.
[[nodiscard]] bool findCertainVoronoiCircle(Corner i, Corner j, Corner k,
                                            VoronoiCircle& circle) noexcept;

}  // namespace apollonius::internal
