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
// Nearest sites are not kept, as centres of circles are not images of centres of caps.
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
  /// Of the cap about a point that a site touches which is at this distance.
  [[nodiscard]] Image imageOfTouching(const Direction& point, const HalfAngle& distance) const {
    return image(point, distance + pole_.radius);
  }
  /// Of a point: its circle has the radius 0, and it has none at the pole.
  [[nodiscard]] Image imageOfPoint(const Direction& point) const { return image(point, {}); }

  /// cos d - cos D of two caps with these circles, D being the angle between their centres and d
  /// the difference of their weights: 0 where one touches the other from inside. To a small
  /// relative error, as the circles have it, which tell exactly what is hidden.
  [[nodiscard]] static double rise(const Site& a, const Site& b);
  /// The same of the pole and a cap with this circle.
  [[nodiscard]] static double riseFromPole(const Site& circle);

  /// sin d of the first cap minus the second, likewise.
  [[nodiscard]] static double shift(const Site& a, const Site& b);
  /// The same of the pole and a cap with this circle.
  [[nodiscard]] static double shiftFromPole(const Site& circle) {
    return -circle.r * riseFromPole(circle);
  }
  /// A vector in the direction of the second cap as seen from the first, and in the plane of their
  /// centres: by their circles, however close they are.
  [[nodiscard]] Direction towards(const Site& from, const Site& to) const;

  /// An empty cap that touches sites from outside: its centre, and its radius as an angle, which is
  /// the distance to the sites.
  struct EmptyCap {
    Direction centre;
    double radius = 0;
  };
  /// That of a circle with centre (x, y) and radius s, which touches another. Of several the one
  /// closest to the origin loses least.
  [[nodiscard]] EmptyCap fromCircle(double x, double y, double s, const Site& touched) const;
  /// That of the half-plane with inner normal (a, b) that touches a circle, likewise.
  [[nodiscard]] EmptyCap fromHalfPlane(double a, double b, const Site& touched) const;

 private:
  /// Of a cap whose radius has been reduced.
  [[nodiscard]] Image image(const Direction& centre, const HalfAngle& reduced) const;
  /// At an angle from the antipode of the pole, in the direction of the plane's (x, y), a unit
  /// vector.
  [[nodiscard]] Direction pointAt(double angle, double x, double y) const;

  Cap pole_;
  // The axes of the plane. Seen from outside of the sphere at the antipode of the pole, x to y is
  // counter-clockwise, so that the projection keeps the orientation.
  Direction x_, y_;
};

}  // namespace apollonius::internal::sphere
