// A piece of a conic as a rational quadratic Bezier curve: the one kind of curve of this library.
// Pieces of hyperbola branches (Voronoi edges), parabolas and segments (the dual graph), circular
// arcs (the hull) all are exactly that.
//
//     P(t) = ((1-t)² p0 + 2 w t (1-t) p1 + t² p2) / ((1-t)² + 2 w t (1-t) + t²),   0 <= t <= 1
//
// p1 is where the tangents at p0 and p2 meet. w > 1: hyperbola, w = 1: parabola, 0 < w < 1:
// ellipse, w = 0: the straight segment, of which p1 is the middle. The curve lies within the
// triangle p0, p1, p2; the middle of the arc, P(1/2), divides the way from the middle of the chord
// to p1 as w : 1. Facts used below, with z = (w-1)/(w+1): both halves have the weight √((1+w)/2),
// and areas and first moments, being affine, are those of the triangle times a function of w
// (moments.h).
#pragma once

#include "predicate/point.h"

namespace apollonius::internal {

struct Conic {
  Point p0, p1;
  double w = 0;
  Point p2;

  [[nodiscard]] static Conic segment(Point from, Point to) {
    return {from, middle(from, to), 0, to};
  }
  /// The arc about `center` from direction `from` to `to` (unit vectors), counter-clockwise.
  /// REQUIRES: less than half a turn.
  [[nodiscard]] static Conic arc(Point center, double radius, Point from, Point to);

  [[nodiscard]] bool isStraight() const { return w == 0; }
  [[nodiscard]] Conic reversed() const { return {p2, p1, w, p0}; }
  /// Point at a parameter in [0, 1].
  [[nodiscard]] Point at(double t) const;
  /// Derivative with respect to the parameter.
  [[nodiscard]] Point tangent(double t) const;
  /// Cuts at t = 1/2.
  void halve(Conic& first, Conic& second) const;
  /// Halving a piece of weight w gives two of weight √((1+w)/2): w is 1 up to rounding after 600
  /// halvings at worst (w near 2^1023), and the sagitta falls to a quarter or less with each.
  /// Points that coincide in doubles end it sooner.
  static constexpr int kMostHalvings = 640;
  /// Is m, the middle that halve() found, different from both ends? No if a coordinate is not
  /// finite: a trusted snapshot can have invalid vertices.
  [[nodiscard]] bool isSplitBy(Point m) const;
  /// Largest distance of the curve from its chord.
  [[nodiscard]] double sagitta() const;
};

}  // namespace apollonius::internal
