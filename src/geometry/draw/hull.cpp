#include "geometry/draw/hull.h"

#include "geometry/curve/arcs.h"
#include "geometry/draw/cubics.h"
#include "number/fp.h"
#include "predicate/predicates.h"
#include "topology/hull.h"

namespace apollonius::internal {

namespace {

/// Continues a path, which is at center + radius · turn.from, along the circle, in pieces of a
/// quarter at most.
void drawArc(Point center, double radius, const HullTurn& turn, Tolerance tolerance, Path& path) {
  const bool isForwards = dot(turn.from, turn.to) >= 0;
  if (turn.sign == Sign::kZero && dot(turn.from, turn.to) > 0) return;
  visitQuarters(turn.from, turn.to, turn.sign != Sign::kNegative && isForwards,
                [&](Point from, Point to) {
                  if (from == to) return;
                  drawConic(Conic::arc(center, radius, from, to), tolerance, path);
                });
}

}  // namespace

HullTurn hullTurnOf(const DelaunayGraph& delaunay, HalfedgeId h) {
  // From the normal of the tangent on the right to that on the left.
  const Graph& graph = delaunay.graph();
  const VoronoiCircle &right = delaunay.circle(faceOf(graph.twin(h))),
                      &left = delaunay.circle(faceOf(h));
  const Point from{right.x, right.y}, to{left.x, left.y};
  const Site &before = delaunay.site(graph.apex(graph.twin(h))),
             &after = delaunay.site(graph.apex(h));
  return {from, to, turnOfHull(delaunay.site(graph.origin(h)), before, after, right, left)};
}

void drawHull(const DiagramCore& core, Tolerance tolerance, Path& path) {
  const DelaunayGraph& delaunay = core.delaunay();
  if (delaunay.visibleCount() == 1) {
    const Site& site = delaunay.site(delaunay.anyVisible());
    if (site.r > 0) return drawCircle(site, tolerance, path);
    path.move(site.x, site.y);
    return path.close();
  }
  bool isFirst = true;
  visitHull(delaunay.graph(), [&](HalfedgeId h) {
    const Site& site = delaunay.site(delaunay.graph().origin(h));
    const HullTurn turn = hullTurnOf(delaunay, h);  // the site's arc is where its cell is unbounded
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

void drawCircle(const Site& site, Tolerance tolerance, Path& path) {
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

}  // namespace apollonius::internal
