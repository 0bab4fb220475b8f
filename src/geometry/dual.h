// The dual graph drawn (paper, Appendix A): every Delaunay edge is a piece of the bisector of the two Voronoi circles at the ends of its
// Voronoi edge, which passes through both centres (Lemma 7). Together they are a planar embedding (Theorem 4). By Lemma 8 an edge is
//
//   - a hyperbola piece, or a segment if both circles have the same radius;
//   - a parabola piece, if one of the circles is a half-plane;
//   - a segment, if both are;
//   - a ray from the centre, if the other site is infinity: halfway between the normals of the two half-planes.
//
// Where more than three sites touch one circle, an edge has the same circle at both ends. The limit of its hyperbola are then the two
// segments from the centres to the centre of that circle; several edges can meet there, but they do not cross.
#pragma once

#include "diagram/delaunay_graph.h"
#include "geometry/conic.h"

namespace apollonius {

struct DualEdge {
  Conic curves[2];  ///< from the centre of h's origin to that of its target
  int count = 1;    ///< 2 for an edge with the same circle at both ends
};

/// The drawn edge of h. REQUIRES: two finite sites.
[[nodiscard]] DualEdge dualEdge(const DelaunayGraph& graph, HalfedgeId h);

/// Unit direction of the ray of an edge from a site to infinity. REQUIRES: h's target is infinity.
[[nodiscard]] Point dualRay(const DelaunayGraph& graph, HalfedgeId h);

}  // namespace apollonius
