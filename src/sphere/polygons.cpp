#include "sphere/polygons.h"

#include <numbers>

#include "sphere/cell.h"
#include "sphere/measures.h"
#include "sphere/nearest.h"

namespace apollonius::internal::sphere {

CellPolygons::CellPolygons(const ProjectedDiagram& diagram, double tolerance, bool isCut,
                           SphericalVertices::Of of)
    : diagram_(diagram),
      chains_(diagram, tolerance, isCut ? Joint::kLonLatLine : Joint::kGreatArc, of),
      isCut_(isCut),
      atNorthPole_(diagram.isEmpty() ? kNoVertex : nearestNode(diagram, {0, 0, 1})),
      cutter_(tolerance * (180 / std::numbers::pi)) {}

bool CellPolygons::isOutside(VertexId node) {
  // Twice the area of the ring as the site's centre sees it: the integral of (sin rho)².
  const Direction& centre = diagram_.cap(node).centre;
  double area = 0, length = 0;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const Direction &a = points_[k], &b = points_[k + 1 < points_.size() ? k + 1 : 0];
    area += dot(cross(a, b), centre);
    length += lengthOf(b - a);
  }
  // Beside a needle thinner than rounding, it depends on that which cell has the pole.
  constexpr double kThin = 0x1p-24;
  if (area > kThin * length) return node == atNorthPole_;
  FlatArray<Sector> sectors;
  listSectors(diagram_, node, chains_.vertices(), sectors);
  return areaOfCell(diagram_.cap(node), sectors) > 2 * std::numbers::pi;
}

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
  for (const Direction& p : points_) {
    if (kept == 0 || lengthOf(p - points_[kept - 1]) > 0) points_[kept++] = p;
  }
  while (kept > 1 && !(lengthOf(points_[kept - 1] - points_[0]) > 0)) --kept;
  points_.resize(kept);
  if (isCut_) {
    cutter_.cut({points_.data(), points_.size()}, isOutside(node), rings_);
    return;
  }
  if (points_.empty()) return;
  for (std::size_t k = 0; k <= kept; ++k) {
    const LonLat p = lonLatOf(points_[k == kept ? 0 : k]);
    rings_.coordinates.push_back(p.lon);
    rings_.coordinates.push_back(p.lat);
  }
  rings_.endRing();
  rings_.endPart();
}

}  // namespace apollonius::internal::sphere
