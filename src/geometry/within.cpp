#include "geometry/within.h"

#include <algorithm>

#include "memory/flat_array.h"

namespace apollonius {

namespace {

/// The directions from the centre at which a piece starts and ends.
struct Sector {
  BoundaryPiece piece;
  Point from, to;
  bool startsOnCircle, endsOnCircle;
};

Point unit(Point p) {
  const double size = length(p);
  return {p.x / size, p.y / size};
}

/// Adds the arc from one direction to another, counter-clockwise; `isFull` says which of nothing and a full turn equal ones mean.
void addArc(Point center, double radius, Point from, Point to, bool isFull, FlatArray<BoundaryPiece>& boundary) {
  const double turn = cross(from, to);
  const bool areEqual = absolute(turn) <= powerOfTwo(-40) && dot(from, to) > 0;
  if (areEqual && !isFull) return;
  bool isDone = !areEqual && turn >= 0 && dot(from, to) >= 0;
  for (int quarter = 0; quarter < 3 && !isDone; ++quarter) {
    const Point next{-from.y, from.x};
    boundary.push_back({Conic::arc(center, radius, from, next), kNoSite});
    from = next;
    isDone = cross(from, to) >= 0 && dot(from, to) >= 0;
  }
  boundary.push_back({Conic::arc(center, radius, from, to), kNoSite});
}

}  // namespace

void cellWithin(const DiagramCore& core, Slot site, double radius, FlatArray<BoundaryPiece>& boundary) {
  boundary.clear();
  if (core.ids().state(site) != SiteState::kVisible || !(radius > 0)) return;
  const DelaunayGraph& base = core.base();
  const Graph& graph = base.graph();
  const Point center{core.site(site).x, core.site(site).y};
  FlatArray<Sector> sectors;
  const VertexId v = DiagramCore::vertexOf(site);
  if (graph.hasVertex(v)) {
    const HalfedgeId begin = graph.outgoing(v);
    HalfedgeId h = begin;
    do {
      if (graph.target(h) != kInfinity) {
        const bool isPole = startsAtPole(base, h);
        const Edge edge(base, isPole ? h : graph.twin(h));
        const Bisector& bisector = edge.bisector;
        const double largest = (isPole ? radius - bisector.transverse() : radius + bisector.transverse()) / (bisector.distance() / 2);
        if (largest > 1) {
          const double e = largest + std::sqrt((largest - 1) * (largest + 1));
          const bool isFromCut = !(edge.e0 > 1 / e), isToCut = !(edge.e1 < e);
          const double e0 = isFromCut ? 1 / e : edge.e0, e1 = isToCut ? e : edge.e1;
          if (e0 < e1) {
            const Point from = isFromCut ? bisector.at(e0) : edge.from.point, to = isToCut ? bisector.at(e1) : edge.to.point;
            const Conic curve = bisector.piece(e0, e1, from, to);
            const SiteId neighbor = core.siteOf(graph.target(h));
            if (isPole) {
              sectors.push_back({{curve, neighbor}, unit(from - center), unit(to - center), isFromCut, isToCut});
            } else {
              sectors.push_back({{curve.reversed(), neighbor}, unit(to - center), unit(from - center), isToCut, isFromCut});
            }
          }
        }
      }
      h = graph.rotateCcw(h);
    } while (h != begin);
  }
  if (sectors.empty()) addArc(center, radius, {1, 0}, {1, 0}, true, boundary);
  for (std::size_t k = 0; k < sectors.size(); ++k) {
    boundary.push_back(sectors[k].piece);
    const Sector& next = sectors[(k + 1) % sectors.size()];
    if (sectors[k].endsOnCircle || next.startsOnCircle) addArc(center, radius, sectors[k].to, next.from, sectors.size() == 1, boundary);
  }
}

}  // namespace apollonius
