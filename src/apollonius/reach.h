// Limits of cells: a cell ends at a distance from the circle of its site, unless it ends at another
// cell before.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "apollonius/types.h"

namespace apollonius {

/// Distances in the unit of the sites; a negative one ends inside the circle, infinity is no limit.
/// Others must be in the range of coordinates, or calls that use the reach return an error
/// (apollonius/voronoi.h).
class Reach {
 public:
  /// Sets no limit.
  Reach() = default;
  /// Sets one distance for all sites.
  explicit Reach(double distance) : all_(taken(distance)) { note(all_); }
  /// Sets a distance for each id; ids beyond have no limit. Throws std::bad_alloc.
  explicit Reach(std::span<const double> byId) : byId_(byId.begin(), byId.end()) {
    for (double& distance : byId_) note(distance = taken(distance));
  }
  /// Limits some ids, ascending, for calls about one cell; all others have no limit. Throws
  /// std::bad_alloc. REQUIRES: as many distances as ids, at least one.
  Reach(std::span<const SiteId> ids, std::span<const double> distances) : Reach(distances) {
    ids_.assign(ids.begin(), ids.end());
  }

  /// Is there a NaN, or a distance out of range?
  [[nodiscard]] bool hasNaN() const { return hasNaN_; }
  [[nodiscard]] bool isOutOfRange() const { return isOutOfRange_; }

  [[nodiscard]] bool isUnlimited() const {
    return byId_.empty() && all_ == std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] double of(SiteId id) const {
    if (byId_.empty()) return all_;
    std::size_t row = id;
    if (!ids_.empty()) {
      const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
      const bool isIn = found != ids_.end() && *found == id;
      row = isIn ? static_cast<std::size_t>(found - ids_.begin()) : byId_.size();
    }
    return row < byId_.size() ? byId_[row] : all_;
  }

 private:
  void note(double distance) {
    const bool isNaN = distance != distance;
    hasNaN_ = hasNaN_ || isNaN;
    const bool isUnlimited = distance == std::numeric_limits<double>::infinity();
    isOutOfRange_ = isOutOfRange_ || !(isNaN || isUnlimited || isInRange(distance));
  }

  double all_ = std::numeric_limits<double>::infinity();
  std::vector<double> byId_;
  std::vector<SiteId> ids_;  // the ids of byId_'s rows; empty if row k is that of id k
  bool hasNaN_ = false, isOutOfRange_ = false;
};

}  // namespace apollonius
