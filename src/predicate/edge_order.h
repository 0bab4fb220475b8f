// Do an edge and its two faces belong to a Delaunay graph? For proofs that a graph of any origin is
// one. Why it is decided so: docs/PREDICATES.md, "Order along an edge".
#pragma once

#include "number/approx.h"
#include "number/sign.h"
#include "predicate/edge_conflict.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::internal {

/// Is the edge that of a Delaunay graph, as far as its two faces tell: do its ends come in the
/// right order along the bisector, and where they coincide, is this the diagonal of the canonical
/// rule? For an edge with infinity only the latter is tested: the order of its ends follows from
/// the whole hull. A false answer is a proof; if all edges, the circles of all faces, and the hull
/// are right, so is the graph. REQUIRES: both faces have circles, which are given, and in each face
/// no site covers another. Degree 8.
[[nodiscard]] bool isDelaunayEdge(EdgeCorners edge, const VoronoiCircle& atK,
                                  const VoronoiCircle& atL);

/// The turn from the middle of l's shadow to that of k's on the bisector of i and j, seen from i.
/// REQUIRES: i is larger than j; none of the four covers i or j. Degree 6.
[[nodiscard]] Sign turnBetweenShadows(const Site& i, const Site& j, const Site& l, const Site& k);

namespace stages {

/// turnBetweenShadows in doubles with an error bound; exactly.
[[nodiscard]] MaybeSign shadowTurnFilter(const Site& i, const Site& j, const Site& l,
                                         const Site& k);
[[nodiscard]] Sign shadowTurnExact(const Site& i, const Site& j, const Site& l, const Site& k);

}  // namespace stages

}  // namespace apollonius::internal
