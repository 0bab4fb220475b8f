// The diagram of the sphere as arrays: neighbours of a site, Voronoi vertices, Voronoi edges. In
// contrast to the plane's (diagram/listing.h), every face has a vertex.
#pragma once

#include <vector>

#include "apollonius/types.h"
#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

// All replace the contents and throw std::bad_alloc.

void listNeighbors(const ProjectedDiagram& diagram, SiteId id, std::vector<SiteId>& neighbors);
/// Lists the neighbours with a row for each edge, and the least distance of the edge from the
/// circles of its two sites, which is the same for both, in the unit of the sphere's radius.
void listNeighbors(const ProjectedDiagram& diagram, SiteId id, double radius,
                   std::vector<SiteId>& neighbors, std::vector<double>& distances);
/// Lists the vertices; clearances are in the unit of the sphere's radius.
void listVertices(const ProjectedDiagram& diagram, double radius, VertexArrays& vertices);
void listEdges(const ProjectedDiagram& diagram, EdgeArrays& edges);
/// Lists the narrowest place of each edge of listEdges(): where it crosses the arc between its
/// sites' centres, or else the nearer end. Leaves out the sites.
void listNarrowest(const ProjectedDiagram& diagram, double radius, VertexArrays& places);

}  // namespace apollonius::internal::sphere
