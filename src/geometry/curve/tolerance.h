// The tolerance of drawings and polygons: their largest distance from the curves.
#pragma once

#include <limits>

#include "number/fp.h"

namespace apollonius::internal {

struct Tolerance {
  double distance;
  /// A relative limit, so that small things keep their shape: a share of a curve's size in
  /// drawings, and in polygons of the extent of the cells beside it (chords.h).
  double share = std::numeric_limits<double>::infinity();
};

/// The default share. Then the area between a chord and its curve is at most 4/3 of it, relative to
/// the cell's area between chord and site: 0.4 %.
inline constexpr double kDefaultShare = 3 * powerOfTwo(-10);

}  // namespace apollonius::internal
