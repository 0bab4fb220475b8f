// The chords that stand for a Voronoi edge in polygons: chosen once, for the cells on both sides.
//
// Polygons fit each other, whatever the tolerance: neighbours have all points of their edge in
// common, no two chords cross, and the polygons tile the same area as the cells. For that each
// chord
//
//   - spans less than a quarter turn seen from both sites, counter-clockwise about the one on its
//     left. A cell is star-shaped about its site's centre, so its chords then lie around that one
//     after the other, in wedges of their own; and triangles between centres and chords are where
//     those between centres and curves are.
//   - lies on the same side of the window's border as its curve: the triangle of the curve's ends
//     and its control point, which holds both, has nothing of the border in it.
//
// By default a chord is also close to its curve for the cells on both sides: it is off by at most a
// share of the height of a triangle over the chord that is in the cell. The triangle to the site's
// centre is in the cell, which is star-shaped, except for the window: so it is made lower until no
// part of the border is in it. Then the area between all chords of a cell and their curves is a
// share of the cell's area, whatever its size and the window's shape.
//
// A piece of an edge is halved until its chord is like that and within the tolerance. Points that
// rounding has put out of order, where they are as close as doubles, are left out for both sides.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "geometry/curve/conic.h"
#include "geometry/curve/tolerance.h"
#include "geometry/window/border.h"
#include "geometry/window/polygon.h"

namespace apollonius::internal {

/// A piece of an edge, and where it meets the border.
struct EdgePiece {
  Conic curve;
  Point left, right;  ///< the centres of the sites on its sides
  std::uint32_t fromSegment = kNoSegment, toSegment = kNoSegment;  ///< polygon segments at its ends
  /// Negative if the cell on the right has the same chords. Otherwise the chords keep to the border
  /// as closely as to the curve, and do not enter the disc of this radius about the centre on the
  /// right, which the curve does not enter either.
  double avoided = -1;
};

class ChordFinder {
 public:
  /// REQUIRES: `border` lives as long.
  ChordFinder(const Border& border, Tolerance tolerance) : border_(border), tolerance_(tolerance) {}

  /// The points of a piece, both ends included. Valid until the next call. Both sides get the same
  /// points only if both give the piece in the same direction.
  [[nodiscard]] std::span<const Point> find(const EdgePiece& piece);
  /// Was an inner point of that piece on the border, or moved there (Border::moveInside)?
  [[nodiscard]] bool isAtBorder() const { return isAtBorder_; }

 private:
  void halve(const Conic& curve, std::uint32_t fromSegment, std::uint32_t toSegment, int depth);
  [[nodiscard]] bool isHalved(const Conic& curve, const Conic& first, const Conic& second,
                              std::uint32_t fromSegment, std::uint32_t toSegment) const;
  [[nodiscard]] bool isLarge(double sagitta, const Conic& curve, Point site,
                             std::uint32_t fromSegment, std::uint32_t toSegment) const;
  /// Has the chord a cell on its right, too?
  [[nodiscard]] bool isBetweenCells() const { return avoided_ < 0; }
  [[nodiscard]] bool turns(Point from, Point to) const;
  [[nodiscard]] bool spansLittle(Point from, Point to) const;
  [[nodiscard]] bool entersDisc(Point from, Point to) const;
  [[nodiscard]] bool isLate(Point from, Point p) const;
  void straighten();

  const Border& border_;
  const Tolerance tolerance_;
  Point left_, right_;
  double size_ = 0, allowed_ = 0, finest_ = 0, finestAtBorder_ = 0, avoided_ = -1;
  FlatArray<Point> points_;
  bool isAtBorder_ = false;
};

}  // namespace apollonius::internal
