#include "predicate/circle_fan.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

#include "base/infinite.h"
#include "number/fp.h"
#include "number/pair.h"
#include "predicate/compute_circle.h"

namespace apollonius::internal {

namespace {

constexpr double kLargestDifference = powerOfTwo(33);  // powers up to the twelfth are formed

/// Two sites, and how they are seen from reference sites.
struct Rows {
  Pair siteX, siteY, siteR;
  Pair x, y, r;
  Pair p, m;  // x² + y² - r² and x² + y² + r²
  Pair l;     // the largest of |x|, |y|, |r|
};

struct References {
  Pair x, y, r;
};

struct Circles {
  Pair x, y, s, error;
};

inline Rows rowsOf(const Site& a, const Site& b, const References& from) {
  Rows row;
  const Pair atA = loadPair(&a.x), atB = loadPair(&b.x);
  row.siteX = firsts(atA, atB);
  row.siteY = seconds(atA, atB);
  row.siteR = Pair{a.r, b.r};
  row.x = row.siteX - from.x;
  row.y = row.siteY - from.y;
  row.r = row.siteR - from.r;
  const Pair xy = row.x * row.x + row.y * row.y, rr = row.r * row.r;
  row.p = xy - rr;
  row.m = xy + rr;
  row.l = larger(larger(absolute(row.x), absolute(row.y)), absolute(row.r));
  return row;
}

/// The second of `a` and the first of `b`.
inline Rows between(const Rows& a, const Rows& b) {
  return {middles(a.siteX, b.siteX), middles(a.siteY, b.siteY), middles(a.siteR, b.siteR),
          middles(a.x, b.x),         middles(a.y, b.y),         middles(a.r, b.r),
          middles(a.p, b.p),         middles(a.m, b.m),         middles(a.l, b.l)};
}

/// Circles of two faces: of a reference site and a site of `j` and of `k` each. The error is
/// infinite where it is not certain that there is one.
///
/// The formulas and the bound are those of findCenter (bounded_center.h, where they are
/// derived), with reference sites of any size. One division serves all quotients, 1/(D den): 1/den
/// = D · that, 1/p_j = p_k p_jk · den · that. The computed D cancels, so f has five roundings more
/// than the errors of p_j and den. Underflow: the last three conditions keep D, D den and a
/// component of the chord far above it, and what smaller products lose is far below the bound.
inline Circles circlesOf(const References& reference, const Rows& j, const Rows& k) {
  constexpr double u1 = kUnitRoundoff;
  const Pair largestRelative = pairOf(powerOfTwo(-10)), tiny = pairOf(powerOfTwo(-900)),
             zero = pairOf(0);
  const Pair dx = k.siteX - j.siteX, dy = k.siteY - j.siteY, dr = k.siteR - j.siteR;
  const Pair dxy = dx * dx + dy * dy, drr = dr * dr;
  const Pair pjk = dxy - drr, mjk = dxy + drr;

  const Pair u = k.x * j.p - j.x * k.p, v = k.y * j.p - j.y * k.p, w = k.r * j.p - j.r * k.p;
  const Pair n2 = u * u + v * v;
  const Pair d = pjk * (j.p * k.p);
  const Pair rootD = root(d);
  const Pair a = v * rootD - w * u, b = -(u * rootD + w * v);
  const Pair den = a * j.x + b * j.y + n2 * j.r;
  const Pair inverse = 1 / (d * den);
  const Pair inverseD = den * inverse, inverseDen = d * inverse;
  const Pair f = 0.5 * j.p * inverseDen;
  const Pair rho = f * n2;
  Circles circle;
  circle.x = reference.x + f * a;
  circle.y = reference.y + f * b;
  circle.s = rho - reference.r;

  const Pair g = absolute(u) + absolute(v);
  const Pair eChord = 9 * u1 * (k.l * j.m + j.l * k.m);
  const Pair relativePj = 5 * u1 * j.m * (k.p * pjk * inverseD);
  const Pair relativeD = 2 * u1 + relativePj + 5 * u1 * ((mjk * k.p + k.m * pjk) * j.p * inverseD);
  const Pair eAb = g * (rootD * (0.5 * relativeD + 2 * u1) + 3 * eChord + 4 * u1 * g);
  const Pair eN = g * (2 * eChord + 3 * u1 * g);
  const Pair relativeDen = j.l * (2 * eAb + eN + 10 * u1 * g * g) * inverseDen;
  const Pair relativeF = relativePj + relativeDen + 8 * u1;
  const Pair error = f * (2 * eAb + eN) + 3 * rho * (relativeF + 2 * u1) +
                     u1 * (absolute(circle.x) + absolute(circle.y) + absolute(circle.s));
  const PairMask isGood = (eChord * g <= largestRelative * n2) & (relativeD <= largestRelative) &
                          (relativeDen >= zero) & (relativeDen <= largestRelative) & (pjk > zero) &
                          (j.p > zero) & (k.p > zero) & (n2 > pairOf(powerOfTwo(-400))) &
                          (d > tiny) & (d * den > tiny);
  circle.error = isGood ? error * (1 + powerOfTwo(-5)) : pairOf(kInfinite);
  return circle;
}

/// Bounds are at least those of roundedUp().
inline void store(const Circles& circles, VoronoiCircle& first, VoronoiCircle& second) {
  const Pair bounds =
      floatsBefore(circles.error * (1 + powerOfTwo(-22)) + powerOfTwo(-126), VoronoiCircle{}.slope);
  static_assert(offsetof(VoronoiCircle, error) == 3 * sizeof(double) &&
                offsetof(VoronoiCircle, slope) == 3 * sizeof(double) + sizeof(float));
  first = std::bit_cast<VoronoiCircle>(
      std::array{firsts(circles.x, circles.y), firsts(circles.s, bounds)});
  second = std::bit_cast<VoronoiCircle>(
      std::array{seconds(circles.x, circles.y), seconds(circles.s, bounds)});
}

inline bool areBelow(Pair numbers, double limit) {
  return numbers[0] < limit && numbers[1] < limit;
}

}  // namespace

void CircleFan::reserve(std::size_t n) {
  const std::size_t room = n + kRepeated;
  if (corners_.size() < room) corners_.resize(std::max(room, std::size_t{24}) * 3 / 2);
}

void CircleFan::compute(const Site& q, std::span<VoronoiCircle> circles) {
  const std::size_t n = circles.size();
  Corner* const corners = corners_.data();
  for (std::size_t k = 0; k < kRepeated; ++k) corners[n + k] = corners[k < n ? k : 0];
  // The site at infinity gets some finite row; its faces are computed below.
  const auto siteOf = [&](Corner corner) -> const Site& { return corner != nullptr ? *corner : q; };
  const References reference{pairOf(q.x), pairOf(q.y), pairOf(q.r)};
  Rows j = rowsOf(siteOf(corners[0]), siteOf(corners[1]), reference);
  Pair largest = j.l, worst = pairOf(0);
  for (std::size_t k = 0; k < n; k += 2) {
    const Rows next = rowsOf(siteOf(corners[k + 2]), siteOf(corners[k + 3]), reference);
    const Circles two = circlesOf(reference, j, between(j, next));
    VoronoiCircle beyond;
    store(two, circles[k], k + 1 < n ? circles[k + 1] : beyond);
    worst = larger(worst, two.error);
    largest = larger(largest, next.l);
    j = next;
  }
  const bool isOrdinary = areBelow(largest, kLargestDifference);
  if (isOrdinary && areBelow(worst, kInfinite)) return;
  for (std::size_t k = 0; k < n; ++k) {
    const Corner from = corners[k], to = corners[k + 1];
    const bool isKnown = isOrdinary && from != nullptr && to != nullptr &&
                         circles[k].error < std::numeric_limits<float>::infinity();
    if (!isKnown) circles[k] = voronoiCircle(from, to, &q);
  }
}

void CircleFan::computeFaces(std::span<const std::array<Corner, 3>> faces,
                             std::span<VoronoiCircle> circles) {
  const std::size_t n = faces.size();
  Pair largest = pairOf(0);
  for (std::size_t k = 0; k < n; k += 2) {
    const std::array<Corner, 3>&first = faces[k], &second = faces[k + 1 < n ? k + 1 : k];
    const Pair atA = loadPair(&first[0]->x), atB = loadPair(&second[0]->x);
    const References reference{firsts(atA, atB), seconds(atA, atB), {first[0]->r, second[0]->r}};
    const Rows j = rowsOf(*first[1], *second[1], reference);
    const Rows l = rowsOf(*first[2], *second[2], reference);
    VoronoiCircle beyond;
    store(circlesOf(reference, j, l), circles[k], k + 1 < n ? circles[k + 1] : beyond);
    largest = larger(largest, larger(j.l, l.l));
  }
  if (areBelow(largest, kLargestDifference)) return;
  for (std::size_t k = 0; k < n; ++k) circles[k].error = std::numeric_limits<float>::infinity();
}

}  // namespace apollonius::internal
