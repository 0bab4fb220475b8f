// Every polynomial of the predicates, once, as a template over the number type. The kernels
// (kernels.h, long_kernels.h) evaluate them over Approx, ExactDouble, FixedInteger and Dyadic, the
// circles over double and Ball. Over Roundings they count, at compile time, the roundings for the
// filters' error factors. Derivations: docs/PREDICATES.md; degrees are in the input coordinates.
//
// All of them look at the diagram from one finite site i, the reference site: other sites are rows
// of differences to it. The site at infinity is the row (0, 0, 0, 1), which makes the same formulas
// hold for unbounded faces and edges.
#pragma once

#include "number/approx.h"

namespace apollonius::internal {

/// A site seen from the reference site: differences x, y, r and p = x² + y² - r² (degree 2), the
/// squared length of the outer tangent.
template <class T>
struct Row {
  T x, y, r, p;
  bool isInfinite = false;
};

/// p of two sites from the differences of their coordinates and weights (degree 2).
template <class T>
constexpr T lorentz(const T& x, const T& y, const T& r) {
  return x * x + y * y - r * r;
}

template <class T>
constexpr Row<T> rowOf(const T& x, const T& y, const T& r) {
  return {x, y, r, lorentz(x, y, r), false};
}

template <class T>
constexpr Row<T> infinityRow() {
  return {T(0), T(0), T(0), T(1), true};
}

/// p of two sites given as rows; 1 if one of them is infinite (degree 2).
template <class T>
constexpr T between(const Row<T>& a, const Row<T>& b) {
  if (a.isInfinite || b.isInfinite) return T(1);
  return lorentz(a.x - b.x, a.y - b.y, a.r - b.r);
}

/// Where the bisectors of the reference site with `from` and with `to` meet: up to the positive
/// factor from.p * to.p, the line a u + b v + w = 0 in the plane of directions (a, b) from the
/// reference site (degree 3).
template <class T>
struct Chord {
  T u, v, w;
};

template <class T>
constexpr Chord<T> chordOf(const Row<T>& from, const Row<T>& to) {
  return {to.x * from.p - from.x * to.p, to.y * from.p - from.y * to.p,
          to.r * from.p - from.r * to.p};
}

/// Vertex conflict: rows j, k of a face (i, j, k) and q of the query.
/// conflict = sign(x - xy √(p_jk p_j p_k)).
template <class T>
struct VertexForm {
  // Determinants of the columns (x r p), (y r p), (x y p) over the rows j, k, q: degree 4.
  T xr, yr, xy;
  T x;  // degree 7

  constexpr VertexForm(const Row<T>& j, const Row<T>& k, const Row<T>& q)
      : xr(determinant(j.x, j.r, j.p, k.x, k.r, k.p, q.x, q.r, q.p)),
        yr(determinant(j.y, j.r, j.p, k.y, k.r, k.p, q.y, q.r, q.p)),
        xy(xyOf(j, k, q)),
        x((k.x * j.p - j.x * k.p) * xr + (k.y * j.p - j.y * k.p) * yr) {}

  /// xy alone, which decides where all weights are equal: xr, yr and x are zero then.
  [[nodiscard]] static constexpr T xyOf(const Row<T>& j, const Row<T>& k, const Row<T>& q) {
    return determinant(j.x, j.y, j.p, k.x, k.y, k.p, q.x, q.y, q.p);
  }

  /// x² - xy² p_jk p_j p_k without its positive factor u² + v² of chordOf(j, k): degree 8.
  [[nodiscard]] constexpr T squares() const { return xr * xr + yr * yr - xy * xy; }

 private:
  static constexpr T determinant(const T& aj, const T& bj, const T& pj, const T& ak, const T& bk,
                                 const T& pk, const T& aq, const T& bq, const T& pq) {
    return pj * (ak * bq - aq * bk) - pk * (aj * bq - aq * bj) + pq * (aj * bk - ak * bj);
  }
};

/// Edge conflict: the turn between the direction of an end of the edge (chord `end`, of j and t)
/// and the middle of the query's shadow (chord `shadow`). turn = sign(±end.w * turn - √D * along),
/// D = p_jt p_j p_t > 0.
template <class T>
struct EdgeForm {
  T turn;   // degree 6
  T along;  // degree 6

