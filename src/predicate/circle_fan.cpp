#include "predicate/circle_fan.h"

#include <algorithm>
#include <limits>

#include "number/fp.h"
#include "number/pair.h"
#include "predicate/compute_circle.h"

namespace apollonius::internal {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kLargestDifference = powerOfTwo(33);  // powers up to the twelfth are formed

// The arrays in numbers_, one after the other.
enum Array : std::size_t {
  kSiteX,
  kSiteY,
  kSiteR,
  kX,
  kY,
  kR,
  kP,
  kM,
  kL,
  kReferenceX,
  kReferenceY,
  kReferenceR,
  kCircleX,
  kCircleY,
  kCircleS,
  kError,
  kArrays
};

}  // namespace

void CircleFan::reserve(std::size_t n) {
  if (corners_.size() >= n) return;
  const std::size_t room = std::max(n, std::size_t{16}) * 3 / 2;
  // The first two corners follow the last, for the last pair of faces.
  const std::size_t stride = room + 2;
  numbers_.resize(kArrays * stride);
  stride_ = stride;
  corners_.resize(room);  // last: its size tells that there is room in all
}

/// Row k: the site, seen from the reference site. Returns the largest difference.
inline double CircleFan::setRow(std::size_t k, const Site& reference, const Site& site) {
  double* const numbers = numbers_.data() + k;
  const double x = site.x - reference.x, y = site.y - reference.y, r = site.r - reference.r;
  const double xx = x * x, yy = y * y, rr = r * r;
  const double l = std::max(std::max(absolute(x), absolute(y)), absolute(r));
  numbers[kSiteX * stride_] = site.x;
  numbers[kSiteY * stride_] = site.y;
  numbers[kSiteR * stride_] = site.r;
  numbers[kX * stride_] = x;
  numbers[kY * stride_] = y;
  numbers[kR * stride_] = r;
  numbers[kP * stride_] = xx + yy - rr;
  numbers[kM * stride_] = xx + yy + rr;
  numbers[kL * stride_] = l;
  return l;
}

inline void CircleFan::setReference(std::size_t k, const Site& reference) {
  numbers_[kReferenceX * stride_ + k] = reference.x;
  numbers_[kReferenceY * stride_ + k] = reference.y;
  numbers_[kReferenceR * stride_ + k] = reference.r;
}

inline VoronoiCircle CircleFan::circle(std::size_t k) const {
  const double* const numbers = numbers_.data() + k;
  return {numbers[kCircleX * stride_], numbers[kCircleY * stride_], numbers[kCircleS * stride_],
          roundedUp(numbers[kError * stride_]), -1};
}

bool CircleFan::computeAll(const Site& q, std::size_t n) {
  double* const numbers = numbers_.data();
  double largest = 0;
  // The site at infinity gets some finite row; its faces are computed below.
  for (std::size_t k = 0; k < n; ++k)
    largest = std::max(largest, setRow(k, q, corners_[k] != nullptr ? *corners_[k] : q));
  for (std::size_t a = kSiteX; a <= kL; ++a) {
    for (std::size_t k = 0; k < 2; ++k) numbers[a * stride_ + n + k] = numbers[a * stride_ + k];
  }
  if (!(largest < kLargestDifference)) return false;
  setReference(0, q);
  setReference(1, q);
  computeBounded(n, 1, 0);
  return true;
}

void CircleFan::compute(const Site& q, std::span<VoronoiCircle> circles) {
  const std::size_t n = circles.size();
  const bool isOrdinary = computeAll(q, n);
  for (std::size_t k = 0; k < n; ++k) {
    const Corner j = corners_[k], l = corners_[k + 1 < n ? k + 1 : 0];
    const bool isKnown =
        isOrdinary && j != nullptr && l != nullptr && numbers_[kError * stride_ + k] < kInfinite;
    circles[k] = isKnown ? circle(k) : voronoiCircle(j, l, &q);
  }
}

