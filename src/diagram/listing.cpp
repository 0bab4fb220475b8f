// The diagram as arrays: neighbours of a site, Voronoi vertices, Voronoi edges.
#include <vector>

#include "delaunay/sort_by_key.h"
#include "diagram/diagram_core.h"
#include "memory/flat_array.h"

namespace apollonius {

void DiagramCore::neighbors(SiteId id, std::vector<SiteId>& neighbors) const {
  neighbors.clear();
  const Graph& graph = base_.graph();
  const VertexId v = vertexOf(ids_.slotOf(id));
  if (!graph.hasVertex(v)) return;
  const HalfedgeId begin = graph.outgoing(v);
  HalfedgeId h = begin;
  do {
    if (graph.target(h) != kInfinity) neighbors.push_back(siteOf(graph.target(h)));
    h = graph.rotateCcw(h);
  } while (h != begin);

  // Keep the first occurrence of each: sort positions by site, mark the later ones, drop them.
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

/// Is it the face of a Voronoi vertex, of three finite sites?
bool DiagramCore::isBounded(FaceId f) const {
  const Graph& graph = base_.graph();
  if (!graph.isLive(f)) return false;
  for (unsigned c = 0; c < 3; ++c) {
    if (graph.origin(halfedgeOf(f, c)) == kInfinity) return false;
  }
  return true;
}

void DiagramCore::faces(std::vector<SiteId>& sites) const {
  sites.clear();
  const Graph& graph = base_.graph();
  for (std::size_t i = 0; i < 3 * graph.faceSlots(); ++i) {
    const HalfedgeId h{static_cast<std::uint32_t>(i)};
    if (graph.isLive(faceOf(h)))
      sites.push_back(graph.origin(h) == kInfinity ? kNoSite : siteOf(graph.origin(h)));
  }
}

void DiagramCore::vertices(VertexArrays& out) const {
  out.coordinates.clear();
  out.clearance.clear();
  out.sites.clear();
  const Graph& graph = base_.graph();
  for (std::size_t i = 0; i < graph.faceSlots(); ++i) {
    const FaceId f{static_cast<std::uint32_t>(i)};
    if (!isBounded(f)) continue;
    const VoronoiCircle circle = base_.vertex(f);
    out.coordinates.push_back(circle.x);
    out.coordinates.push_back(circle.y);
    out.clearance.push_back(circle.s);
    for (unsigned c = 0; c < 3; ++c) out.sites.push_back(siteOf(graph.origin(halfedgeOf(f, c))));
  }
}

void DiagramCore::edges(EdgeArrays& out) const {
  out.sites.clear();
  out.vertices.clear();
  const Graph& graph = base_.graph();
  FlatArray<std::int32_t> row(graph.faceSlots(), -1);  // of the faces in vertices()
  std::int32_t rows = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (isBounded(FaceId{static_cast<std::uint32_t>(i)})) row[i] = rows++;
  }
  for (std::size_t i = 0; i < 3 * graph.faceSlots(); ++i) {
    const HalfedgeId h{static_cast<std::uint32_t>(i)};
    if (!graph.isLive(faceOf(h)) || graph.twin(h) < h) continue;  // each edge once
    if (graph.origin(h) == kInfinity || graph.target(h) == kInfinity) continue;
    out.sites.push_back(siteOf(graph.origin(h)));
    out.sites.push_back(siteOf(graph.target(h)));
    // Counter-clockwise about h's origin the edge runs from the vertex of the face on the right to
    // that on the left.
    out.vertices.push_back(row[index(faceOf(graph.twin(h)))]);
    out.vertices.push_back(row[index(faceOf(h))]);
  }
}

}  // namespace apollonius
