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
  /// `frame` is that of the first site's centre.
  SphericalBisector(const Cap& from, const Frame& frame, const Cap& to) {
    const Direction chord = to.centre - from.centre;
    const HalfAngle between = angleBetween(from.centre, to.centre);
    const double difference = from.weight - to.weight;
    const double half = std::sin(difference / 2);
    rise_ = 2 * (between.sine - half) * (between.sine + half);
    shift_ = std::sin(difference);
    const double slope = 2 * between.sine * between.cosine;
    // The chord's part along the tangent plane has the length of the slope, and the direction of
    // the other site.
    const double x = dot(chord, frame.first), y = dot(chord, frame.second);
    const double length = std::sqrt(x * x + y * y);
    x_ = length > 0 ? slope * (x / length) : slope;
    y_ = length > 0 ? slope * (y / length) : 0;
    scale_ = 0x1p-51 * (std::abs(slope) + std::abs(shift_));
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
    // A site that touches from inside has a cell without width: from the heavier one the bisector
    // is at the antipode, from the lighter one at its centre, but for one bearing.
    if (!(rise_ > 0)) return {shift_ > 0 ? -1.0 : 1.0, 0, x, y, 0};
    const double run = x_ * x + y_ * y - shift_;
    const double length = std::sqrt(rise_ * rise_ + run * run);
    constexpr double kAnywhere = 3;
    return {run / length, rise_ / length, x, y, std::min(scale_ / length, kAnywhere)};
  }
  /// Where the curve is a quarter turn away: at so much from the direction of the other site, to
  /// both sides. If the sites are close to each other, or one nearly covers the other, it goes from
  /// one end of the sphere to the other there, within about the angle `width`.
  struct Turns {
    double aside, width;
  };
  [[nodiscard]] Turns turns() const {
    const double square = x_ * x_ + y_ * y_, slope = std::sqrt(square);
    const double across = std::sqrt(std::max(square - shift_ * shift_, 0.0));
    const double rise = std::max(rise_, 0.0);
    const double steepness = std::max(across, std::sqrt(rise * slope));
    return {std::atan2(across, shift_), steepness > 0 ? std::min(rise / steepness, 1.0) : 1};
  }
  /// The bearing of the other site, where the bisector is nearest.
  [[nodiscard]] double middle() const { return std::atan2(y_, x_); }

  /// The bearing at which another bisector of the same site meets this one; of two the one that is
  /// closer to `about`. More accurate than the bearing of the vertex itself, which is as inaccurate
  /// as that is close to the site.
  [[nodiscard]] double bearingOfMeeting(const SphericalBisector& other, double about) const {
    // Where both rho are equal: p cos phi + q sin phi = r.
    const double p = rise_ * other.x_ - other.rise_ * x_, q = rise_ * other.y_ - other.rise_ * y_;
    const double r = rise_ * other.shift_ - other.rise_ * shift_;
    const double length = std::sqrt(p * p + q * q);
    const double square = (length - r) * (length + r);
    if (!(square > 0)) return about;
    const double middle = std::atan2(q, p), aside = std::atan2(std::sqrt(square), r);
    constexpr double kTurn = 6.283185307179586;
    const double left = std::remainder(middle + aside - about, kTurn);
    const double right = std::remainder(middle - aside - about, kTurn);
    return about + (std::abs(left) < std::abs(right) ? left : right);
  }

 private:
  double rise_, shift_;
  double scale_;  // of what is added up for `run`, times the unit of rounding
  double x_, y_;  // slope times cosine and sine of the other site's bearing
};

}  // namespace apollonius::internal::sphere
