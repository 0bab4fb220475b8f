// A region laid over a diagram: the crossings of its rings from cell to cell, and the parts of
// Voronoi edges inside.
//
// Each ring is walked from cell to cell (boundary_walk.h). The walk is a closed way in the Delaunay
// graph, whatever rounding does: it returns to the cell that it began in, and each of its steps
// crosses one edge at one point. Everything else follows from these crossings alone, and so fits
// together: *winding numbers* of Voronoi vertices (how often the region is wound around them: 0
// outside, 1 inside, and other values only within rounding of a place where two rings nearly meet)
// are 0 at infinity, and change along an edge by one at each crossing. The boundary of a part of a
// cell then closes by itself, and a part of an edge belongs to both of its cells. No point is ever
// tested for the side that it is on.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "diagram/diagram_core.h"
#include "geometry/curve/edge.h"
#include "geometry/window/polygon.h"

namespace apollonius::internal {

/// A point where a ring passes from one cell to another.
struct Crossing {
  HalfedgeId edge;  ///< the half-edge that starts at the reference site
  double e;         ///< the parameter E on it (bisector.h)
  Point point;      ///< on the ring
  Slot from, to;    ///< the cells
  bool isForward;   ///< the ring goes from left to right of `edge`, and so the inside follows
  std::uint32_t ring;
  std::uint32_t next;                    ///< the ring's next crossing, where it leaves `to`
  std::uint32_t firstPoint, pointCount;  ///< the ring's points on the way there, cyclically
};

/// A part of an edge inside, from E = e0 to e1, which rounding can have swapped.
struct InsideInterval {
  double e0, e1;
  Conic curve;
  int multiplicity;                   ///< how often it is inside: once, up to rounding
  bool startsAtVertex, endsAtVertex;  ///< rather than at a crossing
};

class ClippedDiagram {
 public:
  /// REQUIRES: `polygon` lives as long. Cost: O(h + crossings), and what boundary_walk.h says.
  ClippedDiagram(const DiagramCore& core, const NormalizedPolygon& polygon);

  [[nodiscard]] const DiagramCore& core() const { return core_; }
  [[nodiscard]] const NormalizedPolygon& polygon() const { return polygon_; }

  [[nodiscard]] const Crossing& crossing(std::uint32_t k) const { return crossings_[k]; }
  [[nodiscard]] std::uint32_t crossingCount() const {
    return static_cast<std::uint32_t>(crossings_.size());
  }
  /// The crossings of an edge, given by its half-edge that starts at the reference site, in the
  /// order of E.
  [[nodiscard]] std::span<const std::uint32_t> crossingsOf(HalfedgeId edge) const;
  /// Rings within one cell: the value is the ring, the key the cell's slot; sorted by key.
  [[nodiscard]] std::span<const Keyed> interiorRings() const { return interiorRings_; }
  [[nodiscard]] std::span<const Keyed> interiorRingsOf(Slot cell) const;
  /// The winding number of a face's Voronoi vertex.
  [[nodiscard]] int windingOf(FaceId f) const {
    if (!isDense()) return isTouched(f) ? sparseWindingOf(f) : 0;
    return windings_[index(f)];
  }

  /// A piece of an edge inside, from E = e0 to e1, with these ends: crossings or Voronoi vertices.
  /// A vertex that is inside by rounding only can be any multiple of the box's width away, and
  /// would spoil areas; so no part of a piece is far from the box.
  [[nodiscard]] Conic pieceInside(const Edge& edge, double e0, double e1, Point from,
                                  Point to) const;

  /// Does a piece of h's edge exist by rounding only: is the edge a point, or does it only touch
  /// the border there?
  [[nodiscard]] bool isTouch(HalfedgeId h, const Edge& edge, const Conic& piece,
                             bool isWhole) const {
    return core_.delaunay().isPoint(h) || (!isWhole && internal::isTouch(edge.bisector, piece));
  }
  [[nodiscard]] bool isTouch(HalfedgeId h, const Edge& edge, const InsideInterval& piece) const {
    return isTouch(h, edge, piece.curve, piece.e0 == edge.e0 && piece.e1 == edge.e1);
  }

