// The first stages: in doubles, with error bounds (filter) or where they compute exactly (middle).
#include "number/ball.h"
#include "predicate/approx_distance.h"
#include "predicate/decisions.h"

namespace apollonius::stages {

namespace {

/// The sign of SpanForm. Rows of doubles: roots are not among what they compute exactly.
template <class Rows>
Sign roundedSpanSign(const Rows& rows, bool& failed) {
  // Roots of rounded numbers: a running error bound instead of the constant one.
  using T = typename Rows::Number;
  const auto ball = [](T a, Depth depth) { return Ball::bounded(a.value, boundFactor(depth) * a.magnitude + kUnderflow); };
  const Row<T> k = rows.row(1), l = rows.row(2);
  const SpanForm<T> form(l, k);
  const Ball rootK = sqrt(ball(k.p, kRow.p)), rootL = sqrt(ball(l.p, kRow.p));
  const Ball span = ball(form.c0, kSpan.c0) + ball(form.cl, kSpan.cl) * rootL + ball(form.ck, kSpan.ck) * rootK +
                    ball(form.clk, kSpan.clk) * rootL * rootK;
  if (span.certainlyPositive()) return Sign::kPositive;
  if ((Ball(0) - span).certainlyPositive()) return Sign::kNegative;
  failed = true;
  return Sign::kZero;
}

}  // namespace

// --- Covering: p of two sites ------------------------------------------------------------------------------------------------

MaybeSign lorentzFilter(const Site& a, const Site& b) {
  const Approx p = lorentz(Approx(a.x - b.x), Approx(a.y - b.y), Approx(a.r - b.r));
  return filteredSign(p, boundFactor(kRow.p));
}

MaybeSign lorentzMiddle(const Site& a, const Site& b) {
  UnitRows rows(a, {&b});
  const Sign sign = rows.sign(rows.row(0).p, kRow.p);
  return {sign, !rows.failed()};
}

Sign lorentzDifference(const Site& a, const Site& b, const Site& c, const Site& d) {
  const Approx difference = lorentz(Approx(a.x - b.x), Approx(a.y - b.y), Approx(a.r - b.r)) -
                            lorentz(Approx(c.x - d.x), Approx(c.y - d.y), Approx(c.r - d.r));
  const MaybeSign filtered = filteredSign(difference, boundFactor(kRow.p - kRow.p));
  if (filtered.known) return filtered.sign;
  return lorentzDifferenceExact(a, b, c, d);
}

// --- Distance ----------------------------------------------------------------------------------------------------------------

MaybeSign distanceFilter(double x, double y, const Site& a, const Site& b) {
  const ApproxDistance da(x, y, a), db(x, y, b);
  const double difference = da.value - db.value;
  const double bound = da.bound + db.bound;
  if (difference > bound) return {Sign::kPositive, true};
  if (difference < -bound) return {Sign::kNegative, true};
  return {};
}

MaybeSign distanceMiddle(double x, double y, const Site& a, const Site& b) {
  if (a.r != b.r) return {};
  const Site p{x, y, a.r};
  UnitRows rows(p, {&a, &b});
  const Sign sign = rows.sign(rows.row(0).p - rows.row(1).p, kRow.p);  // equal weights: the squared distances
  return {sign, !rows.failed()};
}

// --- Vertex conflict ---------------------------------------------------------------------------------------------------------

MaybeSign vertexFilter(const Site& i, Corner j, Corner k, Corner q) {
  FilterRows rows(i, {j, k, q});
  const Sign sign = vertexSign(rows);
  return {sign, !rows.failed()};
}

MaybeSign vertexMiddle(const Site& i, Corner j, Corner k, Corner q) {
  UnitRows rows(i, {j, k, q});
  const Sign sign = vertexSign(rows);
  return {sign, !rows.failed()};
}

bool vertexDegenerate(const Site& i, Corner j, Corner k, Corner q) {
  // Perturbed weights: only the largest of the four, z, matters. It is i or q (docs/PREDICATES.md, "Degenerate position").
  if (q != nullptr && precedes(i, *q)) return true;
  FilterRows filter(i, {j, k, q});
  const bool probably = isOppositePole(filter);
  if (!filter.failed()) return probably;
  UnitRows unit(i, {j, k, q});
  const bool opposite = isOppositePole(unit);
  if (!unit.failed()) return opposite;
  return isOppositePoleExact(i, j, k, q);
}

// --- Edge conflict -----------------------------------------------------------------------------------------------------------

MaybeSign edgeFilter(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  FilterRows rows(i, {j, k, l, &q});
  bool spanFailed = false;
  const Sign sign = edgeSign(rows, j == nullptr, probe, [&] { return roundedSpanSign(rows, spanFailed); });
  return {sign, !rows.failed() && !spanFailed};
}

MaybeSign edgeMiddle(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  UnitRows rows(i, {j, k, l, &q});
  bool spanFailed = false;
  const Sign sign = edgeSign(rows, j == nullptr, probe, [&] { return roundedSpanSign(rows, spanFailed); });
  return {sign, !rows.failed() && !spanFailed};
}

Counts& counts() {
  thread_local Counts counts;
  return counts;
}

}  // namespace apollonius::stages
