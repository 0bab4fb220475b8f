// The bisector of two sites of the sphere, a closed curve about each of them.
#pragma once

#include <algorithm>
#include <cmath>

#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

/// As seen from one site, i: in the direction of bearing phi the bisector is at the angle rho with
///
///     tan rho = (cos d - cos D) / (sin D cos(phi - phi_j) - sin d),  0 < rho < pi,
///
/// where D is the angle between the sites, phi_j the bearing of the other site, j, and d = w_i -
/// w_j. (The cosine rule in the triangle of i, j and a point p: cos D cos rho + sin D sin rho
/// cos(phi - phi_j) is the cosine of the angle between j and p, which is rho - d.) REQUIRES:
/// neither covers the other.
class SphericalBisector {
 public:
  /// As seen from `node`; `frame` is that of its centre. Computed from the caps, or from the
  /// circles of the plane where these are more accurate: if the sites are close, or one nearly
  /// covers the other.
  SphericalBisector(const ProjectedDiagram& diagram, VertexId node, const Frame& frame,
                    VertexId neighbor) {
    if (diagram.areClose(node, neighbor)) {
      setDirection(diagram.towards(node, neighbor), frame);
      setByCircles(diagram.rise(node, neighbor), diagram.shift(node, neighbor));
      return;
    }
    setByCaps(diagram.cap(node), diagram.cap(neighbor), frame,
              [&](double) { return diagram.rise(node, neighbor); });
  }
  /// Computed from the caps only, as accurate as they are. REQUIRES: as computed, neither covers
  /// the other.
  SphericalBisector(const Cap& from, const Cap& to, const Frame& frame) {
    setByCaps(from, to, frame, [](double rise) { return rise; });
  }

  /// The curve in the direction of a bearing.
  struct At {
    double cosine, sine;  ///< cosine and sine of rho
    double x, y;          ///< cosine and sine of the bearing
    double rounding;      ///< how far rounding may have moved rho, about
    double steepness;     ///< the derivative of ln tan(rho / 2) by the bearing
    /// 1 - cos rho, accurate also where that is small.
    [[nodiscard]] double height() const {
      return cosine > 0 ? sine * sine / (1 + cosine) : 1 - cosine;
    }
    [[nodiscard]] double rho() const { return std::atan2(sine, cosine); }
    /// The length of the curve per radian of bearing.
    [[nodiscard]] double speed() const { return sine * std::sqrt(1 + steepness * steepness); }
    /// The point there; `centre` and `frame` are the first site's.
    [[nodiscard]] Direction point(const Direction& centre, const Frame& frame) const {
      return cosine * centre + sine * (x * frame.first + y * frame.second);
    }
  };
  [[nodiscard]] At at(double bearing) const { return at(std::cos(bearing), std::sin(bearing)); }
  /// The curve in the direction of a bearing, given by its cosine and sine.
  [[nodiscard]] At at(double x, double y) const {
    const Run run = runAt(x, y);
    const double length = std::sqrt(rise_ * rise_ + run.value * run.value);
    constexpr double kAnywhere = 3;
    return {run.value / length,
            rise_ / length,
            x,
            y,
            std::min(run.rounding / length, kAnywhere),
            slope_ * (y * x_ - x * y_) / length};
  }
  /// The bearings where the curve is a quarter turn away: at the angle `aside` to both sides of the
  /// direction of the other site. If the sites are close to each other, or one nearly covers the
  /// other, the curve goes from one end of the sphere to the other there, within about the angle
  /// `width`.
  struct Turns {
    double aside, width;
  };
  [[nodiscard]] Turns turns() const {
    // The sine of `aside` times the slope: its square is (sin D)^2 - (sin d)^2.
    const double across = std::sqrt(std::max(least_ * (slope_ + shift_), 0.0));
    const double steepness = std::max(across, std::sqrt(rise_ * slope_));
    return {std::atan2(across, isHeavier_ ? shift_ : -shift_),
            steepness > 0 ? std::min(rise_ / steepness, 1.0) : 1};
  }
  /// The angle to both sides of the other site's bearing within which the curve is nearer than the
  /// angle `most`: 0 to pi. REQUIRES: `most` in (0, pi).
  [[nodiscard]] double asideWithin(double most) const {
    // There, the run is more than rise / tan(most): the square of the sine, or of the cosine, of
    // half the angle is less than this.
    const double run = rise_ * std::cos(most) / std::sin(most);
    const double square = (isHeavier_ ? least_ - run : least_ + run) / (2 * slope_);
    const double part = std::clamp(square, 0.0, 1.0);
    const double root = std::sqrt(part), other = std::sqrt(1 - part);
    return 2 * (isHeavier_ ? std::atan2(root, other) : std::atan2(other, root));
  }
  /// The bearings at which the curve is nearer than another one about the same site: those within
  /// `aside`, 0 to half a turn, of `middle`.
  struct Nearer {
    double middle, aside;
  };
  [[nodiscard]] Nearer nearerThan(const SphericalBisector& other) const {
    // As in bearingOfNext(): the bearings phi with p cos phi + q sin phi > r.
    const double mine = rise_ * other.slope_, its = other.rise_ * slope_;
    const double p = its * x_ - mine * other.x_, q = its * y_ - mine * other.y_;
    const double r = other.rise_ * signedShift() - rise_ * other.signedShift();
    const double square = p * p + q * q - r * r;
    return {std::atan2(q, p), std::atan2(std::sqrt(std::max(square, 0.0)), r)};
  }
  /// Is it a great circle, because the sites have equal weights?
  [[nodiscard]] bool isGreatCircle() const { return shift_ == 0; }
  /// The bearing of the other site, where the bisector is nearest.
  [[nodiscard]] double middle() const { return std::atan2(y_, x_); }

