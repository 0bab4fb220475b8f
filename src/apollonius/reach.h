// How far cells reach: cut at a distance from the circles of their sites, they grow until they meet
// or have come so far.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "apollonius/types.h"

namespace apollonius {

/// In units of the sites; a negative distance ends inside the circle, infinity nowhere. All others
/// are in the range of coordinates, or calls that use it return an error (apollonius/voronoi.h).
class Reach {
 public:
  /// Everywhere.
  Reach() = default;
  /// The same distance for all sites.
  explicit Reach(double distance) : all_(distance) { note(distance); }
  /// A distance for each id. Throws std::bad_alloc.
  explicit Reach(std::span<const double> byId) : byId_(byId.begin(), byId.end()), isById_(true) {
    for (const double distance : byId) note(distance);
  }

  /// Is there a NaN, or a distance out of range?
  [[nodiscard]] bool hasNaN() const { return hasNaN_; }
  [[nodiscard]] bool isOutOfRange() const { return isOutOfRange_; }

  [[nodiscard]] bool isUnlimited() const {
    return !isById_ && all_ == std::numeric_limits<double>::infinity();
  }
  /// Is there a distance for all ids below a limit?
  [[nodiscard]] bool covers(std::size_t idLimit) const {
    return !isById_ || idLimit <= byId_.size();
  }
  /// REQUIRES: there is one.
  [[nodiscard]] double of(SiteId id) const { return isById_ ? byId_[id] : all_; }

 private:
  void note(double distance) {
    const bool isNaN = distance != distance;
    hasNaN_ = hasNaN_ || isNaN;
    const bool isUnlimited = distance == std::numeric_limits<double>::infinity();
    isOutOfRange_ = isOutOfRange_ || !(isNaN || isUnlimited || isInRange(distance));
  }

  double all_ = std::numeric_limits<double>::infinity();
  std::vector<double> byId_;
  bool isById_ = false;
  bool hasNaN_ = false, isOutOfRange_ = false;
};

}  // namespace apollonius
