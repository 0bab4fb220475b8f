// The Voronoi circle of a face in doubles, with bounds on its error: kept with each face for the
// first filters of the predicates (vertex_conflict.h, direction.h). It is computed by
// compute_circle.h, circle_fan.h and precise_circle.h, which may ask predicates.
//
// For a bounded face: centre (x, y) and clearance s, the common distance to its three sites. For an
// unbounded face: the half-plane a·x + b·y >= c beyond the two circles' common tangent line, with
// outer unit normal (a, b); a site of weight r sticks out of it if a·x + b·y + r > c.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "number/fp.h"

namespace apollonius::internal {

struct VoronoiCircle {
  double x = 0;  ///< centre, or the normal's a
  double y = 0;  ///< centre, or the normal's b
  double s = 0;  ///< clearance, or the half-plane's c
  /// For a circle: |exact centre - (x, y)| + |exact s - s| is at most this; infinite if nothing is
  /// known; NaN if it has not been computed. For a half-plane: the error of c.
  float error = 0;
  /// For a half-plane: the error of the normal's components. Negative for a circle.
  float slope = -1;

  [[nodiscard]] bool isHalfPlane() const { return slope >= 0; }
  [[nodiscard]] bool isMissing() const { return std::isnan(error); }
};

/// Stands for a circle that is computed when it is needed. For the filters it is unknown.
inline constexpr VoronoiCircle kMissingCircle{0, 0, 0, std::numeric_limits<float>::quiet_NaN(), -1};

/// For bounds: the smallest convenient float that is at least x; infinity for NaN.
inline float roundedUp(double x) {
  if (!(x <= 1e38)) return std::numeric_limits<float>::infinity();
  return std::max(static_cast<float>(x * (1 + powerOfTwo(-22))), std::numeric_limits<float>::min());
}

}  // namespace apollonius::internal
