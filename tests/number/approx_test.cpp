// The theorem of number/approx.h on the predicates' own formulas: the exact value lies within
// errorFactor * magnitude + kUnderflow of the computed one. Exact values from Dyadic.
#include "number/approx.h"

#include <gtest/gtest.h>

#include <cmath>

#include "number/dyadic.h"
#include "predicate/formulas.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

void expectWithinBound(Approx computed, Roundings roundings, const Dyadic& exact) {
  const double bound = errorFactor(roundings) * computed.magnitude + kUnderflow;
  const Dyadic error = Dyadic(computed.value) - exact;
  EXPECT_NE((error - Dyadic(bound)).sign(), Sign::kPositive) << computed.value;
  EXPECT_NE((error + Dyadic(bound)).sign(), Sign::kNegative) << computed.value;
  const MaybeSign filtered = filteredSign(computed, errorFactor(roundings));
  if (filtered.known) {
    EXPECT_EQ(filtered.sign, exact.sign());
  }
}

/// Two sites' coordinates whose difference gets rounded: that is the rounding which
/// Roundings::Input counts.
struct Difference {
  double a, b;
  [[nodiscard]] Approx approx() const { return Approx(a - b); }
  [[nodiscard]] Dyadic exact() const { return Dyadic(a) - Dyadic(b); }
};

TEST(Roundings, AreCounted) {
  constexpr Roundings input{Roundings::Input{}};
  static_assert((input + input).count == 2);
  static_assert((input * input).count == 3);
  static_assert((input * input + input).count == 4);
  static_assert((Roundings(1) * input).count == 2);
  SUCCEED();
}

TEST(Approx, FormulasStayWithinTheirBounds) {
  constexpr Roundings input{Roundings::Input{}};
  constexpr Row<Roundings> rowRoundings = rowOf(input, input, input);
  constexpr VertexForm<Roundings> vertexRoundings{rowRoundings, rowRoundings, rowRoundings};
  constexpr Chord<Roundings> chordRoundings = chordOf(rowRoundings, rowRoundings);
  constexpr EdgeForm<Roundings> edgeRoundings{chordRoundings, chordRoundings};
  constexpr SpanForm<Roundings> spanRoundings{rowRoundings, rowRoundings};
  Random random(31);
  for (int run = 0; run < test::runs(4000); ++run) {
    Difference d[9];
    for (Difference& difference : d) {
      // Magnitudes far apart from row to row, equal ones now and then, coordinates that cancel.
      const double size =
          std::ldexp(1.0, run % 2 == 0 ? random.below(7) - 3 : random.below(231) - 200);
      difference = {size * random.between(-1, 1), size * random.between(-1, 1)};
      if (random.oneIn(4)) difference.b = std::nextafter(difference.a, 2.0 * size);
    }
    Row<Approx> approx[3];
    Row<Dyadic> exact[3];
    for (int k = 0; k < 3; ++k) {
      approx[k] = rowOf(d[3 * k].approx(), d[3 * k + 1].approx(), d[3 * k + 2].approx());
      exact[k] = rowOf(d[3 * k].exact(), d[3 * k + 1].exact(), d[3 * k + 2].exact());
    }
    if (run % 5 == 0) {
      approx[1] = infinityRow<Approx>();
      exact[1] = infinityRow<Dyadic>();
    }
    expectWithinBound(approx[0].p, rowRoundings.p, exact[0].p);
    const VertexForm<Approx> vertex(approx[0], approx[1], approx[2]);
    const VertexForm<Dyadic> exactVertex(exact[0], exact[1], exact[2]);
    expectWithinBound(vertex.x, vertexRoundings.x, exactVertex.x);
    expectWithinBound(vertex.xy, vertexRoundings.xy, exactVertex.xy);
    expectWithinBound(vertex.squares(), vertexRoundings.squares(), exactVertex.squares());
    const Chord<Approx> end = chordOf(approx[0], approx[1]), shadow = chordOf(approx[0], approx[2]);
    const Chord<Dyadic> exactEnd = chordOf(exact[0], exact[1]),
                        exactShadow = chordOf(exact[0], exact[2]);
    expectWithinBound(end.w, chordRoundings.w, exactEnd.w);
    const EdgeForm<Approx> edge(end, shadow);
    const EdgeForm<Dyadic> exactEdge(exactEnd, exactShadow);
    expectWithinBound(edge.turn, edgeRoundings.turn, exactEdge.turn);
    expectWithinBound(edge.along, edgeRoundings.along, exactEdge.along);
    expectWithinBound(
        EdgeForm<Approx>::squares(end, shadow, edge.along),
        EdgeForm<Roundings>::squares(chordRoundings, chordRoundings, edgeRoundings.along),
        EdgeForm<Dyadic>::squares(exactEnd, exactShadow, exactEdge.along));
    const SpanForm<Approx> span(approx[0], approx[2]);
    const SpanForm<Dyadic> exactSpan(exact[0], exact[2]);
    expectWithinBound(span.cross, spanRoundings.cross, exactSpan.cross);
    expectWithinBound(span.tangents, spanRoundings.tangents, exactSpan.tangents);
    expectWithinBound(span.squares(approx[0], approx[2]),
                      spanRoundings.squares(rowRoundings, rowRoundings),
                      exactSpan.squares(exact[0], exact[2]));
    if (HasFailure()) {
      FAIL() << "run " << run;
    }
  }
}

TEST(Approx, InfinitiesAndNansAreUnknown) {
  const Approx huge(1e200);
  EXPECT_FALSE(filteredSign(huge * huge - huge * huge, errorFactor(Roundings(3))).known);
  EXPECT_FALSE(filteredSign(huge * huge, errorFactor(Roundings(3))).known) << "an infinite bound";
}

// Where everything was lost to underflow, the magnitude is as well: nothing is known of a value
// that small.
TEST(Approx, WhatUnderflowMayHaveLeftIsUnknown) {
  for (const double value : {0x1p-700, -0x1p-700}) {
    EXPECT_FALSE(filteredSign({value, 0}, errorFactor(Roundings(3))).known);
  }
}

}  // namespace
}  // namespace apollonius::internal
