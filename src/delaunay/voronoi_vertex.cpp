// Voronoi vertices for output. Unlike those of cached circles, their last bits must not depend on
// the history; nor, where more than three sites touch one circle, on the face chosen: the edges
// between these faces have length zero, and a boundary through them must not wander.
//
// All faces of such a vertex have the largest z of the touching sites for a corner: perturbed as in
// docs/PREDICATES.md ("Degenerate position"), z takes the vertex for its own cell, and each of the
// others becomes its neighbour. So the faces are consecutive around z, which is the reference site
// of each, and two edges of a face tell whether there are other faces with its vertex.
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

/// Do the faces on both sides of an edge have one circle? Also true if they have the same three
/// sites, in both orders, and circles that doubles cannot tell apart: then they have to be rounded
/// as if they were one. REQUIRES: h starts at the largest site of its face, which has no corner at
/// infinity.
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
