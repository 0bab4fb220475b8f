// The bisector of two circles, |p - a| - ra = |p - b| - rb: a line if the weights are equal, else a
// branch of a hyperbola with its foci at the centres (paper, section 2). Also the bisector of two
// Voronoi circles, with which Appendix A draws the dual.
//
// It is seen from the *reference site*, the circle of larger weight, away from which it bends: in
// the frame with the reference site at the origin and the other centre at (D, 0), with
// A = (ra - rb)/2 >= 0, B = √p/2 and p = D² - (ra - rb)² (so that A² + B² = (D/2)²), it is
//
//     X = D/2 + A cosh t,  Y = B sinh t,
//     at the distance (D/2) cosh t + A from the reference site and (D/2) cosh t - A from the other,
//
// counter-clockwise about the reference site as t grows. The parameter that is stored is E = e^t,
// from 0 to infinity: with it, everything takes + - * / and roots only (the same bits natively and
// as WebAssembly), an intersection with a line is a quadratic equation, and the ends at infinity
// are ordinary values. A line has A = 0 and the same parametrisation.
#pragma once

#include "geometry/curve/conic.h"
#include "predicate/site.h"

namespace apollonius::internal {

/// The coordinates of a point on a bisector: cosh t and sinh t from E.
struct HyperbolicCoordinates {
  double cosh, sinh;
  explicit HyperbolicCoordinates(double e) : cosh((e + 1 / e) / 2), sinh((e - 1 / e) / 2) {}
};

class Bisector {
 public:
  /// REQUIRES: neither covers the other, `reference` has the larger weight or the same.
  Bisector(const Site& reference, const Site& other);

  /// Is it known in doubles? Not if the centres are so close, or one circle so nearly covers the
  /// other, that B is 0.
  [[nodiscard]] bool isKnown() const { return b_ > 0; }
  [[nodiscard]] bool isLine() const { return a_ == 0; }
  [[nodiscard]] double distance() const { return d_; }    ///< D
  [[nodiscard]] double transverse() const { return a_; }  ///< A
  [[nodiscard]] double conjugate() const { return b_; }   ///< B
  [[nodiscard]] Point reference() const { return reference_; }
  /// Unit vector from the reference site to the other centre.
  [[nodiscard]] Point axis() const { return axis_; }

  [[nodiscard]] Point at(double e) const;
  /// Unit tangent, in the direction of growing E.
  [[nodiscard]] Point tangent(double e) const;
  /// Direction in which the bisector goes to infinity: at E = infinity, or at E = 0 (then away from
  /// the plane, too).
  [[nodiscard]] Point asymptote(bool upper) const;

  /// The parameter of a point that is on the bisector up to rounding.
  [[nodiscard]] double parameterOf(Point p) const;

  /// The piece from E = e0 to e1 > e0, both positive and finite, with these ends (the points of e0
  /// and e1 up to rounding).
  [[nodiscard]] Conic piece(double e0, double e1, Point from, Point to) const;
  [[nodiscard]] Conic piece(double e0, double e1) const { return piece(e0, e1, at(e0), at(e1)); }

 private:
  Point reference_;
  Point axis_;
  double d_, a_, b_;
};

/// n · p - h along a bisector, for a unit vector n: P cosh t + Q sinh t + c. Convex or concave in
/// Y, so it changes sign twice at most.
class LineForm {
 public:
  LineForm(const Bisector& bisector, Point normal, double offset);
  /// The form of the line through a point.
  LineForm(const Bisector& bisector, Point normal, Point through);

  /// Is it positive or 0 at E = e? At the ends at infinity (E = 0 and E = infinity): is its limit?
  [[nodiscard]] bool isBeyond(double e) const;
  /// The E where it becomes positive, or negative, as E grows, clamped to [e0, e1]. Meaningful only
  /// if there is one: between two E of different sign, or on the two sides of a dip or bump.
  [[nodiscard]] double rise(double e0, double e1) const;
  [[nodiscard]] double fall(double e0, double e1) const;
  /// The E where it becomes positive, or negative, on the whole bisector; 0 if there is none.
  [[nodiscard]] double rise() const;
  [[nodiscard]] double fall() const;
  /// Does it dip below 0 (for sign = 1), or rise above 0 (sign = -1), strictly between e0 and e1,
  /// where it has that sign? `at` receives the E of the extremum.
  [[nodiscard]] bool hasExcursion(int sign, double e0, double e1, double& at) const;

 private:
  [[nodiscard]] double root() const;
  [[nodiscard]] double rising() const;
  [[nodiscard]] double falling() const;
  [[nodiscard]] double ifAny(double e) const;

  double p_, q_, c_;
};

}  // namespace apollonius::internal
