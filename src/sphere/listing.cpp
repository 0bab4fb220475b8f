#include "sphere/listing.h"

#include "base/flat_array.h"
#include "diagram/listing.h"
#include "sphere/vertices.h"

namespace apollonius::internal {

void listNeighbors(const ProjectedDiagram& diagram, SiteId id, std::vector<SiteId>& neighbors) {
  neighbors.clear();
  if (diagram.isHidden(id)) return;
  const VertexId node = diagram.nodeOf(id);
  if (!diagram.graph().isEmpty()) {
    for (const HalfedgeId h : diagram.graph().star(node))
      neighbors.push_back(diagram.siteOf(diagram.graph().target(h)));
    keepFirstOccurrences(neighbors);
  } else if (diagram.visibleCount() == 2) {
    neighbors.push_back(node == kInfinity ? diagram.siteOf(diagram.plane().delaunay().anyVisible())
                                          : diagram.pole());
  }
}

void listVertices(const ProjectedDiagram& diagram, double radius, VertexArrays& vertices) {
  vertices.coordinates.clear();
  vertices.clearance.clear();
  vertices.sites.clear();
  const Graph& graph = diagram.graph();
  SphericalVertices computed(diagram);
  for (const FaceId face : graph.faces()) {
    const SphericalVertex& vertex = computed[face];
    const LonLat point = lonLatOf(vertex.point);
    vertices.coordinates.push_back(point.lon);
    vertices.coordinates.push_back(point.lat);
    vertices.clearance.push_back(vertex.clearance * radius);
    for (unsigned corner = 0; corner < 3; ++corner)
      vertices.sites.push_back(diagram.siteOf(graph.origin(halfedgeOf(face, corner))));
  }
}

void listEdges(const ProjectedDiagram& diagram, EdgeArrays& edges) {
  edges.sites.clear();
  edges.vertices.clear();
  const Graph& graph = diagram.graph();
  if (graph.isEmpty() && diagram.visibleCount() == 2) {
    edges.sites = {diagram.pole(), diagram.siteOf(diagram.plane().delaunay().anyVisible())};
    edges.vertices = {-1, -1};
    return;
  }
  FlatArray<std::int32_t> row(graph.faceSlots(), -1);  // of the faces in listVertices()
  std::int32_t rows = 0;
  for (const FaceId face : graph.faces()) row[index(face)] = rows++;
  for (const HalfedgeId h : graph.edges()) {
    edges.sites.push_back(diagram.siteOf(graph.origin(h)));
    edges.sites.push_back(diagram.siteOf(graph.target(h)));
    edges.vertices.push_back(row[index(faceOf(graph.twin(h)))]);
    edges.vertices.push_back(row[index(faceOf(h))]);
  }
}

}  // namespace apollonius::internal
