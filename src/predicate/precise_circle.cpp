#include "predicate/precise_circle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include "number/root_sign.h"
#include "number/twofold.h"
#include "predicate/bounded_center.h"
#include "predicate/compute_circle.h"
#include "predicate/grid_circle.h"
#include "predicate/kernels.h"
#include "predicate/long_kernels.h"
#include "predicate/reference_site.h"

namespace apollonius::internal {

namespace {

using Rounded = Dyadic::Rounded;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// x 2^exponent; infinite or 0 where that is beyond doubles.
double scaled(double x, int exponent) {
  for (; exponent > 1000 && absolute(x) <= std::numeric_limits<double>::max(); exponent -= 1000)
    x *= powerOfTwo(1000);
  for (; exponent < -1000 && x != 0; exponent += 1000) x *= powerOfTwo(-1000);
  return absolute(x) <= std::numeric_limits<double>::max()
             ? x * powerOfTwo(std::clamp(exponent, -1000, 1000))
             : x;
}

/// Of numbers with mantissas between 2^30 and 2^130, or 0.
Rounded sum(const Rounded& x, const Rounded& y) {
  if (x.mantissa == 0) return y;
  if (y.mantissa == 0) return x;
  if (x.exponent < y.exponent) return sum(y, x);
  return {x.mantissa + scaled(y.mantissa, y.exponent - x.exponent), x.exponent};
}

/// a + b √d; d > 0. Where the terms cancel, it is (a² - b² d) / (a - b √d), whose do not. Relative
/// errors, in units of 2^-53, up to terms of second order: b and d 1 each, √d 1.5, b √d 3.5, a
/// sum 4.5, a quotient 6.5.
Rounded withRoot(const Dyadic& a, const Dyadic& b, const Dyadic& d) {
  Rounded root = d.rounded();
  if (root.exponent % 2 != 0) root = {2 * root.mantissa, root.exponent - 1};
  Rounded term = b.rounded();
  term = {term.mantissa * std::sqrt(root.mantissa), term.exponent + root.exponent / 2};
  const Rounded first = a.rounded();
  if (a.sign() * b.sign() != Sign::kNegative) return sum(first, term);
  const Rounded over = (a * a - b * b * d).rounded(),
                under = sum(first, {-term.mantissa, term.exponent});
  return {over.mantissa / under.mantissa, over.exponent - under.exponent};
}

/// a b / (2 c), rounded: with the errors of a, b and c, and 2 more.
double halfQuotient(const Rounded& a, const Rounded& b, const Rounded& c) {
  return scaled(a.mantissa / c.mantissa * b.mantissa, a.exponent + b.exponent - c.exponent - 1);
}

/// A face in long numbers. Its vertex is at (x, y) from the reference site, which is rho away, with
/// 2c x = p a, 2c y = p b, 2c rho = p n, c > 0, and each of a, b, c of the form first + second √d
/// (as in bounded_center.h).
struct LongFace {
  struct Number {
    Dyadic first, second;
  };
  Dyadic d, n;
  Row<Dyadic> row;
  Number a, b, c;

