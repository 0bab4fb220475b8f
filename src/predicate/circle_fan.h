// The Voronoi circles of many faces at once, two by two: of all around a new site, which is what an
// insertion spends most of its time on, or of any.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "memory/flat_array.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// Room for the rows of a fan; grows as needed, and is used again.
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
  /// infinite error where it is not certain that there is one. REQUIRES: reserve(2 * faces.size()).
  void computeFaces(std::span<const std::array<Corner, 3>> faces, std::span<VoronoiCircle> circles);

 private:
  /// Computes the arrays; false if the numbers are beyond the range of the formulas.
  bool computeAll(const Site& q, std::size_t n);
  double setRow(std::size_t k, const Site& reference, const Site& site);
  void setReference(std::size_t k, const Site& reference);
  void computeBounded(std::size_t n, std::size_t second, std::size_t referenceMask);
  [[nodiscard]] VoronoiCircle circle(std::size_t k) const;

  FlatArray<Corner> corners_;
  // Arrays of stride_ numbers, one for each quantity of a corner or a face (circle_fan.cpp), so
  // that two faces are computed at once.
  FlatArray<double> numbers_;
  std::size_t stride_ = 0;
};

}  // namespace apollonius::internal
