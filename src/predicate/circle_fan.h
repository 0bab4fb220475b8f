// The Voronoi circles of many faces at once, two by two: of all around a new site, which is what an
// insertion spends most of its time on, or of any.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/flat_array.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// Room for the corners of a fan; grows as needed, and is used again.
class CircleFan {
 public:
  /// Room for n corners around a site. Throws std::bad_alloc.
  void reserve(std::size_t n);

  /// Corner k, counter-clockwise around q.
  void setCorner(std::size_t k, Corner corner) { corners_[k] = corner; }

  /// circles[k] becomes the circle of the face (corner k, corner k+1, q), the last one's next being
  /// the first. Bounds on the errors as in VoronoiCircle; the bits are not those of
  /// voronoiCircle(), which looks from another site. REQUIRES: reserve(circles.size()), all corners
  /// set, all circles exist.
  void compute(const Site& q, std::span<VoronoiCircle> circles);

  /// Circles of counter-clockwise faces of three finite sites, none of which covers another; an
  /// infinite error where it is not certain that there is one.
  static void computeFaces(std::span<const std::array<Corner, 3>> faces,
                           std::span<VoronoiCircle> circles);

 private:
  static constexpr std::size_t kRepeated = 3;  // the first corners follow the last, for the last
                                               // pair of faces

  FlatArray<Corner> corners_;
};

}  // namespace apollonius::internal
