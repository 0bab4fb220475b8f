#include "geometry/cell/disc_cell.h"

#include <algorithm>

#include "base/flat_array.h"
#include "geometry/curve/arcs.h"
#include "geometry/curve/edge.h"

namespace apollonius::internal {

namespace {

/// A part of an edge within the radius, the directions from the centre in which it starts and ends,
/// and one between them from which both are less than half a turn away.
struct Sector {
  BoundaryPiece piece;
  Point from, between, to;
  bool startsOnCircle, endsOnCircle;
};

/// Are they the same direction up to rounding?
bool areEqual(Point a, Point b) {
  return absolute(cross(a, b)) <= powerOfTwo(-40) && dot(a, b) > 0;
}

/// Adds the arc from one direction to another, counter-clockwise; a full turn if they are equal.
void addArc(Point center, double radius, Point from, Point to, FlatArray<BoundaryPiece>& boundary) {
  visitQuarters(from, to, !areEqual(from, to) && isQuarterAtMost(from, to), [&](Point a, Point b) {
    boundary.push_back({Conic::arc(center, radius, a, b), kNoSite});
  });
}

/// The parts of a cell's edges within the radius, counter-clockwise about the site.
void findSectors(const DiagramCore& core, Slot site, double radius, FlatArray<Sector>& sectors) {
  const DelaunayGraph& delaunay = core.delaunay();
  const Graph& graph = delaunay.graph();
  const Point center{core.site(site).x, core.site(site).y};
  const VertexId v = vertexOf(site);
  const auto add = [&](HalfedgeId h) {
    if (graph.target(h) == kInfinity) return;
    const bool isReference = startsAtReference(delaunay, h);
    const Edge edge(delaunay, isReference ? h : graph.twin(h));
    const Bisector& bisector = edge.bisector;
    const double a = isReference ? -bisector.transverse() : bisector.transverse();
    const double largest = (radius + a) / (bisector.distance() / 2);
    if (!(largest > 1)) return;
    const bool isImmense = largest > powerOfTwo(500);  // of which the square may be infinite
    const double e = largest + (isImmense ? largest : std::sqrt((largest - 1) * (largest + 1)));
    const bool isFromCut = !(edge.e0 > 1 / e), isToCut = !(edge.e1 < e);
    const double e0 = isFromCut ? 1 / e : edge.e0, e1 = isToCut ? e : edge.e1;
    // An edge inside that has no length in doubles still says that the cell ends there.
    if (e0 > e1 || (e0 == e1 && (isFromCut || isToCut))) return;
    const Point from = isFromCut ? bisector.at(e0) : edge.from.point,
                to = isToCut ? bisector.at(e1) : edge.to.point;
    const Conic curve = bisector.piece(e0, e1, from, to);
    // Seen from either site, a bisector turns by less than half a turn on each side of the axis.
    const Point between = bisector.at(std::clamp(1.0, e0, e1));
    const SiteId neighbor = core.siteOf(graph.target(h));
    const Point start = unit(from - center), middle = unit(between - center),
                end = unit(to - center);
    if (isReference) {
      sectors.push_back({{curve, neighbor}, start, middle, end, isFromCut, isToCut});
    } else {
      sectors.push_back({{curve.reversed(), neighbor}, end, middle, start, isToCut, isFromCut});
    }
  };
  for (const HalfedgeId h : graph.star(v)) add(h);
}

void findBoundary(const DiagramCore& core, Slot site, double radius,
                  FlatArray<BoundaryPiece>& boundary) {
  const Point center{core.site(site).x, core.site(site).y};
  FlatArray<Sector> sectors;
  findSectors(core, site, radius, sectors);
  if (sectors.empty()) return addArc(center, radius, {1, 0}, {1, 0}, boundary);

  // All sectors and the arcs between them are one turn. So an arc between equal directions is
  // empty, unless nothing else turns: then one of them is all of it.
  const auto hasArc = [&](std::size_t k) {
    return sectors[k].endsOnCircle || sectors[(k + 1) % sectors.size()].startsOnCircle;
  };
  bool isTurnFound = false;
  for (std::size_t k = 0; k < sectors.size() && !isTurnFound; ++k) {
    const Sector& sector = sectors[k];
    isTurnFound = !areEqual(sector.from, sector.between) || !areEqual(sector.between, sector.to) ||
                  (hasArc(k) && !areEqual(sector.to, sectors[(k + 1) % sectors.size()].from));
  }
  for (std::size_t k = 0; k < sectors.size(); ++k) {
    boundary.push_back(sectors[k].piece);
    const Point from = sectors[k].to, to = sectors[(k + 1) % sectors.size()].from;
    if (!hasArc(k) || (areEqual(from, to) && isTurnFound)) continue;
    addArc(center, radius, from, to, boundary);
    isTurnFound = true;
  }
}

}  // namespace

const Cell& DiscCellClipper::find(Slot site) {
  cell_.pieces.clear();
  cell_.starts.assign(1, 0);
  cell_.outers.assign(1, 0);
  if (core_.ids().state(site) != SiteState::kVisible || !(radius_ > 0)) return cell_;
  findBoundary(core_, site, radius_, cell_.pieces);
  cell_.starts.push_back(static_cast<std::uint32_t>(cell_.pieces.size()));
  cell_.outers.push_back(1);
  return cell_;
}

}  // namespace apollonius::internal
