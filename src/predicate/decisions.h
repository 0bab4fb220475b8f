// The decisions of the predicates, once, as templates over the kind of rows (predicate/kernels.h),
// which are what their stages differ by.
#pragma once

#include "number/root_sign.h"
#include "predicate/kernels.h"
#include "predicate/stages.h"

namespace apollonius::stages {

// --- Roundings of the formulas: how many roundings the filter's bound has to count
// (number/approx.h)

inline constexpr Roundings kInput{Roundings::Input{}};
inline constexpr Row<Roundings> kRow = rowOf(kInput, kInput, kInput);
inline constexpr VertexForm<Roundings> kVertex{kRow, kRow, kRow};
inline constexpr Chord<Roundings> kChord = chordOf(kRow, kRow);
inline constexpr EdgeForm<Roundings> kEdge{kChord, kChord};
inline constexpr SpanForm<Roundings> kSpan{kRow, kRow};
inline constexpr Chord<Roundings> kRay{kInput, kInput,
                                       kInput};  // an arrow from the reference site; it has no w
inline constexpr EdgeForm<Roundings> kRayForm{kChord, kRay};
inline constexpr Roundings kProducts = kRow.p * between(kRow, kRow) - kRow.p * between(kRow, kRow);

static_assert(kRow.p.count == 5, "x² and y² 3 each, their sum 4, less r² 5");
static_assert(kProducts.count == 14, "p of two rows 7, times p 13, difference 14");
static_assert(kVertex.xy.count == 12, "minor 4, times p 10, two sums 12");
static_assert(kVertex.x.count == 22);
static_assert(kVertex.squares().count == 27);
static_assert(kEdge.along.count == 18 && kEdge.turn.count == 18, "chord 8, product 17, sum 18");
static_assert(EdgeForm<Roundings>::squares(kChord, kChord, kEdge.along).count == 38);
static_assert(kRayForm.along.count == 11 && kRayForm.turn.count == 11,
              "chord 8, product 10, sum 11");
static_assert(EdgeForm<Roundings>::squares(kChord, kRay, kRayForm.along).count == 24);

// --- The decisions

/// Rows 0, 1, 2 are j, k, q.
template <class Kernel>
Sign vertexSign(Kernel& kernel) {
  using T = typename Kernel::Number;
  if (kernel.hasEqualWeights())
    return -kernel.sign(VertexForm<T>::xyOf(kernel.row(0), kernel.row(1), kernel.row(2)),
                        kVertex.xy);
  const VertexForm<T> form(kernel.row(0), kernel.row(1), kernel.row(2));
  return signOfSum(kernel.sign(form.x, kVertex.x), -kernel.sign(form.xy, kVertex.xy),
                   [&] { return kernel.sign(form.squares(), kVertex.squares()); });
}

/// Rows 0, 1, 2 are j, k, q on one circle (or line) with the reference site. q is opposite to a
/// corner of the face on it exactly if, of the three ways to pair the four, the one that pairs q
/// with this corner has the largest product of tangent lengths (Casey's theorem).
template <class Kernel>
bool isOpposite(Kernel& kernel, FaceCorner corner) {
  using T = typename Kernel::Number;
  const Row<T> j = kernel.row(0), k = kernel.row(1), q = kernel.row(2);
  const std::array<T, 3> products{q.p * between(j, k), between(j, q) * k.p, between(k, q) * j.p};
  const auto n = static_cast<std::size_t>(corner);
  return kernel.sign(products[n] - products[(n + 1) % 3], kProducts) == Sign::kPositive &&
         kernel.sign(products[n] - products[(n + 2) % 3], kProducts) == Sign::kPositive;
}

/// sign(±end.w · turn - √D · along): which side of an end of the edge the probe is on. `side` is +
/// for the end at k, - at l.
template <class Kernel, class T>
Sign edgeEndSign(Kernel& kernel, const Chord<T>& end, const Chord<T>& shadow, Sign side) {
  const EdgeForm<T> form(end, shadow);
  const Sign first = side * kernel.sign(end.w, kChord.w) * kernel.sign(form.turn, kEdge.turn);
  const Sign second = -kernel.sign(form.along, kEdge.along);
  return signOfSum(first, second, [&] {
    return kernel.sign(EdgeForm<T>::squares(end, shadow, form.along),
                       EdgeForm<Roundings>::squares(kChord, kChord, kEdge.along));
  });
}

/// Rows 0, 1 are j, k of a face of the reference site's, row 2 a point. Up to a positive factor,
/// the direction d of the face's vertex is (√D v - w u, -√D u - w v) for the chord (u, v, w) from j
/// to k. So with turn = u y - v x and along = u x + v y of the point (x, y):
///     cross(d, point) = √D along - w turn,     dot(d, point) = -√D turn - w along,
/// and, as D = u² + v² - w², the squares of the two terms differ by (along² - w² (x² + y²)) (u² +
/// v²), or the same with turn².
template <class Kernel>
Sign raySign(Kernel& kernel, RayPart part) {
  using T = typename Kernel::Number;
  const Row<T> point = kernel.row(2);
  const Chord<T> end = chordOf(kernel.row(0), kernel.row(1));
  const Chord<T> ray{point.x, point.y, T(0)};
  const EdgeForm<T> form(end, ray);
  const bool isLeftwards = part == RayPart::kLeftwards;
  const T& rooted = isLeftwards ? form.along : form.turn;  // the factor of √D
  const T& other = isLeftwards ? form.turn : form.along;
  const Sign first =
      isLeftwards ? kernel.sign(rooted, kRayForm.along) : -kernel.sign(rooted, kRayForm.turn);
  if (kernel.hasEqualWeights()) return first;
  const Sign second = -(kernel.sign(end.w, kChord.w) * kernel.sign(other, kRayForm.turn));
  return signOfSum(first, second, [&] {
    return -kernel.sign(EdgeForm<T>::squares(end, ray, rooted),
                        EdgeForm<Roundings>::squares(kChord, kRay, kRayForm.along));
  });
}

/// Rows 0 … 3 are j, k, l, q; jIsInfinite tells whether the range may span more than a half turn,
/// and then `spanSign` gives the sign of SpanForm of rows 2 and 1.
template <class Kernel, class SpanSign>
Sign edgeSign(Kernel& kernel, bool jIsInfinite, Probe probe, SpanSign&& spanSign) {
  using T = typename Kernel::Number;
  const Row<T> j = kernel.row(0);
  Chord<T> shadow = chordOf(j, kernel.row(3));
  if (probe == Probe::kOpposite) shadow = {T(0) - shadow.u, T(0) - shadow.v, shadow.w};
  const Sign beforeK = edgeEndSign(kernel, chordOf(j, kernel.row(1)), shadow, Sign::kPositive);
  const Sign afterL = edgeEndSign(kernel, chordOf(j, kernel.row(2)), shadow, Sign::kNegative);
  if (beforeK == Sign::kPositive && afterL == Sign::kPositive) return Sign::kPositive;
  // A range of at most half a turn (all bounded edges, seen from the larger site) asks for both, a
  // larger one for either.
  if (!jIsInfinite || (beforeK != Sign::kPositive && afterL != Sign::kPositive))
    return Sign::kNegative;
  return -spanSign();
}

/// Rows 0, 1, 2 are j, l, k: the turn from the middle of l's shadow to that of k's.
template <class Kernel>
Sign shadowTurnSign(Kernel& kernel) {
  using T = typename Kernel::Number;
  const Row<T> j = kernel.row(0);
  return kernel.sign(EdgeForm<T>(chordOf(j, kernel.row(1)), chordOf(j, kernel.row(2))).turn,
                     kEdge.turn);
}

}  // namespace apollonius::stages
