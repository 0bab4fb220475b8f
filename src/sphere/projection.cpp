#include "sphere/projection.h"

#include <cmath>
#include <numbers>

#include "predicate/squared_tangent.h"

namespace apollonius::internal::sphere {

Projection::Projection(const Cap& pole) : pole_(pole) {
  if (pole.centre.x == 0 && pole.centre.y == 0 && pole.centre.z == 0)
    return;  // the pole of an empty diagram
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
  // chord·x is centre·x, and accurate also near the pole.
  const double across = dot(chord, x_), up = dot(chord, y_);
  double square = dot(chord, chord);
  if (square < kClose * kClose) {  // without the part that is rounding
    const HalfAngle away = acuteAngle(std::sqrt(across * across + up * up));
    square = 4 * away.sine * away.sine;
  }
  if (square == 0 || reduced.cosine <= 0) return {covered};
  const double x = 2 * across / square, y = 2 * up / square;
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

// A cap with centre u and weight w as the vector (u, cos w) / sin w: of two, with the product of
// signature (+, +, +, -),
//
//     1 - product = (cos d - cos D) / (sin w_i sin w_j) = (|c_i - c_j|² - (r_i - r_j)²) / (2 r_i
//     r_j),
//
// as it is the same for circles of the plane. The vector of a circle with centre c and radius r is
// (2 c, |c|² - r² - 1, |c|² - r² + 1) / (2 r), so sin w / r = 2 / √((|c|² - r² + 1)² + 4 r²). The
// pole is the vector (0, 0, 1, 1), whose product with that is -1 / r.
double Projection::riseFromPole(const Site& circle) {
  const double square = circle.x * circle.x + circle.y * circle.y;
  const double centre = std::sqrt(square);
  const double power = (centre - circle.r) * (centre + circle.r) + 1;
  return 2 / std::hypot(power, 2 * circle.r);
}

double Projection::rise(const Site& a, const Site& b) {
  return riseFromPole(a) * riseFromPole(b) * squaredTangent(a, b) / 2;
}

namespace {

/// |c|² - r² of the second circle minus that of the first.
double changeOfPower(const Site& a, const Site& b) {
  return (b.x - a.x) * (b.x + a.x) + (b.y - a.y) * (b.y + a.y) - (b.r - a.r) * (b.r + a.r);
}

}  // namespace

// With q = |c|² - r² such a vector times 2 r is (2 c, q - 1, q + 1), and H = √((q + 1)² + 4 r²) is
// the length of its first three coordinates. So cos w = (q + 1) / H and sin w = 2 r / H; and those
// three are H u: their difference for two caps is H_j (u_j - u_i) and a multiple of u_i.
double Projection::shift(const Site& a, const Site& b) {
  const double power = (b.x * b.x + b.y * b.y) - b.r * b.r;
  return riseFromPole(a) * riseFromPole(b) / 2 *
         ((a.r - b.r) * (power + 1) + b.r * changeOfPower(a, b));
}

Direction Projection::towards(const Site& from, const Site& to) const {
  return 2 * (to.x - from.x) * x_ + 2 * (to.y - from.y) * y_ +
         changeOfPower(from, to) * pole_.centre;
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

Projection::EmptyCap Projection::fromHalfPlane(double a, double b, const Site& touched) const {
  // From the border, at the angle 2 atan(a x + b y + r), to the pole, at pi.
  const double border = std::atan(a * touched.x + b * touched.y + touched.r);
  return {pointAt(border + std::numbers::pi / 2, a, b), std::numbers::pi / 2 - border};
}

}  // namespace apollonius::internal::sphere
