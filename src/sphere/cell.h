// The cell of a site of the sphere as sectors about it, one for each edge.
#pragma once

#include "base/flat_array.h"
#include "sphere/bisector.h"
#include "sphere/projected_diagram.h"
#include "sphere/vertices.h"

namespace apollonius::internal::sphere {

/// The part of a cell that is bounded by one edge.
struct Sector {
  SphericalBisector bisector;
  double from = 0;   ///< bearing of its first point about the site
  double width = 0;  ///< to its last one, counter-clockwise, 0 to 2 pi
};

/// The sector of an edge about the site where `h` starts. Calls throw std::bad_alloc.
[[nodiscard]] Sector sectorOf(const ProjectedDiagram& diagram, HalfedgeId h,
                              SphericalVertices& vertices);

/// Of two visible sites, the other one.
[[nodiscard]] inline VertexId otherOfTwo(const ProjectedDiagram& diagram, VertexId node) {
  return node == kInfinity ? diagram.plane().delaunay().anyVisible() : kInfinity;
}

/// Lists the sectors of a visible site, counter-clockwise; none if it is the only one. Cost: O(d).
void listSectors(const ProjectedDiagram& diagram, VertexId node, SphericalVertices& vertices,
                 FlatArray<Sector>& sectors);

}  // namespace apollonius::internal::sphere
