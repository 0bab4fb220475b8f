// The rings of a cell as they are found, and which of them are holes of which.
#pragma once

#include "geometry/cell/boundary_piece.h"
#include "geometry/cell/cell_clipper.h"
#include "geometry/window/ring_nesting.h"

namespace apollonius::internal {

/// Does a ray from a point to the right cross a curve, an odd number of times?
[[nodiscard]] bool crossesRay(const Conic& c, Point p);

class RingSorter final : private NestedRings {
 public:
  explicit RingSorter(Parts parts) : parts_(parts) {}

  /// Begins a new cell, whose site has this centre.
  void clear(Point center);
  /// Adds a piece to the current ring.
  void add(const BoundaryPiece& piece) { found_.pieces.push_back(piece); }
  /// Ends a ring; takes it back if it has no area up to rounding, unless thin parts are asked for.
  /// Rounding has moved the places where a ring meets edges, but not one that is given.
  void closeRing(bool isGiven = false);
  /// Adds the rings to a cell without parts, each hole behind the outer ring around it. Cost: for
  /// each hole what ring_nesting.h says, about O(log n) for n pieces and rings.
  void sortInto(Cell& cell);

  /// Number of steps taken to find the rings around holes.
  [[nodiscard]] std::size_t looks() const { return nesting_.looks(); }

 private:
  [[nodiscard]] std::size_t pieceCount(std::uint32_t ring) const override {
    return found_.ring(ring).size();
  }
  [[nodiscard]] Piece piece(std::uint32_t ring, std::size_t k) const override {
    const Conic& curve = found_.ring(ring)[k].curve;
    return {curve.p0, curve.p1, curve.p2};
  }
  bool isCrossed(std::uint32_t ring, std::size_t k, Point p) override {
    return crossesRay(found_.ring(ring)[k].curve, p);
  }
  bool isAround(std::uint32_t ring) override { return nesting_.isInside(ring, asked_); }

  Parts parts_;
  Point center_;
  Cell found_;  // in the order in which they are found
  FlatArray<double> areas_;
  RingNesting nesting_{*this};  // the rings that are no holes
  Point asked_;                 // a point of the hole whose outer ring is searched
};

}  // namespace apollonius::internal
