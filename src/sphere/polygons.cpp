#include "sphere/polygons.h"

#include <numbers>

#include "sphere/cell.h"
#include "sphere/measures.h"

namespace apollonius::internal::sphere {

CellPolygons::CellPolygons(const ProjectedDiagram& diagram, double tolerance, bool isCut,
                           const AngularReach& reach, SphericalVertices::Of of)
    : diagram_(diagram),
      reach_(reach),
      chains_(diagram, tolerance, isCut ? Joint::kLonLatLine : Joint::kGreatArc, of),
      isCut_(isCut),
      cutter_(tolerance * (180 / std::numbers::pi)) {}

void CellPolygons::followWithin(VertexId node, double reach) {
  const Graph& graph = diagram_.graph();
  listSectors(diagram_, node, chains_.vertices(), sectors_);
  strands_.clear();
  inner_.clear();
  double turn = 0;  // sum of the widths of the sectors that are done
  if (graph.isEmpty()) {
    if (!sectors_.empty()) chains_.appendClosedWithin(node, sectors_[0], reach_, inner_, strands_);
    turn = 2 * std::numbers::pi;
  } else {
    std::size_t k = 0;
    for (const HalfedgeId h : graph.star(node)) {
      const std::size_t first = strands_.size();
      chains_.appendWithin(h, sectors_[k], reach_, inner_, strands_);
      for (std::size_t strand = first; strand < strands_.size(); ++strand) {
        strands_[strand].from += turn;
        strands_[strand].to += turn;
      }
      turn += sectors_[k++].width;
    }
  }
  points_.clear();
  const double start = sectors_.empty() ? 0 : sectors_[0].from;
  if (strands_.empty()) {
    if (reach >= std::numbers::pi) return;
    const MapPoint point = chains_.onCircle(node, reach, start);
    points_.push_back(point);
    chains_.appendCircle(node, reach, point, start, 2 * std::numbers::pi, point, points_);
    return;
  }
  for (std::size_t k = 0; k < strands_.size(); ++k) {
    const ChainMaker::Strand& strand = strands_[k];
    const bool isLast = k + 1 == strands_.size();
    const ChainMaker::Strand& next = strands_[isLast ? 0 : k + 1];
    points_.append({inner_.data() + strand.begin, strand.end - strand.begin});
    const double width = next.from + (isLast ? turn : 0) - strand.to;
    if (width > 0)
      chains_.appendCircle(node, reach, inner_[strand.end - 1], start + strand.to, width,
                           inner_[next.begin], points_);
  }
}

std::span<const MapPoint> CellPolygons::withoutSpurs() {
  const auto areSame = [&](std::size_t k, std::size_t m) {
    const MapPoint &a = points_[k], &b = points_[m];
    return !(lengthOf(a.point - b.point) > 0) || (a.at.lon == b.at.lon && a.at.lat == b.at.lat);
  };
  std::size_t begin = 0, end = 0;
  for (const MapPoint& p : points_) {
    points_[end++] = p;
    if (end > 1 && areSame(end - 1, end - 2)) {
      --end;
    } else if (end > 2 && areSame(end - 1, end - 3)) {
      end -= 2;
    }
  }
  // Where the ring is closed, too.
  for (;;) {
    const std::size_t count = end - begin;
    if (count > 1 && (areSame(begin, end - 1) || (count > 2 && areSame(begin, end - 2)))) {
      --end;
    } else if (count > 2 && areSame(begin + 1, end - 1)) {
      ++begin;
    } else {
      return {points_.data() + begin, count};
    }
  }
}

void CellPolygons::append(VertexId node) {
  const double reach = reach_.of(diagram_, node);
  if (!(reach > 0)) return;
  const Graph& graph = diagram_.graph();
  if (reach_.isUnlimited() && !graph.isEmpty()) {
    points_.clear();
    for (const HalfedgeId h : graph.star(node)) chains_.append(h, points_);
  } else {
    followWithin(node, reach);
  }
  const std::span<const MapPoint> ring = withoutSpurs();
  if (reach < std::numbers::pi && ring.size() < 3) return;  // a reach as small as rounding
  if (isCut_) {
    const auto area = [&] {
      listSectors(diagram_, node, chains_.vertices(), sectors_);
      return areaOfCell(diagram_.cap(node), sectors_, reach);
    };
    cutter_.cut(ring, area, rings_);
    return;
  }
  if (ring.empty()) return;
  for (std::size_t k = 0; k <= ring.size(); ++k) {
    const LonLat& p = ring[k == ring.size() ? 0 : k].at;
    rings_.coordinates.push_back(p.lon);
    rings_.coordinates.push_back(p.lat);
  }
  rings_.endRing();
  rings_.endPart();
}

}  // namespace apollonius::internal::sphere
