// From the segments around a cell to its polygons, in the sense of OGC's Simple Features and RFC
// 7946: rings that pass no point twice, each outer one with its holes.
//
// Segments are linked so that only the inside is between one and the next. The way is cut where it
// comes to a point again: so a hole that touches the ring around it in one point becomes a ring of
// its own; where it touches in two, the outer ring falls into two. A segment and its reverse cancel
// each other.
#pragma once

#include "geometry/polygons/point_numbers.h"
#include "geometry/polygons/rings.h"
#include "geometry/window/rectangle.h"
#include "geometry/window/ring_nesting.h"

namespace apollonius::internal {

class Tracer final : private NestedRings {
 public:
  void clear();
  /// Adds a closed ring, the inside on its left. REQUIRES: rings do not cross.
  void addRing(std::span<const double> ring);
  /// Does any point occur twice?
  [[nodiscard]] bool hasTouch() const { return numbers_.points().size() < segments_.size(); }
  /// Finds the polygons of all rings added, without loops thinner than `thinnest`. Replaces the
  /// contents. Cost: O(m log m) for m points; and for holes what ring_nesting.h says.
  void trace(Rings& rings, double thinnest = 0);

 private:
  struct Segment {
    std::uint32_t from, to;
    bool isDone;
  };
  struct Loop {
    std::uint32_t first, count;
    double area;
    Rectangle box;
  };

  [[nodiscard]] Point at(std::uint32_t number) const { return numbers_.points()[number]; }
  void sortSegments();
  void cancel();
  [[nodiscard]] std::uint32_t next(std::uint32_t segment) const;
  void cut(std::uint32_t point);
  void link();
  [[nodiscard]] std::span<const Point> ringOf(const Loop& loop) const {
    return std::span(traced_).subspan(loop.first, loop.count);
  }
  [[nodiscard]] std::size_t pieceCount(std::uint32_t loop) const override {
    return loops_[loop].count;
  }
  [[nodiscard]] Piece piece(std::uint32_t loop, std::size_t k) const override {
    const std::span<const Point> ring = ringOf(loops_[loop]);
    const Point from = ring[k > 0 ? k - 1 : ring.size() - 1];
    return {from, from, ring[k]};
  }
  bool isCrossed(std::uint32_t loop, std::size_t k, Point p) override;
  bool isAround(std::uint32_t loop) override;

  PointNumbers numbers_;
  FlatArray<Segment> segments_;
  FlatArray<std::uint32_t> firstFrom_;  // by point: its first segment; and the number of segments
  FlatArray<std::uint32_t> way_, indexOnWay_;
  FlatArray<Point> traced_;  // the loops' points
  FlatArray<Loop> loops_;
  RingNesting nesting_{*this};  // the loops that are no holes
  std::uint32_t hole_ = 0;      // the hole whose outer loop is searched
  bool isCorner_ = false;       // is the point that was tested a corner of the loop?
  double width_ = 0;            // thinner loops are dropped
};

}  // namespace apollonius::internal
