#include "geometry/curve/edge.h"

#include <limits>

#include "base/infinite.h"
#include "number/fp.h"
#include "predicate/reference_site.h"

namespace apollonius::internal {

namespace {

/// Where a vertex lies that is too far away for doubles: at which end of the bisector.
Point clippedToDoubles(Point p) {
  const auto part = [](double x) { return x == kInfinite ? 1.0 : x == -kInfinite ? -1.0 : 0.0; };
  return {part(p.x), part(p.y)};
}

bool isUsable(Point p) {
  return absolute(p.x) <= std::numeric_limits<double>::max() &&
         absolute(p.y) <= std::numeric_limits<double>::max();
}

/// endAt() unless it is kept.
EdgeEnd endOf(const DelaunayGraph& delaunay, FaceId f, VertexPrecision precision,
              KeptVertices* kept) {
  if (kept == nullptr) return endAt(delaunay, f, precision);
  KeptVertex& own = (*kept)[index(f) % kept->size()];
  if (own.face != f) own = {endAt(delaunay, f, precision), f};
  return own.vertex;
}

}  // namespace

EdgeEnd endAt(const DelaunayGraph& delaunay, FaceId f, VertexPrecision precision) {
  const VoronoiCircle& cached = delaunay.circle(f);
  const double share = powerOfTwo(precision == VertexPrecision::kRough ? -30 : -40);
  const bool isEnough = precision != VertexPrecision::kReproducible && isKnownWithin(cached, share);
  const VoronoiCircle circle = isEnough ? cached : delaunay.voronoiVertex(f);
  if (circle.isHalfPlane()) return {};
  return {{circle.x, circle.y}, true};
}

bool startsAtReference(const DelaunayGraph& delaunay, HalfedgeId h) {
  const VertexId i = delaunay.graph().origin(h), j = delaunay.graph().target(h);
  const Site &a = delaunay.site(i), &b = delaunay.site(j);
  return precedes(b, a) || (!precedes(a, b) && h < delaunay.graph().twin(h));
}

Edge::Edge(const Bisector& curve, EdgeEnd start, EdgeEnd end)
    : bisector(curve), from(start), to(end), e0(0), e1(kInfinite) {
  const auto parameter = [&](EdgeEnd& place, double atInfinity) {
    if (!place.isFinite) return atInfinity;
    if (absolute(place.point.x) < kInfinite && absolute(place.point.y) < kInfinite) {
      const double e = bisector.parameterOf(place.point);
      if (e > 0 && e < kInfinite) return e;
      place.isFinite = false;
      return e;
    }
    place.isFinite = false;
    return cross(bisector.axis(), clippedToDoubles(place.point)) < 0 ? 0 : kInfinite;
  };
  e0 = parameter(from, 0);
  e1 = parameter(to, kInfinite);
  if (e1 < e0) e1 = e0;  // so short that rounding turned it
}

Edge::Edge(const DelaunayGraph& delaunay, HalfedgeId h, VertexPrecision precision,
           KeptVertices* kept)
    : Edge(Bisector(delaunay.site(delaunay.graph().origin(h)),
                    delaunay.site(delaunay.graph().target(h))),
           endOf(delaunay, faceOf(delaunay.graph().twin(h)), precision, kept),
           endOf(delaunay, faceOf(h), precision, kept)) {}

Conic pieceOf(const Bisector& bisector, double e0, double e1, Point from, Point to) {
  if (!bisector.isLine() && e1 > e0) {
    const Conic curve = bisector.piece(e0, e1, from, to);
    if (isUsable(curve.p1) && curve.w >= 1) return curve;
  }
  return Conic::segment(from, to);
}

bool isTouch(const Bisector& bisector, const Conic& piece) {
  const Point p = piece.p0;
  const double size = absolute(p.x) + absolute(p.y) + length(p - bisector.reference());
  return length(piece.p2 - p) <= powerOfTwo(-46) * size;
}

}  // namespace apollonius::internal
