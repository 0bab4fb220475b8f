#include "sphere/cap.h"

namespace apollonius::internal::sphere {

namespace {

/// Cosine and sine of an angle in degrees, exact at multiples of 90: the angle is reduced to one of
/// at most 45 degrees, which is exact, before it is turned into radians.
struct Turn {
  explicit Turn(double degrees) {
    // Both are exact; the library's takes a loop over the bits.
    const double whole = std::abs(degrees) < 0x1p40 ? degrees - 360 * std::nearbyint(degrees / 360)
                                                    : std::remainder(degrees, 360);
    const double quarters = std::nearbyint(whole / 90);
    const double rest = (whole - 90 * quarters) * kRadian;
    const double c = std::cos(rest), s = std::sin(rest);
    switch (static_cast<int>(quarters) & 3) {
      case 0:
        cosine = c, sine = s;
        break;
      case 1:
        cosine = -s, sine = c;
        break;
      case 2:
        cosine = -c, sine = -s;
        break;
      default:
        cosine = s, sine = -c;
    }
  }

  double cosine = 1, sine = 0;
};

}  // namespace

Direction directionOf(const LonLat& point) {
  const Turn lon(point.lon), lat(point.lat);
  // -0 + 0 is 0.
  return {toGrid(lat.cosine * lon.cosine) + 0.0, toGrid(lat.cosine * lon.sine) + 0.0,
          toGrid(lat.sine) + 0.0};
}

LonLat lonLatOf(const Direction& point) {
  if (point.x == 0 && point.y == 0) return {0, point.z > 0 ? 90.0 : -90.0};
  return {std::atan2(point.y, point.x) / kRadian,
          std::atan2(point.z, std::sqrt(point.x * point.x + point.y * point.y)) / kRadian};
}

Frame::Frame(const Direction& up) {
  // The axis that is farthest from `up` gives the most accurate product.
  const double x = std::abs(up.x), y = std::abs(up.y), z = std::abs(up.z);
  const Direction axis = x <= y && x <= z ? Direction{1, 0, 0}
                         : y <= z         ? Direction{0, 1, 0}
                                          : Direction{0, 0, 1};
  first = normalized(cross(axis, up));
  second = cross(up, first);
}

Cap capOf(const LonLat& centre, double weight) {
  return {
      directionOf(centre), {toGrid(std::sin(weight / 2)), toGrid(std::cos(weight / 2))}, weight};
}

}  // namespace apollonius::internal::sphere