void CircleFan::computeFaces(std::span<const std::array<Corner, 3>> faces,
                             std::span<VoronoiCircle> circles) {
  const std::size_t n = faces.size();
  double largest = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Site& reference = *faces[k][0];
    setReference(k, reference);
    largest = std::max(largest, std::max(setRow(k, reference, *faces[k][1]),
                                         setRow(n + k, reference, *faces[k][2])));
  }
  computeBounded(n, n, ~std::size_t{0});
  for (std::size_t k = 0; k < n; ++k) {
    circles[k] = circle(k);
    if (!(largest < kLargestDifference)) circles[k].error = std::numeric_limits<float>::infinity();
  }
}

/// Circles of the faces of the reference site and rows k and `second` + k, for k < n (the last pair
/// may read one more of each). Reference site k is at k & referenceMask.
///
/// The formulas and the bound are those of boundedCircle (compute_circle.cpp, where they are
/// derived), with reference sites of any size. One division serves all quotients, 1/(D den): 1/den
/// = D · that, 1/p_j = p_k p_jk · den · that. The computed D cancels, so f has five roundings more
/// than the errors of p_j and den. Underflow: the last three conditions keep D, D den and a
/// component of the chord far above it, and what smaller products lose is far below the bound.
void CircleFan::computeBounded(std::size_t n, std::size_t second, std::size_t referenceMask) {
  constexpr double u1 = kUnitRoundoff;
  const Pair largestRelative = pairOf(powerOfTwo(-10)), zero = pairOf(0),
             tiny = pairOf(powerOfTwo(-900));
  const double* const in = numbers_.data();
  double* const out = numbers_.data();
  const auto load = [&](Array array, std::size_t k) { return loadPair(in + array * stride_ + k); };
  for (std::size_t k = 0; k < n; k += 2) {
    const Pair xj = load(kX, k), yj = load(kY, k), rj = load(kR, k);
    const Pair xk = load(kX, k + second), yk = load(kY, k + second), rk = load(kR, k + second);
    const Pair pj = load(kP, k), pk = load(kP, k + second);
    const Pair mj = load(kM, k), mk = load(kM, k + second);
    const Pair lj = load(kL, k), lk = load(kL, k + second);
    const Pair dx = load(kSiteX, k + second) - load(kSiteX, k);
    const Pair dy = load(kSiteY, k + second) - load(kSiteY, k);
    const Pair dr = load(kSiteR, k + second) - load(kSiteR, k);
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
    const std::size_t reference = k & referenceMask;
    const Pair x = load(kReferenceX, reference) + f * a, y = load(kReferenceY, reference) + f * b,
               s = rho - load(kReferenceR, reference);

    const Pair g = absolute(u) + absolute(v);
    const Pair eChord = 9 * u1 * (lk * mj + lj * mk);
    const Pair relativePj = 5 * u1 * mj * (pk * pjk * inverseD);
    const Pair relativeD = 2 * u1 + relativePj + 5 * u1 * ((mjk * pk + mk * pjk) * pj * inverseD);
    const Pair eAb = g * (rootD * (0.5 * relativeD + 2 * u1) + 3 * eChord + 4 * u1 * g);
    const Pair eN = g * (2 * eChord + 3 * u1 * g);
    const Pair relativeDen = lj * (2 * eAb + eN + 10 * u1 * g * g) * inverseDen;
    const Pair relativeF = relativePj + relativeDen + 8 * u1;
    const Pair error = f * (2 * eAb + eN) + 3 * rho * (relativeF + 2 * u1) +
                       u1 * (absolute(x) + absolute(y) + absolute(s));
    const PairMask isGood = (eChord * g <= largestRelative * n2) & (relativeD <= largestRelative) &
                            (relativeDen >= zero) & (relativeDen <= largestRelative) &
                            (pjk > zero) & (pj > zero) & (pk > zero) &
                            (n2 > pairOf(powerOfTwo(-400))) & (d > tiny) & (d * den > tiny);
    storePair(out + kCircleX * stride_ + k, x);
    storePair(out + kCircleY * stride_ + k, y);
    storePair(out + kCircleS * stride_ + k, s);
    storePair(out + kError * stride_ + k,
              isGood ? error * (1 + powerOfTwo(-5)) : pairOf(kInfinite));
  }
}

}  // namespace apollonius::internal
