// The centre of the Voronoi circle of three finite sites, with a bound on its error: over double
// for the circles that are kept with faces, over Twofold where those are not accurate enough.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "number/twofold.h"
#include "predicate/formulas.h"

namespace apollonius::internal {

/// Does a circle exist, as far as a computation in rounded numbers tells?
enum class Existence : unsigned char { kYes, kNo, kUnknown };

/// Seen from the reference site, in units of the rows: the centre, its distance rho from there, and
/// a bound of the errors of these three numbers together.
template <class Number>
struct BoundedCenter {
  Number x, y, rho;
  double error = 0;
};

/// Is the first double of a sum of two twofold numbers certainly the one nearest to the exact sum?
/// One of the two has the error given, and the sum is rounded.
inline bool isRounded(const Twofold& sum, double error) {
  const double all = error + kTwofoldRoundoff * absolute(sum.value);
  return sum.value + (sum.rest + all) == sum.value && sum.value + (sum.rest - all) == sum.value;
}

inline double valueOf(double x) { return x; }
inline double valueOf(const Twofold& x) { return x.value; }
inline double rootOf(double x) { return std::sqrt(x); }
inline Twofold rootOf(const Twofold& x) { return root(x); }

/// Finds the centre from the rows j and k of a counter-clockwise triple, and the row from j to k.
/// The bound holds if the answer is kYes. The circle exists exactly if the denominator below is
/// positive.
///
/// Direction of the vertex from the reference site: n (cos, sin) = (a, b) with
///     a = v √D - w u,  b = -u √D - w v,
/// where (u, v, w) = chordOf(j, k), n = u² + v² and D = p_jk p_j p_k = n - w². Its distance from
/// there is rho = n f with f = p_j / (2 den), den = a x_j + b y_j + n r_j; docs/PREDICATES.md.
///
/// Bound, to first order in u (here the relative error of one operation), e_X being the error of X,
/// l the largest of |x|, |y|, |r|, m = x² + y² + r², to which the roundings in p are relative (5u
/// m, number/approx.h), and g = |u| + |v| >= √n >= |w|, √D:
///
///     e_c     = 9u (l_k m_j + l_j m_k)       of u, v, w: 8 roundings
///     e_root  = √D (3u + 2.5u (m_jk/p_jk + m_j/p_j + m_k/p_k))
///                                            half the relative error of D, which is 5u m/p for
///                                            each factor and 2u for the products; and 2u
///     e_ab    = g (e_root + 3 e_c + 4u g)    of a, of b
///     e_n     = g (2 e_c + 3u g)
///     e_den   = l_j (2 e_ab + e_n + 10u g²)  |a| + |b| + n <= 2.42 g², 4 roundings each
///     e_f/f   = 5u m_j/p_j + e_den/den + 3u
///     x, y, rho:                             f (2 e_ab + e_n) + 3 rho (e_f/f + 2u)
///
/// Products of errors are smaller than the terms above by the largest relative error, which must be
/// at most 2^-10; the bound itself has fewer than 2^6 roundings, a relative error of 2^-46. A
/// factor of 1 + 2^-5, which the caller applies, covers both.
template <class Number>
Existence findCenter(const Row<Number>& j, const Row<Number>& k, const Row<Number>& jk,
                     BoundedCenter<Number>& center) {
  constexpr double u1 = std::is_same_v<Number, double> ? kUnitRoundoff : kTwofoldRoundoff;
  const auto magnitude = [](const Row<Number>& row) {
    const double x = valueOf(row.x), y = valueOf(row.y), r = valueOf(row.r);
    return x * x + y * y + r * r;
  };
  const auto largest = [](const Row<Number>& row) {
    return std::max({absolute(valueOf(row.x)), absolute(valueOf(row.y)), absolute(valueOf(row.r))});
  };
  const Chord<Number> chord = chordOf(j, k);
  const Number &u = chord.u, &v = chord.v, &w = chord.w;
  const Number n = u * u + v * v;
  const Number root = rootOf(jk.p * j.p * k.p);
  const Number a = v * root - w * u;
  const Number b = -(u * root + w * v);
  const Number denominator = a * j.x + b * j.y + n * j.r;
  const Number f = j.p / (denominator + denominator);
  center.rho = f * n;
  center.x = f * a;
  center.y = f * b;

  const double mj = magnitude(j), mk = magnitude(k);
  const double pj = valueOf(j.p), pk = valueOf(k.p), pjk = valueOf(jk.p);
  const double lj = largest(j), lk = largest(k);
  const double g = absolute(valueOf(u)) + absolute(valueOf(v));
  const double eChord = 9 * u1 * (lk * mj + lj * mk);
  const double relativePj = 5 * u1 * mj / pj;
  const double relativeD = 2 * u1 + relativePj + 5 * u1 * (magnitude(jk) / pjk + mk / pk);
  const double eAb = g * (valueOf(root) * (relativeD / 2 + 2 * u1) + 3 * eChord + 4 * u1 * g);
  const double eN = g * (2 * eChord + 3 * u1 * g);
  const double relativeDen = lj * (2 * eAb + eN + 10 * u1 * g * g) / valueOf(denominator);
  constexpr double kLargestRelative = powerOfTwo(-10);
  // Written so that NaN, negative p (a cover by rounding), and a denominator that may be 0 are
  // unknown, too. The last condition is for underflow: chords of normal size keep every product
  // normal.
  const bool isCertain = eChord * g <= kLargestRelative * valueOf(n) &&
                         relativeD <= kLargestRelative &&
                         absolute(relativeDen) <= kLargestRelative && pjk > 0 && pj > 0 && pk > 0 &&
                         valueOf(n) > powerOfTwo(-400);
  if (!isCertain) return Existence::kUnknown;
  if (valueOf(denominator) < 0) return Existence::kNo;
  const double relativeF = relativePj + relativeDen + 3 * u1;
  center.error = valueOf(f) * (2 * eAb + eN) + 3 * valueOf(center.rho) * (relativeF + 2 * u1);
  return Existence::kYes;
}

// Instantiated once, in bounded_center.cpp: it is large, and speed does not matter there.
extern template Existence findCenter(const Row<Twofold>& j, const Row<Twofold>& k,
                                     const Row<Twofold>& jk, BoundedCenter<Twofold>& center);

}  // namespace apollonius::internal
