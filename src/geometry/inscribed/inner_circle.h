// The largest circle inside an outline of curves: a cell's, with the window's border and all its
// holes. (Cartographers call its centre the pole of inaccessibility.)
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "geometry/cell/boundary_piece.h"
#include "geometry/inscribed/widest_place.h"

namespace apollonius::internal {

/// Replaces `curves` by those of a cell.
void copyCurves(const Cell& cell, FlatArray<Conic>& curves);
/// The box of the control points of some curves, which holds them. REQUIRES: there is a curve.
[[nodiscard]] Rectangle boxOf(std::span<const Conic> curves);
/// The least difference between coordinates in a box that doubles can tell.
[[nodiscard]] double grainOf(const Rectangle& box);

/// Keeps its scratch memory from one outline to the next.
class InnerCircleFinder {
 public:
  /// Finds the largest circle inside rings of curves: starts[k] is the first curve of ring k, and
  /// the last entry the number of curves; at least one. r is at least 0.999 of what is possible,
  /// and the circle is inside up to rounding. With an aspect, finds the ellipse that is that many
  /// times as wide as high: r is half its height. Result, cost and exceptions are those of
  /// WidestPlace::find().
  [[nodiscard]] bool find(std::span<const Conic> curves, std::span<const std::uint32_t> starts,
                          double aspect, Place& circle);

 private:
  FlatArray<Conic> narrowed_;
  BorderTree border_;
  WidestPlace search_{border_};
};

}  // namespace apollonius::internal