  LongFace(const Site& i, const Site& j, const Site& k) {
    const ExactKernel kernel(i, {&j, &k});
    row = kernel.row(0);
    const auto [u, v, w] = chordOf(row, kernel.row(1));
    n = u * u + v * v;
    d = n - w * w;
    a = {-(w * u), v};
    b = {-(w * v), -u};
    c = {n * row.r - w * (u * row.x + v * row.y), v * row.x - u * row.y};
  }
};

/// The next double above or below; t is not 0.
double neighborOf(double t, bool above) {
  const auto bits = std::bit_cast<std::uint64_t>(t);
  return std::bit_cast<double>((t > 0) == above ? bits + 1 : bits - 1);
}

/// `number` / (2c), rounded to the nearest double, or to the one of even mantissa if there are two;
/// from an estimate.
double correctQuotient(const LongFace& face, const LongFace::Number& number, double estimate) {
  const LongFace::Number c{face.c.first + face.c.first, face.c.second + face.c.second};
  const Rounded under = withRoot(c.first, c.second, face.d);
  // number - 2c t, of which the signs are exact.
  const auto restAt = [&](const Dyadic& t) {
    return LongFace::Number{number.first - c.first * t, number.second - c.second * t};
  };
  if (signOfRoot(number.first, number.second, face.d) == Sign::kZero) return 0;
  double t = estimate, previous = t, step = 0;
  for (int round = 0; round < 16; ++round) {
    const LongFace::Number rest = restAt(Dyadic(t));
    const Rounded over = withRoot(rest.first, rest.second, face.d);
    previous = t;
    step = scaled(over.mantissa / under.mantissa, over.exponent - under.exponent);
    t = previous + step;
    if (absolute(step) <= powerOfTwo(-30) * absolute(t)) break;
  }
  // The step is good to 2^-49 of itself, a 2^-79th of t. So t is right unless the sum was as near
  // to the middle of two doubles as that.
  const double back = t - previous, lost = (previous - (t - back)) + (step - back);
  const double next = neighborOf(t, lost > 0);
  if (lost == 0 ||
      absolute(absolute(lost) - absolute(next - t) / 2) > powerOfTwo(-20) * absolute(next - t))
    return t;
  const LongFace::Number rest = restAt((Dyadic(t) + Dyadic(next)) * Dyadic(0.5));
  const Sign beyond = signOfRoot(rest.first, rest.second, face.d);
  if (beyond == Sign::kZero) return lowestExponentOf(t) > lowestExponentOf(next) ? t : next;
  return (beyond == Sign::kPositive) == (next > t) ? next : t;
}

/// Are the numbers short enough for the exact stage of a quotient: forms of degree 16, 2 of them in
/// a double of any size?
bool haveFewDigits(std::initializer_list<const Site*> sites) {
  Range range;
  for (const Site* s : sites) range.include(*s);
  return range.highest - range.lowest < 500;
}

/// The circle in numbers of twice the digits, rounded; false unless what these are off by is beyond
/// the last places of the centre, seen from i, and of its distance. i is the reference site.
bool findTwofoldCircle(const Site& i, const Site& j, const Site& k, VoronoiCircle& circle) {
  double largest = 0;
  for (const Site* s : {&j, &k})
    largest = std::max({largest, absolute(s->x - i.x), absolute(s->y - i.y), absolute(s->r - i.r)});
  const double scale = inputScale(largest);
  // Exact.
  const auto difference = [scale](double a, double b) {
    const Twofold exact = Twofold(a) - b;
    return Twofold(scale * exact.value, scale * exact.rest);
  };
  const auto rowFrom = [&](const Site& s) {
    return rowOf(difference(s.x, i.x), difference(s.y, i.y), difference(s.r, i.r));
  };
  const Row<Twofold> rowJ = rowFrom(j), rowK = rowFrom(k);
  const Row<Twofold> jk = rowOf(rowK.x - rowJ.x, rowK.y - rowJ.y, rowK.r - rowJ.r);
  BoundedCenter<Twofold> center;
  if (findCenter(rowJ, rowK, jk, center) != Existence::kYes) return false;
  // The distance is the longest of the three.
  const double least = std::min(absolute(center.x.value), absolute(center.y.value));
  if (!(center.error <= kUnitRoundoff * least)) return false;
  const auto beside = [scale](double own, const Twofold& part) {
    return (Twofold(own) + Twofold(part.value / scale, part.rest / scale)).value;
  };
  circle.x = beside(i.x, center.x);
  circle.y = beside(i.y, center.y);
  circle.s = beside(-i.r, center.rho);
  circle.slope = -1;
  circle.error = roundedUp(
      2 * kUnitRoundoff *
      (center.rho.value / scale + absolute(circle.x) + absolute(circle.y) + absolute(circle.s)));
  return true;
}

/// With errors of a few units in the last place. i is the reference site.
VoronoiCircle closeCircle(Corner i, Corner j, Corner k) {
  VoronoiCircle circle = voronoiCircle(i, j, k);
  const double size = absolute(circle.x) + absolute(circle.y) + absolute(circle.s);
  const bool isKnown = circle.error < std::numeric_limits<float>::infinity();
  if (circle.isHalfPlane() || (isKnown && circle.error <= powerOfTwo(-40) * size)) return circle;
  if (findTwofoldCircle(*i, *j, *k, circle)) return circle;

  // The centre is half p (a, b) / c from the reference site, and half p n / c is its distance.
  const LongFace face(*i, *j, *k);
  const Rounded p = face.row.p.rounded();
  const Rounded a = withRoot(face.a.first, face.a.second, face.d),
                b = withRoot(face.b.first, face.b.second, face.d);
  const Rounded c = withRoot(face.c.first, face.c.second, face.d);
  circle.x = i->x + halfQuotient(p, a, c);
  circle.y = i->y + halfQuotient(p, b, c);
  const double rho = halfQuotient(p, face.n.rounded(), c);
  circle.s = rho - i->r;
  // Each of the three quotients is off by at most 1 + 6.5 + 6.5 + 2 = 16 units of rho, and each sum
  // by one of its own.
  const double error64 =
      16 * kUnitRoundoff * (3 * rho + absolute(circle.x) + absolute(circle.y) + absolute(circle.s));
  circle.error = error64 < 1e38 ? std::max(static_cast<float>(error64 * 1.01),
                                           std::numeric_limits<float>::min())
                                : std::numeric_limits<float>::infinity();
  return circle;
}

/// With the centre, and its distance from i, rounded correctly, unless the sites have too many
/// digits. i is the reference site.
VoronoiCircle correctCircle(const Site& i, const Site& j, const Site& k) {
  VoronoiCircle circle = closeCircle(&i, &j, &k);
  const double rho = circle.s + i.r;
  const bool isFinite = absolute(circle.x) + absolute(circle.y) + rho < kInfinite;
  if (!isFinite || !haveFewDigits({&i, &j, &k})) return circle;
  const LongFace face(i, j, k);
  // t + p `number` / (2c), as a number over 2c.
  const auto offBy = [&](const LongFace::Number& number, double t) {
    const Dyadic twice(2 * t);
    return LongFace::Number{number.first * face.row.p + face.c.first * twice,
                            number.second * face.row.p + face.c.second * twice};
  };
  circle.x = correctQuotient(face, offBy(face.a, i.x), circle.x);
  circle.y = correctQuotient(face, offBy(face.b, i.y), circle.y);
  circle.s = correctQuotient(face, offBy({face.n, Dyadic(0)}, 0), rho) - i.r;
  return circle;
}

VoronoiCircle circleOf(Corner i, Corner j, Corner k, bool isShared) {
  rotateToReference(i, j, k);
  VoronoiCircle circle;
  const OnGrid onGrid =
      j == nullptr || k == nullptr ? OnGrid::kNo : circleOnGrid(*i, *j, *k, circle);
  if (onGrid == OnGrid::kYesRounded) return circle;
  return isShared || onGrid == OnGrid::kYes ? correctCircle(*i, *j, *k) : closeCircle(i, j, k);
}

}  // namespace

VoronoiCircle preciseVoronoiCircle(Corner i, Corner j, Corner k) {
  return circleOf(i, j, k, false);
}

VoronoiCircle commonVoronoiCircle(const Site& first, const Site& second, const Site& third) {
  return circleOf(&first, &second, &third, true);
}

}  // namespace apollonius::internal
