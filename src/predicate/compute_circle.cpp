#include "predicate/compute_circle.h"

#include <algorithm>
#include <limits>

#include "number/ball.h"
#include "predicate/formulas.h"
#include "predicate/kernels.h"
#include "predicate/reference_site.h"
#include "predicate/vertex_conflict.h"

namespace apollonius::internal {

namespace {

double largest(const Row<double>& row) {
  return std::max({absolute(row.x), absolute(row.y), absolute(row.r)});
}

/// Differences to the reference site times a power of two: one rounding each.
Row<double> rowFrom(const Site& reference, const Site& s, double scale) {
  return rowOf((s.x - reference.x) * scale, (s.y - reference.y) * scale,
               (s.r - reference.r) * scale);
}

/// x² + y² + r²: what the roundings in p = x² + y² - r² are relative to; |error of p| <= 5u times
/// this (number/approx.h).
double magnitude(const Row<double>& row) { return row.x * row.x + row.y * row.y + row.r * row.r; }

/// What a computation in doubles has found out about the existence of a circle.
enum class Existence : unsigned char { kYes, kNo, kUnknown };

/// Circle of three finite sites, and a bound on its error. It exists exactly if the denominator
/// below is positive.
///
/// Direction of the vertex from the reference site: n (cos, sin) = (a, b) with
///     a = v √D - w u,  b = -u √D - w v,
/// where (u, v, w) = chordOf(j, k), n = u² + v² and D = p_jk p_j p_k = n - w². Its distance from
/// there is rho = n f with f = p_j / (2 den), den = a x_j + b y_j + n r_j; docs/PREDICATES.md.
///
/// Bound, to first order in u (here the unit roundoff), e_X being the error of X, l the largest of
/// |x|, |y|, |r|, m magnitude(), and g = |u| + |v| >= √n >= |w|, √D:
///
///     e_c     = 9u (l_k m_j + l_j m_k)       of u, v, w: 8 roundings
///     e_root  = √D (3u + 2.5u (m_jk/p_jk + m_j/p_j + m_k/p_k))
///                                            half the relative error of D, which is 5u m/p for
///                                            each factor and 2u for the products; and 2u
///     e_ab    = g (e_root + 3 e_c + 4u g)    of a, of b
///     e_n     = g (2 e_c + 3u g)
///     e_den   = l_j (2 e_ab + e_n + 10u g²)  |a| + |b| + n <= 2.42 g², 4 roundings each
///     e_f/f   = 5u m_j/p_j + e_den/den + 3u
///     centre, each coordinate:               f e_ab + rho (e_f/f + 2u) + u |x|
///     clearance:                             f e_n + rho (e_f/f + 2u) + u |s|
///
/// Products of errors are smaller than the terms above by the largest relative error, which is
/// demanded to be at most 2^-10; the roundings in the bound itself are fewer than 2^6, a 2^-46th. A
/// factor of 1 + 2^-5 covers both.
Existence boundedCircle(const Site& reference, const Site& sj, const Site& sk,
                        VoronoiCircle& circle) {
  constexpr double u1 = kUnitRoundoff;
  Row<double> j = rowFrom(reference, sj, 1), k = rowFrom(reference, sk, 1);
  const double size = std::max(largest(j), largest(k));
  const double scale = inputScale(size);
  if (scale != 1) {
    j = rowFrom(reference, sj, scale);
    k = rowFrom(reference, sk, scale);
  }
  const Row<double> jk = rowFrom(sj, sk, scale);
  const Chord<double> chord = chordOf(j, k);
  const double u = chord.u, v = chord.v, w = chord.w;
  const double n = u * u + v * v;
  const double d = jk.p * j.p * k.p;
  const double root = std::sqrt(d);
  const double a = v * root - w * u;
  const double b = -(u * root + w * v);
  const double denominator = a * j.x + b * j.y + n * j.r;
  const double f = j.p / (2 * denominator);
  const double rho = f * n;

  circle.slope = -1;
  circle.x = reference.x + f * a / scale;
  circle.y = reference.y + f * b / scale;
  circle.s = rho / scale - reference.r;

  const double mj = magnitude(j), mk = magnitude(k);
  const double lj = largest(j), lk = largest(k);
  const double g = absolute(u) + absolute(v);
  const double eChord = 9 * u1 * (lk * mj + lj * mk);
  const double relativePj = 5 * u1 * mj / j.p;
  const double relativeD = 2 * u1 + relativePj + 5 * u1 * (magnitude(jk) / jk.p + mk / k.p);
  const double eAb = g * (root * (relativeD / 2 + 2 * u1) + 3 * eChord + 4 * u1 * g);
  const double eN = g * (2 * eChord + 3 * u1 * g);
  const double relativeDen = lj * (2 * eAb + eN + 10 * u1 * g * g) / denominator;
  constexpr double kLargestRelative = powerOfTwo(-10);
  // Written so that NaN, negative p (a rounded cover), and a denominator that may be 0 end here,
  // too. The last is for underflow: chords of normal size keep every product normal.
  const bool isCertain = eChord * g <= kLargestRelative * n && relativeD <= kLargestRelative &&
                         absolute(relativeDen) <= kLargestRelative && jk.p > 0 && j.p > 0 &&
                         k.p > 0 && n > powerOfTwo(-400);
  if (!isCertain || denominator < 0) {
    circle.error = std::numeric_limits<float>::infinity();
    return isCertain ? Existence::kNo : Existence::kUnknown;
  }
  const double relativeF = relativePj + relativeDen + 3 * u1;
  const double error = (f * (2 * eAb + eN) + 3 * rho * (relativeF + 2 * u1)) / scale +
                       u1 * (absolute(circle.x) + absolute(circle.y) + absolute(circle.s));
  circle.error = roundedUp(error * (1 + powerOfTwo(-5)));
  return Existence::kYes;
}

/// Half-plane of two finite sites, the reference site and t; `side` is +1 if it is the reference
/// site's left on the way to t, else -1. There are few of these faces, so the bound is computed
/// along with the value.
VoronoiCircle halfPlane(const Site& reference, const Site& t, int side) {
  const double size = std::max(
      {absolute(t.x - reference.x), absolute(t.y - reference.y), absolute(t.r - reference.r)});
  const double scale = inputScale(size);
  const Ball x = Ball::rounded((t.x - reference.x) * scale),
             y = Ball::rounded((t.y - reference.y) * scale);
  const Ball r = Ball::rounded((t.r - reference.r) * scale);
  const Ball n = x * x + y * y;
  const Ball root = Ball(side) * sqrt(lorentz(x, y, r));
  // The direction (a, b) of boundedCircle with t for one row and infinity for the other.
  const Ball a = (Ball(0) - (y * root + r * x)) / n, b = (x * root - r * y) / n;
  const Ball offset =
      a * Ball::exact(reference.x) + b * Ball::exact(reference.y) + Ball::exact(reference.r);
  VoronoiCircle plane;
  plane.x = a.value();
  plane.y = b.value();
  plane.s = offset.value();
  plane.error = roundedUp(offset.bound());
  plane.slope = roundedUp(std::max(a.bound(), b.bound()));
  return plane;
}

}  // namespace

VoronoiCircle voronoiCircle(Corner i, Corner j, Corner k) {
  rotateToReference(i, j, k);
  if (k == nullptr) return halfPlane(*i, *j, 1);
  if (j == nullptr) return halfPlane(*i, *k, -1);
  VoronoiCircle circle;
  (void)boundedCircle(*i, *j, *k, circle);  // that it exists is known to the caller
  return circle;
}

bool findCertainVoronoiCircle(Corner i, Corner j, Corner k, VoronoiCircle& circle) noexcept {
  rotateToReference(i, j, k);
  if (k != nullptr && j != nullptr) return boundedCircle(*i, *j, *k, circle) == Existence::kYes;
  circle = k == nullptr ? halfPlane(*i, *j, 1) : halfPlane(*i, *k, -1);
  return true;
}

bool findVoronoiCircle(Corner i, Corner j, Corner k, VoronoiCircle& circle) {
  rotateToReference(i, j, k);
  if (j == nullptr || k == nullptr) {
    circle = voronoiCircle(i, j, k);
    return true;
  }
  const Existence existence = boundedCircle(*i, *j, *k, circle);
  return existence == Existence::kYes ||
         (existence == Existence::kUnknown && hasVoronoiCircle(*i, *j, *k));
}

}  // namespace apollonius::internal
