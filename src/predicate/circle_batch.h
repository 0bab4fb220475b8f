// The Voronoi circles of many faces that are added one by one: collects them in blocks, in which
// CircleFan computes two circles at a time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "predicate/circle_fan.h"

namespace apollonius::internal {

inline constexpr std::size_t kCircleBatch = 64;

/// Calls take(face, circle) for each face added, in their order, at the latest in finish(). `face`
/// is the caller's number for it; the circle is that of CircleFan::computeFaces.
template <class Take>
class CircleBatch {
 public:
  explicit CircleBatch(Take take) : take_(take) {}

  /// Adds a face. REQUIRES: three finite sites.
  void add(std::uint32_t face, const std::array<Corner, 3>& corners) {
    faces_[count_] = face;
    corners_[count_] = corners;
    if (++count_ == kCircleBatch) finish();
  }

  void finish() {
    CircleFan::computeFaces({corners_.data(), count_}, circles_);
    for (std::size_t k = 0; k < count_; ++k) take_(faces_[k], circles_[k]);
    count_ = 0;
  }

 private:
  Take take_;
  std::array<std::uint32_t, kCircleBatch> faces_;
  std::array<std::array<Corner, 3>, kCircleBatch> corners_;
  std::array<VoronoiCircle, kCircleBatch> circles_;
  std::size_t count_ = 0;
};

}  // namespace apollonius::internal
