// Voronoi edges clipped to a window, analytically: conic against line.
//
// Each decision by rounded numbers is made once: whether a vertex is in the window (by its
// coordinates, the same for its three edges), and then where an edge crosses a side's line. An edge
// whose ends are on different sides of a line crosses it once, upwards or downwards, and the
// crossing is the root of the quadratic with that slope, whatever the roots' rounding. An edge
// whose ends are on the same side crosses it twice or not at all, which is decided at the extremum
// between. So a rounding error can only move a crossing, never lose or invent one, and all cells
// fit together.
#pragma once

#include <array>

#include "geometry/curve/edge.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// The side of a piece's end that is a Voronoi vertex, not on the border.
inline constexpr signed char kNoSide = -1;

/// A part of an edge inside the window, counter-clockwise about the edge's reference site.
struct ClippedPiece {
  Conic curve;
  signed char fromSide = kNoSide;  ///< the side of the window on which it starts
  signed char toSide = kNoSide;    ///< the side on which it ends
  bool isTouch = false;            ///< does the edge only touch the border there?
  [[nodiscard]] ClippedPiece reversed() const {
    return {curve.reversed(), toSide, fromSide, isTouch};
  }
};

/// At most five pieces: each of four lines is crossed upwards at most once, so the window is left
/// at most four times.
struct ClippedEdge {
  std::array<ClippedPiece, 5> pieces;
  int count = 0;
};

void clipEdge(const Edge& edge, const Rectangle& window, ClippedEdge& clipped);
/// Clips the edge dual to h. Edges of one drawing or sum use the same bits of vertices, so that
/// they meet. An edge that is a point has no pieces if its ends have the same bits, as those of
/// kReproducible have: then it does not cross the border. REQUIRES: startsAtReference.
void clipEdge(const DelaunayGraph& delaunay, HalfedgeId h, const Rectangle& window,
              ClippedEdge& clipped, VertexPrecision precision = VertexPrecision::kReproducible,
              KeptVertices* kept = nullptr);

/// Clips all edges of the diagram. Calls visit(h, piece) for each piece inside, h being the
/// half-edge that it is a part of.
template <class Visit>
void forEachClippedPiece(const DelaunayGraph& delaunay, const Rectangle& window,
                         VertexPrecision precision, Visit&& visit) {
  const Graph& graph = delaunay.graph();
  delaunay.computeMissingCircles();
  ClippedEdge clipped;
  for (const FaceId f : graph.faces()) {
    for (unsigned c = 0; c < 3; ++c) {
      const HalfedgeId h = halfedgeOf(f, c);
      if (graph.origin(h) == kInfinity || graph.target(h) == kInfinity ||
          !startsAtReference(delaunay, h))
        continue;
      clipEdge(delaunay, h, window, clipped, precision);
      for (int piece = 0; piece < clipped.count; ++piece)
        visit(h, clipped.pieces[static_cast<std::size_t>(piece)]);
    }
  }
}

}  // namespace apollonius::internal
