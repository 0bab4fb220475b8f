#include "predicate/precise_circle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>

#include "base/infinite.h"
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

/// x 2^exponent; infinite or 0 if that is beyond doubles.
double scaled(double x, int exponent) {
  for (; exponent > 1000 && absolute(x) <= std::numeric_limits<double>::max(); exponent -= 1000)
    x *= powerOfTwo(1000);
  for (; exponent < -1000 && x != 0; exponent += 1000) x *= powerOfTwo(-1000);
  return absolute(x) <= std::numeric_limits<double>::max()
             ? x * powerOfTwo(std::clamp(exponent, -1000, 1000))
             : x;
}

/// x + y. REQUIRES: mantissas between 2^30 and 2^130, or 0.
Rounded sum(const Rounded& x, const Rounded& y) {
  if (x.mantissa == 0) return y;
  if (y.mantissa == 0) return x;
  if (x.exponent < y.exponent) return sum(y, x);
  return {x.mantissa + scaled(y.mantissa, y.exponent - x.exponent), x.exponent};
}

/// a + b √d; d > 0. Where the terms cancel, it is (a² - b² d) / (a - b √d), whose terms do not.
/// Relative errors, in units of 2^-53, up to terms of second order: b and d 1 each, √d 1.5, b √d
/// 3.5, a sum 4.5, a quotient 6.5.
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

/// A face in long numbers. Its vertex is at (x, y) / (2c) from the reference site, which is
/// rho / (2c) away, with c > 0 (bounded_center.h, where x is p_j a).
struct LongFace {
  /// first + second √d
  struct Number {
    Dyadic first, second;
  };
  Dyadic d;
  Number x, y, rho, c;

  LongFace(const Site& i, const Site& j, const Site& k) {
    const ExactKernel kernel(i, {&j, &k});
    const Row<Dyadic>&rowJ = kernel.row(0), &rowK = kernel.row(1);
    const auto [u, v, w] = chordOf(rowJ, rowK);
    const Dyadic n = u * u + v * v;
    d = n - w * w;
    x = {-(w * u) * rowJ.p, v * rowJ.p};
    y = {-(w * v) * rowJ.p, -u * rowJ.p};
    rho.first = n * rowJ.p;
    c = {n * rowJ.r - w * (u * rowJ.x + v * rowJ.y), v * rowJ.x - u * rowJ.y};
  }
};

/// The next double above or below; t is not 0.
double neighborOf(double t, bool above) {
  const auto bits = std::bit_cast<std::uint64_t>(t);
  return std::bit_cast<double>((t > 0) == above ? bits + 1 : bits - 1);
}

/// `number` - 2c t, whose sign is exact.
LongFace::Number restAt(const LongFace& face, const LongFace::Number& number, const Dyadic& t) {
  const Dyadic twice = t + t;
  return {number.first - face.c.first * twice, number.second - face.c.second * twice};
}

/// A double, and its neighbour: one of the two is the nearest to a number that is known to many
/// more digits.
struct Candidates {
  double t, next;

  explicit Candidates(const Twofold& found) : t(found.value), next(neighborOf(t, found.rest > 0)) {}
  /// From where the number is, seen from their middle. If it is there, the one of even mantissa.
  [[nodiscard]] double nearest(Sign beyond) const {
    if (beyond == Sign::kZero) return lowestExponentOf(t) > lowestExponentOf(next) ? t : next;
    return (beyond == Sign::kPositive) == (next > t) ? next : t;
  }
};

