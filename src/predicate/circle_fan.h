// The Voronoi circles of all faces around a new site at once: what an insertion spends most of its time on.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius {

/// Room for the rows of a fan; grows as needed, and is used again.
class CircleFan {
 public:
  /// Room for a rim of n corners. Throws std::bad_alloc.
  void reserve(std::size_t n);

  /// Corner k of the rim, counter-clockwise around q.
  void setCorner(std::size_t k, Corner corner) { corners_[k] = corner; }

  /// circles[k] becomes the circle of the face (corner k, corner k+1, q), the last one's next being the first. Bounds on the errors
  /// as in VoronoiCircle; the bits are not those of voronoiCircle(), which looks from another site.
  /// REQUIRES: reserve(circles.size()), all corners set, all circles exist.
  void compute(const Site& q, std::span<VoronoiCircle> circles);

 private:
  /// Computes the arrays; false if the numbers are beyond the range of the formulas.
  bool computeAll(const Site& q, std::size_t n);
  void computeBounded(const Site& q, std::size_t n);

  std::vector<Corner> corners_;
  // Arrays of stride_ numbers, one for each quantity of a corner or a face (circle_fan.cpp), so that two faces are computed at once.
  std::vector<double> numbers_;
  std::size_t stride_ = 0;
};

}  // namespace apollonius
