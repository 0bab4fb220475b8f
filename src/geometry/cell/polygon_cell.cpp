#include "geometry/cell/polygon_cell.h"

#include <algorithm>

#include "geometry/curve/moments.h"

namespace apollonius::internal {

namespace {

/// How far rounding moves a region's boundary at most where it meets an edge, in units of the
/// numbers there. Thinner parts are discarded.
constexpr double kThinnest = powerOfTwo(-46);

}  // namespace

PolygonCellClipper::PolygonCellClipper(const ClippedDiagram& clippedDiagram, Parts parts)
    : CellClipper(parts),
      clippedDiagram_(clippedDiagram),
      rankOf_(clippedDiagram.crossingCount(), 0) {}

const Cell& PolygonCellClipper::find(Slot site) {
  for (Cell* const cell : {&cell_, &found_}) {
    cell->pieces.clear();
    cell->starts.assign(1, 0);
  }
  cell_.outers.assign(1, 0);
  areas_.clear();
  nesting_.clear();
  const DiagramCore& core = clippedDiagram_.core();
  if (core.ids().state(site) != SiteState::kVisible) return cell_;
  const Graph& graph = core.delaunay().graph();
  const VertexId v = vertexOf(site);
  if (graph.hasVertex(v)) {
    listSides(v);
    const int winding = clippedDiagram_.windingOf(faceOf(graph.twin(graph.outgoing(v))));
    const auto count = static_cast<std::int64_t>(std::min(exits_.size(), entries_.size()));
    if (count == 0 && winding > 0) {
      for (const Side& side : sides_) addPiece(side, nullptr, nullptr);
      closeRing();
    }
    for (std::uint32_t k = 0; k < exits_.size(); ++k) rankOf_[exits_[k].crossing] = k;
    isUsed_.assign(entries_.size(), 0);
    // Between the cell's first edge and an exit, this many more rings have entered than left
    // as the winding number at the first edge's start says; so that many entries further on is the
    // exit's. What rounding has exchanged is in its place again after sorting.
    for (std::size_t first = 0; first < isUsed_.size(); ++first) {
      std::size_t k = first;
      if (isUsed_[k] != 0) continue;
      while (isUsed_[k] == 0) {
        isUsed_[k] = 1;
        const Crossing& entry = clippedDiagram_.crossing(entries_[k].crossing);
        addBoundaryChain(entry);
        const std::int64_t exit = rankOf_[entry.next], rank = exit + winding;
        const std::int64_t turns = rank >= 0 ? rank / count : -((count - 1 - rank) / count);
        k = static_cast<std::size_t>(rank - turns * count);
        const Event &from = exits_[static_cast<std::size_t>(exit)], &to = entries_[k];
        const auto way = turns * static_cast<std::int64_t>(sides_.size()) +
                         static_cast<std::int64_t>(to.edge) - static_cast<std::int64_t>(from.edge);
        addBoundary(from, to, way > 0 ? static_cast<std::size_t>(way) : 0);
      }
      closeRing();
    }
  }
  addInteriorRings(site);
  sortHoles();
  return cell_;
}

/// The cell's edges, and the crossings on them.
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

void PolygonCellClipper::addSegment(Point from, Point to, SiteId neighbor) {
  if (!(from == to)) found_.pieces.push_back({Conic::segment(from, to), neighbor});
}

/// The region's boundary through the cell.
void PolygonCellClipper::addBoundaryChain(const Crossing& entry) {
  clippedDiagram_.visitBoundaryChain(entry,
                                     [&](Point from, Point to) { addSegment(from, to, kNoSite); });
}

/// The cell's boundary from one crossing to another, this many sides further on.
void PolygonCellClipper::addBoundary(const Event& from, const Event& to, std::size_t sides) {
  const Crossing &start = clippedDiagram_.crossing(from.crossing),
                 &end = clippedDiagram_.crossing(to.crossing);
  if (sides == 0) return addPiece(sides_[from.edge], &start, &end);
  addPiece(sides_[from.edge], &start, nullptr);
  for (std::size_t k = 1; k < sides; ++k)
    addPiece(sides_[(from.edge + k) % sides_.size()], nullptr, nullptr);
  addPiece(sides_[to.edge], nullptr, &end);
}

/// A piece of an edge, counter-clockwise; from its start and to its end, where none is given.
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
  // Places that rounding has exchanged are gone between backwards.
  const Conic curve = !isHere    ? Conic::segment(a, b)
                      : e0 <= e1 ? clippedDiagram_.pieceInside(edge, e0, e1, a, b)
                                 : clippedDiagram_.pieceInside(edge, e1, e0, b, a).reversed();
  if (!(curve.p0 == curve.p2))
    found_.pieces.push_back(
        {isReference ? curve : curve.reversed(), side.neighbor, segmentOf(from), segmentOf(to)});
}

