// The diagram as arrays: a site's neighbours, the Voronoi vertices and edges, the faces of the
// Delaunay graph. Each replaces the contents of its last argument and throws std::bad_alloc.
#pragma once

#include <vector>

#include "apollonius/types.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

/// The distinct sites whose cells share an edge with that of `id`, counter-clockwise, each at its
/// first occurrence; none for a hidden site. REQUIRES: an id in use. Cost: O(d).
void listNeighbors(const DiagramCore& diagram, SiteId id, std::vector<SiteId>& neighbors);

void listVertices(const DiagramCore& diagram, VertexArrays& out);

/// The ends of an edge are rows of listVertices().
void listEdges(const DiagramCore& diagram, EdgeArrays& out);

/// Three sites each, counter-clockwise, kNoSite for infinity.
void listFaces(const DiagramCore& diagram, std::vector<SiteId>& sites);

}  // namespace apollonius::internal
