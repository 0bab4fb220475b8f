#include "sphere/listing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/flat_array.h"
#include "diagram/listing.h"
#include "sphere/cell.h"
#include "sphere/vertices.h"

namespace apollonius::internal::sphere {

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

namespace {

/// The least angle from the site to a part of one of its bisectors.
double leastAngle(const Sector& sector) {
  // The less the bearing differs from that of the other site, the nearer is the curve.
  const SphericalBisector& bisector = sector.bisector;
  const double ahead = std::remainder(bisector.middle() - sector.from, kTurn);
  if ((ahead < 0 ? ahead + kTurn : ahead) <= sector.width)
    return bisector.at(bisector.middle()).rho();
  return std::min(bisector.at(sector.from).rho(), bisector.at(sector.from + sector.width).rho());
}

}  // namespace

void listNeighbors(const ProjectedDiagram& diagram, SiteId id, double radius,
                   std::vector<SiteId>& neighbors, std::vector<double>& distances) {
  neighbors.clear();
  distances.clear();
  if (diagram.isHidden(id)) return;
  const Graph& graph = diagram.graph();
  SphericalVertices vertices(diagram, SphericalVertices::Of::kSome);
  const auto add = [&](SiteId neighbor, VertexId from, const Sector& sector) {
    neighbors.push_back(neighbor);
    distances.push_back((leastAngle(sector) - diagram.cap(from).weight) * radius);
  };
  const VertexId node = diagram.nodeOf(id);
  if (!graph.isEmpty()) {
    for (const HalfedgeId h : graph.star(node)) {
      const SiteId neighbor = diagram.siteOf(graph.target(h));
      // Computed from the same one of the two sites always.
      const HalfedgeId seen = id < neighbor ? h : graph.twin(h);
      add(neighbor, graph.origin(seen), sectorOf(diagram, seen, vertices));
    }
  } else if (diagram.visibleCount() == 2) {
    const VertexId other = otherOfTwo(diagram, node);
    const VertexId from = id < diagram.siteOf(other) ? node : other;
    FlatArray<Sector> sectors;
    listSectors(diagram, from, vertices, sectors);
    add(diagram.siteOf(other), from, sectors[0]);
  }
}

void listVertices(const ProjectedDiagram& diagram, double radius, VertexArrays& vertices) {
  const Graph& graph = diagram.graph();
  const std::size_t count = graph.isEmpty() ? 0 : graph.faceCount();
  vertices.coordinates.resize(2 * count);
  vertices.clearance.resize(count);
  vertices.sites.resize(3 * count);
  SphericalVertices computed(diagram, SphericalVertices::Of::kAll);
  std::size_t row = 0;
  for (const FaceId face : graph.faces()) {
    const SphericalVertex& vertex = computed[face];
    const LonLat point = lonLatOf(vertex.point);
    vertices.coordinates[2 * row] = point.lon;
    vertices.coordinates[2 * row + 1] = point.lat;
    vertices.clearance[row] = vertex.clearance * radius;
    for (unsigned corner = 0; corner < 3; ++corner)
      vertices.sites[3 * row + corner] = diagram.siteOf(graph.origin(halfedgeOf(face, corner)));
    ++row;
  }
}

void listEdges(const ProjectedDiagram& diagram, EdgeArrays& edges) {
  const Graph& graph = diagram.graph();
  const bool isClosed = graph.isEmpty() && diagram.visibleCount() == 2;
  const std::size_t count = isClosed ? 1 : graph.faceCount() / 2 * 3;
  edges.sites.resize(2 * count);
  edges.vertices.resize(2 * count);
  if (isClosed) {
    edges.sites[0] = diagram.pole();
    edges.sites[1] = diagram.siteOf(diagram.plane().delaunay().anyVisible());
    edges.vertices[0] = edges.vertices[1] = -1;
    return;
  }
  FlatArray<std::int32_t> row(graph.faceSlots(), -1);  // by face: its row in listVertices()
  std::int32_t rows = 0;
  for (const FaceId face : graph.faces()) row[index(face)] = rows++;
  std::size_t k = 0;
  for (const HalfedgeId h : graph.edges()) {
    edges.sites[k] = diagram.siteOf(graph.origin(h));
    edges.vertices[k++] = row[index(faceOf(graph.twin(h)))];
    edges.sites[k] = diagram.siteOf(graph.target(h));
    edges.vertices[k++] = row[index(faceOf(h))];
  }
}

namespace {

constexpr std::uint32_t kNoRow = 0xFFFFFFFFu;

/// Is the middle of a bisector, where it is nearest, on a sector's edge?
bool hasMiddle(const Sector& sector) {
  const double turn = std::remainder(sector.bisector.middle() - sector.from, kTurn);
  return (turn < 0 ? turn + kTurn : turn) < sector.width;
}

}  // namespace

void listNarrowest(const ProjectedDiagram& diagram, double radius, VertexArrays& places) {
  EdgeArrays edges;
  VertexArrays vertices;
  listEdges(diagram, edges);
  listVertices(diagram, radius, vertices);
  const std::size_t count = edges.sites.size() / 2;
  places.coordinates.resize(2 * count);
  places.clearance.assign(count, std::numeric_limits<double>::infinity());
  places.sites.clear();
  for (std::size_t k = 0; k < 2 * count; ++k) {
    if (edges.vertices[k] < 0) continue;
    const auto end = static_cast<std::size_t>(edges.vertices[k]);
    if (!(vertices.clearance[end] < places.clearance[k / 2])) continue;
    places.clearance[k / 2] = vertices.clearance[end];
    std::copy_n(&vertices.coordinates[2 * end], 2, &places.coordinates[k / 2 * 2]);
  }
  SphericalVertices computed(diagram, SphericalVertices::Of::kAll);
  FlatArray<Sector> sectors;
  const auto atMiddle = [&](std::size_t k, VertexId node, const Sector& sector) {
    const Cap& cap = diagram.cap(node);
    const auto middle = sector.bisector.at(sector.bisector.middle());
    const double clearance = (middle.rho() - cap.weight) * radius;
    if (!hasMiddle(sector) || !(clearance < places.clearance[k])) return;
    const LonLat point = lonLatOf(middle.point(cap.centre, Frame(cap.centre)));
    places.clearance[k] = clearance;
    places.coordinates[2 * k] = point.lon;
    places.coordinates[2 * k + 1] = point.lat;
  };
  const Graph& graph = diagram.graph();
  if (graph.isEmpty()) {
    listSectors(diagram, kInfinity, computed, sectors);
    if (count == 1) atMiddle(0, kInfinity, sectors[0]);
    return;
  }
  // Goes cell by cell, as the sectors of a cell are found together: each edge with its first
  // site's.
  FlatArray<std::uint32_t> rowOf(3 * graph.faceSlots(), kNoRow);
  std::uint32_t row = 0;
  for (const HalfedgeId h : graph.edges()) rowOf[index(h)] = row++;
  FlatArray<VertexId> nodes;
  graph.listVertices(nodes);
  nodes.push_back(kInfinity);
  for (const VertexId node : nodes) {
    listSectors(diagram, node, computed, sectors);
    const Sector* sector = sectors.data();
    for (const HalfedgeId h : graph.star(node)) {
      if (rowOf[index(h)] != kNoRow) atMiddle(rowOf[index(h)], node, *sector);
      ++sector;
    }
  }
}

}  // namespace apollonius::internal::sphere
