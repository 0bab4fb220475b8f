// Do the rings of all cells tile the window? A proof in O(n), which looks at no pairs but of what
// is at the border. It may miss that they do; then segments are compared (mesh.h).
//
//   1. Each ring is simple and counter-clockwise: it turns once around the site's centre, to the
//      left at each step; or no two of its segments meet, and it turns left in its leftmost point.
//   2. Each segment that is not of the border has its reverse in another ring: a sum of hashes, in
//      which both directions cancel, is 0.
//   3. Segments of the border meet in common ends only.
//
// By 1 each ring winds 0 or 1 times around every point, so what all wind is at least 0, and as many
// as there are cells at the point. By 2 that number changes across the border only, and by 3 the
// border is closed curves side by side. So it is the same in each of the areas between them. Their
// sum is the window's area (coverage.cpp): the number is 1 inside of the window and 0 outside, and
// where one cell is no other is. Then no two segments cross, nor does one pass an end of another:
// the cells around that end would leave no room for it.
#pragma once

#include "geometry/polygons/mesh.h"

namespace apollonius::internal {

class TilingProof {
 public:
  TilingProof(const DiagramCore& core, const Rectangle& box, const CellList& raw);

  [[nodiscard]] bool holds() const { return holds_; }
  /// How far rounding can have moved the border, times its length.
  [[nodiscard]] double borderRounding() const { return borderRounding_; }

 private:
  [[nodiscard]] bool isSimple(const Corners& ring);
  [[nodiscard]] bool doAnyMeet() const;
  void listBorder(const DiagramCore& core, const CellList& raw);

  Rectangle box_;
  // Of the ring, or the border, that is looked at.
  PointNumbers numbers_;
  FlatArray<Segment> segments_;
  bool holds_ = false;
  double borderRounding_ = 0;
};

}  // namespace apollonius::internal
