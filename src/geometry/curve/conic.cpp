#include "geometry/curve/conic.h"

#include "number/fp.h"

namespace apollonius::internal {

Conic Conic::arc(Point center, double radius, Point from, Point to) {
  // With u = from + to, the tangents meet at center + radius 2u/|u|², and w is the cosine of half
  // the angle, |u|/2.
  const Point u = from + to;
  const double square = dot(u, u);
  return {center + radius * from, center + (2 * radius / square) * u, std::sqrt(square) / 2,
          center + radius * to};
}

Point Conic::at(double t) const {
  const double s = 1 - t;
  const double a = s * s, b = 2 * w * t * s, c = t * t;
  const double sum = a + b + c;
  return (a / sum) * p0 + (b / sum) * p1 + (c / sum) * p2;
}

Point Conic::tangent(double t) const {
  // Quotient rule, with the terms of degree 3 and 4 cancelled on paper.
  const double s = 1 - t;
  const double sum = s * s + 2 * w * t * s + t * t;
  const Point numerator =
      (2 * w * s * s) * (p1 - p0) + (2 * t * s) * (p2 - p0) + (2 * w * t * t) * (p2 - p1);
  return (1 / (sum * sum)) * numerator;
}

void Conic::halve(Conic& first, Conic& second) const {
  const double u = 1 / (1 + w);
  const Point a = u * p0 + (w * u) * p1, b = u * p2 + (w * u) * p1;
  const Point m = middle(a, b);
  const Point from = p0, to = p2;
  const double half = isStraight() ? 0 : std::sqrt((1 + w) / 2);
  first = {from, a, half, m};
  second = {m, b, half, to};
  if (half == 0) {
    first.p1 = middle(from, m);
    second.p1 = middle(m, to);
  }
}

bool Conic::isSplitBy(Point m) const { return dot(m, m) >= 0 && !(m == p0 || m == p2); }

double Conic::sagitta() const {
  if (isStraight()) return 0;
  // From left to right: in both directions the same bits, so that neighbours decide alike.
  if (isLeftOf(p2, p0)) return reversed().sagitta();
  const Point chord = p2 - p0, way = p1 - p0;
  const double share = w / (1 + w), square = dot(chord, chord), along = dot(way, chord);
  // The tangent at the middle of the arc is parallel to the chord, so that is where the distance
  // from its line is largest. Where p1 is beyond an end of the chord, the curve can be, too.
  if (along >= 0 && along <= square && square > 0)
    return share * absolute(cross(chord, way)) / std::sqrt(square);
  return share * length(p1 - middle(p0, p2));
}

}  // namespace apollonius::internal