/// `number` / (2c), rounded to the nearest double, or to the one of even mantissa if there are two;
/// from an estimate.
double correctQuotient(const LongFace& face, const LongFace::Number& number, double estimate) {
  if (signOfRoot(number.first, number.second, face.d) == Sign::kZero) return 0;
  const Rounded under = withRoot(face.c.first, face.c.second, face.d);
  double t = estimate, previous = t, step = 0;
  for (int round = 0; round < 16; ++round) {
    const LongFace::Number rest = restAt(face, number, Dyadic(t));
    const Rounded over = withRoot(rest.first, rest.second, face.d);
    previous = t;
    step = scaled(over.mantissa / under.mantissa, over.exponent - under.exponent - 1);
    t = previous + step;
    if (absolute(step) <= powerOfTwo(-30) * absolute(t)) break;
  }
  // The step is good to 2^-49 of itself, a 2^-79th of t. So t is right unless the sum was as near
  // to the middle of two doubles as that.
  const double back = t - previous, lost = (previous - (t - back)) + (step - back);
  const Candidates candidates({t, lost});
  const double apart = absolute(candidates.next - t);
  if (lost == 0 || absolute(absolute(lost) - apart / 2) > powerOfTwo(-20) * apart) return t;
  const LongFace::Number rest =
      restAt(face, number, (Dyadic(t) + Dyadic(candidates.next)) * Dyadic(0.5));
  return candidates.nearest(signOfRoot(rest.first, rest.second, face.d));
}

/// On which side of the middle of two doubles is a coordinate of the centre of three sites of equal
/// weights? False if their numbers are too long for integers of fixed width.
bool findSide(const Site& i, const Site& j, const Site& k, bool isX, const Candidates& doubles,
              Sign& side) {
  Range range;
  for (const Site* s : {&i, &j, &k}) range.include(*s);
  for (const double v : {doubles.t, doubles.next}) range.include(v);
  if (range.highest - range.lowest > FixedInteger::kInputBits - 3) return false;
  const auto in = [&](double v) { return FixedInteger::inUnits(v, range.lowest); };
  const auto rowFrom = [&](const Site& s) {
    return rowOf(in(s.x) - in(i.x), in(s.y) - in(i.y), FixedInteger());
  };
  const Row<FixedInteger> rowJ = rowFrom(j), rowK = rowFrom(k);
  const FixedInteger turn = rowJ.x * rowK.y - rowJ.y * rowK.x;
  const FixedInteger over =
      isX ? rowJ.p * rowK.y - rowK.p * rowJ.y : rowK.p * rowJ.x - rowJ.p * rowK.x;
  const FixedInteger own = in(isX ? i.x : i.y);
  // The coordinate is own + over / (2 turn).
  side = (over - turn * ((in(doubles.t) - own) + (in(doubles.next) - own))).sign();
  return true;
}

/// Are the numbers short enough for the exact stage of a quotient: forms of degree 16, 2 of them in
/// a double of any size?
bool haveFewDigits(std::initializer_list<const Site*> sites) {
  Range range;
  for (const Site* s : sites) range.include(*s);
  return range.highest - range.lowest < 500;
}

/// The circle in numbers of twice the digits: centre, and its distance rho from i, the reference
/// site. False if not even these know it.
bool findTwofoldCircle(const Site& i, const Site& j, const Site& k,
                       BoundedCenter<Twofold>& circle) {
  double largest = 0;
  for (const Site* s : {&j, &k})
    largest = std::max({largest, absolute(s->x - i.x), absolute(s->y - i.y), absolute(s->r - i.r)});
  const double scale = inputScale(largest);
  const auto times = [](const Twofold& x, double power) {
    return Twofold(power * x.value, power * x.rest);
  };
  const auto rowFrom = [&](const Site& s) {
    const auto part = [&](double a, double b) { return times(Twofold(a) - b, scale); };  // exact
    return rowOf(part(s.x, i.x), part(s.y, i.y), part(s.r, i.r));
  };
  const Row<Twofold> rowJ = rowFrom(j), rowK = rowFrom(k);
  const Row<Twofold> jk = rowOf(rowK.x - rowJ.x, rowK.y - rowJ.y, rowK.r - rowJ.r);
  if (findCenter(rowJ, rowK, jk, circle) != Existence::kYes) return false;
  for (Twofold* part : {&circle.x, &circle.y, &circle.rho}) *part = times(*part, 1 / scale);
  circle.error *= (1 + powerOfTwo(-5)) / scale;
  return true;
}

/// The nearest circle in doubles.
VoronoiCircle rounded(const BoundedCenter<Twofold>& circle, const Site& i) {
  VoronoiCircle result;
  result.x = (circle.x + i.x).value;
  result.y = (circle.y + i.y).value;
  result.s = circle.rho.value - i.r;
  result.error = roundedUp(
      2 * kUnitRoundoff *
      (2 * circle.rho.value + absolute(result.x) + absolute(result.y) + absolute(result.s)));
  return result;
}

