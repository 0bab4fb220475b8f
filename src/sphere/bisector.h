// The bisector of two sites of the sphere, a closed curve about each of them.
#pragma once

#include <algorithm>
#include <cmath>

#include "sphere/cap.h"

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
  /// `frame` is that of the first site's centre. `accurateRise` returns cos d - cos D more
  /// accurately than the caps tell it where one site nearly covers the other.
  template <class AccurateRise>
  SphericalBisector(const Cap& from, const Frame& frame, const Cap& to,
                    AccurateRise&& accurateRise) {
    const Direction chord = to.centre - from.centre;
    const HalfAngle between = angleBetween(from.centre, to.centre);
    isHeavier_ = from.weight > to.weight;
    const HalfAngle half = isHeavier_ ? from.radius - to.radius : to.radius - from.radius;
    const HalfAngle gap = between - half, sum = between + half;
    // cos d - cos D = 2 sin((D - |d|) / 2) sin((D + |d|) / 2), and sin D - sin |d| is the same with
    // the cosine of the second. The first is the smaller sine of the two.
    if (gap.sine > kNearlyCovered * sum.sine) {
      rise_ = 2 * gap.sine * sum.sine;
      least_ = 2 * gap.sine * sum.cosine;
    } else {
      rise_ = accurateRise();
      least_ = rise_ / std::max(sum.sine, std::sqrt(rise_ / 2)) * sum.cosine;
    }
    slope_ = 2 * between.sine * between.cosine;
    shift_ = 2 * half.sine * half.cosine;
    // The chord's part along the tangent plane has the direction of the other site.
    const double x = dot(chord, frame.first), y = dot(chord, frame.second);
    const double length = std::sqrt(x * x + y * y);
    x_ = length > 0 ? x / length : 1;
    y_ = length > 0 ? y / length : 0;
  }

  /// What there is in the direction of a bearing.
  struct At {
    double cosine, sine;  ///< of rho
    double x, y;          ///< cosine and sine of the bearing
    double rounding;      ///< how far rounding may have moved rho, about
    /// 1 - cos rho, accurate also where that is small.
    [[nodiscard]] double height() const {
      return cosine > 0 ? sine * sine / (1 + cosine) : 1 - cosine;
    }
    [[nodiscard]] double rho() const { return std::atan2(sine, cosine); }
    /// The point there; `centre` and `frame` are the first site's.
    [[nodiscard]] Direction point(const Direction& centre, const Frame& frame) const {
      return cosine * centre + sine * (x * frame.first + y * frame.second);
    }
  };
  [[nodiscard]] At at(double bearing) const { return at(std::cos(bearing), std::sin(bearing)); }
  /// The same by cosine and sine of the bearing.
  [[nodiscard]] At at(double x, double y) const {
    const Run run = runAt(x, y);
    const double length = std::sqrt(rise_ * rise_ + run.value * run.value);
    constexpr double kAnywhere = 3;
    return {run.value / length, rise_ / length, x, y, std::min(run.rounding / length, kAnywhere)};
  }
  /// Where the curve is a quarter turn away: at so much from the direction of the other site, to
  /// both sides. If the sites are close to each other, or one nearly covers the other, it goes from
  /// one end of the sphere to the other there, within about the angle `width`.
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
  /// The bearing of the other site, where the bisector is nearest.
  [[nodiscard]] double middle() const { return std::atan2(y_, x_); }

  /// The bearing at which another bisector of the same site meets this one; of two the one that is
  /// closer to `about`. More accurate than the bearing of the vertex itself, which is as inaccurate
  /// as that is close to the site.
  [[nodiscard]] double bearingOfMeeting(const SphericalBisector& other, double about) const {
    // Where both rho are equal: p cos phi + q sin phi = r.
    const double mine = rise_ * other.slope_, its = other.rise_ * slope_;
    const double p = mine * other.x_ - its * x_, q = mine * other.y_ - its * y_;
    const double r = rise_ * other.signedShift() - other.rise_ * signedShift();
    const double length = std::sqrt(p * p + q * q);
    const double square = (length - r) * (length + r);
    if (!(square > 0)) return about;
    const double middle = std::atan2(q, p), aside = std::atan2(std::sqrt(square), r);
    const double left = std::remainder(middle + aside - about, kTurn);
    const double right = std::remainder(middle - aside - about, kTurn);
    double bearing = about + (std::abs(left) < std::abs(right) ? left : right);
    // Where one of the sites nearly covers another, little is left of the differences; of the
    // curves themselves more. Both solutions are at `aside` from the middle.
    double most = std::min({aside / 2, (kTurn / 2 - aside) / 2, 0x1p-20});
    for (int step = 0; step < 2; ++step) {
      const double x = std::cos(bearing), y = std::sin(bearing);
      const double apart = rise_ * other.runAt(x, y).value - other.rise_ * runAt(x, y).value;
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
  [[nodiscard]] double signedShift() const { return isHeavier_ ? shift_ : -shift_; }

  // Where one site nearly covers the other, the curve depends on what is left of D - |d|, so
  // nothing here subtracts what is nearly equal.
  double rise_;           // cos d - cos D
  double least_;          // sin D - sin |d|
  double slope_, shift_;  // sin D, sin |d|
  double x_, y_;          // the direction of the other site
  bool isHeavier_;
};

}  // namespace apollonius::internal::sphere
