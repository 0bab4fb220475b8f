#include "geometry/render.h"

#include <limits>

#include "geometry/approximate.h"
#include "geometry/clip.h"
#include "geometry/dual.h"
#include "geometry/hull.h"

namespace apollonius {

namespace {

/// Goes over the half-edges in the plane that start at their pole, from the portion's cursor on.
template <class Draw>
bool visitEdges(const DelaunayGraph& base, Portion& portion, const Path& path, Draw&& draw) {
  const std::size_t count = 3 * base.graph().faceSlots(), limit = portion.commands;
  for (; portion.cursor < count; ++portion.cursor) {
    if (path.commands.size() >= limit) return true;
    const HalfedgeId h{static_cast<std::uint32_t>(portion.cursor)};
    if (base.graph().isLive(faceOf(h))) draw(h);
  }
  return false;
}

/// Is the edge inside the window and straight up to the tolerance? A quick test that says yes for most edges of large diagrams.
/// The curvature of the bisector is at most A/B² = 2|r|/p =: c. With a chord of length l and c l <= 1, the arc turns by less than half a
/// turn and is at most l² c / 7 away from its chord (a circle's: l² c / 8 (1 + …), at c l = 1 a 7.46th).
bool isPlain(const Site& i, const Site& j, const VoronoiCircle& from, const VoronoiCircle& to, const Window& window, double tolerance) {
  if (from.isHalfPlane() || to.isHalfPlane()) return false;
  if (!window.holds({from.x, from.y}) || !window.holds({to.x, to.y})) return false;
  const double dx = j.x - i.x, dy = j.y - i.y, r = absolute(j.r - i.r);
  const double p = dx * dx + dy * dy - r * r;
  const double lx = to.x - from.x, ly = to.y - from.y, l2 = lx * lx + ly * ly;
  return 2 * r * l2 <= 7 * p * tolerance && 4 * r * r * l2 <= p * p;
}

}  // namespace

bool drawEdges(const DiagramCore& core, const Window& window, double tolerance, Portion& portion, Path& path) {
  const DelaunayGraph& base = core.base();
  const Graph& graph = base.graph();
  ClippedEdge clipped;
  return visitEdges(base, portion, path, [&](HalfedgeId h) {
    const HalfedgeId twin = graph.twin(h);
    const VertexId i = graph.origin(h), j = graph.target(h);
    if (i == kInfinity || j == kInfinity || !startsAtPole(base, h)) return;
    const VoronoiCircle &from = base.circle(faceOf(twin)), &to = base.circle(faceOf(h));
    if (isPlain(base.site(i), base.site(j), from, to, window, tolerance) && isPrecise(from) && isPrecise(to)) {
      path.move(from.x, from.y);
      path.line(to.x, to.y);
      return;
    }
    if (!isInPlane(base, h)) return;
    clipEdge(base, h, window, clipped);
    for (int k = 0; k < clipped.count; ++k) {
      const Conic& curve = clipped.pieces[static_cast<std::size_t>(k)].curve;
      path.move(curve.p0.x, curve.p0.y);
      drawConic(curve, tolerance, path);
    }
  });
}

bool drawDual(const DiagramCore& core, const Window* window, double tolerance, Portion& portion, Path& path) {
  const DelaunayGraph& base = core.base();
  const Graph& graph = base.graph();
  return visitEdges(base, portion, path, [&](HalfedgeId h) {
    const VertexId i = graph.origin(h), j = graph.target(h);
    if (i == kInfinity) return;
    const Site& site = base.site(i);
    if (j != kInfinity) {
      if (!startsAtPole(base, h) || !isInPlane(base, h)) return;
      const DualEdge edge = dualEdge(base, h);
      path.move(site.x, site.y);
      for (int k = 0; k < edge.count; ++k) drawConic(edge.curves[k], tolerance, path);
      return;
    }
    if (window == nullptr || !window->holds({site.x, site.y})) return;
    // How far until the ray leaves: the nearest of the lines that it goes towards.
    const Point ray = dualRay(base, h);
    double far = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 4; ++side) {
      const double speed = dot(Window::normal(side), ray);
      if (speed > 0) far = std::min(far, (window->offset(side) - dot(Window::normal(side), {site.x, site.y})) / speed);
    }
    const Point end = window->nearestTo(Point{site.x, site.y} + far * ray);
    path.move(site.x, site.y);
    path.line(end.x, end.y);
  });
}

bool drawSites(const DiagramCore& core, double tolerance, Portion& portion, Path& path) {
  const std::size_t limit = portion.commands;
  for (; portion.cursor < core.ids().slots(); ++portion.cursor) {
    if (path.commands.size() >= limit) return true;
    const auto id = static_cast<SiteId>(portion.cursor);
    if (core.ids().state(id) != SiteState::kFree) drawCircle(core.site(id), tolerance, path);
  }
  return false;
}

}  // namespace apollonius
