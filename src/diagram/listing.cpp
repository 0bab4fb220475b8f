// The diagram as arrays: neighbours of a site, Voronoi vertices, Voronoi edges.
#include "diagram/listing.h"

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "delaunay/conflict.h"
#include "predicate/covers.h"
#include "topology/hull.h"

namespace apollonius::internal {

namespace {

/// Is it the face of a Voronoi vertex, of three finite sites?
bool isBounded(const Graph& graph, FaceId f) {
  for (unsigned c = 0; c < 3; ++c) {
    if (graph.origin(halfedgeOf(f, c)) == kInfinity) return false;
  }
  return true;
}

}  // namespace

void listNeighbors(const DiagramCore& diagram, SiteId id, std::vector<SiteId>& neighbors) {
  neighbors.clear();
  const Graph& graph = diagram.delaunay().graph();
  const VertexId v = vertexOf(diagram.ids().slotOf(id));
  if (!graph.hasVertex(v)) return;
  for (const HalfedgeId h : graph.star(v)) {
    if (graph.target(h) != kInfinity) neighbors.push_back(diagram.siteOf(graph.target(h)));
  }
  keepFirstOccurrences(neighbors);
}

void listConflict(const DiagramCore& diagram, const Site& site, std::vector<SiteId>& sites,
                  bool& isCovered) {
  sites.clear();
  isCovered = false;
  if (diagram.visibleCount() == 0) return;
  const Slot nearest = diagram.nearest(site.x, site.y);
  sites.push_back(diagram.ids().idOf(nearest));
  isCovered = covers(diagram.site(nearest), site);
  if (isCovered || diagram.visibleCount() == 1) return;
  const DelaunayGraph& delaunay = diagram.delaunay();
  const Graph& graph = delaunay.graph();
  ConflictSearch search;
  search.find(delaunay, site, vertexOf(nearest), kNoHalfedge);
  const auto add = [&](VertexId v) {
    if (v != kInfinity) sites.push_back(diagram.siteOf(v));
  };
  // Nothing is left of the others if the new one covers them all.
  for (const FaceId f : search.faces()) {
    for (unsigned corner = 0; corner < 3; ++corner) add(graph.origin(halfedgeOf(f, corner)));
  }
  for (const HalfedgeId h : search.boundary()) add(graph.origin(h));
  if (search.boundary().empty()) {
    for (Slot slot = 0; slot < diagram.ids().slots(); ++slot) {
      if (diagram.ids().state(slot) == SiteState::kVisible) add(vertexOf(slot));
    }
  }
  keepFirstOccurrences(sites);
}

void keepFirstOccurrences(std::vector<SiteId>& neighbors) {
  // Sort positions by site, mark the later ones, drop them.
  FlatArray<Keyed> positions(neighbors.size());
  for (std::uint32_t k = 0; k < positions.size(); ++k) positions[k] = {neighbors[k], k};
  sortByKey(positions);
  FlatArray<bool> isRepeated(neighbors.size(), false);
  for (std::size_t k = 1; k < positions.size(); ++k)
    isRepeated[positions[k].value] = positions[k].key == positions[k - 1].key;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    if (!isRepeated[k]) neighbors[kept++] = neighbors[k];
  }
  neighbors.resize(kept);
}

void listFaces(const DiagramCore& diagram, std::vector<SiteId>& sites) {
  sites.clear();
  const Graph& graph = diagram.delaunay().graph();
  for (const FaceId f : graph.faces()) {
    for (unsigned c = 0; c < 3; ++c) {
      const VertexId v = graph.origin(halfedgeOf(f, c));
      sites.push_back(v == kInfinity ? kNoSite : diagram.siteOf(v));
    }
  }
}

void listVertices(const DiagramCore& diagram, VertexArrays& out) {
  out.coordinates.clear();
  out.clearance.clear();
  out.sites.clear();
  const Graph& graph = diagram.delaunay().graph();
  for (const FaceId f : graph.faces()) {
    if (!isBounded(graph, f)) continue;
    const VoronoiCircle circle = diagram.delaunay().voronoiVertex(f);
    out.coordinates.push_back(circle.x);
    out.coordinates.push_back(circle.y);
    out.clearance.push_back(circle.s);
    for (unsigned c = 0; c < 3; ++c)
      out.sites.push_back(diagram.siteOf(graph.origin(halfedgeOf(f, c))));
  }
}

void listEdges(const DiagramCore& diagram, EdgeArrays& out) {
  out.sites.clear();
  out.vertices.clear();
  const Graph& graph = diagram.delaunay().graph();
  FlatArray<std::int32_t> row(graph.faceSlots(), -1);  // by face: its row in listVertices()
  std::int32_t rows = 0;
  for (const FaceId f : graph.faces()) {
    if (isBounded(graph, f)) row[index(f)] = rows++;
  }
  for (const HalfedgeId h : graph.edges()) {
    if (graph.origin(h) == kInfinity || graph.target(h) == kInfinity) continue;
    out.sites.push_back(diagram.siteOf(graph.origin(h)));
    out.sites.push_back(diagram.siteOf(graph.target(h)));
    // Counter-clockwise about h's origin the edge runs from the vertex of the face on the right to
    // that on the left.
    out.vertices.push_back(row[index(faceOf(graph.twin(h)))]);
    out.vertices.push_back(row[index(faceOf(h))]);
  }
}

void listHull(const DiagramCore& diagram, std::vector<SiteId>& sites) {
  sites.clear();
  const DelaunayGraph& delaunay = diagram.delaunay();
  if (delaunay.visibleCount() == 1) sites.push_back(diagram.siteOf(delaunay.anyVisible()));
  visitHull(delaunay.graph(),
            [&](HalfedgeId h) { sites.push_back(diagram.siteOf(delaunay.graph().origin(h))); });
}

void listLevels(const DiagramCore& diagram, std::vector<std::uint8_t>& levels) {
  const IdPool& ids = diagram.ids();
  const Hierarchy& hierarchy = diagram.locationIndex().filledLevels(diagram.delaunay());
  levels.assign(ids.idLimit(), 0);
  for (SiteId id = 0; id < ids.idLimit(); ++id) {
    const Slot slot = ids.slotOf(id);
    if (slot != kNoSlot && ids.state(slot) == SiteState::kVisible)
      levels[id] = static_cast<std::uint8_t>(hierarchy.levelsOf(slot));
  }
}

}  // namespace apollonius::internal
