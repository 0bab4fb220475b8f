// The decisions of the predicates, once, as templates over the kind of rows (predicate/kernels.h),
// which are what their stages differ by.
#pragma once

#include "number/root_sign.h"
#include "predicate/kernels.h"
#include "predicate/stages.h"

namespace apollonius::stages {

// --- Depths of the formulas: how many roundings the filter's bound has to count (number/approx.h)

inline constexpr Depth kInput{Depth::Input{}};
inline constexpr Row<Depth> kRow = rowOf(kInput, kInput, kInput);
inline constexpr VertexForm<Depth> kVertex{kRow, kRow, kRow};
inline constexpr Chord<Depth> kChord = chordOf(kRow, kRow);
inline constexpr EdgeForm<Depth> kEdge{kChord, kChord};
inline constexpr SpanForm<Depth> kSpan{kRow, kRow};
inline constexpr Chord<Depth> kRay{kInput, kInput, kInput};  // an arrow from the pole; it has no w
inline constexpr EdgeForm<Depth> kRayForm{kChord, kRay};
inline constexpr Depth kProducts = kRow.p * between(kRow, kRow) - kRow.p * between(kRow, kRow);

static_assert(kRow.p.roundings == 5, "x² and y² 3 each, their sum 4, less r² 5");
static_assert(kProducts.roundings == 14, "p of two rows 7, times p 13, difference 14");
static_assert(kVertex.xy.roundings == 12, "minor 4, times p 10, two sums 12");
static_assert(kVertex.x.roundings == 22);
static_assert(kVertex.squares().roundings == 27);
static_assert(kEdge.along.roundings == 18 && kEdge.turn.roundings == 18,
              "chord 8, product 17, sum 18");
static_assert(EdgeForm<Depth>::squares(kChord, kChord, kEdge.along).roundings == 38);
static_assert(kRayForm.along.roundings == 11 && kRayForm.turn.roundings == 11,
              "chord 8, product 10, sum 11");
static_assert(EdgeForm<Depth>::squares(kChord, kRay, kRayForm.along).roundings == 24);

// --- The decisions

/// Rows 0, 1, 2 are j, k, q.
template <class Rows>
Sign vertexSign(Rows& rows) {
  using T = typename Rows::Number;
  if (rows.hasEqualWeights())
    return -rows.sign(VertexForm<T>::xyOf(rows.row(0), rows.row(1), rows.row(2)), kVertex.xy);
  const VertexForm<T> form(rows.row(0), rows.row(1), rows.row(2));
  return signOfSum(rows.sign(form.x, kVertex.x), -rows.sign(form.xy, kVertex.xy),
                   [&] { return rows.sign(form.squares(), kVertex.squares()); });
}

/// Rows 0, 1, 2 are j, k, q on one circle (or line) with the pole. q is opposite to a corner of the
/// face on it exactly if, of the three ways to pair the four, the one that pairs q with this corner
/// has the largest product of tangent lengths (Casey's theorem).
template <class Rows>
bool isOpposite(Rows& rows, FaceCorner corner) {
  using T = typename Rows::Number;
  const Row<T> j = rows.row(0), k = rows.row(1), q = rows.row(2);
  const std::array<T, 3> products{q.p * between(j, k), between(j, q) * k.p, between(k, q) * j.p};
  const auto n = static_cast<std::size_t>(corner);
  return rows.sign(products[n] - products[(n + 1) % 3], kProducts) == Sign::kPositive &&
         rows.sign(products[n] - products[(n + 2) % 3], kProducts) == Sign::kPositive;
}

/// sign(±end.w · turn - √D · along): which side of an end of the edge the probe is on. `side` is +
/// for the end at k, - at l.
template <class Rows, class T>
Sign edgeEndSign(Rows& rows, const Chord<T>& end, const Chord<T>& shadow, Sign side) {
  const EdgeForm<T> form(end, shadow);
  const Sign first = side * rows.sign(end.w, kChord.w) * rows.sign(form.turn, kEdge.turn);
  const Sign second = -rows.sign(form.along, kEdge.along);
  return signOfSum(first, second, [&] {
    return rows.sign(EdgeForm<T>::squares(end, shadow, form.along),
                     EdgeForm<Depth>::squares(kChord, kChord, kEdge.along));
  });
}

/// Rows 0, 1 are j, k of a face of the pole's, row 2 a point. Up to a positive factor, the
/// direction d of the face's vertex is (√D v - w u, -√D u - w v) for the chord (u, v, w) from j to
/// k. So with turn = u y - v x and along = u x + v y of the point (x, y):
///     cross(d, point) = √D along - w turn,     dot(d, point) = -√D turn - w along,
/// and, as D = u² + v² - w², the squares of the two terms differ by (along² - w² (x² + y²)) (u² +
/// v²), or the same with turn².
template <class Rows>
Sign raySign(Rows& rows, RayPart part) {
  using T = typename Rows::Number;
  const Row<T> point = rows.row(2);
  const Chord<T> end = chordOf(rows.row(0), rows.row(1));
  const Chord<T> ray{point.x, point.y, T(0)};
  const EdgeForm<T> form(end, ray);
  const bool isLeftwards = part == RayPart::kLeftwards;
  const T& rooted = isLeftwards ? form.along : form.turn;  // the factor of √D
  const T& other = isLeftwards ? form.turn : form.along;
  const Sign first =
      isLeftwards ? rows.sign(rooted, kRayForm.along) : -rows.sign(rooted, kRayForm.turn);
  if (rows.hasEqualWeights()) return first;
  const Sign second = -(rows.sign(end.w, kChord.w) * rows.sign(other, kRayForm.turn));
  return signOfSum(first, second, [&] {
    return -rows.sign(EdgeForm<T>::squares(end, ray, rooted),
                      EdgeForm<Depth>::squares(kChord, kRay, kRayForm.along));
  });
}

/// Rows 0 … 3 are j, k, l, q; jIsInfinite tells whether the range may span more than a half turn,
/// and then `spanSign` gives the sign of SpanForm of rows 2 and 1.
template <class Rows, class SpanSign>
Sign edgeSign(Rows& rows, bool jIsInfinite, Probe probe, SpanSign&& spanSign) {
  using T = typename Rows::Number;
  const Row<T> j = rows.row(0);
  Chord<T> shadow = chordOf(j, rows.row(3));
  if (probe == Probe::kOpposite) shadow = {T(0) - shadow.u, T(0) - shadow.v, shadow.w};
  const Sign beforeK = edgeEndSign(rows, chordOf(j, rows.row(1)), shadow, Sign::kPositive);
  const Sign afterL = edgeEndSign(rows, chordOf(j, rows.row(2)), shadow, Sign::kNegative);
  if (beforeK == Sign::kPositive && afterL == Sign::kPositive) return Sign::kPositive;
  // A range of at most half a turn (all bounded edges, seen from the larger site) asks for both, a
  // larger one for either.
  if (!jIsInfinite || (beforeK != Sign::kPositive && afterL != Sign::kPositive))
    return Sign::kNegative;
  return -spanSign();
}

/// Rows 0, 1, 2 are j, l, k: the turn from the middle of l's shadow to that of k's.
template <class Rows>
Sign shadowTurnSign(Rows& rows) {
  using T = typename Rows::Number;
  const Row<T> j = rows.row(0);
  return rows.sign(EdgeForm<T>(chordOf(j, rows.row(1)), chordOf(j, rows.row(2))).turn, kEdge.turn);
}

}  // namespace apollonius::stages
