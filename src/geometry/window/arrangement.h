// The segments of all rings of a polygon, split where they meet; polygon.h lists the steps by which
// they become rings that do not cross.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "geometry/window/polygon.h"
#include "geometry/window/rectangle.h"
#include "geometry/window/segment_pairs.h"

namespace apollonius::internal {

class Arrangement {
 public:
  /// `fewLooks` is that of SegmentPairs.
  explicit Arrangement(const Rectangle& box, double fewLooks = SegmentPairs::kFewLooks)
      : box_(box), fewLooks_(fewLooks) {}

  /// Adds a ring; its last point is joined to its first.
  void addRing(std::span<const double> coordinates) {
    const auto first = static_cast<std::uint32_t>(points_.size());
    for (std::size_t k = 0; k + 1 < coordinates.size(); k += 2) {
      const auto at = static_cast<std::uint32_t>(points_.size());
      points_.push_back({coordinates[k] + 0.0, coordinates[k + 1] + 0.0});  // -0 becomes 0
      segments_.push_back({at, at + 1});
    }
    segments_.back().to = first;
  }

  /// Steps 1 and 2. False if they do not end.
  [[nodiscard]] bool split();
  /// Step 3. REQUIRES: split().
  void orient();
  /// Step 4: writes the rings to an empty polygon. REQUIRES: orient().
  void link(NormalizedPolygon& polygon);

  /// Number of pairs of segments examined.
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  struct Cut {
    std::uint32_t segment;
    std::uint32_t point;
  };

  [[nodiscard]] Point from(const Segment& s) const { return points_[s.from]; }
  [[nodiscard]] Point to(const Segment& s) const { return points_[s.to]; }
  /// Rounds a point to the grid, if there is one: adding 3·2^51 units drops the fraction.
  [[nodiscard]] Point rounded(Point p) const {
    const Point big = 3 * powerOfTwo(51) * unit_;
    return p + big - big;
  }
  [[nodiscard]] bool rises(const Segment& s) const { return from(s).y <= to(s).y; }
  [[nodiscard]] bool passes(const Segment& s, std::uint32_t point) const;

  void unify();
  void snap();
  bool findCuts();
  bool cutAt(std::uint32_t segment, std::uint32_t point);
  void cutBoth(std::uint32_t k, std::uint32_t m, FlatArray<Cut>& crossings);
  [[nodiscard]] Point crossingOf(const Segment& s, const Segment& t) const;
  void cut();
  void listEnds();
  /// The segments that have an end at a point.
  [[nodiscard]] std::span<const Keyed> endsAt(std::uint32_t point) const {
    return std::span(ends_).subspan(firstEnd_[point], firstEnd_[point + 1] - firstEnd_[point]);
  }
  [[nodiscard]] bool isInsideBelow(std::uint32_t segment, std::span<const std::uint32_t> below,
                                   std::span<const char> turns) const;
  [[nodiscard]] std::uint32_t next(std::uint32_t segment) const;

  Rectangle box_;
  double fewLooks_;
  std::size_t looks_ = 0;
  bool areRounded_ = false;  // are the last cuts crossings, which are rounded?
  Point unit_;               // unit of the grid that all points are on; 0: no grid
  FlatArray<Point> points_;
  FlatArray<Segment> segments_;  // after unify(): from comes before to, until orient()
  FlatArray<Cut> cuts_;
  FlatArray<Keyed> ends_;              // segments by their ends
  FlatArray<std::uint32_t> firstEnd_;  // by point: its first entry in ends_; and their number
};

}  // namespace apollonius::internal
