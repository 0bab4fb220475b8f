// The edges inside a window as a graph, and the narrowest place of each edge: along a bisector the
// distance from the circles is (D/2) cosh t - (ra + rb)/2, which is least between the two, at t =
// 0, and elsewhere at the end that is nearer.
#pragma once

#include "apollonius/types.h"
#include "geometry/clipping/clipping.h"

namespace apollonius::internal {

/// The pieces of the window's edges, in the order of Clipping::visitEdges. Faces with edges of
/// length zero between them are one vertex, whose three sites are those of the least face. Replaces
/// the contents. Throws std::bad_alloc.
void listEdgeGraph(const DiagramCore& core, const Clipping& clipping, VertexArrays& vertices,
                   EdgeArrays& edges, VertexArrays& narrowest);

/// Lists for each edge that listEdges() has the place where it is the nearest to its sites, and the
/// distance from them; without sites. Replaces the contents. Throws std::bad_alloc.
void listNarrowest(const DiagramCore& core, VertexArrays& places);

}  // namespace apollonius::internal
