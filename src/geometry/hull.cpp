#include "geometry/hull.h"

#include <vector>

#include "geometry/approximate.h"
#include "number/fp.h"
#include "predicate/predicates.h"

namespace apollonius {

namespace {

Point leftOf(Point p) { return {-p.y, p.x}; }

/// Continues a path, which is at center + radius · turn.from, along the circle, in pieces of a
/// quarter at most.
void drawArc(Point center, double radius, const HullTurn& turn, double tolerance, Path& path) {
  Point from = turn.from;
  const Point to = turn.to;
  if (turn.sign == Sign::kZero && dot(from, to) > 0) return;
  bool isDone = turn.sign != Sign::kNegative && dot(from, to) >= 0;
  for (int quarter = 0; quarter < 3 && !isDone; ++quarter) {
    const Point next = leftOf(from);
    drawConic(Conic::arc(center, radius, from, next), tolerance, path);
    from = next;
    isDone = cross(from, to) >= 0 && dot(from, to) >= 0;
  }
  if (!(from == to)) drawConic(Conic::arc(center, radius, from, to), tolerance, path);
}

/// The half-edges from sites to infinity, counter-clockwise around the hull.
template <class Visit>
void visitHull(const Graph& graph, Visit&& visit) {
  if (graph.isEmpty()) return;
  const HalfedgeId begin = graph.twin(graph.outgoing(kInfinity));
  HalfedgeId h = begin;
  do {
    visit(h);
    h = graph.twin(next(h));  // face (i, infinity, k): k follows i
  } while (h != begin);
}

}  // namespace

HullTurn hullTurnOf(const DelaunayGraph& base, HalfedgeId h) {
  // From the normal of the tangent on the right to that on the left.
  const Graph& graph = base.graph();
  const VoronoiCircle &right = base.circle(faceOf(graph.twin(h))), &left = base.circle(faceOf(h));
  const Point from{right.x, right.y}, to{left.x, left.y};
  const Site &before = base.site(graph.apex(graph.twin(h))), &after = base.site(graph.apex(h));
  return {from, to, turnOfHull(base.site(graph.origin(h)), before, after, right, left)};
}

void hullSites(const DiagramCore& core, std::vector<SiteId>& sites) {
  sites.clear();
  const DelaunayGraph& base = core.base();
  if (base.visibleCount() == 1) sites.push_back(core.siteOf(base.anyVisible()));
  visitHull(base.graph(),
            [&](HalfedgeId h) { sites.push_back(core.siteOf(base.graph().origin(h))); });
}

void drawHull(const DiagramCore& core, double tolerance, Path& path) {
  const DelaunayGraph& base = core.base();
  if (base.visibleCount() == 1) {
    const Site& site = base.site(base.anyVisible());
    if (site.r > 0) return drawCircle(site, tolerance, path);
    path.move(site.x, site.y);
    return path.close();
  }
  bool isFirst = true;
  visitHull(base.graph(), [&](HalfedgeId h) {
    const Site& site = base.site(base.graph().origin(h));
    const HullTurn turn = hullTurnOf(base, h);  // the site's arc is where its cell is unbounded
    const Point center{site.x, site.y};
    const Point start = center + site.r * turn.from;
    if (isFirst) {
      path.move(start.x, start.y);
    } else {
      path.line(start.x, start.y);
    }
    isFirst = false;
    if (site.r != 0) drawArc(center, site.r, turn, tolerance, path);
  });
  if (!isFirst) path.close();
}

void drawCircle(const Site& site, double tolerance, Path& path) {
  if (!(site.r > 0)) return;
  const Point center{site.x, site.y};
  Point from{1, 0};
  path.move(site.x + site.r, site.y);
  for (int quarter = 0; quarter < 4; ++quarter) {
    drawConic(Conic::arc(center, site.r, from, leftOf(from)), tolerance, path);
    from = leftOf(from);
  }
  path.close();
}

}  // namespace apollonius
