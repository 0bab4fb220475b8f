// A point or a vector of the plane, y upwards, in the unit of the sites.
#pragma once

#include <cmath>

namespace apollonius::internal {

struct Point {
  double x = 0;
  double y = 0;

  friend constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Point operator*(double s, Point a) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(Point a, Point b) { return a.x == b.x && a.y == b.y; }
};

constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
/// Positive if b is to the left of a.
constexpr double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
/// From left to right, and upwards where the two are in a vertical line.
constexpr bool isLeftOf(Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }
constexpr Point middle(Point a, Point b) { return {a.x / 2 + b.x / 2, a.y / 2 + b.y / 2}; }
/// Turned by a quarter, counter-clockwise.
constexpr Point leftOf(Point a) { return {-a.y, a.x}; }
inline double length(Point a) { return std::sqrt(a.x * a.x + a.y * a.y); }
/// Its direction; any for the zero vector, as which rounding may leave a difference.
inline Point unit(Point a) {
  const double size = length(a);
  if (!(size > 0)) return {1, 0};
  return {a.x / size, a.y / size};
}

}  // namespace apollonius::internal
