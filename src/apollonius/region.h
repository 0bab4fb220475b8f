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

/// Rings, of which the inside is where a line to infinity crosses them an odd number of times
/// (even-odd rule), whatever their directions. They may cross and touch themselves and each other,
/// repeat points, and overlap; parts whose area is but the rounding of their points are left out.
/// Not thread-safe, also for reading: it keeps what it has found out
/// about the diagram that it was last used with, as long as that stays as it is.
class APOLLONIUS_EXPORT Region {
 public:
  Region() noexcept;
  ~Region();
  Region(Region&&) noexcept;
  Region& operator=(Region&&) noexcept;

  /// Replaces the region, which is as it was after an error. Of rings x, y, …, closed by
  /// themselves: starts[k] is the first point of ring k, and the last entry the number of points.
  /// Errors: kBadBounds for a ring of fewer than three points, a coordinate that is not finite or
  /// out of range, starts that do not fit, and if nothing is inside; kOutOfMemory. Cost:
  /// O(m log m), m = points and crossings, unless many segments are close together.
  [[nodiscard]] Error assign(std::span<const double> coordinates,
                             std::span<const std::uint32_t> starts);

  /// The box of what is inside; the default Bounds for a region that has not been assigned.
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
