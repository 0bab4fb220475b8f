// How far from their curves drawings and polygons may be.
#pragma once

#include <limits>

#include "number/fp.h"

namespace apollonius::internal {

struct Tolerance {
  double distance;
  /// And, so that what is small beside that keeps its shape, as a share: of a curve's size in
  /// drawings, and in polygons of how far the cells beside it go on from it (chords.h).
  double share = std::numeric_limits<double>::infinity();
};

/// The share by default. A chord is then off by 4/3 of that at most, in units of the area that the
/// cell has between it and its site: 0.4 %.
inline constexpr double kDefaultShare = 3 * powerOfTwo(-10);

}  // namespace apollonius::internal
