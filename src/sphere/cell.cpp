#include "sphere/cell.h"

#include <cmath>
#include <numbers>

#include "sphere/nearest.h"

namespace apollonius::internal::sphere {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// Does an edge whose ends are in one direction go all the way round its site, or is it without
/// length? All points of the bisector are nearest to the two sites in the first case. In the
/// second, many can be, as the two sites may have another edge; but not those close to the ends.
bool goesRound(const ProjectedDiagram& diagram, HalfedgeId h, const Frame& frame,
               const SphericalBisector& bisector, double from) {
  constexpr double kRounding = 0x1p-40, kClosest = 0x1p-14;
  const Graph& graph = diagram.graph();
  const Cap& cap = diagram.cap(graph.origin(h));
  const auto isOnEdge = [&](double bearing) {
    const Direction point = bisector.at(bearing).point(cap.centre, frame);
    const double distance = distanceInRadians(point, cap);
    const auto isNearest = [&](VertexId node) {
      return distance < distanceInRadians(point, diagram.cap(node)) + kRounding;
    };
    return isNearest(graph.apex(h)) && isNearest(graph.apex(graph.twin(h))) &&
           isNearest(nearestNode(diagram, point));
  };
  for (double turn = 2.7; turn > kClosest; turn /= 2) {
    if (!isOnEdge(from + turn) || !isOnEdge(from - turn)) return false;
  }
  return true;
}

/// From one bearing to another, counter-clockwise: of an edge whose ends these are.
double widthOf(const ProjectedDiagram& diagram, HalfedgeId h, const Frame& frame,
               const SphericalBisector& bisector, double from, double to) {
  // Bearings are not known better than this where a vertex is close to the site.
  constexpr double kInOneDirection = 0x1p-16;
  const double turn = std::remainder(to - from, kTurn);
  if (std::abs(turn) > kInOneDirection) return turn < 0 ? turn + kTurn : turn;
  if (goesRound(diagram, h, frame, bisector, from)) return turn + kTurn;
  return turn < 0 ? 0 : turn;
}

}  // namespace

Sector sectorOf(const ProjectedDiagram& diagram, HalfedgeId h, SphericalVertices& vertices) {
  const Graph& graph = diagram.graph();
  const Cap& cap = diagram.cap(graph.origin(h));
  const Frame frame(cap.centre);
  const auto bisectorWith = [&](VertexId node) {
    return SphericalBisector(cap, frame, diagram.cap(node));
  };
  // Counter-clockwise about the origin of h, the edge of h runs from the vertex of the face at the
  // right of h to that of the face at the left.
  const HalfedgeId twin = graph.twin(h);
  const SphericalBisector bisector = bisectorWith(graph.target(h));
  const double from = bisector.bearingOfMeeting(bisectorWith(graph.apex(twin)),
                                                frame.bearing(vertices[faceOf(twin)].point));
  const double to = bisector.bearingOfMeeting(bisectorWith(graph.apex(h)),
                                              frame.bearing(vertices[faceOf(h)].point));
  return {bisector, from, widthOf(diagram, h, frame, bisector, from, to)};
}

void listSectors(const ProjectedDiagram& diagram, VertexId node, SphericalVertices& vertices,
                 FlatArray<Sector>& sectors) {
  sectors.clear();
  const Graph& graph = diagram.graph();
  const Cap& cap = diagram.cap(node);
  const Frame frame(cap.centre);
  if (graph.isEmpty()) {
    if (diagram.visibleCount() == 2)
      sectors.push_back(
          {SphericalBisector(cap, frame, diagram.cap(otherOfTwo(diagram, node))), 0, kTurn});
    return;
  }
  for (const HalfedgeId h : graph.star(node))
    sectors.push_back({SphericalBisector(cap, frame, diagram.cap(graph.target(h))),
                       frame.bearing(vertices[faceOf(graph.twin(h))].point), 0});
  const Sector* before = &sectors.back();
  for (Sector& sector : sectors) {
    sector.from = sector.bisector.bearingOfMeeting(before->bisector, sector.from);
    before = &sector;
  }
  std::size_t k = 0;
  for (const HalfedgeId h : graph.star(node)) {
    Sector& sector = sectors[k++];
    sector.width = widthOf(diagram, h, frame, sector.bisector, sector.from,
                           sectors[k == sectors.size() ? 0 : k].from);
  }
}

}  // namespace apollonius::internal::sphere
