// The stereographic projection from a visible site, the pole, which turns the diagram of the sphere
// into one of the plane.
//
// Subtract the pole's weight from all weights, so that the pole is a point. Caps become circles
// whose radii have the sign of the reduced weights. Moebius maps keep oriented tangency and
// oriented containment, so a site covers another on the sphere exactly if its circle does in the
// plane, and a cap that touches three sites from outside and is empty becomes such a circle, or a
// half-plane if it touches the pole. Hence the Delaunay graph of the circles, with its vertex at
// infinity, is the Delaunay graph of the sphere, with the pole. (docs/PROOFS.md, "The sphere".)
//
// The projection does not preserve nearest sites, as centres of circles are not images of centres
// of caps.
#pragma once

#include <cstdint>
#include <limits>

#include "predicate/site.h"
#include "sphere/cap.h"

namespace apollonius::internal::sphere {

/// With a loss of accuracy up to this, a circle is within 10^-13 radians of its cap.
inline constexpr double kUsualLoss = 1024;

class Projection {
 public:
  explicit Projection(const Cap& pole = {});

  /// The image of a cap. A cap that the pole covers has none, and the pole is hidden if a cap
  /// covers it.
  enum class Kind : std::uint8_t { kCircle, kBelowPole, kCoversPole };
  struct Image {
    Kind kind = Kind::kBelowPole;
    Site circle = {};
    /// A rounding of the circle is up to this many times a rounding of the cap: large where the cap
    /// is nearly tangent to the pole from inside.
    double loss = std::numeric_limits<double>::infinity();
  };
  [[nodiscard]] Image image(const Cap& cap) const {
    return image(cap.centre, cap.radius - pole_.radius);
  }
  /// The image of the cap about a point that a site at this distance touches.
  [[nodiscard]] Image imageOfTouching(const Direction& point, const HalfAngle& distance) const {
    return image(point, distance + pole_.radius);
  }
  /// The image of a point: a circle of radius 0, or none at the pole.
  [[nodiscard]] Image imageOfPoint(const Direction& point) const { return image(point, {}); }

  /// cos d - cos D of two caps with these circles, D being the angle between their centres and d
  /// the difference of their weights: 0 where one touches the other from inside. The relative error
  /// is small for the circles given, which tell exactly what is hidden.
  [[nodiscard]] static double rise(const Site& a, const Site& b);
  /// rise() of the pole and a cap with this circle.
  [[nodiscard]] static double riseFromPole(const Site& circle);

  /// sin d, d being the weight of the first cap minus that of the second; equally accurate.
  [[nodiscard]] static double shift(const Site& a, const Site& b);
  /// shift() of the pole and a cap with this circle.
  [[nodiscard]] static double shiftFromPole(const Site& circle) {
    return -circle.r * riseFromPole(circle);
  }
  /// A vector in the direction from the first cap to the second, in the plane of their centres:
  /// computed from their circles, so that they may be arbitrarily close.
  [[nodiscard]] Direction towards(const Site& from, const Site& to) const;

  /// An empty cap that touches sites from outside: its centre, and its radius as an angle, the
  /// distance to the sites.
  struct EmptyCap {
    Direction centre;
    double radius = 0;
  };
  /// The empty cap of a circle with centre (x, y) and radius s, which touches the circle `touched`.
  /// If there are several, the touched circle closest to the origin gives the best accuracy.
  [[nodiscard]] EmptyCap fromCircle(double x, double y, double s, const Site& touched) const;
  /// The empty cap of the half-plane with inner normal (a, b) that touches the circle `touched`.
  [[nodiscard]] EmptyCap fromHalfPlane(double a, double b, const Site& touched) const;

 private:
  /// The image of a cap whose radius has been reduced by the pole's.
  [[nodiscard]] Image image(const Direction& centre, const HalfAngle& reduced) const;
  /// The point at an angle from the antipode of the pole, in the direction of the plane's unit
  /// vector (x, y).
  [[nodiscard]] Direction pointAt(double angle, double x, double y) const;

  Cap pole_;
  // The axes of the plane. Seen from outside of the sphere at the antipode of the pole, x to y is
  // counter-clockwise, so that the projection keeps the orientation.
  Direction x_, y_;
};

}  // namespace apollonius::internal::sphere
