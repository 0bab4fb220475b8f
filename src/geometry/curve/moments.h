// Area, first moments and length of what conic pieces bound. Areas and moments are closed forms; no
// logarithm is taken, so that the bits are the same natively and as WebAssembly.
//
// The area between a conic and its chord is that of its control triangle times a function g of the
// weight alone, because rational quadratic curves of the same weight are affine images of each
// other; so is the first moment about the chord, in units of the way from the chord's middle to p1
// (the centroid is on that line). With w = cosh u for a hyperbola (likewise cos for an ellipse),
// its area is sinh u cosh u - u of a unit hyperbola's, and
//
//     g(w) = w (w s - u) / s³,     m(w) = w² (s + s³/3 - w u) / s⁵,     s = sinh u.
//
// Both cancel for w near 1. With z = (w-1)/(w+1) = tanh²(u/2) they are power series that converge
// for |z| < 1:
//
//     g = 2 (1+z)  Σ  -z^(k-1) / ((2k+1)(2k-1)(2k-3)),                k >= 1;    g(1) = 2/3
//     m = (1+z)²   Σ  -2 (k-1) z^(k-2) / ((2k+1)(2k-1)(2k-3)(2k-5)),  k >= 2;    m(1) = 2/15
//
// For larger z the arc is halved, in numbers only: with w' = √((1+w)/2),
//
//     g(w) = w/(1+w) + w/(1+w)² g(w'),     m(w) = w²/(3(1+w)²) + w²/(2(1+w)³) (g(w') + m(w')).
#pragma once

#include "geometry/curve/conic.h"

namespace apollonius::internal {

/// g and m above, with relative errors of a few units in the last place.
struct ArcFactors {
  double area, moment;
};
[[nodiscard]] ArcFactors arcFactors(double w);
/// g alone.
[[nodiscard]] double arcAreaFactor(double w);

/// The signed area between a conic and its chord: positive if the curve runs to the right of the
/// chord.
[[nodiscard]] double areaBeyondChord(const Conic& conic);

/// Adds area and first moments (about `origin`) of the sector between `origin` and a piece of a
/// counter-clockwise boundary.
struct Moments {
  double area = 0;
  Point first;
  void add(const Conic& piece, Point origin);
};

/// Length of a conic, to double precision: adaptive Gauss-Legendre quadrature.
[[nodiscard]] double lengthOf(const Conic& conic);

}  // namespace apollonius::internal
