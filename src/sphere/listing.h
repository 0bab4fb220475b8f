// The diagram of the sphere as arrays: neighbours of a site, Voronoi vertices, Voronoi edges. In
// contrast to the plane's (diagram/listing.h), every face has a vertex.
#pragma once

#include <vector>

#include "apollonius/types.h"
#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

/// All replace the contents and throw std::bad_alloc.

void listNeighbors(const ProjectedDiagram& diagram, SiteId id, std::vector<SiteId>& neighbors);
/// The same with a row for each edge, and how near the edge comes to the circles of its two sites,
/// in the unit of the sphere's radius: the same number for both.
void listNeighbors(const ProjectedDiagram& diagram, SiteId id, double radius,
                   std::vector<SiteId>& neighbors, std::vector<double>& distances);
/// Clearances in the unit of the sphere's radius.
void listVertices(const ProjectedDiagram& diagram, double radius, VertexArrays& vertices);
void listEdges(const ProjectedDiagram& diagram, EdgeArrays& edges);
/// The narrowest place of each edge that listEdges() has: where it crosses the way between its
/// sites' centres, or else the end that is nearer. Without sites.
void listNarrowest(const ProjectedDiagram& diagram, double radius, VertexArrays& places);

}  // namespace apollonius::internal::sphere
