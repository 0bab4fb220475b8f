// Cells as polygons of the plane of longitude and latitude, cut where they cross the meridian of
// 180 degrees and closed along the border of [-180, 180] x [-90, 90] (RFC 7946, section 3.1.9).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "base/function_ref.h"
#include "sphere/cap.h"

namespace apollonius::internal::sphere {

/// A point within kNearBorder of the meridian of 180 degrees, in radians, is moved there, and one
/// within kNearPole of a pole to the pole: otherwise, rounding would cut a boundary along that
/// meridian, or through the pole, into slivers. At kNearPole from a pole, the former changes
/// longitude by less than 8 degrees.
inline constexpr double kNearBorder = 0x1p-40, kNearPole = 0x1p-37;
[[nodiscard]] Direction snappedToBorder(const Direction& point);

/// Polygons of longitudes and latitudes, one after the other: parts, each a row of closed rings.
struct LonLatRings {
  FlatArray<double> coordinates;       ///< longitude, latitude of each point
  FlatArray<std::uint32_t> starts{0};  ///< 0 and the end of each ring, in points
  FlatArray<std::uint32_t> parts{0};   ///< 0 and the end of each part, in rings

  void endRing() { starts.push_back(static_cast<std::uint32_t>(coordinates.size() / 2)); }
  void endPart() { parts.push_back(static_cast<std::uint32_t>(starts.size() - 1)); }
};

class AntimeridianCutter {
 public:
  /// `tolerance` is that of the points of rings, in degrees.
  explicit AntimeridianCutter(double tolerance)
      : thinnest_(std::max(tolerance, 0x1p-20)) {}  // as far as rounding moves a thin ring's points

  /// Cuts a ring of snapped points that has the cell on its left and is not closed, and appends the
  /// resulting rings: outer ones counter-clockwise, holes clockwise. An empty ring stands for the
  /// whole sphere. `areaOfCell` gives the area of the cell on the unit sphere; few rings need it.
  /// Throws std::bad_alloc.
  void cut(std::span<const MapPoint> ring, FunctionRef<double()> areaOfCell, LonLatRings& output);

 private:
  /// A part of the ring inside of the rectangle, from border to border.
  struct Arc {
    std::size_t begin = 0, end = 0;  // range in points_
    double from = 0, to = 0;         // positions on the border
    std::size_t next = 0;            // the arc that follows
    double border = 0;               // distance to its beginning along the border; negative: behind
    bool isLinked = false, isFollowed = false, isDone = false;
  };

  void beginArc(const LonLat& point);
  void endArc(const LonLat& point);
  void followChords(std::span<const MapPoint> ring, std::size_t first);
  void linkArcs(double areaOfCell);
  void linkBehind();
  void linkNext();
  void emitArcs(LonLatRings& output);
  void trace(std::size_t first);
  void addBorder(double from, double to);
  bool emitRing(LonLatRings& output);

  double thinnest_;  // thinner rings may have the wrong orientation
  FlatArray<LonLat> points_;
  FlatArray<Arc> arcs_;
  FlatArray<LonLat> ring_;
};

}  // namespace apollonius::internal::sphere
