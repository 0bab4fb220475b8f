// The parts of a cell inside a region, as closed boundaries of conic pieces: outer ones run
// counter-clockwise, each followed by those of its holes, which run clockwise.
#pragma once

#include "geometry/cell/cell_clipper.h"
#include "geometry/cell/ring_sorter.h"
#include "geometry/window/polygon_clip.h"

namespace apollonius::internal {

class PolygonCellClipper final : public CellClipper {
 public:
  PolygonCellClipper(const ClippedDiagram& clippedDiagram, Parts parts);

  /// Cost: O(d + c log c + points of the region within the cell) for its c crossings, and for its
  /// holes what ring_nesting.h says: about O(log n) each for n pieces and parts.
  const Cell& find(Slot site) override;

  /// Number of steps taken to find the rings around holes.
  [[nodiscard]] std::size_t looks() const { return rings_.looks(); }

 private:
  /// A crossing on the cell's boundary, in counter-clockwise order from its first half-edge.
  struct Event {
    std::uint32_t crossing;
    std::uint32_t edge;  // index in sides_
  };
  /// A Voronoi edge of the cell, counter-clockwise.
  struct Side {
    HalfedgeId halfedge, edge;  // the cell's; the one of the two at the reference site
    SiteId neighbor;
  };

  void listSides(VertexId v);
  void sortRanks();
  [[nodiscard]] std::uint32_t rankOf(std::uint32_t crossing) const;
  void addBoundaryChain(const Crossing& entry);
  void addBoundary(const Event& from, const Event& to, std::size_t sides);
  void addPiece(const Side& side, const Crossing* from, const Crossing* to);
  [[nodiscard]] std::uint32_t segmentOf(const Crossing* crossing) const;
  void addBorder(Point from, Point to, std::uint32_t segment);
  void addInteriorRings(Slot site);

  const ClippedDiagram& clippedDiagram_;
  Cell cell_;
  RingSorter rings_;
  FlatArray<Side> sides_;
  FlatArray<Event> exits_, entries_;
  FlatArray<Keyed> ranks_;  // indices in exits_, sorted by crossing
  FlatArray<char> isUsed_;  // by entry
};

}  // namespace apollonius::internal
