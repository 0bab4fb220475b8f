// The parts of a cell inside a region, as closed boundaries of conic pieces: outer ones run
// counter-clockwise, each followed by those of its holes, which run clockwise.
#pragma once

#include "geometry/cell/cell_clipper.h"
#include "geometry/window/polygon_clip.h"
#include "geometry/window/ring_nesting.h"

namespace apollonius::internal {

class PolygonCellClipper final : public CellClipper, private NestedRings {
 public:
  PolygonCellClipper(const ClippedDiagram& clippedDiagram, Parts parts);

  /// Cost: O(d + crossings of the cell + points of the region within it), and for its
  /// holes what ring_nesting.h says: about O(log n) each for n pieces and parts.
  const Cell& find(Slot site) override;

  /// How much has been looked at to find the rings around holes.
  [[nodiscard]] std::size_t looks() const { return nesting_.looks(); }

 private:
  /// A crossing on the cell's boundary, in counter-clockwise order from its first half-edge.
  struct Event {
    std::uint32_t crossing;
    std::uint32_t edge;  // of edges_
  };
  /// A Voronoi edge of the cell, counter-clockwise.
  struct Side {
    HalfedgeId halfedge, edge;  // of the cell; the one of the two at the reference site
    SiteId neighbor;
  };

  void listSides(VertexId v);
  void addBoundaryChain(const Crossing& entry);
  void addBoundary(const Event& from, const Event& to, std::size_t sides);
  void addPiece(const Side& side, const Crossing* from, const Crossing* to);
  [[nodiscard]] std::uint32_t segmentOf(const Crossing* crossing) const;
  void addSegment(Point from, Point to, SiteId neighbor);
  void addInteriorRings(Slot site);
  /// Ends a ring; takes it back if it has no area up to rounding.
  void closeRing();
  /// Puts each hole behind the outer ring around it.
  void sortHoles();
  [[nodiscard]] std::size_t pieceCount(std::uint32_t ring) const override {
    return found_.ring(ring).size();
  }
  [[nodiscard]] Piece piece(std::uint32_t ring, std::size_t k) const override {
    const Conic& curve = found_.ring(ring)[k].curve;
    return {curve.p0, curve.p1, curve.p2};
  }
  bool isCrossed(std::uint32_t ring, std::size_t k, Point p) override;
  bool isAround(std::uint32_t ring) override { return nesting_.isInside(ring, asked_); }

  const ClippedDiagram& clippedDiagram_;
  Cell cell_;
  Cell found_;  // the rings in the order in which they are found
  FlatArray<double> areas_;
  RingNesting nesting_{*this};  // of those that are no holes
  Point asked_;                 // of the hole whose ring is searched
  FlatArray<Side> sides_;
  FlatArray<Event> exits_, entries_;
  FlatArray<std::uint32_t> rankOf_;  // by crossing: of exits_
  FlatArray<char> isUsed_;           // by entry
};

}  // namespace apollonius::internal
