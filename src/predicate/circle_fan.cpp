#include "predicate/circle_fan.h"

#include <algorithm>
#include <limits>

#include "number/fp.h"
#include "number/pair.h"

namespace apollonius {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kLargestDifference = powerOfTwo(33);  // powers up to the twelfth are formed

// The arrays in numbers_, one after the other.
enum Array : std::size_t { kSiteX, kSiteY, kSiteR, kX, kY, kR, kP, kM, kL, kCircleX, kCircleY, kCircleS, kError, kArrays };

}  // namespace

void CircleFan::reserve(std::size_t n) {
  if (corners_.size() >= n) return;
  const std::size_t room = std::max(n, std::size_t{16}) * 3 / 2;
  const std::size_t stride = room + 2;  // the first two corners follow the last, for the last pair of faces
  numbers_.resize(kArrays * stride);
  stride_ = stride;
  corners_.resize(room);  // last: who looks at its size finds room in all
}

bool CircleFan::computeAll(const Site& q, std::size_t n) {
  double* const numbers = numbers_.data();
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    // The site at infinity gets some finite row; its faces are computed below.
    const Site& site = corners_[k] != nullptr ? *corners_[k] : q;
    const double x = site.x - q.x, y = site.y - q.y, r = site.r - q.r;
    const double xx = x * x, yy = y * y, rr = r * r;
    const double l = std::max(std::max(absolute(x), absolute(y)), absolute(r));
    largest = std::max(largest, l);
    numbers[kSiteX * stride_ + k] = site.x;
    numbers[kSiteY * stride_ + k] = site.y;
    numbers[kSiteR * stride_ + k] = site.r;
    numbers[kX * stride_ + k] = x;
    numbers[kY * stride_ + k] = y;
    numbers[kR * stride_ + k] = r;
    numbers[kP * stride_ + k] = xx + yy - rr;
    numbers[kM * stride_ + k] = xx + yy + rr;
    numbers[kL * stride_ + k] = l;
  }
  for (std::size_t a = kSiteX; a <= kL; ++a) {
    for (std::size_t k = 0; k < 2; ++k) numbers[a * stride_ + n + k] = numbers[a * stride_ + k];
  }
  if (!(largest < kLargestDifference)) return false;
  computeBounded(q, n);
  return true;
}

void CircleFan::compute(const Site& q, std::span<VoronoiCircle> circles) {
  const std::size_t n = circles.size();
  const bool isOrdinary = computeAll(q, n);
  const double* const numbers = numbers_.data();
  for (std::size_t k = 0; k < n; ++k) {
    const Corner j = corners_[k], l = corners_[k + 1 < n ? k + 1 : 0];
    const double error = numbers[kError * stride_ + k];
    if (isOrdinary && j != nullptr && l != nullptr && error < kInfinite) {
      circles[k] = {numbers[kCircleX * stride_ + k], numbers[kCircleY * stride_ + k], numbers[kCircleS * stride_ + k], roundedUp(error), -1};
    } else {
      circles[k] = voronoiCircle(j, l, &q);
    }
  }
}

/// The formulas and the bound are those of boundedCircle (voronoi_circle.cpp, where they are derived), seen from q, whose rows
/// are shared by neighbouring faces. One division serves all quotients, 1/(D den): 1/den = D · that, 1/p_j = p_k p_jk · den · that.
/// The computed D cancels, so f has five roundings more than the errors of p_j and den. Underflow: the last three conditions keep
/// D, D den and a component of the chord far above it, and what smaller products lose is far below the bound.
void CircleFan::computeBounded(const Site& q, std::size_t n) {
  constexpr double u1 = kUnitRoundoff;
  const Pair largestRelative = pairOf(powerOfTwo(-10)), zero = pairOf(0), tiny = pairOf(powerOfTwo(-900));
  const double* const in = numbers_.data();
  double* const out = numbers_.data();
  const auto load = [&](Array array, std::size_t k) { return loadPair(in + array * stride_ + k); };
  for (std::size_t k = 0; k < n; k += 2) {
    const Pair xj = load(kX, k), yj = load(kY, k), rj = load(kR, k);
    const Pair xk = load(kX, k + 1), yk = load(kY, k + 1), rk = load(kR, k + 1);
    const Pair pj = load(kP, k), pk = load(kP, k + 1);
    const Pair mj = load(kM, k), mk = load(kM, k + 1);
    const Pair lj = load(kL, k), lk = load(kL, k + 1);
    const Pair dx = load(kSiteX, k + 1) - load(kSiteX, k);
    const Pair dy = load(kSiteY, k + 1) - load(kSiteY, k);
    const Pair dr = load(kSiteR, k + 1) - load(kSiteR, k);
    const Pair dxy = dx * dx + dy * dy, drr = dr * dr;
    const Pair pjk = dxy - drr, mjk = dxy + drr;

    const Pair u = xk * pj - xj * pk, v = yk * pj - yj * pk, w = rk * pj - rj * pk;
    const Pair n2 = u * u + v * v;
    const Pair d = pjk * (pj * pk);
    const Pair rootD = root(d);
    const Pair a = v * rootD - w * u, b = -(u * rootD + w * v);
    const Pair den = a * xj + b * yj + n2 * rj;
    const Pair inverse = 1 / (d * den);
    const Pair inverseD = den * inverse, inverseDen = d * inverse;
    const Pair f = 0.5 * pj * inverseDen;
    const Pair rho = f * n2;
    const Pair x = q.x + f * a, y = q.y + f * b, s = rho - q.r;

    const Pair g = absolute(u) + absolute(v);
    const Pair eChord = 9 * u1 * (lk * mj + lj * mk);
    const Pair relativePj = 5 * u1 * mj * (pk * pjk * inverseD);
    const Pair relativeD = 2 * u1 + relativePj + 5 * u1 * ((mjk * pk + mk * pjk) * pj * inverseD);
    const Pair eAb = g * (rootD * (0.5 * relativeD + 2 * u1) + 3 * eChord + 4 * u1 * g);
    const Pair eN = g * (2 * eChord + 3 * u1 * g);
    const Pair relativeDen = lj * (2 * eAb + eN + 10 * u1 * g * g) * inverseDen;
    const Pair relativeF = relativePj + relativeDen + 8 * u1;
    const Pair error = f * (2 * eAb + eN) + 3 * rho * (relativeF + 2 * u1) + u1 * (absolute(x) + absolute(y) + absolute(s));
    const PairMask isGood = (eChord * g <= largestRelative * n2) & (relativeD <= largestRelative) & (relativeDen >= zero) &
                            (relativeDen <= largestRelative) & (pjk > zero) & (pj > zero) & (pk > zero) &
                            (n2 > pairOf(powerOfTwo(-400))) & (d > tiny) & (d * den > tiny);
    storePair(out + kCircleX * stride_ + k, x);
    storePair(out + kCircleY * stride_ + k, y);
    storePair(out + kCircleS * stride_ + k, s);
    storePair(out + kError * stride_ + k, isGood ? error * (1 + powerOfTwo(-5)) : pairOf(kInfinite));
  }
}

}  // namespace apollonius
