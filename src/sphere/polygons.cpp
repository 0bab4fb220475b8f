#include "sphere/polygons.h"

#include <numbers>

#include "sphere/cell.h"
#include "sphere/measures.h"

namespace apollonius::internal::sphere {

CellPolygons::CellPolygons(const ProjectedDiagram& diagram, double tolerance, bool isCut,
                           SphericalVertices::Of of)
    : diagram_(diagram),
      chains_(diagram, tolerance, isCut ? Joint::kLonLatLine : Joint::kGreatArc, of),
      isCut_(isCut),
      cutter_(tolerance * (180 / std::numbers::pi)) {}

void CellPolygons::append(VertexId node) {
  const Graph& graph = diagram_.graph();
  points_.clear();
  if (!graph.isEmpty()) {
    for (const HalfedgeId h : graph.star(node)) chains_.append(h, points_);
  } else if (diagram_.visibleCount() == 2) {
    chains_.appendClosed(node, points_);
  }
  // Edges without length repeat points.
  std::size_t kept = 0;
  const auto isApart = [](const MapPoint& p, const MapPoint& other) {
    return lengthOf(p.point - other.point) > 0;
  };
  for (const MapPoint& p : points_) {
    if (kept == 0 || isApart(p, points_[kept - 1])) points_[kept++] = p;
  }
  while (kept > 1 && !isApart(points_[kept - 1], points_[0])) --kept;
  points_.resize(kept);
  if (isCut_) {
    const auto area = [&] {
      listSectors(diagram_, node, chains_.vertices(), sectors_);
      return areaOfCell(diagram_.cap(node), sectors_);
    };
    cutter_.cut({points_.data(), points_.size()}, area, rings_);
    return;
  }
  if (points_.empty()) return;
  for (std::size_t k = 0; k <= kept; ++k) {
    const LonLat& p = points_[k == kept ? 0 : k].at;
    rings_.coordinates.push_back(p.lon);
    rings_.coordinates.push_back(p.lat);
  }
  rings_.endRing();
  rings_.endPart();
}

}  // namespace apollonius::internal::sphere
