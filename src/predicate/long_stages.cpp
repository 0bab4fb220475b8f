// The last stages: in long integers (whole) and in numbers as long as any input can ask for (exact). Apart from the first ones because they are compiled
// for size: what takes the time is in number/whole.cpp and in cpp_int.
#include "predicate/decisions.h"
#include "predicate/long_rows.h"

namespace apollonius::stages {

namespace {

template <class Rows>
Sign spanSign(const Rows& rows) {
  const SpanForm<typename Rows::Number> form(rows.row(2), rows.row(1));
  return signOfTwoRoots(form.c0, form.cl, rows.row(2).p, form.ck, rows.row(1).p, form.clk);
}

Dyadic exactLorentz(const Site& a, const Site& b) {
  return lorentz(Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.r) - Dyadic(b.r));
}

}  // namespace

Sign lorentzExact(const Site& a, const Site& b) { return exactLorentz(a, b).sign(); }

Sign lorentzDifferenceExact(const Site& a, const Site& b, const Site& c, const Site& d) {
  return (exactLorentz(a, b) - exactLorentz(c, d)).sign();
}

MaybeSign distanceWhole(double x, double y, const Site& a, const Site& b) {
  WholeRows rows({x, y, 0}, {&a, &b});
  if (rows.failed()) return {};
  const Row<Whole> &s = rows.row(0), &t = rows.row(1);
  return {signOfTwoRoots(t.r - s.r, Whole(1), s.x * s.x + s.y * s.y, Whole(-1), t.x * t.x + t.y * t.y, Whole(0)), true};
}

Sign distanceExact(double x, double y, const Site& a, const Site& b) {
  const Dyadic px(x), py(y);
  const auto squaredTo = [&](const Site& s) {
    const Dyadic dx = Dyadic(s.x) - px, dy = Dyadic(s.y) - py;
    return dx * dx + dy * dy;
  };
  // √A - √B - (ra - rb)
  return signOfTwoRoots(Dyadic(b.r) - Dyadic(a.r), Dyadic(1), squaredTo(a), Dyadic(-1), squaredTo(b), Dyadic(0));
}

MaybeSign vertexWhole(const Site& i, Corner j, Corner k, Corner q) {
  WholeRows rows(i, {j, k, q});
  if (rows.failed()) return {};
  return {vertexSign(rows), true};
}

Sign vertexExact(const Site& i, Corner j, Corner k, Corner q) {
  ExactRows rows(i, {j, k, q});
  return vertexSign(rows);
}

bool isOppositePoleExact(const Site& i, Corner j, Corner k, Corner q) {
  WholeRows whole(i, {j, k, q});
  if (!whole.failed()) return isOppositePole(whole);
  ExactRows exact(i, {j, k, q});
  return isOppositePole(exact);
}

MaybeSign edgeWhole(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  WholeRows rows(i, {j, k, l, &q});
  if (rows.failed()) return {};
  return {edgeSign(rows, j == nullptr, probe, [&] { return spanSign(rows); }), true};
}

Sign hullTurnExact(const Site& i, const Site& l, const Site& k) { return spanSign(ExactRows(i, {nullptr, &k, &l})); }

Sign edgeExact(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  ExactRows rows(i, {j, k, l, &q});
  return edgeSign(rows, j == nullptr, probe, [&] { return spanSign(rows); });
}

}  // namespace apollonius::stages
