#include "geometry/dual.h"

#include <algorithm>
#include <utility>

#include "geometry/bisector.h"
#include "geometry/edge.h"
#include "geometry/hull.h"

namespace apollonius {

namespace {

Point unit(Point p) {
  const double size = length(p);
  return {p.x / size, p.y / size};
}

/// The piece of the bisector of two circles between two of its points. Seen from the larger circle's centre c it is
/// 1/rho = q · d + k for unit directions d, q = D axis / (2 B²), k = -A / B², so a rational quadratic curve: its control point is at
/// c + m / s with the middle direction m, s = q · m + k cos(half of the angle), and its weight is s √(rho0 rho2). If the circles nearly
/// coincide, s is large and p1 close to c: rounding in q cannot bend the curve.
Conic pieceAbout(const Bisector& bisector, Point from, Point to) {
  const Point center = bisector.pole();
  const double rho0 = length(from - center), rho2 = length(to - center);
  const Point d0 = unit(from - center), d2 = unit(to - center);
  const double b2 = bisector.conjugate() * bisector.conjugate();
  const Point q = (bisector.distance() / (2 * b2)) * bisector.axis();
  const double k = -bisector.transverse() / b2;
  const Point sum = d0 + d2, difference = d2 - d0;
  // The better conditioned of two ways to the middle direction.
  Point m = dot(sum, sum) >= 1 ? unit(sum) : unit({difference.y, -difference.x});
  if (dot(m, sum) < 0) m = {-m.x, -m.y};
  const double cosine = length(sum) / 2;
  double s = dot(q, m) + k * cosine;
  if (!(s > 0) && cosine < 0.001) {  // opposite directions: the middle one is where the curve is
    m = {-m.x, -m.y};
    s = dot(q, m) + k * cosine;
  }
  const double w = s * std::sqrt(rho0) * std::sqrt(rho2);
  const Conic conic{from, center + (1 / s) * m, w, to};
  const bool isUsable = w > 0 && w < 1e300 && length(conic.p1) < 1e300;
  return isUsable ? conic : Conic::segment(from, to);
}

/// The parabola |p - c| - R = n · (p - a) + r from a, which has the weight r, to b: as far from the circle (c, R) as from the line whose
/// unit normal n points to its inner side. With c as origin, x along the line and y along n, it is y = (x² - k²) / 2k.
Conic parabola(const VoronoiCircle& circle, Point n, const Site& a, const Site& b) {
  const Point c{circle.x, circle.y}, pa{a.x, a.y}, pb{b.x, b.y};
  const double k = circle.s + dot(n, c - pa) + a.r;
  if (!(k > 0)) return Conic::segment(pa, pb);
  const Point along{n.y, -n.x};
  const double xa = dot(along, pa - c), xb = dot(along, pb - c);
  const double x = (xa + xb) / 2;
  const double y = dot(n, pa - c) + xa / k * (x - xa);  // on the tangent at a
  return {pa, c + x * along + y * n, 1, pb};
}

/// A bound on the error of a circle from preciseCircleOf that touches the site. Its own is a float, and no smaller than 2^-126.
double errorOf(const VoronoiCircle& circle, const Site& site) {
  const double numbers = absolute(circle.x) + absolute(circle.y) + absolute(circle.s);
  const double inputs = absolute(site.x) + absolute(site.y) + absolute(site.r);
  return std::min(static_cast<double>(circle.error), powerOfTwo(-39) * numbers + powerOfTwo(-48) * inputs);
}

}  // namespace

DualEdge dualEdge(const DelaunayGraph& graph, HalfedgeId h) {
  const Site &i = graph.site(graph.graph().origin(h)), &j = graph.site(graph.graph().target(h));
  const Point pi{i.x, i.y}, pj{j.x, j.y};
  VoronoiCircle first = preciseCircleOf(graph, faceOf(graph.graph().twin(h))), second = preciseCircleOf(graph, faceOf(h));
  DualEdge edge;
  if (first.isHalfPlane() || second.isHalfPlane()) {
    if (!first.isHalfPlane()) std::swap(first, second);  // `first` is a half-plane, with its outer normal
    edge.curves[0] = second.isHalfPlane() ? Conic::segment(pi, pj) : parabola(second, {-first.x, -first.y}, i, j);
    return edge;
  }
  if (first.s < second.s) std::swap(first, second);
  const Point c1{first.x, first.y}, c2{second.x, second.y};
  const double distance = length(c2 - c1);
  const bool areFar = distance > 4 * (errorOf(first, i) + errorOf(second, i));
  if (areFar) {
    const Bisector bisector({first.x, first.y, first.s}, {second.x, second.y, second.s});
    if (bisector.isKnown()) {
      edge.curves[0] = bisector.isLine() ? Conic::segment(pi, pj) : pieceAbout(bisector, pi, pj);
      return edge;
    }
  }
  edge.curves[0] = Conic::segment(pi, c1);
  edge.curves[1] = Conic::segment(c1, pj);
  edge.count = 2;
  return edge;
}

Point dualRay(const DelaunayGraph& graph, HalfedgeId h) {
  const VoronoiCircle &right = graph.circle(faceOf(graph.graph().twin(h))), &left = graph.circle(faceOf(h));
  const Point from{right.x, right.y}, to{left.x, left.y};  // the cell is unbounded between them, counter-clockwise
  const Point sum = from + to;
  if (dot(sum, sum) >= 1) return unit(turnBetween(right, left) >= 0 ? sum : Point{-sum.x, -sum.y});
  // More than a third of a turn: at right angles to the difference, on the side of the range.
  const Point difference = to - from;
  return unit({difference.y, -difference.x});
}

}  // namespace apollonius
