// The rings of a cell as polygons have them.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "predicate/point.h"

namespace apollonius::internal {

struct Rings {
  FlatArray<double> coordinates;       ///< x, y, … of all rings, the first point again at the end
  FlatArray<std::uint32_t> starts{0};  ///< of each ring its first point; and the number of points
  /// Of each part of the cell its outer ring, counter-clockwise, which those of its holes follow;
  /// and the number of rings.
  FlatArray<std::uint32_t> parts{0};

  void clear() {
    coordinates.clear();
    starts.assign(1, 0);
    parts.assign(1, 0);
  }
  [[nodiscard]] std::size_t ringCount() const { return starts.size() - 1; }
  [[nodiscard]] std::span<const double> ring(std::size_t k) const {
    return std::span(coordinates)
        .subspan(2 * std::size_t{starts[k]}, 2 * std::size_t{starts[k + 1] - starts[k]});
  }
  void add(Point p) {
    coordinates.push_back(p.x);
    coordinates.push_back(p.y);
  }
  /// The points since the last ring are one.
  void endRing() { starts.push_back(static_cast<std::uint32_t>(coordinates.size() / 2)); }
  /// The rings since the last part are one.
  void endPart() { parts.push_back(static_cast<std::uint32_t>(ringCount())); }
};

}  // namespace apollonius::internal
