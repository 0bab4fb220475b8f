#include "sphere/natural_neighbors.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "sphere/measures.h"
#include "sphere/nearest.h"

namespace apollonius::internal::sphere {

namespace {

/// Does the first cap cover the other, as computed, or so nearly that there is no bisector?
bool covers(const Cap& cap, const Cap& other) {
  return !(HalfAngle{} < angleBetween(cap.centre, other.centre) - (cap.radius - other.radius));
}

}  // namespace

void NaturalNeighbors::note(VertexId node) {
  if (seen_.insert(diagram_.siteOf(node))) reached_.push_back(node);
}

template <class Visit>
void NaturalNeighbors::visitEdges(VertexId node, Visit&& visit) const {
  const Graph& graph = diagram_.graph();
  if (graph.isEmpty()) {
    if (!sectors_.empty()) visit(sectors_[0], otherOfTwo(diagram_, node));
    return;
  }
  std::size_t k = 0;
  for (const HalfedgeId h : graph.star(node)) visit(sectors_[k++], graph.target(h));
}

double NaturalNeighbors::areaTaken(VertexId node, const Cap& cap) {
  const Cap& own = diagram_.cap(node);
  listSectors(diagram_, node, vertices_, sectors_);
  if (covers(cap, own)) {
    visitEdges(node, [&](const Sector&, VertexId neighbor) { note(neighbor); });
    return areaOfCell(own, sectors_, std::numbers::pi);
  }
  const SphericalBisector bisector(own, cap, Frame(own.centre));
  if (sectors_.empty()) return 4 * std::numbers::pi - areaBelow(bisector, 0, 2 * std::numbers::pi);
  double area = 0;
  visitEdges(node, [&](const Sector& sector, VertexId neighbor) {
    const SphericalBisector::Nearer nearer = bisector.nearerThan(sector.bisector);
    visitAbout(sector, nearer.middle, nearer.aside, [&](double from, double to) {
      note(neighbor);
      const double begin = sector.from + from, width = to - from;
      area += std::max(areaBelow(sector.bisector, begin, width) - areaBelow(bisector, begin, width),
                       0.0);
    });
  });
  return area;
}

std::span<const NaturalShare> NaturalNeighbors::find(const Cap& cap) {
  const VertexId nearest = nearestNode(diagram_, cap.centre);
  shares_.clear();
  double sum = 0;
  if (!covers(diagram_.cap(nearest), cap)) {
    reached_.clear();
    seen_.clear();
    note(nearest);
    for (std::size_t k = 0; k < reached_.size(); ++k) {
      const VertexId node = reached_[k];
      const double area = areaTaken(node, cap);
      if (!(area > 0)) continue;
      shares_.push_back({node, area});
      sum += area;
    }
  }
  if (!(sum > 0)) {
    shares_.assign(1, {nearest, 1});
    sum = 1;
  }
  for (NaturalShare& share : shares_) share.weight /= sum;
  return {shares_.data(), shares_.size()};
}

void interpolate(const ProjectedDiagram& diagram, std::span<const double> values,
                 std::span<const double> lonLat, double weight, std::span<double> results) {
  if (diagram.isEmpty()) {
    std::fill(results.begin(), results.end(), std::numeric_limits<double>::quiet_NaN());
    return;
  }
  NaturalNeighbors neighbors(diagram, SphericalVertices::Of::kAll);
  const Cap cap = capOf({}, weight);
  visitPoints(diagram, lonLat, [&](std::size_t k, const Direction& point) {
    double sum = 0;
    for (const NaturalShare& share : neighbors.find({point, cap.radius, weight}))
      sum += share.weight * values[diagram.siteOf(share.node)];
    results[k] = sum;
  });
}

}  // namespace apollonius::internal::sphere
