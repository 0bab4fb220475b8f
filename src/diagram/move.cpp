// A certificate that moving a site changes no face, for the small moves of animations.
//
// Let the circles of the site's faces be computed anew. The graph is that of the new diagram if
//   1. all of them exist, and neighbours do not cover each other;
//   2. across each edge of these faces, the corner beyond is not in conflict with the face, seen from either side;
//   3. each of the vertices moves, as seen from each of its three sites, by less than a quarter turn.
// Why. 1 and 2 say that along each Voronoi edge its two ends come in the right order. So each cell is bounded by a closed curve
// that runs counter-clockwise around its centre; by 3 it does so as often as before, once. Hence the cells, glued along their
// edges, cover the sphere without branching; the graph is a sphere as well, and so (Riemann-Hurwitz) they cover it once: they tile
// the plane. Now let p be in the cell of i, and suppose j nearer to it. From p straight to c_j the distance to j falls as fast as any can,
// so j stays strictly nearer than the tile's site, down to c_j itself; but c_j is in the tile of j. So the tiles are the Voronoi cells.
//
// Everything is asked of the filters; what they do not know counts as no. Faces at infinity are left to the general way.
#include "diagram/delaunay_graph.h"
#include "predicate/direction.h"

namespace apollonius {

namespace {

bool isClear(const VoronoiCircle& circle, const Site& site) {
  const MaybeSign filtered = circleFilter(circle, site);
  return filtered.known && filtered.sign == Sign::kNegative;
}

constexpr std::size_t kMostFaces = 24;  // a site of more neighbours rarely moves without consequences

}  // namespace

bool DelaunayGraph::moveInPlace(VertexId v, const Site& to) {
  if (!graph_.hasVertex(v)) return false;
  reserveFaces(kMostFaces, kMostFaces);
  const HalfedgeId begin = graph_.outgoing(v);
  std::size_t n = 0;
  for (HalfedgeId h = begin;;) {
    const VertexId u = graph_.target(h);
    if (u == kInfinity || n == kMostFaces) return false;
    fan_.setCorner(n, &site(u));
    newFaces_[n++] = faceOf(h);
    // The corner beyond the face is not v itself, nor is v in conflict with the face beyond.
    const HalfedgeId beyond = graph_.twin(next(h));
    if (graph_.apex(beyond) == v || !isClear(circle(faceOf(beyond)), to)) return false;
    h = graph_.rotateCcw(h);
    if (h == begin) break;
  }
  if (n < 3 || !fan_.computeIfCertain(to, {newCircles_.data(), n})) return false;

  HalfedgeId h = begin;
  const Site& from = site(v);
  for (std::size_t k = 0; k < n; ++k, h = graph_.rotateCcw(h)) {
    const VoronoiCircle &before = circle(faceOf(h)), &after = newCircles_[k];
    const Site &right = site(graph_.target(h)), &left = site(graph_.apex(h));
    if (before.isHalfPlane()) return false;
    if (!differByLessThanAQuarter(directionOf(before, from), directionOf(after, to)) ||
        !differByLessThanAQuarter(directionOf(before, right), directionOf(after, right)) ||
        !differByLessThanAQuarter(directionOf(before, left), directionOf(after, left))) {
      return false;
    }
    const VertexId beyond = graph_.apex(graph_.twin(next(h)));
    const VertexId beyondRight = graph_.target(graph_.rotateCw(h)), beyondLeft = graph_.apex(graph_.rotateCcw(h));
    if ((beyond != kInfinity && !isClear(after, site(beyond))) || !isClear(after, site(beyondRight)) ||
        !isClear(after, site(beyondLeft))) {
      return false;
    }
  }
  sites_[index(v)] = to;
  takeCircles(n);
  return true;
}

}  // namespace apollonius
