// Proves in O(n) that the rings of all cells tile the window, without comparing segments except at
// the border. Where the proof fails the rings may still tile: then all segments are compared
// (mesh.h).
//
//   1. Each ring is simple and counter-clockwise. Either it turns left around its site's centre at
//      each step and goes round once, or no two of its segments meet and it turns left at its
//      leftmost point.
//   2. Each segment that is not on the border also occurs reversed. A sum of hashes shows it, in
//      which a segment and its reverse cancel; by accident it is 0 with a probability of 2^-64.
//   3. Segments of the border meet at common ends only.
//
// By 1 the winding number of a ring is 0 or 1 at every point, so the sum over all rings counts the
// cells that contain the point. By 2 the sum changes only across the border, so it is constant on
// either side of it. The areas of the rings add up to the window's (coverage.cpp checks that), so
// the sum is 1 inside the window and 0 outside: cells neither overlap nor leave gaps. Hence no two
// segments cross, and no segment passes through the end of another, as the cells around that end
// leave no room for it.
#pragma once

#include "geometry/polygons/mesh.h"

namespace apollonius::internal {

class TilingProof {
 public:
  /// REQUIRES: `box` holds the window. All live as long, and the rings stay as they are for
  /// holds().
  TilingProof(const DiagramCore& core, const Rectangle& box, const CellList& raw);

  /// REQUIRES: the cells are to fill the window.
  [[nodiscard]] bool holds();
  /// How far rounding can have moved the border, times its length.
  [[nodiscard]] double borderRounding() const { return borderRounding_; }

 private:
  [[nodiscard]] bool isSimple(const Corners& ring);
  [[nodiscard]] bool doAnyMeet() const;

  const DiagramCore& core_;
  Rectangle box_;
  const CellList& raw_;
  // Those of the border at first, then those of one ring.
  PointNumbers numbers_;
  FlatArray<Segment> segments_;
  double borderRounding_ = 0;
};

}  // namespace apollonius::internal
