// Coordinates of Voronoi vertices from long numbers: for nearly collinear triples and other cases where doubles cancel.
#include <algorithm>
#include <limits>

#include "predicate/long_rows.h"
#include "predicate/pole.h"
#include "predicate/voronoi_circle.h"

namespace apollonius {

namespace {

/// x 2^exponent; infinite or 0 where that is beyond doubles.
double scaled(double x, int exponent) {
  for (; exponent > 1000 && absolute(x) <= std::numeric_limits<double>::max(); exponent -= 1000) x *= powerOfTwo(1000);
  for (; exponent < -1000 && x != 0; exponent += 1000) x *= powerOfTwo(-1000);
  return absolute(x) <= std::numeric_limits<double>::max() ? x * powerOfTwo(std::clamp(exponent, -1000, 1000)) : x;
}

/// a b / (2 c), rounded: a relative error of at most 2^-49.
double halfQuotient(const Dyadic& a, const Dyadic& b, const Dyadic& c) {
  const Dyadic::Rounded ra = a.rounded(), rb = b.rounded(), rc = c.rounded();
  return scaled(ra.mantissa / rc.mantissa * rb.mantissa, ra.exponent + rb.exponent - rc.exponent - 1);
}

Dyadic magnitude(const Dyadic& x) { return x.sign() == Sign::kNegative ? -x : x; }

}  // namespace

VoronoiCircle preciseVoronoiCircle(Corner i, Corner j, Corner k) {
  const VoronoiCircle quick = voronoiCircle(i, j, k);
  const double size = absolute(quick.x) + absolute(quick.y) + absolute(quick.s);
  const bool isKnown = quick.error < std::numeric_limits<float>::infinity();
  if (quick.isHalfPlane() || (isKnown && quick.error <= powerOfTwo(-40) * size)) return quick;

  rotateToPole(i, j, k);
  const ExactRows rows(*i, {j, k});
  const Row<Dyadic>&rj = rows.row(0), &rk = rows.row(1);
  const Chord<Dyadic> chord = chordOf(rj, rk);
  const Dyadic n = chord.u * chord.u + chord.v * chord.v;
  const Dyadic d = n - chord.w * chord.w;
  // As in voronoiCircle, with a root of ever more digits until what its error can do to the denominator, and to a and b as parts of
  // n, is below a 2^-60th. The denominator is not 0, so there is an end.
  for (unsigned digits = 128;; digits *= 2) {
    const Dyadic root = d.root(digits);
    const Dyadic a = chord.v * root - chord.w * chord.u;
    const Dyadic b = -(chord.u * root + chord.w * chord.v);
    const Dyadic denominator = a * rj.x + b * rj.y + n * rj.r;
    // The root is at most 2^-digits of itself too small, and smaller than √n.
    const Dyadic rootError = root * Dyadic::powerOfTwo(-static_cast<int>(digits));
    const Dyadic error = (magnitude(chord.v * rj.x) + magnitude(chord.u * rj.y)) * rootError;
    if ((denominator - error * Dyadic::powerOfTwo(60)).sign() != Sign::kPositive) continue;
    VoronoiCircle circle;
    circle.x = i->x + halfQuotient(rj.p, a, denominator);
    circle.y = i->y + halfQuotient(rj.p, b, denominator);
    const double rho = halfQuotient(rj.p, n, denominator);
    circle.s = rho - i->r;
    const double error64 = 16 * kUnitRoundoff * (3 * rho + absolute(circle.x) + absolute(circle.y) + absolute(circle.s));
    circle.error = error64 < 1e38 ? std::max(static_cast<float>(error64 * 1.01), std::numeric_limits<float>::min())
                                  : std::numeric_limits<float>::infinity();
    return circle;
  }
}

}  // namespace apollonius
