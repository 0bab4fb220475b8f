// On which side of the direction of a Voronoi vertex is a ray from a site?
#pragma once

#include "number/approx.h"
#include "number/sign.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// Position of a ray as seen along a direction.
enum class Bearing : signed char { kAlong, kLeft, kOpposite, kRight };

/// The bearing of the ray from the centre of i through (x, y), seen along the direction from that
/// centre to the vertex of the face (i, j, k). `circle` is the face's cached circle, for the first
/// filter. REQUIRES: a face of a diagram, i finite, (x, y) not the centre. Degree 8.
[[nodiscard]] Bearing bearingOf(double x, double y, const VoronoiCircle& circle, const Site& i,
                                Corner j, Corner k);

namespace stages {

/// Two coordinates of a ray from i's centre through (x, y) in the frame of the direction d from
/// there to the vertex of the face (i, j, k): positive to the left of d, and positive along d.
enum class RayPart : signed char { kLeftwards, kAlong };

/// From the cached circle; in doubles with an error bound; in doubles that are exact; in integers
/// of fixed width; exactly.
[[nodiscard]] MaybeSign rayCircleFilter(double x, double y, const VoronoiCircle& circle,
                                        const Site& i, RayPart part);
[[nodiscard]] MaybeSign rayFilter(double x, double y, const Site& i, Corner j, Corner k,
                                  RayPart part);
[[nodiscard]] MaybeSign rayMiddle(double x, double y, const Site& i, Corner j, Corner k,
                                  RayPart part);
[[nodiscard]] MaybeSign rayFixed(double x, double y, const Site& i, Corner j, Corner k,
                                 RayPart part);
[[nodiscard]] Sign rayExact(double x, double y, const Site& i, Corner j, Corner k, RayPart part);

}  // namespace stages

}  // namespace apollonius::internal
