// A window of any shape, for apollonius/voronoi.h: holes, several parts, not convex.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "apollonius/bounds.h"
#include "apollonius/diagram.h"
#include "apollonius/export.h"
#include "apollonius/path.h"

namespace apollonius {

namespace internal {
struct RegionState;
}

/// A region bounded by rings, whatever their directions: a point is inside if a line from it to
/// infinity crosses them an odd number of times (even-odd rule). Rings may cross and touch
/// themselves and each other, repeat points, and overlap; parts whose area is only the rounding of
/// their points are left out. Not thread-safe, also for reading: a region caches results for the
/// diagram that it was last used with, as long as that does not change.
class APOLLONIUS_EXPORT Region {
 public:
  Region() noexcept;
  ~Region();
  Region(Region&&) noexcept;
  Region& operator=(Region&&) noexcept;

  /// Replaces the region by that of the rings x, y, …; after an error it is unchanged. The last
  /// point of a ring is joined to its first; starts[k] is the first point of ring k, and the last
  /// entry the number of points. Errors: kBadBounds for a ring of fewer than three points, a
  /// coordinate that is not finite or out of range, starts that do not fit, and if nothing is
  /// inside; kOutOfMemory. Cost: O(m log m), m = points and crossings, unless many segments are
  /// close together.
  [[nodiscard]] Error assign(std::span<const double> coordinates,
                             std::span<const std::uint32_t> starts);

  /// The box of the inside; the default Bounds for a region that has not been assigned.
  [[nodiscard]] Bounds box() const noexcept;
  /// 0, as are both below, for a region that has not been assigned.
  [[nodiscard]] double area() const noexcept;
  [[nodiscard]] double centroidX() const noexcept;
  [[nodiscard]] double centroidY() const noexcept;
  /// Is a point inside or on the border that draw() draws? Exact. false unless x and y are finite.
  /// Cost: O(m).
  [[nodiscard]] bool contains(double x, double y) const noexcept;
  /// Draws its border: rings that do not cross, the inside on the left of each, so that any fill
  /// rule fills it. Errors: kOutOfMemory.
  [[nodiscard]] Error draw(Path& path) const;

 private:
  friend class AreaFit;
  friend class Voronoi;

  std::unique_ptr<internal::RegionState> state_;
};

}  // namespace apollonius
