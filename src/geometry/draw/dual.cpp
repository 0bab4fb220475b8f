#include "geometry/draw/dual.h"

#include <algorithm>

#include "base/infinite.h"
#include "geometry/curve/bisector.h"
#include "geometry/curve/edge.h"
#include "geometry/draw/hull.h"

namespace apollonius::internal {

namespace {

/// A Voronoi vertex as its edge's reference site sees it, with the reference site at the origin and
/// the other site at (D, 0). The distance of the vertex is rho and 1/(2 rho) = (D cosine + r) / p
/// (docs/PREDICATES.md, "Seen from one site"), r <= 0 being the other weight less the
/// reference site's: so D cosine is a sum of positive terms, which is good however far away the
/// vertex is, and at infinity (rho infinite, a half-plane).
struct SeenVertex {
  double inverse;  ///< p / (2 rho)
  double cosine, sine;
};

SeenVertex seen(const Bisector& bisector, const VoronoiCircle& circle, double referenceWeight,
                bool isLeft) {
  const double p = 4 * bisector.conjugate() * bisector.conjugate(), d = bisector.distance();
  SeenVertex vertex{0, 0, 0};
  const Point way = circle.isHalfPlane() ? Point{circle.x, circle.y}
                                         : Point{circle.x, circle.y} - bisector.reference();
  if (!circle.isHalfPlane()) vertex.inverse = p / (2 * (circle.s + referenceWeight));
  vertex.cosine = std::min((vertex.inverse + 2 * bisector.transverse()) / d, 1.0);
  const double size = length(way), side = cross(bisector.axis(), way) / size;
  // Near the axis the sine is accurate, elsewhere the cosine, which is also all that is known if
  // the vertex is too far for doubles.
  const bool isOnLeft = side >= 0 || (!(side < 0) && isLeft);
  const double sine = std::sqrt((1 - vertex.cosine) * (1 + vertex.cosine));
  vertex.sine = absolute(side) < 0.5 ? side : isOnLeft ? sine : -sine;
  return vertex;
}

/// Beyond this weight a curve is the two segments to its control point up to rounding.
constexpr double kLargestWeight = powerOfTwo(48);

}  // namespace

DualEdge dualEdge(const DelaunayGraph& delaunay, HalfedgeId h) {
  const Site &i = delaunay.site(delaunay.graph().origin(h)),
             &j = delaunay.site(delaunay.graph().target(h));
  const Point pi{i.x, i.y}, pj{j.x, j.y};
  const VoronoiCircle first = delaunay.voronoiVertex(faceOf(delaunay.graph().twin(h))),
                      second = delaunay.voronoiVertex(faceOf(h));
  DualEdge edge;
  edge.curves[0] = Conic::segment(pi, pj);
  const Bisector bisector(i, j);
  if ((first.isHalfPlane() && second.isHalfPlane()) || !bisector.isKnown()) return edge;

  const SeenVertex a = seen(bisector, first, i.r, false), b = seen(bisector, second, i.r, true);
  const double chordX = b.cosine - a.cosine,
               chordY = b.sine - a.sine;  // between the two directions
  const double sumX = a.cosine + b.cosine;
  const double sumY = a.sine * b.sine < 0 ? -(chordX * sumX) / chordY : a.sine + b.sine;
  const double p = 4 * bisector.conjugate() * bisector.conjugate();
  const double t =
      p /
      (2 * ((a.inverse + b.inverse) + bisector.transverse() * (chordX * chordX + chordY * chordY)));
  const Point along = bisector.axis();
  const Point way{t * (along.x * sumX - along.y * sumY), t * (along.y * sumX + along.x * sumY)};
  const Point control = pi + way;
  // Both circles give the same weight; the one further from the control point knows it better.
  double w = 1, farthest = 0;
  for (const VoronoiCircle& c : {first, second}) {
    const double distance = c.isHalfPlane() ? kInfinite : length(control - Point{c.x, c.y});
    if (!(distance >= farthest)) continue;
    farthest = distance;
    w = distance < kInfinite
            ? std::sqrt(std::max(c.s + i.r, 0.0)) * std::sqrt(std::max(c.s + j.r, 0.0)) / distance
            : 1;
  }
  if (!(length(way) < kInfinite)) return edge;
  if (w < kLargestWeight) {
    edge.curves[0] = {pi, control, std::max(w, 1.0), pj};
    return edge;
  }
  edge.curves[0] = Conic::segment(pi, control);
  edge.curves[1] = Conic::segment(control, pj);
  edge.count = 2;
  return edge;
}

Point dualRay(const DelaunayGraph& delaunay, HalfedgeId h) {
  const HullTurn turn = hullTurnOf(delaunay, h);
  const Point sum = turn.from + turn.to;
  if (dot(sum, sum) >= 1) return unit(turn.sign != Sign::kNegative ? sum : Point{-sum.x, -sum.y});
  // More than a third of a turn: at right angles to the difference, on the side of the range.
  const Point difference = turn.to - turn.from;
  return unit({difference.y, -difference.x});
}

}  // namespace apollonius::internal
