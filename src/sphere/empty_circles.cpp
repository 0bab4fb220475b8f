// The candidates are the Voronoi vertices; the far point of each edge, where the longer way from
// one centre to the other along their great circle meets it; and the point opposite to the only
// site (docs/PROOFS.md, "The sphere").
#include "sphere/empty_circles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/flat_array.h"
#include "sphere/nearby.h"
#include "sphere/nearest.h"
#include "sphere/vertices.h"

namespace apollonius::internal::sphere {

namespace {

/// Rounding of a point and of its distances, in radians.
constexpr double kRounding = 1e-12;

struct Candidate {
  LonLat at;
  Direction point;
  double r;  // in the unit of the sphere's radius
  SiteId site;
};

/// The largest are on top of a heap.
bool isBelow(const Candidate& a, const Candidate& b) {
  if (a.r != b.r) return a.r < b.r;
  return a.at.lon != b.at.lon ? a.at.lon > b.at.lon : a.at.lat > b.at.lat;
}

/// The direction of the great circle from a point to another one; arbitrary if they are opposite or
/// close.
Direction tangent(const Direction& from, const Direction& to) {
  const Direction way = to - dot(to, from) * from;
  if (lengthOf(way) < kRounding) return Frame(from).first;
  const Direction ahead = normalized(way);
  return normalized(ahead - dot(ahead, from) * from);
}

class Candidates {
 public:
  Candidates(const ProjectedDiagram& diagram, const SiteTable& sites)
      : diagram_(diagram), sites_(sites) {}

  /// The candidates as a heap. Throws std::bad_alloc.
  FlatArray<Candidate>& heap() {
    addVertices();
    addFarPoints();
    std::make_heap(heap_.begin(), heap_.end(), isBelow);
    return heap_;
  }

 private:
  void addVertices() {
    const Graph& graph = diagram_.graph();
    SphericalVertices vertices(diagram_, SphericalVertices::Of::kAll);
    for (const FaceId face : graph.faces()) {
      const SphericalVertex& vertex = vertices[face];
      const LonLat at = lonLatOf(vertex.point);
      heap_.push_back({at, directionOf(at), vertex.clearance * sites_.radius(),
                       diagram_.siteOf(graph.origin(halfedgeOf(face, 0)))});
    }
  }

  void addFarPoints() {
    const Graph& graph = diagram_.graph();
    if (!graph.isEmpty()) {
      for (const HalfedgeId h : graph.edges()) addFarPoint(graph.origin(h), graph.target(h));
    } else if (diagram_.visibleCount() == 2) {
      addFarPoint(kInfinity, diagram_.plane().delaunay().anyVisible());
    } else {
      const Cap& only = diagram_.cap(kInfinity);
      add(-1 * only.centre, std::numbers::pi - only.weight);
    }
  }

  void addFarPoint(VertexId nodeA, VertexId nodeB) {
    const Cap &a = diagram_.cap(nodeA), &b = diagram_.cap(nodeB);
    const double between = angleBetween(a.centre, b.centre).angle();
    const double away = (2 * std::numbers::pi - between + a.weight - b.weight) / 2;
    const Direction ahead = tangent(a.centre, b.centre);
    add(std::cos(away) * a.centre - std::sin(away) * ahead, away - a.weight);
  }

  /// Adds a point at this distance from two sites, in radians, unless another site is nearer.
  void add(const Direction& place, double distance) {
    const LonLat at = lonLatOf(place);
    const Direction point = directionOf(at);
    const SiteId site = diagram_.siteOf(nearestNode(diagram_, point));
    const double r = distanceTo(sites_, site, point);
    if (r >= sites_.radius() * (distance - kRounding)) heap_.push_back({at, point, r, site});
  }

  const ProjectedDiagram& diagram_;
  const SiteTable& sites_;
  FlatArray<Candidate> heap_;
};

}  // namespace

void listEmptyCircles(const ProjectedDiagram& diagram, const SiteTable& sites, std::size_t most,
                      VertexArrays& circles) {
  circles.coordinates.clear();
  circles.clearance.clear();
  circles.sites.clear();
  if (diagram.isEmpty()) return;
  Candidates candidates(diagram, sites);
  FlatArray<Candidate> chosen;
  for (FlatArray<Candidate>& heap = candidates.heap(); !heap.empty() && chosen.size() < most;) {
    std::pop_heap(heap.begin(), heap.end(), isBelow);
    const Candidate one = heap.back();
    heap.pop_back();
    const bool isApart = std::all_of(chosen.begin(), chosen.end(), [&](const Candidate& other) {
      const double away = sites.radius() * angleBetween(one.point, other.point).angle();
      return away >= other.r && away > 0;
    });
    if (isApart) chosen.push_back(one);
  }
  for (const Candidate& one : chosen) {
    for (const double degrees : {one.at.lon, one.at.lat}) circles.coordinates.push_back(degrees);
    circles.clearance.push_back(one.r);
    circles.sites.push_back(one.site);
  }
}

}  // namespace apollonius::internal::sphere
