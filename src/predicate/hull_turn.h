// How do the outer normals of the hull turn? For proofs that the hull turns once.
#pragma once

#include "number/approx.h"
#include "number/sign.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// Has the half-plane of the face (i, j, infinity), which is given, an outer normal of an angle in
/// [0, pi)? Degree 6.
[[nodiscard]] bool pointsUp(const Site& i, const Site& j, const VoronoiCircle& plane);

/// The turn from the outer normal of the face (i, l, infinity) to that of (k, i, infinity), whose
/// half-planes are given. Degree 4.
[[nodiscard]] Sign turnOfHull(const Site& i, const Site& l, const Site& k, const VoronoiCircle& atL,
                              const VoronoiCircle& atK);

namespace stages {

// The given half-planes are the filters; these are the exact stages.

[[nodiscard]] bool normalIsUpExact(const Site& i, const Site& j);
[[nodiscard]] Sign spanExact(const Site& i, const Site& l, const Site& k);

}  // namespace stages

}  // namespace apollonius::internal
