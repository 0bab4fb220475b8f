// The identities of docs/PREDICATES.md, written out here from the document (not from
// src/predicate/formulas.h) and evaluated on random integers; and formulas.h against them. A
// polynomial identity of degree 18 that holds at thousands of random points of 2^20 values per
// variable holds everywhere, except with negligible probability (Schwartz, Zippel).
#include <gtest/gtest.h>

#include "predicate/formulas.h"
#include "support/oracle_numbers.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Integer;
using test::Random;

struct Relative {
  Integer x, y, r, p;
};

Relative relative(const Integer& x, const Integer& y, const Integer& r) {
  return {x, y, r, x * x + y * y - r * r};
}

Relative randomRow(Random& random) {
  constexpr std::int64_t kBound = 1 << 20;
  return relative(random.integer(-kBound, kBound), random.integer(-kBound, kBound),
                  random.integer(-kBound, kBound));
}

const Relative kInfinityRow{0, 0, 0, 1};

/// p of two sites given relative to a third.
Integer pOf(const Relative& a, const Relative& b) {
  return relative(a.x - b.x, a.y - b.y, a.r - b.r).p;
}

Row<Integer> row(const Relative& a) { return {a.x, a.y, a.r, a.p}; }

/// Determinant of three rows, expanded along the first column, by definition.
Integer determinant(const Integer (&m)[3][3]) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[1][0] * (m[0][1] * m[2][2] - m[0][2] * m[2][1]) +
         m[2][0] * (m[0][1] * m[1][2] - m[0][2] * m[1][1]);
}

struct Determinants {
  Integer xr, yr, xy;
};

Determinants determinants(const Relative& j, const Relative& k, const Relative& q) {
  return {determinant({{j.x, j.r, j.p}, {k.x, k.r, k.p}, {q.x, q.r, q.p}}),
          determinant({{j.y, j.r, j.p}, {k.y, k.r, k.p}, {q.y, q.r, q.p}}),
          determinant({{j.x, j.y, j.p}, {k.x, k.y, k.p}, {q.x, q.y, q.p}})};
}

class Identities : public ::testing::Test {
 protected:
  static constexpr int kPoints = 2000;
  Random random{51};
};

TEST_F(Identities, VertexSquaresHaveDegreeEight) {
  // X^2 - E_xy^2 p_jk p_j p_k = (U^2 + V^2) (E_xr^2 + E_yr^2 - E_xy^2)
  for (int point = 0; point < kPoints; ++point) {
    const Relative j = randomRow(random), k = randomRow(random), q = randomRow(random);
    const auto [xr, yr, xy] = determinants(j, k, q);
    const Integer U = k.x * j.p - j.x * k.p, V = k.y * j.p - j.y * k.p;
    const Integer X = U * xr + V * yr;
    const Integer reduced = xr * xr + yr * yr - xy * xy;
    ASSERT_EQ(X * X - xy * xy * pOf(j, k) * j.p * k.p, (U * U + V * V) * reduced);

    const VertexForm<Integer> form(row(j), row(k), row(q));
    ASSERT_EQ(form.xr, xr);
    ASSERT_EQ(form.yr, yr);
    ASSERT_EQ(form.xy, xy);
    ASSERT_EQ(form.x, X);
    ASSERT_EQ(form.squares(), reduced);
  }
}

TEST_F(Identities, VertexSquaresWithInfinity) {
  // Again with one of the rows j, k at infinity, where p_jk and p_j are 1.
  for (int point = 0; point < kPoints; ++point) {
    const Relative j = randomRow(random), q = randomRow(random);
    const auto [xr, yr, xy] = determinants(j, kInfinityRow, q);
    const Integer U = -j.x, V = -j.y;
    const Integer X = U * xr + V * yr;
    ASSERT_EQ(X * X - xy * xy * j.p, (U * U + V * V) * (xr * xr + yr * yr - xy * xy));
    const VertexForm<Integer> form(row(j), infinityRow<Integer>(), row(q));
    ASSERT_EQ(form.x, X);
    ASSERT_EQ(form.xy, xy);
  }
}

TEST_F(Identities, EqualWeightsGiveTheInCircleTest) {
  for (int point = 0; point < kPoints; ++point) {
    const Relative all[] = {randomRow(random), randomRow(random), randomRow(random)};
    Row<Integer> rows[3];
    for (int t = 0; t < 3; ++t) rows[t] = row(relative(all[t].x, all[t].y, 0));
    const VertexForm<Integer> form(rows[0], rows[1], rows[2]);
    ASSERT_EQ(form.x, 0);
    ASSERT_EQ(form.xy, determinant({{rows[0].x, rows[0].y, rows[0].p},
                                    {rows[1].x, rows[1].y, rows[1].p},
                                    {rows[2].x, rows[2].y, rows[2].p}}));
  }
}

TEST_F(Identities, ShadowIsAnArc) {
  // |m|^2 - w^2 = p_jq / (p_j p_q), multiplied by (p_j p_q)^2, with m and w as the chord from j to
  // q.
  for (int point = 0; point < kPoints; ++point) {
    const Relative j = randomRow(random), q = randomRow(random);
    const Integer u = q.x * j.p - j.x * q.p, v = q.y * j.p - j.y * q.p, w = q.r * j.p - j.r * q.p;
    ASSERT_EQ(u * u + v * v - w * w, pOf(j, q) * j.p * q.p);
    const Chord<Integer> chord = chordOf(row(j), row(q));
    ASSERT_EQ(chord.u, u);
    ASSERT_EQ(chord.v, v);
    ASSERT_EQ(chord.w, w);
  }
}

