#include "geometry/draw/render.h"

#include <algorithm>
#include <array>
#include <limits>

#include "geometry/draw/cubics.h"
#include "geometry/draw/dual.h"
#include "geometry/draw/hull.h"
#include "geometry/window/rectangle_clip.h"

namespace apollonius::internal {

namespace {

/// Goes over the half-edges, from the portion's cursor on.
template <class Draw>
void visitEdges(const DelaunayGraph& delaunay, Portion& portion, const Path& path, Draw&& draw) {
  const std::size_t count = 3 * delaunay.graph().faceSlots(), limit = portion.commands;
  for (; portion.cursor < count; ++portion.cursor) {
    if (path.commands.size() >= limit) return;
    const HalfedgeId h{static_cast<std::uint32_t>(portion.cursor)};
    if (delaunay.graph().isLive(faceOf(h))) draw(h);
  }
  portion.isDone = true;
}

/// Is it a precise vertex inside the window? All of this is easily guessed: mostly it is, or
/// (zoomed in) mostly it is not.
bool isUsable(const VoronoiCircle& c, const Rectangle& window) {
  return window.holds({c.x, c.y}) && !c.isHalfPlane() &&
         c.error <= powerOfTwo(-40) * (absolute(c.x) + absolute(c.y) + absolute(c.s));
}

/// Is the edge inside the window, longer than rounding, and straight up to the tolerance? A quick
/// test that says yes for most edges of large diagrams. The curvature of the bisector is at most
/// A/B² = 2|r|/p =: c. With a chord of length l and c l <= 1, the arc turns by less than half a
/// turn and is at most l² c / 7 away from its chord (a circle's: l² c / 8 (1 + …), at c l = 1
/// a 7.46th). (c l)² is at most `bend`. No branch on that: which edges pass cannot be guessed.
bool isPlain(double p, double r, const VoronoiCircle& from, const VoronoiCircle& to,
             const Rectangle& window, double tolerance, double bend) {
  if (!isUsable(from, window) || !isUsable(to, window)) return false;
  const double lx = to.x - from.x, ly = to.y - from.y, l2 = lx * lx + ly * ly;
  const double error = static_cast<double>(from.error) + static_cast<double>(to.error);
  return (static_cast<int>(l2 > 2 * error * error) &
          static_cast<int>(2 * r * l2 <= 7 * p * tolerance) &
          static_cast<int>(4 * r * r * l2 <= bend * p * p)) != 0;
}

/// Draws an edge between two vertices inside the window by one line or one cubic, if that will do
/// and is well-conditioned; most edges that are not plain. `p` as in bisector.h, without the care
/// for circles that nearly cover each other: those are left to clipEdge.
///
/// Seen from the reference site the bisector is 1/rho = 2 (c · d + r) / p for unit directions d, c
/// and r being the other site less the reference site (docs/PREDICATES.md, "Seen from one site").
/// For points a and b of it with distances rho_a and rho_b, n = rho_b a + rho_a b points to where
/// the tangents meet, at t n with t = p / (2 (c · n + r s)), s = rho_a rho_b + a · b, and the
/// weight is 1 / (t √(2s)).
bool drawQuickly(const Site& reference, const Site& other, double p, Point from, Point to,
                 const Rectangle& window, Tolerance tolerance, Path& path) {
  const Point center{reference.x, reference.y}, c{other.x - reference.x, other.y - reference.y},
      a = from - center, b = to - center;
  const double r = other.r - reference.r, ra = length(a), rb = length(b);
  const double s = ra * rb + dot(a, b);
  const Point n = rb * a + ra * b;
  const double t = p / (2 * (dot(c, n) + r * s));
  const double w = 1 / (t * std::sqrt(2 * s));
  const Point p1 = center + t * n;
  if (!(s > 0.25 * ra * rb && p > powerOfTwo(-10) * (dot(c, c) + r * r) && w >= 1 && w < 16 &&
        window.holds(p1)))
    return false;
  // As draw() in cubics.cpp, in squares.
  const Point chord = to - from, way = p1 - from;
  const double l2 = dot(chord, chord), along = dot(way, chord);
  if (!(along >= 0 && along <= l2)) return false;
  const double allowed =
      std::min(tolerance.distance * tolerance.distance, tolerance.share * tolerance.share * l2);
  const double height = w * cross(chord, way);
  if (height * height <= (1 + w) * (1 + w) * allowed * l2) {
    path.move(from.x, from.y);
    path.line(to.x, to.y);
    return true;
  }
  const double z = (w - 1) / (w + 1), error = z * z * (0.02 + 0.054 * z);  // cubicError
  const Point up = p1 - middle(from, to);
  if (!(error * error * dot(up, up) <= allowed)) return false;
  const double share = 4 * w / (3 * (1 + w));
  const Point first = from + share * way, second = to + share * (p1 - to);
  path.move(from.x, from.y);
  path.curve(first.x, first.y, second.x, second.y, to.x, to.y);
  return true;
}

}  // namespace

void drawEdges(const DiagramCore& core, const Rectangle& window, Tolerance tolerance,
               Portion& portion, Path& path) {
  // In blocks, each in several short loops without branches: the time is that of fetching sites and
  // circles from memory, and many fetches overlap if there is little to do and nothing to guess
  // between them. (Half as long as one loop.)
  constexpr std::size_t kBlock = 256;
  const DelaunayGraph& delaunay = core.delaunay();
  const Graph& graph = delaunay.graph();
  delaunay.computeMissingCircles();
  const std::size_t count = 3 * graph.faceSlots();
  const double bend = std::min(1.0, 49 * tolerance.share * tolerance.share);
  std::array<HalfedgeId, kBlock> edges;
  std::array<std::size_t, kBlock> others;  // those of `edges` that are not plain
  std::array<VoronoiCircle, kBlock> starts;
  std::array<double, kBlock> squares, differences;  // p and |r| of the two sites
  std::array<double, 4 * kBlock> ends;
  ClippedEdge clipped;
  while (portion.cursor < count) {
    if (path.commands.size() >= portion.commands) return;
    const std::size_t end = std::min(portion.cursor + kBlock, count);
    std::size_t edgeCount = 0;
    for (; portion.cursor < end; ++portion.cursor) {
      const HalfedgeId h{static_cast<std::uint32_t>(portion.cursor)};
      edges[edgeCount] = h;
      // Each edge once. In a free face twins are something else.
      edgeCount += static_cast<std::size_t>(graph.isLive(faceOf(h))) &
                   static_cast<std::size_t>(graph.twin(h) > h) &
                   static_cast<std::size_t>(graph.origin(h) != kInfinity) &
                   static_cast<std::size_t>(graph.target(h) != kInfinity);
    }
    for (std::size_t k = 0; k < edgeCount; ++k)
      starts[k] = delaunay.cachedCircle(faceOf(graph.twin(edges[k])));
    for (std::size_t k = 0; k < edgeCount; ++k) {
      const Site &i = delaunay.site(graph.origin(edges[k])),
                 &j = delaunay.site(graph.target(edges[k]));
      const double dx = j.x - i.x, dy = j.y - i.y, dr = j.r - i.r;
      squares[k] = dx * dx + dy * dy - dr * dr;
      differences[k] = absolute(dr);
    }
    std::size_t plainCount = 0, otherCount = 0;
    for (std::size_t k = 0; k < edgeCount; ++k) {
      const VoronoiCircle &from = starts[k], &to = delaunay.cachedCircle(faceOf(edges[k]));
      const bool plain =
          isPlain(squares[k], differences[k], from, to, window, tolerance.distance, bend);
      double* const at = &ends[4 * plainCount];
      at[0] = from.x;
      at[1] = from.y;
      at[2] = to.x;
      at[3] = to.y;
      others[otherCount] = k;
      plainCount += static_cast<std::size_t>(plain);
      otherCount += static_cast<std::size_t>(!plain);
    }
    path.segments(ends.data(), plainCount);
    for (std::size_t m = 0; m < otherCount; ++m) {
      const HalfedgeId g = edges[others[m]], h = startsAtReference(delaunay, g) ? g : graph.twin(g);
      if (delaunay.isPoint(h)) continue;
      const VoronoiCircle &from = starts[others[m]], &to = delaunay.cachedCircle(faceOf(g));
      if (isUsable(from, window) && isUsable(to, window) &&
          drawQuickly(delaunay.site(graph.origin(h)), delaunay.site(graph.target(h)),
                      squares[others[m]], {from.x, from.y}, {to.x, to.y}, window, tolerance,
                      path)) {
        continue;
      }
      clipEdge(delaunay, h, window, clipped, VertexPrecision::kFast);
      for (int k = 0; k < clipped.count; ++k) {
        const ClippedPiece& piece = clipped.pieces[static_cast<std::size_t>(k)];
        if (piece.isTouch) continue;
        path.move(piece.curve.p0.x, piece.curve.p0.y);
        drawConic(piece.curve, tolerance, path);
      }
    }
  }
  portion.isDone = true;
}

void drawEdges(const ClippedDiagram& clippedDiagram, Tolerance tolerance, Portion& portion,
               Path& path) {
  const DelaunayGraph& delaunay = clippedDiagram.core().delaunay();
  FlatArray<InsideInterval> pieces;
  visitEdges(delaunay, portion, path, [&](HalfedgeId h) {
    if (!clippedDiagram.isAnyInside(h)) return;
    const Edge edge = clippedDiagram.edgeInside(h, VertexPrecision::kFast, pieces);
    for (const InsideInterval& piece : pieces) {
      if (clippedDiagram.isTouch(h, edge, piece)) continue;
      path.move(piece.curve.p0.x, piece.curve.p0.y);
      drawConic(piece.curve, tolerance, path);
    }
  });
}

void drawDual(const DiagramCore& core, const Rectangle* window, Tolerance tolerance,
              Portion& portion, Path& path) {
  const DelaunayGraph& delaunay = core.delaunay();
  const Graph& graph = delaunay.graph();
  visitEdges(delaunay, portion, path, [&](HalfedgeId h) {
    const VertexId i = graph.origin(h), j = graph.target(h);
    if (i == kInfinity) return;
    const Site& site = delaunay.site(i);
    if (j != kInfinity) {
      if (!startsAtReference(delaunay, h)) return;
      const DualEdge edge = dualEdge(delaunay, h);
      path.move(site.x, site.y);
      for (int k = 0; k < edge.count; ++k) drawConic(edge.curves[k], tolerance, path);
      return;
    }
    if (window == nullptr || !window->holds({site.x, site.y})) return;
    // How far until the ray leaves: the nearest of the lines that it goes towards.
    const Point ray = dualRay(delaunay, h);
    double far = std::numeric_limits<double>::infinity();
    for (int side = 0; side < 4; ++side) {
      const double speed = dot(Rectangle::normal(side), ray);
      if (speed > 0)
        far = std::min(
            far, (window->offset(side) - dot(Rectangle::normal(side), {site.x, site.y})) / speed);
    }
    const Point end = window->nearestTo(Point{site.x, site.y} + far * ray);
    path.move(site.x, site.y);
    path.line(end.x, end.y);
  });
}

void drawSites(const DiagramCore& core, Tolerance tolerance, Portion& portion, Path& path) {
  const std::size_t limit = portion.commands;
  for (; portion.cursor < core.ids().slots(); ++portion.cursor) {
    if (path.commands.size() >= limit) return;
    const auto slot = static_cast<Slot>(portion.cursor);
    if (core.ids().state(slot) != SiteState::kFree) drawCircle(core.site(slot), tolerance, path);
  }
  portion.isDone = true;
}

}  // namespace apollonius::internal
