#include "geometry/cell/polygon_cell.h"

#include <algorithm>

namespace apollonius::internal {

PolygonCellClipper::PolygonCellClipper(const ClippedDiagram& clippedDiagram, Parts parts)
    : CellClipper(parts), clippedDiagram_(clippedDiagram), rings_(parts) {}

const Cell& PolygonCellClipper::find(Slot site) {
  cell_.clear();
  const DiagramCore& core = clippedDiagram_.core();
  rings_.clear({core.site(site).x, core.site(site).y});
  if (core.ids().state(site) != SiteState::kVisible) return cell_;
  const Graph& graph = core.delaunay().graph();
  const VertexId v = vertexOf(site);
  if (graph.hasVertex(v)) {
    listSides(v);
    const int winding = clippedDiagram_.windingOf(faceOf(graph.twin(graph.outgoing(v))));
    const auto count = static_cast<std::int64_t>(std::min(exits_.size(), entries_.size()));
    if (count == 0 && winding > 0) {
      for (const Side& side : sides_) addPiece(side, nullptr, nullptr);
      rings_.closeRing();
    }
    sortRanks();
    isUsed_.assign(entries_.size(), 0);
    // The winding number at the start of the cell's first edge tells how far exits and entries are
    // out of step: the entry of exit k is entry k + winding. Sorting has put back in place what
    // rounding had swapped.
    for (std::size_t first = 0; first < isUsed_.size(); ++first) {
      std::size_t k = first;
      if (isUsed_[k] != 0) continue;
      while (isUsed_[k] == 0) {
        isUsed_[k] = 1;
        const Crossing& entry = clippedDiagram_.crossing(entries_[k].crossing);
        addBoundaryChain(entry);
        const std::int64_t exit = rankOf(entry.next), rank = exit + winding;
        const std::int64_t turns = rank >= 0 ? rank / count : -((count - 1 - rank) / count);
        k = static_cast<std::size_t>(rank - turns * count);
        const Event &from = exits_[static_cast<std::size_t>(exit)], &to = entries_[k];
        const auto way = turns * static_cast<std::int64_t>(sides_.size()) +
                         static_cast<std::int64_t>(to.edge) - static_cast<std::int64_t>(from.edge);
        addBoundary(from, to, way > 0 ? static_cast<std::size_t>(way) : 0);
      }
      rings_.closeRing();
    }
  }
  addInteriorRings(site);
  rings_.sortInto(cell_);
  return cell_;
}

/// Lists the cell's edges, and the crossings on them.
void PolygonCellClipper::listSides(VertexId v) {
  const DiagramCore& core = clippedDiagram_.core();
  const Graph& graph = core.delaunay().graph();
  sides_.clear();
  exits_.clear();
  entries_.clear();
  for (const HalfedgeId h : graph.star(v)) {
    const auto number = static_cast<std::uint32_t>(sides_.size());
    if (graph.target(h) == kInfinity) {
      sides_.push_back({h, kNoHalfedge, kNoSite});
      continue;
    }
    const bool isReference = startsAtReference(core.delaunay(), h);
    const HalfedgeId edge = isReference ? h : graph.twin(h);
    sides_.push_back({h, edge, core.siteOf(graph.target(h))});
    const std::span<const std::uint32_t> crossings = clippedDiagram_.crossingsOf(edge);
    for (std::size_t k = 0; k < crossings.size(); ++k) {
      const std::uint32_t c = crossings[isReference ? k : crossings.size() - 1 - k];
      const bool isExit = clippedDiagram_.crossing(c).isForward == isReference;
      (isExit ? exits_ : entries_).push_back({c, number});
    }
  }
}

void PolygonCellClipper::sortRanks() {
  ranks_.clear();
  for (std::uint32_t k = 0; k < exits_.size(); ++k) ranks_.push_back({exits_[k].crossing, k});
  sortByKey(ranks_);
}

/// Index in exits_ of the exit with this crossing.
std::uint32_t PolygonCellClipper::rankOf(std::uint32_t crossing) const {
  const auto isBefore = [](const Keyed& rank, std::uint32_t exit) { return rank.key < exit; };
  return std::lower_bound(ranks_.begin(), ranks_.end(), crossing, isBefore)->value;
}

/// Adds a part of a segment of the polygon.
void PolygonCellClipper::addBorder(Point from, Point to, std::uint32_t segment) {
  if (!(from == to)) rings_.add({Conic::segment(from, to), kNoSite, segment, segment});
}

/// Adds the region's boundary through the cell.
void PolygonCellClipper::addBoundaryChain(const Crossing& entry) {
  clippedDiagram_.visitBoundaryChain(
      entry, [&](Point from, Point to, std::uint32_t segment) { addBorder(from, to, segment); });
}

/// Adds the cell's boundary from one crossing to another, this many sides further on.
void PolygonCellClipper::addBoundary(const Event& from, const Event& to, std::size_t sides) {
  const Crossing &start = clippedDiagram_.crossing(from.crossing),
                 &end = clippedDiagram_.crossing(to.crossing);
  if (sides == 0) return addPiece(sides_[from.edge], &start, &end);
  addPiece(sides_[from.edge], &start, nullptr);
  for (std::size_t k = 1; k < sides; ++k)
    addPiece(sides_[(from.edge + k) % sides_.size()], nullptr, nullptr);
  addPiece(sides_[to.edge], nullptr, &end);
}

/// Adds a piece of an edge, counter-clockwise. A null crossing stands for the edge's own start or
/// end.
void PolygonCellClipper::addPiece(const Side& side, const Crossing* from, const Crossing* to) {
  if (side.edge == kNoHalfedge) return;
  const Edge edge(clippedDiagram_.core().delaunay(), side.edge);
  const bool isReference = side.edge == side.halfedge;
  const Crossing* const low = isReference ? from : to;
  const Crossing* const high = isReference ? to : from;
  if ((low == nullptr && !edge.from.isFinite) || (high == nullptr && !edge.to.isFinite)) return;
  const bool isHere =
      low == nullptr || high == nullptr || (low->edge == side.edge && high->edge == side.edge);
  const Point a = low == nullptr ? edge.from.point : low->point,
              b = high == nullptr ? edge.to.point : high->point;
  const double e0 = low == nullptr ? edge.e0 : low->e, e1 = high == nullptr ? edge.e1 : high->e;
  // If rounding swapped the ends, the piece is taken backwards.
  const Conic curve = !isHere    ? Conic::segment(a, b)
                      : e0 <= e1 ? clippedDiagram_.pieceInside(edge, e0, e1, a, b)
                                 : clippedDiagram_.pieceInside(edge, e1, e0, b, a).reversed();
  const bool isTouch =
      clippedDiagram_.isTouch(side.edge, edge, curve, from == nullptr && to == nullptr);
  if (!isTouch || !(curve.p0 == curve.p2))
    rings_.add({isReference ? curve : curve.reversed(), side.neighbor, segmentOf(from),
                segmentOf(to), false, isTouch});
}

/// The polygon segment that a crossing is on.
std::uint32_t PolygonCellClipper::segmentOf(const Crossing* crossing) const {
  if (crossing == nullptr) return kNoSegment;
  return clippedDiagram_.polygon().starts[crossing->ring] + crossing->firstPoint - 1;
}

void PolygonCellClipper::addInteriorRings(Slot site) {
  const NormalizedPolygon& polygon = clippedDiagram_.polygon();
  for (const Keyed& interiorRing : clippedDiagram_.interiorRingsOf(site)) {
    const std::span<const Point> ring = polygon.ring(interiorRing.value);
    const std::uint32_t first = polygon.starts[interiorRing.value];
    auto segment = first + static_cast<std::uint32_t>(ring.size()) - 1;
    Point at = ring.back();
    for (const Point p : ring) {
      addBorder(at, p, segment);
      at = p;
      segment = segment + 1 == polygon.starts[interiorRing.value + 1] ? first : segment + 1;
    }
    rings_.closeRing(true);
  }
}

}  // namespace apollonius::internal
