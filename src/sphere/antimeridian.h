// Cells as polygons of the plane of longitude and latitude, cut where they cross the meridian of
// 180 degrees and closed along the border of [-180, 180] x [-90, 90] (RFC 7946, section 3.1.9).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/flat_array.h"
#include "sphere/cap.h"

namespace apollonius::internal {

/// A point that is within 10^-12 radians of a pole or of the meridian of 180 degrees is moved
/// there: a boundary through the pole, or along that meridian, would be cut into slivers by its
/// rounding.
[[nodiscard]] Direction snappedToBorder(const Direction& point);

class AntimeridianCutter {
 public:
  /// Closed rings, counter-clockwise outside and clockwise within, one part after the other.
  struct Output {
    std::vector<double>& coordinates;
    std::vector<std::uint32_t>& starts;  ///< gets the end of each ring
    std::vector<std::uint32_t>& parts;   ///< gets the end of each part
  };

  /// Cuts a ring of snapped points that has the cell at its left and is not closed. No points stand
  /// for the whole sphere. `hasNorthPole` tells whether the cell contains the north pole: then, if
  /// the ring does not touch the border, it is a hole. Throws std::bad_alloc.
  void cut(std::span<const Direction> ring, bool hasNorthPole, Output output);

 private:
  /// A part of the ring inside of the rectangle, from border to border.
  struct Arc {
    std::size_t begin, end;  // in points_
    double from, to;         // positions on the border
    bool isJoined;
  };

  void beginArc(const LonLat& point);
  void endArc(const LonLat& point);
  void followChords(std::span<const Direction> ring, std::size_t first);
  void joinArcs(Output output);
  [[nodiscard]] std::size_t arcAfter(double position) const;
  void addBorder(double from, double to);
  void emitRing(Output output);

  FlatArray<LonLat> points_;
  FlatArray<Arc> arcs_;
  FlatArray<LonLat> ring_;
};

}  // namespace apollonius::internal
