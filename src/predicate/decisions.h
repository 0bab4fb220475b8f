// The decisions of the predicates, once, as templates over the kind of rows (predicate/rows.h), which are what their stages differ by.
#pragma once

#include "number/root_sign.h"
#include "predicate/rows.h"
#include "predicate/stages.h"

namespace apollonius::stages {

// --- Depths of the formulas: how many roundings the filter's bound has to count (number/approx.h) --------------------------

inline constexpr Depth kInput{Depth::Input{}};
inline constexpr Row<Depth> kRow = rowOf(kInput, kInput, kInput);
inline constexpr VertexForm<Depth> kVertex{kRow, kRow, kRow};
inline constexpr Chord<Depth> kChord = chordOf(kRow, kRow);
inline constexpr EdgeForm<Depth> kEdge{kChord, kChord};
inline constexpr SpanForm<Depth> kSpan{kRow, kRow};
inline constexpr Depth kProducts = kRow.p * kRow.p - kRow.p * kRow.p;  // for signs that are computed without rounding

static_assert(kRow.p.roundings == 5, "x² and y² 3 each, their sum 4, less r² 5");
static_assert(kVertex.xy.roundings == 12, "minor 4, times p 10, two sums 12");
static_assert(kVertex.x.roundings == 22);
static_assert(kVertex.squares().roundings == 27);
static_assert(kEdge.along.roundings == 18 && kEdge.turn.roundings == 18, "chord 8, product 17, sum 18");
static_assert(EdgeForm<Depth>::squares(kChord, kChord, kEdge.along).roundings == 38);

// --- The decisions -------------------------------------------------------------------------------------------------------------

/// Rows 0, 1, 2 are j, k, q.
template <class Rows>
Sign vertexSign(Rows& rows) {
  using T = typename Rows::Number;
  if (rows.hasEqualWeights()) return -rows.sign(VertexForm<T>::xyOf(rows.row(0), rows.row(1), rows.row(2)), kVertex.xy);
  const VertexForm<T> form(rows.row(0), rows.row(1), rows.row(2));
  return signOfSum(rows.sign(form.x, kVertex.x), -rows.sign(form.xy, kVertex.xy),
                   [&] { return rows.sign(form.squares(), kVertex.squares()); });
}

/// Rows 0, 1, 2 are j, k, q on one circle with the pole. q is opposite to the pole on it exactly if, of the three products of tangent
/// lengths of opposite pairs, the one that pairs q with the pole is the largest (Casey's theorem).
template <class Rows>
bool isOppositePole(Rows& rows) {
  using T = typename Rows::Number;
  const Row<T> j = rows.row(0), k = rows.row(1), q = rows.row(2);
  const T opposite = q.p * between(j, k);
  return rows.sign(opposite - between(j, q) * k.p, kProducts) == Sign::kPositive &&
         rows.sign(opposite - between(k, q) * j.p, kProducts) == Sign::kPositive;
}

/// sign(±end.w · turn - √D · along): which side of an end of the edge the probe is on. `side` is + for the end at k, - at l.
template <class Rows, class T>
Sign edgeEndSign(Rows& rows, const Chord<T>& end, const Chord<T>& shadow, Sign side) {
  const EdgeForm<T> form(end, shadow);
  const Sign first = side * rows.sign(end.w, kChord.w) * rows.sign(form.turn, kEdge.turn);
  const Sign second = -rows.sign(form.along, kEdge.along);
  return signOfSum(first, second, [&] {
    return rows.sign(EdgeForm<T>::squares(end, shadow, form.along), EdgeForm<Depth>::squares(kChord, kChord, kEdge.along));
  });
}

/// Rows 0 … 3 are j, k, l, q; jIsInfinite tells whether the range may span more than a half turn, and then `spanSign` gives the sign
/// of SpanForm of rows 2 and 1.
template <class Rows, class SpanSign>
Sign edgeSign(Rows& rows, bool jIsInfinite, Probe probe, SpanSign&& spanSign) {
  using T = typename Rows::Number;
  const Row<T> j = rows.row(0);
  Chord<T> shadow = chordOf(j, rows.row(3));
  if (probe == Probe::kOpposite) shadow = {T(0) - shadow.u, T(0) - shadow.v, shadow.w};
  const Sign beforeK = edgeEndSign(rows, chordOf(j, rows.row(1)), shadow, Sign::kPositive);
  const Sign afterL = edgeEndSign(rows, chordOf(j, rows.row(2)), shadow, Sign::kNegative);
  if (beforeK == Sign::kPositive && afterL == Sign::kPositive) return Sign::kPositive;
  // A range of at most half a turn (all bounded edges, seen from the larger site) asks for both, a larger one for either.
  if (!jIsInfinite || (beforeK != Sign::kPositive && afterL != Sign::kPositive)) return Sign::kNegative;
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
