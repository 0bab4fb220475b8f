// The rings of polygons.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "predicate/point.h"

namespace apollonius::internal {

/// The points of a ring, each once.
class Corners {
 public:
  /// Takes coordinates with the first point again at the end.
  explicit Corners(std::span<const double> ring) : ring_(ring) {}
  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(ring_.size() / 2 - 1);
  }
  /// Corner k; at size() the first one again.
  [[nodiscard]] Point operator[](std::size_t k) const { return {ring_[2 * k], ring_[2 * k + 1]}; }

 private:
  std::span<const double> ring_;
};

struct Rings {
  FlatArray<double> coordinates;       ///< x, y, … of all rings, the first point again at the end
  FlatArray<std::uint32_t> starts{0};  ///< the first point of each ring, and the number of points
  /// The outer ring of each part of the cell, and the number of rings. An outer ring runs
  /// counter-clockwise, and those of its holes follow it.
  FlatArray<std::uint32_t> parts{0};

  void clear() {
    coordinates.clear();
    starts.assign(1, 0);
    parts.assign(1, 0);
  }
  [[nodiscard]] std::size_t ringCount() const { return starts.size() - 1; }
  [[nodiscard]] std::size_t partCount() const { return parts.size() - 1; }
  [[nodiscard]] std::span<const double> ring(std::size_t k) const {
    return std::span(coordinates)
        .subspan(2 * std::size_t{starts[k]}, 2 * std::size_t{starts[k + 1] - starts[k]});
  }
  [[nodiscard]] Corners corners(std::size_t k) const { return Corners(ring(k)); }
  void add(Point p) {
    coordinates.push_back(p.x);
    coordinates.push_back(p.y);
  }
  /// Adds the parts of `other` from `first` to before `end`.
  void append(const Rings& other, std::size_t first, std::size_t end);
  /// Makes a ring of the points since the last one.
  void endRing() { starts.push_back(static_cast<std::uint32_t>(coordinates.size() / 2)); }
  /// Makes a part of the rings since the last one.
  void endPart() { parts.push_back(static_cast<std::uint32_t>(ringCount())); }
};

}  // namespace apollonius::internal