  /// The bearing at which `next`, the bisector with the next neighbour counter-clockwise about the
  /// site, takes over from this one: from there on it is the nearer of the two. If the two do not
  /// meet as computed, otherwise() is returned.
  template <class Otherwise>
  [[nodiscard]] double bearingOfNext(const SphericalBisector& next, Otherwise&& otherwise) const {
    // Where both rho are equal: p cos phi + q sin phi = r. The next one is nearer where the left
    // side is less, so the left side is falling.
    const double mine = rise_ * next.slope_, its = next.rise_ * slope_;
    const double p = its * x_ - mine * next.x_, q = its * y_ - mine * next.y_;
    const double r = next.rise_ * signedShift() - rise_ * next.signedShift();
    const double length = std::sqrt(p * p + q * q);
    const double square = (length - r) * (length + r);
    if (!(square > 0)) return otherwise();
    const double aside = std::atan2(std::sqrt(square), r);
    double bearing = std::atan2(q, p) + aside;
    // Where one of the sites nearly covers another, little is left of the differences; of the
    // curves themselves more. Both solutions are at `aside` from the middle.
    double most = std::min({aside / 2, (kTurn / 2 - aside) / 2, 0x1p-20});
    for (int step = 0; step < 2; ++step) {
      const double x = std::cos(bearing), y = std::sin(bearing);
      const double apart = next.rise_ * runAt(x, y).value - rise_ * next.runAt(x, y).value;
      const double change = apart / (p * y - q * x);
      if (!(std::abs(change) < most)) break;
      bearing += change;
      most = std::abs(change);
    }
    return bearing;
  }

 private:
  static constexpr double kTurn = 6.283185307179586;

  /// The denominator of tan rho, sin D cos(phi - phi_j) - sin d, by the chord between the direction
  /// (x, y) and that in which it is least in magnitude.
  struct Run {
    double value, rounding;
  };
  [[nodiscard]] Run runAt(double x, double y) const {
    const double aside = isHeavier_ ? x - x_ : x + x_, up = isHeavier_ ? y - y_ : y + y_;
    const double square = aside * aside + up * up;
    const double value = least_ - slope_ * square / 2;
    return {isHeavier_ ? value : -value, 0x1p-51 * (std::abs(least_) + slope_ * std::sqrt(square))};
  }
  /// Where the caps give cos d - cos D inaccurately, betterRise() turns their value into a better
  /// one.
  template <class Rise>
  void setByCaps(const Cap& from, const Cap& to, const Frame& frame, Rise&& betterRise) {
    setDirection(to.centre - from.centre, frame);
    const HalfAngle between = angleBetween(from.centre, to.centre);
    isHeavier_ = from.weight > to.weight;
    const HalfAngle half = isHeavier_ ? from.radius - to.radius : to.radius - from.radius;
    const HalfAngle gap = between - half, sum = between + half;
    // cos d - cos D = 2 sin((D - |d|) / 2) sin((D + |d|) / 2), and sin D - sin |d| is the same with
    // the cosine of the second. The first is the smaller sine of the two.
    rise_ = 2 * gap.sine * sum.sine;
    if (gap.sine > kNearlyCovered * sum.sine) {
      least_ = 2 * gap.sine * sum.cosine;
    } else {
      rise_ = betterRise(rise_);
      least_ = rise_ / std::max(sum.sine, std::sqrt(rise_ / 2)) * sum.cosine;
    }
    slope_ = 2 * between.sine * between.cosine;
    shift_ = 2 * half.sine * half.cosine;
  }
  /// REQUIRES: D and d are acute.
  void setByCircles(double rise, double shift) {
    rise_ = rise;
    isHeavier_ = shift > 0;
    shift_ = std::abs(shift);
    // 1 - cos D = 1 - cos d + rise, and by the halves sin D - sin |d| is what rises divided by the
    // tangent of (D + |d|) / 2.
    const HalfAngle half = acuteAngle(shift_);
    const double square = half.sine * half.sine + rise / 2;
    const HalfAngle between = {std::sqrt(square), std::sqrt(1 - square)};
    const HalfAngle sum = between + half;
    slope_ = 2 * between.sine * between.cosine;
    least_ = rise_ / sum.sine * sum.cosine;
  }
  /// The part of a vector along the tangent plane has the direction of the other site.
  void setDirection(const Direction& towards, const Frame& frame) {
    const double x = dot(towards, frame.first), y = dot(towards, frame.second);
    const double length = std::sqrt(x * x + y * y);
    x_ = length > 0 ? x / length : 1;
    y_ = length > 0 ? y / length : 0;
  }
  [[nodiscard]] double signedShift() const { return isHeavier_ ? shift_ : -shift_; }

  // If one site nearly covers the other, the curve depends on the small difference D - |d|, so no
  // nearly equal numbers are subtracted here.
  double rise_;           // cos d - cos D
  double least_;          // sin D - sin |d|
  double slope_, shift_;  // sin D, sin |d|
  double x_, y_;          // the direction of the other site
  bool isHeavier_;
};

}  // namespace apollonius::internal::sphere