  /// Calls visit(from, to, segment) for the segments of a ring from a crossing to its next one, or
  /// parts of these.
  template <class Visit>
  void visitBoundaryChain(const Crossing& crossing, Visit&& visit) const {
    const std::span<const Point> ring = polygon_.ring(crossing.ring);
    const auto size = static_cast<std::uint32_t>(ring.size()),
               first = polygon_.starts[crossing.ring];
    Point at = crossing.point;
    std::uint32_t k = crossing.firstPoint;
    for (std::uint32_t n = 0; n < crossing.pointCount; ++n) {
      if (k >= size) k -= size;
      visit(at, ring[k], first + (k == 0 ? size : k) - 1);
      at = ring[k++];
    }
    visit(at, crossings_[crossing.next].point, first + k - 1);
  }

  /// Is any part of an edge inside? Always false for the half-edge that does not start at the
  /// reference site.
  [[nodiscard]] bool isAnyInside(HalfedgeId h) const;
  /// Returns the edge, and lists its parts inside, in the order of E. REQUIRES: isAnyInside();
  /// vertices that are kept have the same precision.
  Edge edgeInside(HalfedgeId h, VertexPrecision precision, FlatArray<InsideInterval>& pieces,
                  KeptVertices* kept = nullptr) const;
  /// Calls visit(h, edge, piece) for the parts of all edges inside.
  template <class Visit>
  void visitEdges(VertexPrecision precision, Visit&& visit) const {
    const auto count = static_cast<std::uint32_t>(3 * core_.delaunay().graph().faceSlots());
    FlatArray<InsideInterval> pieces;
    // A vertex that is computed anew serves three edges. 512 KB
    constexpr std::size_t kMostKept = std::size_t{1} << 14;
    KeptVertices kept;
    if (precision == VertexPrecision::kReproducible)
      kept.resize(std::min(kMostKept, core_.delaunay().graph().faceSlots()));
    for (std::uint32_t k = 0; k < count; ++k) {
      const HalfedgeId h{k};
      if (!core_.delaunay().graph().isLive(faceOf(h)) || !isAnyInside(h)) continue;
      const Edge edge = edgeInside(h, precision, pieces, kept.empty() ? nullptr : &kept);
      for (const InsideInterval& piece : pieces) visit(h, edge, piece);
    }
  }

 private:
  void sortCrossings();
  void wind();
  [[nodiscard]] bool isCrossed(HalfedgeId edge) const { return isTouched(faceOf(edge)); }
  /// May its vertex be inside, or has one of its half-edges a crossing?
  [[nodiscard]] bool isTouched(FaceId f) const {
    return (touched_[index(f) / 8] >> (index(f) % 8) & 1) != 0;
  }
  void touch(FaceId f) { touched_[index(f) / 8] |= static_cast<unsigned char>(1 << index(f) % 8); }
  [[nodiscard]] bool isDense() const { return !windings_.empty(); }
  [[nodiscard]] int sparseWindingOf(FaceId f) const;
  void thinOut();

  const DiagramCore& core_;
  const NormalizedPolygon& polygon_;
  FlatArray<Crossing> crossings_;  // ring by ring, in their order
  FlatArray<Keyed> interiorRings_;
  FlatArray<std::uint32_t> byEdge_;   // crossings by edge, then by E
  FlatArray<unsigned char> touched_;  // by face, a bit each
  // A view of a small region should not hold much for each site: winding numbers by face, or, where
  // few faces are inside, only theirs (Keyed: the face, its winding number), ascending.
  FlatArray<std::int32_t> windings_;
  FlatArray<Keyed> inside_;
};

}  // namespace apollonius::internal