/// The circle with errors of a few units in the last place. REQUIRES: i is the reference site.
VoronoiCircle closeCircle(Corner i, Corner j, Corner k) {
  VoronoiCircle circle = voronoiCircle(i, j, k);
  const double size = absolute(circle.x) + absolute(circle.y) + absolute(circle.s);
  const bool isKnown = circle.error < std::numeric_limits<float>::infinity();
  if (circle.isHalfPlane() || (isKnown && circle.error <= powerOfTwo(-40) * size)) return circle;
  BoundedCenter<Twofold> twofold;
  if (findTwofoldCircle(*i, *j, *k, twofold)) {
    // Seen from i, no part is larger than the distance.
    const double least = std::min(absolute(twofold.x.value), absolute(twofold.y.value));
    if (twofold.error <= kUnitRoundoff * least) return rounded(twofold, *i);
  }

  const LongFace face(*i, *j, *k);
  const Rounded c = withRoot(face.c.first, face.c.second, face.d);
  const auto quotient = [&](const LongFace::Number& number) {
    const Rounded over = withRoot(number.first, number.second, face.d);
    return scaled(over.mantissa / c.mantissa, over.exponent - c.exponent - 1);
  };
  circle.x = i->x + quotient(face.x);
  circle.y = i->y + quotient(face.y);
  const double rho = quotient(face.rho);
  circle.s = rho - i->r;
  // The error of each of the three quotients is at most 6.5 + 6.5 + 1 = 14 units of rho, and each
  // sum adds one unit of its own.
  const double error64 =
      16 * kUnitRoundoff * (3 * rho + absolute(circle.x) + absolute(circle.y) + absolute(circle.s));
  circle.error = error64 < 1e38 ? std::max(static_cast<float>(error64 * 1.01),
                                           std::numeric_limits<float>::min())
                                : std::numeric_limits<float>::infinity();
  return circle;
}

/// The circle with the centre, and its distance from i, rounded correctly, unless the sites have
/// too many digits. REQUIRES: i is the reference site.
VoronoiCircle correctCircle(const Site& i, const Site& j, const Site& k) {
  BoundedCenter<Twofold> twofold;
  const bool isKnown = findTwofoldCircle(i, j, k, twofold);
  const auto isCorrect = [&](const Twofold& part, double own) {
    return isKnown && isRounded(part + own, twofold.error);
  };
  if (isCorrect(twofold.x, i.x) && isCorrect(twofold.y, i.y) && isCorrect(twofold.rho, 0))
    return rounded(twofold, i);
  VoronoiCircle circle = closeCircle(&i, &j, &k);
  const double rho = circle.s + i.r;
  const bool isFinite = absolute(circle.x) + absolute(circle.y) + rho < kInfinite;
  if (!isFinite || !haveFewDigits({&i, &j, &k})) return circle;
  const bool haveEqualWeights = i.r == j.r && i.r == k.r;
  std::optional<LongFace> face;
  // own + `number` / (2c).
  const auto correct = [&](LongFace::Number LongFace::* part, double own, const Twofold& seen,
                           double estimate) {
    const Twofold found = seen + own;
    if (isCorrect(seen, own)) return found.value;
    // For points, a tie of two doubles is decided in shorter numbers.
    const bool areClose = isKnown && twofold.error < powerOfTwo(-70) * absolute(found.value);
    Sign side;
    if (areClose && haveEqualWeights && part != &LongFace::rho &&
        findSide(i, j, k, part == &LongFace::x, Candidates(found), side))
      return Candidates(found).nearest(side);
    if (!face) face.emplace(i, j, k);
    const LongFace::Number& number = (*face).*part;
    return correctQuotient(*face, own == 0 ? number : restAt(*face, number, Dyadic(-own)),
                           estimate);
  };
  circle.x = correct(&LongFace::x, i.x, twofold.x, circle.x);
  circle.y = correct(&LongFace::y, i.y, twofold.y, circle.y);
  circle.s = correct(&LongFace::rho, 0, twofold.rho, rho) - i.r;
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
