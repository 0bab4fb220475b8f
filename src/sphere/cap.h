// Sites on the unit sphere: directions, caps, and the distance between them.
//
// A site is a cap: a direction u and a weight w, the cap's radius as an angle. The distance of a
// point p to it is the angle between p and u, minus w. Distances are compared as sines and cosines
// of their halves, which the chords |p - u| and |p + u| give without trigonometry.
#pragma once

#include <cmath>
#include <numbers>

namespace apollonius::internal::sphere {

/// A unit vector, or a sum or multiple of such. Coordinates of sites and points are multiples of
/// 2^-60 (toGrid), so that no projected number leaves the range in which the plane is exact.
struct Direction {
  double x = 0;
  double y = 0;
  double z = 0;
};

constexpr Direction operator+(const Direction& a, const Direction& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Direction operator-(const Direction& a, const Direction& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Direction operator*(double factor, const Direction& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
constexpr double dot(const Direction& a, const Direction& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Direction cross(const Direction& a, const Direction& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double lengthOf(const Direction& a) { return std::sqrt(dot(a, a)); }
/// REQUIRES: not 0.
inline Direction normalized(const Direction& a) { return (1 / lengthOf(a)) * a; }
/// The nearest multiple of 2^-60: 10^-18, far below the rounding of a direction.
inline double toGrid(double value) { return std::nearbyint(value * 0x1p60) * 0x1p-60; }

/// A degree in radians.
inline constexpr double kRadian = std::numbers::pi / 180;

/// Longitude and latitude in degrees.
struct LonLat {
  double lon = 0;
  double lat = 0;
};

/// The direction of a point; exact at multiples of 90 degrees. Takes any longitude. REQUIRES:
/// latitude in [-90, 90].
[[nodiscard]] Direction directionOf(const LonLat& point);
/// Longitude and latitude of a direction; longitude in [-180, 180], 0 at the poles.
[[nodiscard]] LonLat lonLatOf(const Direction& point);

/// A direction, and its point on the map.
struct MapPoint {
  Direction point;
  LonLat at;
};

/// Two directions at right angles to a third, and to each other: `first` to `second` is
/// counter-clockwise as seen from outside of the sphere.
struct Frame {
  explicit Frame(const Direction& up);
  /// The bearing of a point, counter-clockwise from `first`, in [-pi, pi].
  [[nodiscard]] double bearing(const Direction& point) const {
    return std::atan2(dot(point, second), dot(point, first));
  }

  Direction first, second;
};

/// An angle, as sine and cosine of its half. Angles are in (-2 pi, 2 pi), and angles that are
/// compared are less than 2 pi apart.
struct HalfAngle {
  double sine = 0;
  double cosine = 1;

  [[nodiscard]] double angle() const { return 2 * std::atan2(sine, cosine); }
};
constexpr HalfAngle operator+(const HalfAngle& a, const HalfAngle& b) {
  return {a.sine * b.cosine + a.cosine * b.sine, a.cosine * b.cosine - a.sine * b.sine};
}
constexpr HalfAngle operator-(const HalfAngle& a, const HalfAngle& b) {
  return {a.sine * b.cosine - a.cosine * b.sine, a.cosine * b.cosine + a.sine * b.sine};
}
/// Correct unless the angles differ by less than 4 units of 2^-53.
constexpr bool operator<(const HalfAngle& a, const HalfAngle& b) {
  return a.sine * b.cosine < a.cosine * b.sine;
}

/// The angle between two directions, 0 to pi; its relative error is a few units in the last place.
inline HalfAngle angleBetween(const Direction& a, const Direction& b) {
  return {lengthOf(a - b) / 2, lengthOf(a + b) / 2};
}

/// Directions are not quite unit vectors. If two are closer than this, in radians, rounding is a
/// relevant part of their chord's length, but not of the chord's part at right angles to them.
inline constexpr double kClose = 0x1p-20;
/// The acute angle with this sine.
inline HalfAngle acuteAngle(double sine) {
  const double cosine = std::sqrt((1 + std::sqrt((1 - sine) * (1 + sine))) / 2);
  return {sine / (2 * cosine), cosine};
}

/// A site of the sphere.
struct Cap {
  Direction centre;
  HalfAngle radius;   ///< the weight, on the grid of directions
  double weight = 0;  ///< the weight in radians
};

[[nodiscard]] Cap capOf(const LonLat& centre, double weight);

constexpr bool areIdentical(const Cap& a, const Cap& b) {
  return a.centre.x == b.centre.x && a.centre.y == b.centre.y && a.centre.z == b.centre.z &&
         a.weight == b.weight;
}

/// If the angle between two centres equals the difference of the weights up to this share, one cap
/// nearly covers the other, and the small difference is mostly rounding.
inline constexpr double kNearlyCovered = 0x1p-26;
/// Does one of two caps nearly cover the other?
inline bool nearlyCovers(const Cap& a, const Cap& b) {
  const HalfAngle between = angleBetween(a.centre, b.centre);
  const HalfAngle half = a.weight > b.weight ? a.radius - b.radius : b.radius - a.radius;
  return (between - half).sine <= kNearlyCovered * (between + half).sine;
}

inline HalfAngle distance(const Direction& point, const Cap& cap) {
  return angleBetween(point, cap.centre) - cap.radius;
}
/// The distance in radians, rounded.
inline double distanceInRadians(const Direction& point, const Cap& cap) {
  return angleBetween(point, cap.centre).angle() - cap.weight;
}

}  // namespace apollonius::internal::sphere
