// Voronoi vertices for output. Their last bits must not depend on the history, as those of cached
// circles do; nor, where more than three sites touch one circle, on which of its faces is asked:
// the edges between those have length zero, and a boundary through them must not wander.
//
// All faces of such a vertex have the largest z of the touching sites for a corner: perturbed as in
// docs/PREDICATES.md ("Degenerate position"), z takes the vertex for its own cell, and each of the
// others becomes its neighbour. So they are consecutive around z, which is the reference site of
// each, and whether a face has company is seen at two of its edges.
#include "delaunay/delaunay_graph.h"
#include "predicate/compute_circle.h"
#include "predicate/precise_circle.h"
#include "predicate/reference_site.h"

namespace apollonius::internal {

namespace {

/// Are the circles of two bounded faces certainly different? Nearly all are: the error of each
/// number is at most its circle's. (Unknown errors are infinite.)
bool areApart(const VoronoiCircle& a, const VoronoiCircle& b) {
  const double error =
      (static_cast<double>(a.error) + static_cast<double>(b.error)) * (1 + powerOfTwo(-20));
  return absolute(a.x - b.x) > error || absolute(a.y - b.y) > error || absolute(a.s - b.s) > error;
}

}  // namespace

bool DelaunayGraph::isPoint(HalfedgeId h) const {
  const EdgeCorners e = edge(h);
  const bool isBounded = e.i != nullptr && e.j != nullptr && e.k != nullptr && e.l != nullptr;
  // If both apexes are one site, the two faces have its two circles, one in each order.
  return isBounded && e.k != e.l && !areApart(circle(faceOf(h)), circle(faceOf(graph_.twin(h)))) &&
         touchesBetween(*e.i, *e.j, *e.k, *e.l);
}

/// Do the faces on both sides of an edge, which starts at the largest site of h's face, have one
/// circle? Or do they have the same three sites, in both orders, and circles that are one as far as
/// doubles can tell: then they are to be rounded as well as if they were. REQUIRES: h's face has no
/// corner at infinity.
bool DelaunayGraph::isSameVertex(HalfedgeId h) const {
  const EdgeCorners e = edge(h);
  if (e.k == e.l)
    return !areApart(voronoiCircle(e.i, e.j, e.k),
                     voronoiCircle(e.j, e.i, e.l));  // not the cached: see above
  return isPoint(h);
}

VoronoiCircle DelaunayGraph::voronoiVertex(FaceId f) const {
  if (circle(f).isHalfPlane()) return circle(f);
  HalfedgeId h = halfedgeOf(f, 0);
  for (unsigned c = 1; c < 3; ++c) {
    const HalfedgeId other = halfedgeOf(f, c);
    if (isBetterReference(corner(graph_.origin(other)), corner(graph_.origin(h)))) h = other;
  }
  const EdgeCorners e = edge(h);
  // previous(h) ends where h starts.
  const bool isMultiple = isSameVertex(h) || isSameVertex(previous(h));
  return isMultiple ? commonVoronoiCircle(*e.i, *e.j, *e.k) : preciseVoronoiCircle(e.i, e.j, e.k);
}

}  // namespace apollonius::internal
