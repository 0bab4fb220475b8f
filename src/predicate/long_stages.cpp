// The last stages: in long integers (whole) and in numbers as long as any input can ask for
// (exact). Apart from the first ones because they are compiled for size: what takes the time is in
// number/fixed_integer.cpp and in cpp_int.
#include "predicate/decisions.h"
#include "predicate/long_kernels.h"

namespace apollonius::stages {

namespace {

template <class Kernel>
Sign spanSign(const Kernel& kernel) {
  const SpanForm<typename Kernel::Number> form(kernel.row(2), kernel.row(1));
  return signOfTwoRoots(form.c0, form.cl, kernel.row(2).p, form.ck, kernel.row(1).p, form.clk);
}

}  // namespace

Sign lorentzExact(const Site& a, const Site& b) {
  return lorentz(Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.r) - Dyadic(b.r))
      .sign();
}

MaybeSign distanceFixed(double x, double y, const Site& a, const Site& b) {
  FixedKernel kernel({x, y, 0}, {&a, &b});
  if (kernel.failed()) return {};
  const Row<FixedInteger>&s = kernel.row(0), &t = kernel.row(1);
  return {signOfTwoRoots(t.r - s.r, FixedInteger(1), s.x * s.x + s.y * s.y, FixedInteger(-1),
                         t.x * t.x + t.y * t.y, FixedInteger(0)),
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

MaybeSign vertexFixed(const Site& i, Corner j, Corner k, Corner q) {
  FixedKernel kernel(i, {j, k, q});
  if (kernel.failed()) return {};
  return {vertexSign(kernel), true};
}

Sign vertexExact(const Site& i, Corner j, Corner k, Corner q) {
  ExactKernel kernel(i, {j, k, q});
  return vertexSign(kernel);
}

bool isOppositeExact(const Site& i, Corner j, Corner k, Corner q, FaceCorner corner) {
  FixedKernel whole(i, {j, k, q});
  if (!whole.failed()) return isOpposite(whole, corner);
  ExactKernel exact(i, {j, k, q});
  return isOpposite(exact, corner);
}

MaybeSign edgeFixed(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  FixedKernel kernel(i, {j, k, l, &q});
  if (kernel.failed()) return {};
  return {edgeSign(kernel, j == nullptr, probe, [&] { return spanSign(kernel); }), true};
}

Sign edgeExact(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  ExactKernel kernel(i, {j, k, l, &q});
  return edgeSign(kernel, j == nullptr, probe, [&] { return spanSign(kernel); });
}

MaybeSign rayFixed(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  const Site point{x, y, i.r};
  FixedKernel kernel(i, {j, k, &point});
  if (kernel.failed()) return {};
  return {raySign(kernel, part), true};
}

Sign rayExact(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  const Site point{x, y, i.r};
  ExactKernel kernel(i, {j, k, &point});
  return raySign(kernel, part);
}

Sign shadowTurnExact(const Site& i, const Site& j, const Site& l, const Site& k) {
  ExactKernel kernel(i,
                     {&j, &l, &k});  // so seldom asked that shorter numbers would only be more code
  return shadowTurnSign(kernel);
}

bool normalIsUpExact(const Site& i, const Site& j) {
  const ExactKernel kernel(i, {&j});
  const Row<Dyadic>& t = kernel.row(0);
  const Sign y = signOfRoot(-(t.r * t.y), t.x, t.p);
  return y == Sign::kPositive ||
         (y == Sign::kZero && signOfRoot(-(t.r * t.x), -t.y, t.p) == Sign::kPositive);
}

Sign spanExact(const Site& i, const Site& l, const Site& k) {
  const FixedKernel whole(i, {nullptr, &k, &l});
  return whole.failed() ? spanSign(ExactKernel(i, {nullptr, &k, &l})) : spanSign(whole);
}

}  // namespace apollonius::stages
