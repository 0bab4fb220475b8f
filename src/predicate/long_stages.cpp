// The last stages: in long integers (whole) and in numbers as long as any input can ask for
// (exact). Apart from the first ones because they are compiled for size: what takes the time is in
// number/fixed_integer.cpp and in cpp_int.
#include "predicate/decisions.h"
#include "predicate/long_kernels.h"

namespace apollonius::stages {

namespace {

template <class Rows>
Sign spanSign(const Rows& rows) {
  const SpanForm<typename Rows::Number> form(rows.row(2), rows.row(1));
  return signOfTwoRoots(form.c0, form.cl, rows.row(2).p, form.ck, rows.row(1).p, form.clk);
}

}  // namespace

Sign lorentzExact(const Site& a, const Site& b) {
  return lorentz(Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.r) - Dyadic(b.r))
      .sign();
}

MaybeSign distanceWhole(double x, double y, const Site& a, const Site& b) {
  WholeRows rows({x, y, 0}, {&a, &b});
  if (rows.failed()) return {};
  const Row<Whole>&s = rows.row(0), &t = rows.row(1);
  return {signOfTwoRoots(t.r - s.r, Whole(1), s.x * s.x + s.y * s.y, Whole(-1),
                         t.x * t.x + t.y * t.y, Whole(0)),
          true};
}

Sign distanceExact(double x, double y, const Site& a, const Site& b) {
  const Dyadic px(x), py(y);
  const auto squaredTo = [&](const Site& s) {
    const Dyadic dx = Dyadic(s.x) - px, dy = Dyadic(s.y) - py;
    return dx * dx + dy * dy;
  };
  // √A - √B - (ra - rb)
  return signOfTwoRoots(Dyadic(b.r) - Dyadic(a.r), Dyadic(1), squaredTo(a), Dyadic(-1),
                        squaredTo(b), Dyadic(0));
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

bool isOppositeExact(const Site& i, Corner j, Corner k, Corner q, FaceCorner corner) {
  WholeRows whole(i, {j, k, q});
  if (!whole.failed()) return isOpposite(whole, corner);
  ExactRows exact(i, {j, k, q});
  return isOpposite(exact, corner);
}

MaybeSign edgeWhole(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  WholeRows rows(i, {j, k, l, &q});
  if (rows.failed()) return {};
  return {edgeSign(rows, j == nullptr, probe, [&] { return spanSign(rows); }), true};
}

Sign edgeExact(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  ExactRows rows(i, {j, k, l, &q});
  return edgeSign(rows, j == nullptr, probe, [&] { return spanSign(rows); });
}

MaybeSign rayWhole(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  const Site point{x, y, i.r};
  WholeRows rows(i, {j, k, &point});
  if (rows.failed()) return {};
  return {raySign(rows, part), true};
}

Sign rayExact(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  const Site point{x, y, i.r};
  ExactRows rows(i, {j, k, &point});
  return raySign(rows, part);
}

Sign shadowTurnExact(const Site& i, const Site& j, const Site& l, const Site& k) {
  ExactRows rows(i, {&j, &l, &k});  // so seldom asked that shorter numbers would only be more code
  return shadowTurnSign(rows);
}

bool normalIsUpExact(const Site& i, const Site& j) {
  const ExactRows rows(i, {&j});
  const Row<Dyadic>& t = rows.row(0);
  const Sign y = signOfRoot(-(t.r * t.y), t.x, t.p);
  return y == Sign::kPositive ||
         (y == Sign::kZero && signOfRoot(-(t.r * t.x), -t.y, t.p) == Sign::kPositive);
}

Sign spanExact(const Site& i, const Site& l, const Site& k) {
  const WholeRows whole(i, {nullptr, &k, &l});
  return whole.failed() ? spanSign(ExactRows(i, {nullptr, &k, &l})) : spanSign(whole);
}

}  // namespace apollonius::stages