/// Of the polygon, on which a crossing is.
std::uint32_t PolygonCellClipper::segmentOf(const Crossing* crossing) const {
  if (crossing == nullptr) return kNoSegment;
  return clippedDiagram_.polygon().starts[crossing->ring] + crossing->firstPoint - 1;
}

void PolygonCellClipper::addInteriorRings(Slot site) {
  for (const Keyed& interiorRing : clippedDiagram_.interiorRingsOf(site)) {
    const std::span<const Point> ring = clippedDiagram_.polygon().ring(interiorRing.value);
    Point at = ring.back();
    for (const Point p : ring) {
      addSegment(at, p, kNoSite);
      at = p;
    }
    closeRing();
  }
}

void PolygonCellClipper::closeRing() {
  const std::uint32_t start = found_.starts.back();
  const auto pieces = std::span(found_.pieces).subspan(start);
  if (pieces.empty()) return;
  double reach = 0, size = 0;
  const Point first = pieces.front().curve.p0;
  Rectangle box{first.x, first.y, first.x, first.y};
  for (const BoundaryPiece& piece : pieces) {
    const Point from = piece.curve.p0;
    reach += length(piece.curve.p2 - from);
    size = std::max({size, absolute(from.x), absolute(from.y)});
    for (const Point p : {piece.curve.p1, piece.curve.p2}) box.include(p);
  }
  const Area area = areaOf(pieces, pieces.front().curve.p0);
  const double thinnest = std::max(area.rounding, kThinnest * size * reach);
  if (absolute(area.value) > thinnest || parts() == Parts::kThinToo) {
    found_.starts.push_back(static_cast<std::uint32_t>(found_.pieces.size()));
    if (area.value > 0) nesting_.add(static_cast<std::uint32_t>(areas_.size()), area.value, box);
    areas_.push_back(area.value);
  } else {
    found_.pieces.resize(start);
  }
}

bool PolygonCellClipper::isCrossed(std::uint32_t ring, std::size_t k, Point p) {
  const Conic& c = found_.ring(ring)[k].curve;
  bool isCrossed = false;
  if ((c.p0.y > p.y) != (c.p2.y > p.y)) {
    const double turn = cross(c.p2 - c.p0, p - c.p0);
    isCrossed = (turn > 0) == (c.p2.y > c.p0.y);
  }
  if (c.isStraight()) return isCrossed;
  // Between chord and curve? There the barycentric coordinates in the control triangle are
  // positive, and b² < 4 w² a c.
  const double whole = cross(c.p1 - c.p0, c.p2 - c.p0);
  const double a = cross(c.p1 - p, c.p2 - p) / whole, b = cross(c.p2 - p, c.p0 - p) / whole,
               g = cross(c.p0 - p, c.p1 - p) / whole;
  return isCrossed != (a > 0 && b > 0 && g > 0 && b * b < 4 * c.w * c.w * a * g);
}

void PolygonCellClipper::sortHoles() {
  const auto take = [&](std::size_t k) {
    cell_.pieces.append(found_.ring(k));
    cell_.starts.push_back(static_cast<std::uint32_t>(cell_.pieces.size()));
  };
  const std::size_t count = areas_.size();
  if (parts() == Parts::kThinToo) {  // what is a hole of what is not known
    for (std::uint32_t k = 0; k < count; ++k) take(k);
    if (count > 0) cell_.outers.push_back(static_cast<std::uint32_t>(count));
    return;
  }
  FlatArray<Keyed> holes;  // by the smallest ring around each
  for (std::uint32_t hole = 0; hole < count; ++hole) {
    if (areas_[hole] > 0) continue;
    const Conic& first = found_.ring(hole).front().curve;
    asked_ = middle(first.p0, first.p2);
    const std::uint32_t around = nesting_.find(asked_, -areas_[hole]);
    holes.push_back({around == RingNesting::kNoRing ? 0 : around, hole});
  }
  sortByKey(holes);
  std::size_t next = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    const bool isOuter = areas_[k] > 0;
    if (isOuter) take(k);
    for (; next < holes.size() && holes[next].key == k; ++next) {
      if (isOuter) take(holes[next].value);
    }
    if (!isOuter) continue;
    cell_.outers.push_back(static_cast<std::uint32_t>(cell_.ringCount()));
  }
}

}  // namespace apollonius::internal
