// Filling the hole that a deletion leaves, the quick way for the common case: by clipping ears off
// the polygon of the neighbours.
//
// Three consecutive corners a, b, c of the polygon are an ear if their Voronoi circle exists, is in
// conflict with the removed site (so it lies in the cell that becomes free) and with no other
// corner. Then it is a vertex of the new diagram: there, only the neighbours matter. A polygon of m
// corners takes m - 2 faces, and the new diagram has as many there; so if clipping ends, the faces
// are those of the new diagram. They fit together in one way only, as the corners are pairwise
// different: then a pair of corners is at most one chord. (Sites that are neighbours of the removed
// one several times, and sites that it had hidden, are left to the small diagram of remove.h.)
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"

namespace apollonius::internal {

class EarClipper {
 public:
  /// The time for longer polygons grows with the square or worse.
  static constexpr std::size_t kMostCorners = 24;

  /// Fills the hole of v, whose link is given (remove.h). False if the link is no simple polygon:
  /// then there is no result. REQUIRES: v hid no site that becomes visible; a link of at least 3.
  /// Throws std::bad_alloc.
  [[nodiscard]] bool fill(const DelaunayGraph& delaunay, VertexId v,
                          std::span<const HalfedgeId> link);

  /// Makes room for the largest polygon.
  void reserve() {
    corners_.reserve(kMostCorners);
    patch_.reserve(kMostCorners);
    circles_.reserve(kMostCorners);
  }

  [[nodiscard]] std::span<const Graph::PatchFace> patch() const { return patch_; }
  [[nodiscard]] std::span<const VoronoiCircle> circles() const { return circles_; }

 private:
  struct CornerOfHole {
    VertexId vertex;
    std::uint32_t side;  ///< beyond the edge to the next corner, as in Graph::PatchFace
  };

  [[nodiscard]] bool isEar(const DelaunayGraph& delaunay, const Site& removed, std::size_t a,
                           std::size_t b, std::size_t c, VoronoiCircle& circle) const;
  void addFace(std::size_t a, std::size_t b, std::size_t c, const VoronoiCircle& circle);
  void join(std::uint32_t halfedge, std::uint32_t side);

  FlatArray<CornerOfHole> corners_;  // the rest of the polygon
  FlatArray<Graph::PatchFace> patch_;
  FlatArray<VoronoiCircle> circles_;
};

}  // namespace apollonius::internal