TEST_F(Identities, EdgeSquaresHaveDegreeTwelve) {
  // (W Y)^2 - D G^2 = (U^2 + V^2) (W^2 (u^2 + v^2) - G^2), D = p_jt p_j p_t = U^2 + V^2 - W^2
  for (int point = 0; point < kPoints; ++point) {
    const Relative j = randomRow(random), t = randomRow(random), q = randomRow(random);
    const Integer U = t.x * j.p - j.x * t.p, V = t.y * j.p - j.y * t.p, W = t.r * j.p - j.r * t.p;
    const Integer u = q.x * j.p - j.x * q.p, v = q.y * j.p - j.y * q.p;
    const Integer Y = U * v - V * u, G = u * U + v * V;
    const Integer D = pOf(j, t) * j.p * t.p;
    const Integer reduced = W * W * (u * u + v * v) - G * G;
    ASSERT_EQ(W * W * Y * Y - D * G * G, (U * U + V * V) * reduced);

    const Chord<Integer> end = chordOf(row(j), row(t)), shadow = chordOf(row(j), row(q));
    const EdgeForm<Integer> form(end, shadow);
    ASSERT_EQ(form.turn, Y);
    ASSERT_EQ(form.along, G);
    ASSERT_EQ(EdgeForm<Integer>::squares(end, shadow, form.along), reduced);
  }
}

TEST_F(Identities, TurnIsTheDeterminantOfPositions) {
  // Y = p_j E_xy of the rows j, t, q.
  for (int point = 0; point < kPoints; ++point) {
    const Relative j = randomRow(random), t = randomRow(random), q = randomRow(random);
    const EdgeForm<Integer> form(chordOf(row(j), row(t)), chordOf(row(j), row(q)));
    ASSERT_EQ(form.turn, j.p * determinants(j, t, q).xy);
  }
}

TEST_F(Identities, HalfPlaneDirections) {
  // d_k and d_l of an unbounded face have lengths |b_k|^2 and |b_l|^2, and their cross product is
  // the span form. The roots are made rational: choose x, y, s and take r with x^2 + y^2 - r^2 =
  // s^2, i.e. x^2 + y^2 = r^2 + s^2 (two ways as sum of squares).
  for (int point = 0; point < kPoints; ++point) {
    const auto sumOfSquaresTwice = [&] {
      const Integer a = random.integer(-1000, 1000), b = random.integer(-1000, 1000);
      const Integer c = random.integer(-1000, 1000), d = random.integer(-1000, 1000);
      struct {
        Integer x, y, r, s;
      } row{a * c - b * d, a * d + b * c, a * c + b * d, a * d - b * c};
      if (row.s < 0) row.s = -row.s;
      return row;
    };
    const auto k = sumOfSquaresTwice();
    const auto l = sumOfSquaresTwice();
    ASSERT_EQ(k.x * k.x + k.y * k.y - k.r * k.r, k.s * k.s);
    const Integer dkx = -k.r * k.x + k.y * k.s, dky = -k.r * k.y - k.x * k.s;
    const Integer dlx = -l.r * l.x - l.y * l.s, dly = -l.r * l.y + l.x * l.s;
    const Integer lengthK = k.x * k.x + k.y * k.y;
    ASSERT_EQ(dkx * dkx + dky * dky, lengthK * lengthK);
    // The half-plane's normal n satisfies n . b_k + r_k = 0, as n = d_k / |b_k|^2 touches the
    // reference site and k alike.
    ASSERT_EQ(dkx * k.x + dky * k.y + k.r * lengthK, 0);

    // cross · P + dot · Q, and the reduction of its squares.
    const Row<Integer> rowL{l.x, l.y, l.r, l.s * l.s}, rowK{k.x, k.y, k.r, k.s * k.s};
    const SpanForm<Integer> form(rowL, rowK);
    const Integer P = form.weights - l.s * k.s, Q = l.r * k.s + k.r * l.s;
    ASSERT_EQ(form.tangents, l.s * l.s * k.s * k.s);
    ASSERT_EQ(form.squares(rowL, rowK), l.r * l.r * k.s * k.s - k.r * k.r * l.s * l.s);
    const Integer first = form.cross * P, second = form.dot * Q;
    ASSERT_EQ(first + second, dlx * dky - dly * dkx);
    const Integer lengthL = l.x * l.x + l.y * l.y;
    ASSERT_EQ(first * first - second * second, lengthK * lengthL * (P * P - form.dot * form.dot));
  }
}

TEST_F(Identities, CaseyOnRationalCircles) {
  // Four circles that touch one circle from outside at known points: the square roots of the
  // products p satisfy Ptolemy's theorem, so the largest product belongs to the pair of opposite
  // sites.
  for (int point = 0; point < 300; ++point) {
    // Weights c - R at (a, b), a^2 + b^2 = c^2, touch the circle of radius R about the origin, in
    // direction (a, b) / c.
    Relative site[4];
    std::int64_t turns = 0;
    for (int t = 0; t < 4; ++t) {
      // Directions by increasing parameter m/n of the rational parametrisation, scaled:
      // counter-clockwise order 0, 1, 2, 3.
      turns += random.integer(1, 40);
      const Integer m = turns, n = 37, scale = random.integer(1, 50);
      site[t] = {scale * (n * n - m * m), scale * 2 * m * n, scale * (n * n + m * m), 0};
    }
    const Integer opposite = pOf(site[0], site[2]) * pOf(site[1], site[3]);
    EXPECT_GT(opposite, pOf(site[0], site[1]) * pOf(site[2], site[3]));
    EXPECT_GT(opposite, pOf(site[0], site[3]) * pOf(site[1], site[2]));
  }
}

}  // namespace
}  // namespace apollonius::internal
