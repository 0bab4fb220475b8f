// How far cells reach: cut at a distance from the circles of their sites, they grow until they meet
// or have come so far.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "apollonius/types.h"

namespace apollonius {

/// In units of the sites; a negative distance ends inside the circle, infinity nowhere.
class Reach {
 public:
  /// Everywhere.
  Reach() = default;
  /// The same distance for all sites. REQUIRES: no NaN.
  explicit Reach(double distance) : all_(distance) {}
  /// A distance for each id. Throws std::bad_alloc. REQUIRES: no NaN.
  explicit Reach(std::span<const double> byId) : byId_(byId.begin(), byId.end()), isById_(true) {}

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
  double all_ = std::numeric_limits<double>::infinity();
  std::vector<double> byId_;
  bool isById_ = false;
};

}  // namespace apollonius
