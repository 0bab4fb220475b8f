// The drawing of the dual graph (paper, Appendix A): every Delaunay edge is a piece of the bisector
// of the two Voronoi circles at the ends of its Voronoi edge; this bisector passes through both
// centres (Lemma 7). Together they are a planar embedding (Theorem 4). By Lemma 8 an edge is
//
//   - a hyperbola piece, or a segment if both circles have the same radius;
//   - a parabola piece, if one of the circles is a half-plane;
//   - a segment, if both are;
//   - a ray from the centre, if the other site is infinity: halfway between the normals of the two
//   half-planes.
//
// The sites' centres i and j and those of the circles are a quadrilateral with an incircle (the
// differences of opposite sides' lengths are the same: r_i - r_j). So the tangents of the Voronoi
// edge at its vertices and those of the dual edge at i and j, which halve its angles, all meet in
// one point m, the control point of both curves; and the dual edge has the weight √(|i c| |j c|) /
// |m c| for either circle's centre c. Seen from the reference site, m depends on the directions d
// of the two vertices and on 1/rho only:
//
//     m = i + p (d1 + d2) / (p/rho1 + p/rho2 + |r_j - r_i| |d1 - d2|²),
//
// sums of positive terms, so it is good to a few units in the last place however large a circle is,
// and half-planes are nothing special (1/rho = 0).
//
// Where more than three sites touch one circle, an edge has the same circle at both ends. Its
// hyperbola then degenerates to the two segments from the centres to m, the centre of that circle;
// several edges can meet there, but they do not cross.
//
// The drawing is off by the tolerance and some units in the last place of its own coordinates: so
// edges cross by no more than that. Three sites nearly in line can have a circle 10^15 times as
// large as they are. An edge that has to pass around its centre does go there; so far out, doubles
// cannot tell it from others that do. Near the sites, edges do not cross
// (tests/geometry/dual_test.cpp).
#pragma once

#include "delaunay/delaunay_graph.h"
#include "geometry/curve/conic.h"

namespace apollonius::internal {

struct DualEdge {
  Conic curves[2];  ///< from the centre of h's origin to that of its target
  int count = 1;    ///< 2 for an edge with the same circle at both ends
};

/// The drawn edge of h. REQUIRES: startsAtReference (edge.h).
[[nodiscard]] DualEdge dualEdge(const DelaunayGraph& delaunay, HalfedgeId h);

/// Unit direction of the ray of an edge from a site to infinity. REQUIRES: h's target is infinity.
[[nodiscard]] Point dualRay(const DelaunayGraph& delaunay, HalfedgeId h);

}  // namespace apollonius::internal