  constexpr EdgeForm(const Chord<T>& end, const Chord<T>& shadow)
      : turn(end.u * shadow.v - end.v * shadow.u), along(end.u * shadow.u + end.v * shadow.v) {}

  /// (w turn)² - D along² without its positive factor u² + v² of `end`: degree 12.
  [[nodiscard]] static constexpr T squares(const Chord<T>& end, const Chord<T>& shadow,
                                           const T& along) {
    return end.w * end.w * (shadow.u * shadow.u + shadow.v * shadow.v) - along * along;
  }
};

/// Unbounded edges: the terms for the turn between the half-planes (l, i) and (i, k) (span.h).
template <class T>
struct SpanForm {
  T cross, dot;  // products of the centres: degree 2
  T weights;     // r_l r_k: degree 2
  T tangents;    // p_l p_k: degree 4

  constexpr SpanForm(const Row<T>& l, const Row<T>& k)
      : cross(l.x * k.y - l.y * k.x),
        dot(l.x * k.x + l.y * k.y),
        weights(l.r * k.r),
        tangents(l.p * k.p) {}

  /// (r_l √p_k)² - (r_k √p_l)²: degree 4.
  [[nodiscard]] static constexpr T squares(const Row<T>& l, const Row<T>& k) {
    return l.r * l.r * k.p - k.r * k.r * l.p;
  }
};

/// How many roundings the filter's bound has to count (number/approx.h): the formulas over
/// Roundings.
namespace roundings {

inline constexpr Roundings kInput{Roundings::Input{}};
inline constexpr Row<Roundings> kRow = rowOf(kInput, kInput, kInput);
inline constexpr VertexForm<Roundings> kVertex{kRow, kRow, kRow};
inline constexpr Chord<Roundings> kChord = chordOf(kRow, kRow);
inline constexpr EdgeForm<Roundings> kEdge{kChord, kChord};
inline constexpr SpanForm<Roundings> kSpan{kRow, kRow};
/// An arrow from the reference site, as a chord; it has no w.
inline constexpr Chord<Roundings> kRay{kInput, kInput, kInput};
inline constexpr EdgeForm<Roundings> kRayForm{kChord, kRay};
/// xy of points whose differences are exact.
inline constexpr Row<Roundings> kPoint{0, 0, 0, Roundings(0) * 0 + Roundings(0) * 0, false};
inline constexpr Roundings kVertexOfPoints = VertexForm<Roundings>::xyOf(kPoint, kPoint, kPoint);
/// Difference of two products of the degenerate rule.
inline constexpr Roundings kProducts = kRow.p * between(kRow, kRow) - kRow.p * between(kRow, kRow);

static_assert(kRow.p.count == 5, "x² and y² 3 each, their sum 4, less r² 5");
static_assert(kProducts.count == 14, "p of two rows 7, times p 13, difference 14");
static_assert(kVertex.xy.count == 12, "minor 4, times p 10, two sums 12");
static_assert(kVertexOfPoints.count == 7, "minor 2, times p 5, two sums 7");
static_assert(kVertex.x.count == 22);
static_assert(kVertex.squares().count == 27);
static_assert(kChord.w.count == 8, "product 7, difference 8");
static_assert(kEdge.along.count == 18 && kEdge.turn.count == 18, "chord 8, product 17, sum 18");
static_assert(EdgeForm<Roundings>::squares(kChord, kChord, kEdge.along).count == 38);
static_assert(kRayForm.along.count == 11 && kRayForm.turn.count == 11,
              "chord 8, product 10, sum 11");
static_assert(EdgeForm<Roundings>::squares(kChord, kRay, kRayForm.along).count == 24);
static_assert(kSpan.cross.count == 4 && kSpan.tangents.count == 11);
static_assert(((kSpan.weights - kSpan.dot) * (kSpan.weights - kSpan.dot) - kSpan.tangents).count ==
              12);

}  // namespace roundings

}  // namespace apollonius::internal
