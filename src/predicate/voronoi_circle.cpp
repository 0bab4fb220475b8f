#include "predicate/voronoi_circle.h"

#include <algorithm>
#include <limits>

#include "number/ball.h"
#include "predicate/formulas.h"
#include "predicate/pole.h"
#include "predicate/rows.h"

namespace apollonius {

namespace {

/// The smallest convenient float that is at least x; infinity for NaN.
float roundedUp(double x) {
  if (!(x <= 1e38)) return std::numeric_limits<float>::infinity();
  return std::max(static_cast<float>(x * (1 + powerOfTwo(-22))), std::numeric_limits<float>::min());
}

Row<Ball> ballRow(Corner c, const Site& pole, double scale) {
  if (c == nullptr) return infinityRow<Ball>();
  // Scaling by a power of two adds no error.
  return rowOf(Ball::rounded((c->x - pole.x) * scale), Ball::rounded((c->y - pole.y) * scale),
               Ball::rounded((c->r - pole.r) * scale));
}

double largestDifference(Corner c, const Site& pole) {
  if (c == nullptr) return 0;
  return std::max({absolute(c->x - pole.x), absolute(c->y - pole.y), absolute(c->r - pole.r)});
}

}  // namespace

VoronoiCircle voronoiCircle(Corner i, Corner j, Corner k) {
  rotateToPole(i, j, k);
  const Site& pole = *i;
  const double scale = inputScale(std::max(largestDifference(j, pole), largestDifference(k, pole)));
  const Row<Ball> rj = ballRow(j, pole, scale), rk = ballRow(k, pole, scale);

  // Direction of the vertex from the pole: n · d = (-w u + v √D, -w v - u √D) with n = u² + v², D = n - w² (PREDICATES.md, 4).
  // D is computed as the product p_jk p_j p_k, which cancels less.
  const Chord<Ball> chord = chordOf(rj, rk);
  const Ball n = chord.u * chord.u + chord.v * chord.v;
  const Ball pjk = j == nullptr || k == nullptr
                       ? Ball(1)
                       : lorentz(Ball::rounded((j->x - k->x) * scale), Ball::rounded((j->y - k->y) * scale),
                                 Ball::rounded((j->r - k->r) * scale));
  const Ball root = sqrt(pjk * rj.p * rk.p);
  const Ball a = chord.v * root - chord.w * chord.u;
  const Ball b = Ball(0) - (chord.u * root + chord.w * chord.v);

  VoronoiCircle circle;
  const Ball px = Ball::exact(pole.x), py = Ball::exact(pole.y), pr = Ball::exact(pole.r);
  if (j == nullptr || k == nullptr) {
    const Ball normalX = a / n, normalY = b / n;
    const Ball offset = normalX * px + normalY * py + pr;
    circle.x = normalX.value();
    circle.y = normalY.value();
    circle.s = offset.value();
    circle.error = roundedUp(offset.bound());
    circle.slope = roundedUp(std::max(normalX.bound(), normalY.bound()));
    return circle;
  }
  // Radius: 1 / (2 rho) = (d · (x_j, y_j) + r_j) / p_j; the centre is pole + rho d.
  const Ball denominator = a * rj.x + b * rj.y + n * rj.r;
  if (!denominator.certainlyPositive()) {
    circle.error = std::numeric_limits<float>::infinity();
    return circle;
  }
  const Ball factor = rj.p / (denominator + denominator) * Ball::exact(1 / scale);
  const Ball x = px + factor * a, y = py + factor * b, s = factor * n - pr;
  circle.x = x.value();
  circle.y = y.value();
  circle.s = s.value();
  circle.error = roundedUp(x.bound() + y.bound() + s.bound());
  return circle;
}

}  // namespace apollonius
