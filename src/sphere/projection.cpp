#include "sphere/projection.h"

#include <cmath>
#include <numbers>

namespace apollonius::internal::sphere {

Projection::Projection(const Cap& pole) : pole_(pole) {
  if (pole.centre.x == 0 && pole.centre.y == 0 && pole.centre.z == 0) return;  // of no diagram
  const Frame frame(pole.centre);
  const auto onGrid = [](const Direction& a) {
    return Direction{toGrid(a.x), toGrid(a.y), toGrid(a.z)};
  };
  x_ = onGrid(frame.first);
  y_ = onGrid(-1 * frame.second);
}

// With T the tangent of half the angle between the cap's centre and the antipode of the pole, and t
// that of half the reduced weight, the circle meets the ray through its centre at (T - t) / (1 + T
// t) and (T + t) / (1 - T t), the tangents of half the angles of the cap's nearest and farthest
// point. Their mean and half their difference are
//
//     T (1 + t²) / (1 - T² t²)   and   t (1 + T²) / (1 - T² t²).
//
// 1 - T² t² is positive exactly if neither the pole nor the cap covers the other.
Projection::Image Projection::image(const Direction& centre, const HalfAngle& reduced) const {
  const Kind covered = reduced.sine > 0 ? Kind::kCoversPole : Kind::kBelowPole;
  const Direction chord = centre - pole_.centre;
  const double square = dot(chord, chord);
  if (square == 0 || reduced.cosine <= 0) return {covered};
  // chord·x is centre·x, and accurate also near the pole.
  const double x = 2 * dot(chord, x_) / square, y = 2 * dot(chord, y_) / square;
  const double t = reduced.sine / reduced.cosine;
  const double squareOfT = x * x + y * y;
  const double product = std::sqrt(squareOfT) * t;
  const double rest = (1 - product) * (1 + product);
  if (!(rest > 0)) return {covered};
  const double stretch = (1 + t * t) / rest;
  return {Kind::kCircle,
          {x * stretch + 0.0, y * stretch + 0.0, t * (1 + squareOfT) / rest + 0.0},
          (1 + product * product) / rest};
}

Direction Projection::pointAt(double angle, double x, double y) const {
  return std::sin(angle) * (x * x_ + y * y_) - std::cos(angle) * pole_.centre;
}

Projection::EmptyCap Projection::fromCircle(double x, double y, double s,
                                            const Site& touched) const {
  const double centre = std::hypot(x, y);
  if (centre == 0) return {-1 * pole_.centre, 2 * std::atan(s)};
  // centre - s, which are two large numbers where the circle is nearly a half-plane: the distance
  // between the centres is s + touched.r.
  const double toTouched = std::hypot(x - touched.x, y - touched.y);
  const double nearest =
      ((2 * x - touched.x) * touched.x + (2 * y - touched.y) * touched.y) / (centre + toTouched) +
      touched.r;
  const double near = std::atan(nearest), far = std::atan(centre + s);
  return {pointAt(near + far, x / centre, y / centre), far - near};
}

Projection::EmptyCap Projection::fromHalfPlane(double a, double b, double c) const {
  // From the border, at the angle 2 atan(c), to the pole, at pi.
  const double border = std::atan(c);
  return {pointAt(border + std::numbers::pi / 2, a, b), std::numbers::pi / 2 - border};
}

}  // namespace apollonius::internal::sphere
