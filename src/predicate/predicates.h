// The questions that the diagram asks. Every answer is exact for sites in the documented range; a
// site covered by another is hidden and no longer asked about. Formulas and proofs:
// docs/PREDICATES.md. None throws but for lack of memory.
//
// Stages (predicate/stages.h): points (equal weights, doubles), filter (doubles with an error
// bound), middle (doubles that are exact in a common unit: grids; long integers), exact (Dyadic),
// degenerate (the canonical rule).
#pragma once

#include "number/sign.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius {

/// Does a cover b, that is, is disc b within disc a (touching from within included)?
/// Laws: reflexive, transitive; both ways only for identical sites. Degree 2.
[[nodiscard]] bool covers(const Site& a, const Site& b);

/// sign(d(p, a) - d(p, b)) for the point p = (x, y) and d(p, s) = |p - c_s| - r_s. Law:
/// antisymmetric in a, b. Degree 4.
[[nodiscard]] Sign compareDistance(double x, double y, const Site& a, const Site& b);

/// Is b nearer to (x, y) than a, where a tie goes to the larger site in the order of precedes()?
/// Irreflexive and transitive.
[[nodiscard]] bool isNearer(double x, double y, const Site& a, const Site& b);

/// Is q in conflict with the Voronoi vertex of the face (i, j, k), i.e. does the vertex belong to
/// q's cell once q is added? REQUIRES: i, j, k counter-clockwise with an existing Voronoi circle,
/// at most one of them infinite, none covering another or q. Laws: the same for (j, k, i); zeros of
/// the polynomial are settled as if infinity began at a finite, immense clearance and larger sites
/// had infinitely larger increments of their weights, so the answers never depend on the order of
/// insertion. Degree 8.
[[nodiscard]] bool isVertexInConflict(Corner i, Corner j, Corner k, const Site& q);

/// The same, asking the face's cached circle first.
[[nodiscard]] bool isVertexInConflict(const VoronoiCircle& circle, Corner i, Corner j, Corner k,
                                      const Site& q);

/// Is there a circle that touches i, j, k from outside (or from inside) in counter-clockwise order?
/// The sites are finite and none covers another. A common tangent line is none: infinity takes it
/// over. Degree 8.
[[nodiscard]] bool hasVoronoiCircle(const Site& i, const Site& j, const Site& k);

/// Where a ray lies as seen along a direction.
enum class Bearing : signed char { kAlong, kLeft, kOpposite, kRight };

/// Of the ray from the centre of i through (x, y), seen along the direction from that centre to the
/// vertex of the face (i, j, k). `circle` is the face's cached circle, which is asked first.
/// REQUIRES: a face of a diagram, i finite, (x, y) not the centre. Degree 8.
[[nodiscard]] Bearing bearingOf(double x, double y, const VoronoiCircle& circle, const Site& i,
                                Corner j, Corner k);

/// Does q touch the Voronoi circle of the face (i, j, k), so that their vertices are one point?
/// REQUIRES: as isVertexInConflict, i, j, k finite.
[[nodiscard]] bool touchesCircle(const Site& i, const Site& j, const Site& k, const Site& q);

/// A Voronoi edge: the part of the bisector of i and j from its vertex (j, i, l) to its vertex (i,
/// j, k), with i on its left. At most one of i, j, and at most one corner of each face, is
/// infinite.
struct EdgeCorners {
  Corner i, j, k, l;
};

/// With neither end of the edge in conflict with q: is its interior?
/// REQUIRES: as isVertexInConflict for both ends, which are not in conflict. Degree 12; 16 for some
/// unbounded edges (the span of their directions).
[[nodiscard]] bool isInteriorInConflict(const EdgeCorners& edge, const Site& q);

/// With both ends of the edge in conflict with q: is all of it?
/// REQUIRES: as isVertexInConflict for both ends, which are in conflict. Degree 12.
[[nodiscard]] bool isEntireEdgeInConflict(const EdgeCorners& edge, const Site& q);

/// The same, asking the cached circles of the edge's faces (i, j, k) and (j, i, l) first.
[[nodiscard]] bool isInteriorInConflict(const EdgeCorners& edge, const VoronoiCircle& atK,
                                        const VoronoiCircle& atL, const Site& q);
[[nodiscard]] bool isEntireEdgeInConflict(const EdgeCorners& edge, const VoronoiCircle& atK,
                                          const VoronoiCircle& atL, const Site& q);

// --- Proofs: what is to be asked of a graph that may be another's
// (docs/PREDICATES.md, "Order along an edge")

/// Is the edge that of a Delaunay graph, as far as its two faces can tell: do its ends come in
/// their order along the bisector, and where they coincide, has the canonical rule chosen this
/// diagonal? Of an edge with infinity only the latter: the order of its ends is for the whole hull
/// to tell. A false answer is a proof; if all edges, the circles of all faces, and the hull are
/// right, so is the graph. REQUIRES: both faces have circles, which are given, and in each face no
/// site covers another. Degree 8.
[[nodiscard]] bool isDelaunayEdge(EdgeCorners edge, const VoronoiCircle& atK,
                                  const VoronoiCircle& atL);

/// On the bisector of i and j, seen from i: the turn from the middle of l's shadow to that of k's.
/// Degree 6.
[[nodiscard]] Sign turnBetweenShadows(const Site& i, const Site& j, const Site& l, const Site& k);

/// Has the half-plane of the face (i, j, infinity), which is given, an outer normal of an angle in
/// [0, pi)? Degree 6.
[[nodiscard]] bool pointsUp(const Site& i, const Site& j, const VoronoiCircle& plane);
/// The turn from the outer normal of the face (i, l, infinity) to that of (k, i, infinity), whose
/// half-planes are given. Degree 16.
[[nodiscard]] Sign turnOfHull(const Site& i, const Site& l, const Site& k, const VoronoiCircle& atL,
                              const VoronoiCircle& atK);

}  // namespace apollonius
