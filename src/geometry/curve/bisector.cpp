#include "geometry/curve/bisector.h"

#include <algorithm>
#include <limits>

#include "number/fp.h"
#include "predicate/squared_tangent.h"

namespace apollonius::internal {

namespace {

/// Parameters beyond these are as good as infinite: B e^t would leave the doubles.
constexpr double kLargestParameter = powerOfTwo(1000);

/// A root in [e0, e1], or the end that is nearer. Where the line is parallel to an asymptote up to
/// rounding, a root near infinity can come out beyond it, as negative and large in size (and one
/// near 0 as negative and small). `otherwise` is for 0/0: along the line.
double between(double e0, double e, double e1, double otherwise) {
  if (e > 0) return std::clamp(e, e0, e1);
  if (!(e <= 0)) return otherwise;
  const double low = std::max(e0, 1 / kLargestParameter), high = std::min(e1, kLargestParameter);
  return absolute(e) / low > high / absolute(e) ? e1 : e0;  // not -e: of 0 that is -0
}

}  // namespace

Bisector::Bisector(const Site& reference, const Site& other)
    : reference_{reference.x, reference.y} {
  const Point way = Point{other.x, other.y} - reference_;
  const double p = squaredTangent(reference, other);
  d_ = length(way);
  axis_ = {way.x / d_, way.y / d_};
  a_ = (reference.r - other.r) / 2;
  b_ = p > 0 ? std::sqrt(p) / 2 : 0;
}

Point Bisector::at(double e) const {
  const HyperbolicCoordinates place(e);
  const double x = d_ / 2 + a_ * place.cosh, y = b_ * place.sinh;
  return {reference_.x + (axis_.x * x - axis_.y * y), reference_.y + (axis_.y * x + axis_.x * y)};
}

Point Bisector::tangent(double e) const {
  const HyperbolicCoordinates place(e);
  const double x = a_ * place.sinh, y = b_ * place.cosh, size = std::sqrt(x * x + y * y);
  return {(axis_.x * x - axis_.y * y) / size, (axis_.y * x + axis_.x * y) / size};
}

Point Bisector::asymptote(bool upper) const {
  const double x = 2 * a_ / d_, y = (upper ? 2 : -2) * b_ / d_;
  return {axis_.x * x - axis_.y * y, axis_.y * x + axis_.x * y};
}

double Bisector::parameterOf(Point p) const {
  const Point way = p - reference_;
  const double y = cross(axis_, way);
  double sinh = y / b_;
  double cosh = absolute(sinh) < powerOfTwo(30) ? std::sqrt(1 + sinh * sinh) : absolute(sinh);
  // An error of y moves the place by A/B times as much along the axis where |sinh| is large. Where
  // that is worse, the distance from the reference site tells the place, whose error is at most
  // that of the point times 2A/D <= 1.
  if (a_ * absolute(sinh) > b_ * cosh) {
    const double fromReference = (length(way) - a_) / (d_ / 2);
    cosh = fromReference > 1 ? fromReference : 1;
    // The square overflows where the centres are very close; there the two are the same.
    sinh = cosh < powerOfTwo(300) ? std::sqrt((cosh - 1) * (cosh + 1)) : cosh;
    if (y < 0) sinh = -sinh;
  }
  if (absolute(sinh) < kLargestParameter) return sinh >= 0 ? cosh + sinh : 1 / (cosh - sinh);
  return y > 0 ? std::numeric_limits<double>::infinity() : 0;
}

Conic Bisector::piece(double e0, double e1, Point from, Point to) const {
  if (isLine()) return Conic::segment(from, to);
  // The tangents at t0 and t1 meet at (D/2 + A cosh m / cosh u, B sinh m / cosh u) with the middle
  // m and half the difference u; the weight is cosh u, and cosh m / cosh u = (cosh t0 + cosh t1) /
  // (2 cosh² u).
  const double h = std::sqrt(e1) / std::sqrt(e0);
  const double w = (h + 1 / h) / 2;
  const HyperbolicCoordinates first(e0), second(e1);
  const double scale = 1 / (2 * w * w);
  const double x = d_ / 2 + a_ * ((first.cosh + second.cosh) * scale),
               y = b_ * ((first.sinh + second.sinh) * scale);
  return {from,
          {reference_.x + (axis_.x * x - axis_.y * y), reference_.y + (axis_.y * x + axis_.x * y)},
          w,
          to};
}

LineForm::LineForm(const Bisector& bisector, Point normal, double offset)
    : p_(dot(normal, bisector.axis()) * bisector.transverse()),
      q_(cross(bisector.axis(), normal) * bisector.conjugate()),
      c_((dot(normal, bisector.reference()) - offset) +
         dot(normal, bisector.axis()) * (bisector.distance() / 2)) {}

LineForm::LineForm(const Bisector& bisector, Point normal, Point through)
    : p_(dot(normal, bisector.axis()) * bisector.transverse()),
      q_(cross(bisector.axis(), normal) * bisector.conjugate()),
      c_(dot(normal, bisector.reference() - through) +
         dot(normal, bisector.axis()) * (bisector.distance() / 2)) {}

bool LineForm::isBeyond(double e) const {
  if (e > 0 && e < std::numeric_limits<double>::infinity())
    return ((p_ + q_) * e + (p_ - q_) / e) / 2 + c_ >= 0;
  // The coefficients of E, 1 and 1/E, or the other way round: the first that is not 0. (All but the
  // last are 0 where the asymptote is the line.)
  const double leading = e > 0 ? p_ + q_ : p_ - q_, last = e > 0 ? p_ - q_ : p_ + q_;
  return (leading != 0 ? leading : c_ != 0 ? c_ : last) >= 0;
}

double LineForm::root() const {
  const double discriminant = c_ * c_ - (p_ - q_) * (p_ + q_);
  return discriminant > 0 ? std::sqrt(discriminant) : 0;
}

// In E the form is (P+Q)/2 E + (P-Q)/2 / E + c. Its zeros are those of (P+Q) E² + 2cE + (P-Q); the
// slope there is that of (P+Q) E + c = ±√(c² - (P+Q)(P-Q)), so the sign of the root tells a rise
// from a fall. Each is written so that nothing cancels.

double LineForm::rising() const {
  const double s = root();
  return c_ <= 0 ? (s - c_) / (p_ + q_) : (q_ - p_) / (c_ + s);
}

double LineForm::falling() const {
  const double s = root();
  return c_ >= 0 ? -(c_ + s) / (p_ + q_) : (p_ - q_) / (s - c_);
}

double LineForm::rise(double e0, double e1) const { return between(e0, rising(), e1, e1); }

double LineForm::fall(double e0, double e1) const { return between(e0, falling(), e1, e0); }

double LineForm::rise() const { return ifAny(rising()); }

double LineForm::fall() const { return ifAny(falling()); }

double LineForm::ifAny(double e) const {
  const bool isAny = c_ * c_ >= (p_ - q_) * (p_ + q_) && e > 1 / kLargestParameter;
  return isAny && e < kLargestParameter ? e : 0;
}

bool LineForm::hasExcursion(int sign, double e0, double e1, double& at) const {
  const double p = sign * p_, c = sign * c_;
  if (!(p > absolute(q_))) return false;  // no minimum
  const double square = (p_ - q_) / (p_ + q_);
  at = std::sqrt(square);
  return at > e0 && at < e1 && c + std::sqrt((p - q_) * (p + q_)) < 0;
}

}  // namespace apollonius::internal
