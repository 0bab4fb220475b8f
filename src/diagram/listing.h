// The diagram as arrays: a site's neighbours, the Voronoi vertices and edges, the faces of the
// Delaunay graph, the hull, the levels of the hierarchy. Each `list` replaces the contents of its
// last argument; all throw std::bad_alloc.
#pragma once

#include <cstdint>
#include <vector>

#include "apollonius/types.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

/// The distinct sites whose cells share an edge with that of `id`, counter-clockwise, each at its
/// first occurrence; none for a hidden site. REQUIRES: an id in use. Cost: O(d).
void listNeighbors(const DiagramCore& diagram, SiteId id, std::vector<SiteId>& neighbors);

/// The distinct sites from whose cells a new site would take something; if one covers it, only that
/// one, and `isCovered`. None in an empty diagram. Cost: location, the degree of the nearest site,
/// and the size of what would change.
void listConflict(const DiagramCore& diagram, const Site& site, std::vector<SiteId>& sites,
                  bool& isCovered);

/// Removes repeats from a list, and keeps first occurrences. Cost: O(d).
void keepFirstOccurrences(std::vector<SiteId>& neighbors);

void listVertices(const DiagramCore& diagram, VertexArrays& out);

/// The ends of an edge are rows of listVertices().
void listEdges(const DiagramCore& diagram, EdgeArrays& out);

/// Three sites each, counter-clockwise, kNoSite for infinity.
void listFaces(const DiagramCore& diagram, std::vector<SiteId>& sites);

/// The sites that the convex hull of the circles touches, all of them, counter-clockwise; one can
/// occur several times (a large circle with small ones sticking out; points in line, there and
/// back). Cost: O(length).
void listHull(const DiagramCore& diagram, std::vector<SiteId>& sites);

/// By id: on how many levels of the hierarchy each site is; 0 for hidden ones and ids not in use.
void listLevels(const DiagramCore& diagram, std::vector<std::uint8_t>& levels);

}  // namespace apollonius::internal
