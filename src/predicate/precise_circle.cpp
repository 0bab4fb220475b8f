// Coordinates of Voronoi vertices from long numbers: for nearly collinear triples and other cases where doubles cancel.
#include <algorithm>
#include <cmath>
#include <limits>

#include "predicate/long_rows.h"
#include "predicate/pole.h"
#include "predicate/voronoi_circle.h"

namespace apollonius {

namespace {

using Rounded = Dyadic::Rounded;

/// x 2^exponent; infinite or 0 where that is beyond doubles.
double scaled(double x, int exponent) {
  for (; exponent > 1000 && absolute(x) <= std::numeric_limits<double>::max(); exponent -= 1000) x *= powerOfTwo(1000);
  for (; exponent < -1000 && x != 0; exponent += 1000) x *= powerOfTwo(-1000);
  return absolute(x) <= std::numeric_limits<double>::max() ? x * powerOfTwo(std::clamp(exponent, -1000, 1000)) : x;
}

/// Of numbers with mantissas between 2^30 and 2^130, or 0.
Rounded sum(const Rounded& x, const Rounded& y) {
  if (x.mantissa == 0) return y;
  if (y.mantissa == 0) return x;
  if (x.exponent < y.exponent) return sum(y, x);
  return {x.mantissa + scaled(y.mantissa, y.exponent - x.exponent), x.exponent};
}

/// a + b √d; d > 0. Where the terms cancel, it is (a² - b² d) / (a - b √d), whose do not. Relative errors, in units of 2^-53, up to
/// terms of second order: b and d 1 each, √d 1.5, b √d 3.5, a sum 4.5, a quotient 6.5.
Rounded withRoot(const Dyadic& a, const Dyadic& b, const Dyadic& d) {
  Rounded root = d.rounded();
  if (root.exponent % 2 != 0) root = {2 * root.mantissa, root.exponent - 1};
  Rounded term = b.rounded();
  term = {term.mantissa * std::sqrt(root.mantissa), term.exponent + root.exponent / 2};
  const Rounded first = a.rounded();
  if (a.sign() * b.sign() != Sign::kNegative) return sum(first, term);
  const Rounded over = (a * a - b * b * d).rounded(), under = sum(first, {-term.mantissa, term.exponent});
  return {over.mantissa / under.mantissa, over.exponent - under.exponent};
}

/// a b / (2 c), rounded: with the errors of a, b and c, and 2 more.
double halfQuotient(const Rounded& a, const Rounded& b, const Rounded& c) {
  return scaled(a.mantissa / c.mantissa * b.mantissa, a.exponent + b.exponent - c.exponent - 1);
}

}  // namespace

VoronoiCircle preciseVoronoiCircle(Corner i, Corner j, Corner k) {
  const VoronoiCircle quick = voronoiCircle(i, j, k);
  const double size = absolute(quick.x) + absolute(quick.y) + absolute(quick.s);
  const bool isKnown = quick.error < std::numeric_limits<float>::infinity();
  if (quick.isHalfPlane() || (isKnown && quick.error <= powerOfTwo(-40) * size)) return quick;

  // As in voronoiCircle: the centre is half p (a, b) / c from the pole, and half p n / c is its distance.
  rotateToPole(i, j, k);
  const ExactRows rows(*i, {j, k});
  const Row<Dyadic>& row = rows.row(0);
  const auto [u, v, w] = chordOf(row, rows.row(1));
  const Dyadic n = u * u + v * v;
  const Dyadic d = n - w * w;
  const Rounded p = row.p.rounded();
  const Rounded a = withRoot(-(w * u), v, d), b = withRoot(-(w * v), -u, d);
  const Rounded c = withRoot(n * row.r - w * (u * row.x + v * row.y), v * row.x - u * row.y, d);
  VoronoiCircle circle;
  circle.x = i->x + halfQuotient(p, a, c);
  circle.y = i->y + halfQuotient(p, b, c);
  const double rho = halfQuotient(p, n.rounded(), c);
  circle.s = rho - i->r;
  // Each of the three quotients is off by at most 1 + 6.5 + 6.5 + 2 = 16 units of rho, and each sum by one of its own.
  const double error64 = 16 * kUnitRoundoff * (3 * rho + absolute(circle.x) + absolute(circle.y) + absolute(circle.s));
  circle.error = error64 < 1e38 ? std::max(static_cast<float>(error64 * 1.01), std::numeric_limits<float>::min())
                                : std::numeric_limits<float>::infinity();
  return circle;
}

}  // namespace apollonius
