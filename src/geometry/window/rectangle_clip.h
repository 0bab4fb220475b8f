// Voronoi edges clipped to a window, analytically: conic against line.
//
// What is decided by rounded numbers is decided once: whether a vertex is in the window (by its
// coordinates, the same for its three edges), and then where an edge crosses a side's line. An edge
// whose ends are on different sides of a line crosses it once, upwards or downwards, and that
// crossing is the root of the quadratic with that slope, whatever the roots' rounding; one whose
// ends are on the same side crosses it twice or not at all, and that is decided at the extremum
// between. So a rounding error can only move a crossing, never lose one or invent one, and all
// cells fit together.
#pragma once

#include <array>

#include "geometry/curve/edge.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// Not on the border: an end of a piece that is a Voronoi vertex.
inline constexpr signed char kNoSide = -1;

/// A part of an edge inside the window, counter-clockwise about the edge's reference site.
struct ClippedPiece {
  Conic curve;
  signed char fromSide = kNoSide;  ///< the side of the window on which it starts
  signed char toSide = kNoSide;    ///< and ends
  bool isTouch = false;            ///< does the edge but touch the border there?
  [[nodiscard]] ClippedPiece reversed() const {
    return {curve.reversed(), toSide, fromSide, isTouch};
  }
};

/// At most five: each of four lines is crossed upwards once at most, so the window is left four
/// times at most.
struct ClippedEdge {
  std::array<ClippedPiece, 5> pieces;
  int count = 0;
};

void clipEdge(const Edge& edge, const Rectangle& window, ClippedEdge& clipped);
/// Clips the edge dual to h. Edges of one drawing or sum take the same bits, so that they meet.
/// Nothing is left of an edge that is a point if its ends have the same bits, as those of
/// kReproducible have: then it does not cross the border. REQUIRES: startsAtReference.
void clipEdge(const DelaunayGraph& delaunay, HalfedgeId h, const Rectangle& window,
              ClippedEdge& clipped, VertexPrecision precision = VertexPrecision::kReproducible,
              KeptVertices* kept = nullptr);

/// Clips all edges of the diagram; visit(h, piece) gets each piece that is left, with the half-edge
/// that it is a part of.
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
