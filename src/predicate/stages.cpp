// The first stages: in doubles, with error bounds (filter) or where they compute exactly (middle).
#include "number/ball.h"
#include "predicate/approx_distance.h"
#include "predicate/decisions.h"

namespace apollonius::stages {

namespace {

/// isOpposite (decisions.h) where all weights are equal, so that a p is a sum of squares: each
/// product is off by a factor of at most (1 + u)^9.
MaybeSign isOppositeOfPoints(const Site& i, Corner j, Corner k, Corner q, FaceCorner corner) {
  const auto areEqual = [&](Corner c) { return c == nullptr || c->r == i.r; };
  if (!areEqual(j) || !areEqual(k) || !areEqual(q)) return {};
  const auto squared = [](Corner a, Corner b) {
    if (a == nullptr || b == nullptr) return 1.0;
    const double x = a->x - b->x, y = a->y - b->y;
    return x * x + y * y;
  };
  const std::array<double, 3> products{squared(&i, q) * squared(j, k),
                                       squared(j, q) * squared(&i, k),
                                       squared(k, q) * squared(&i, j)};
  const auto n = static_cast<std::size_t>(corner);
  const double opposite = products[n],
               larger = std::max(products[(n + 1) % 3], products[(n + 2) % 3]);
  constexpr double kMargin = 1 + 32 * kUnitRoundoff, kTiny = powerOfTwo(-400);
  if (!(opposite > kTiny && larger > kTiny && opposite < 1 / kTiny && larger < 1 / kTiny))
    return {};
  if (opposite > larger * kMargin) return {Sign::kPositive, true};
  if (opposite * kMargin < larger) return {Sign::kNegative, true};
  return {};
}

/// The sign of SpanForm. Rows of doubles: roots are not among what they compute exactly.
template <class Kernel>
Sign roundedSpanSign(Kernel& kernel, bool& failed) {
  using T = typename Kernel::Number;
  // The other terms are zero, and there is no root to be taken: on the hull of a grid, where most
  // spans are zero.
  if (kernel.hasEqualWeights())
    return kernel.sign(SpanForm<T>(kernel.row(2), kernel.row(1)).clk, kSpan.clk);
  // Roots of rounded numbers: a running error bound instead of the constant one.
  const auto ball = [](T a, Roundings roundings) {
    return Ball::bounded(a.value, errorFactor(roundings) * a.magnitude + kUnderflow);
  };
  const Row<T> k = kernel.row(1), l = kernel.row(2);
  const SpanForm<T> form(l, k);
  const Ball rootK = sqrt(ball(k.p, kRow.p)), rootL = sqrt(ball(l.p, kRow.p));
  const Ball span = ball(form.c0, kSpan.c0) + ball(form.cl, kSpan.cl) * rootL +
                    ball(form.ck, kSpan.ck) * rootK + ball(form.clk, kSpan.clk) * rootL * rootK;
  if (span.certainlyPositive()) return Sign::kPositive;
  if ((Ball(0) - span).certainlyPositive()) return Sign::kNegative;
  failed = true;
  return Sign::kZero;
}

}  // namespace

// --- Covering: p of two sites

MaybeSign lorentzFilter(const Site& a, const Site& b) {
  const Approx p = lorentz(Approx(a.x - b.x), Approx(a.y - b.y), Approx(a.r - b.r));
  return filteredSign(p, errorFactor(kRow.p));
}

MaybeSign lorentzMiddle(const Site& a, const Site& b) {
  UnitKernel kernel(a, {&b});
  const Sign sign = kernel.sign(kernel.row(0).p, kRow.p);
  return {sign, !kernel.failed()};
}

// --- Distance

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
  UnitKernel kernel(p, {&a, &b});
  const Sign sign = kernel.sign(kernel.row(0).p - kernel.row(1).p,
                                kRow.p);  // equal weights: the squared distances
  return {sign, !kernel.failed()};
}

// --- Vertex conflict

/// The sign of xy (see VertexForm): d = p_j |k q| + p_k |q j| + p_q |j k|, with p = x² + y² of rows
/// of differences to i.
///
/// Let e be the exponent of the largest difference. If all coordinates are multiples of W =
/// 2^(e-11), then so are differences, of less than 2^12 W; p and the minors |k q| … are less than
/// 2^25 W² each, and d's terms less than 2^50 W^4: all exact. (With infinity, p = 1, the only term
/// is a minor.) If they are multiples of W = 2^(e-25) only, p and minors are still exact, at most
/// 2^53 W², hence d, too, if all minors are zero; else three roundings of d's terms bound its
/// error. If not, depth 12 does, of the terms with + for -. Multiples: adding 1.5 · 2^53 W and
/// taking it away again leaves nothing else as it was, for ulp(sum) >= W.
MaybeSign vertexOfPoints(const Site& i, Corner j, Corner k, Corner q) {
  const std::array<Corner, 3> corners{j, k, q};
  std::array<double, 3> x{}, y{}, p{1, 1, 1};
  double largest = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    const Corner c = corners[n];
    if (c == nullptr) continue;
    if (c->r != i.r) return {};
    x[n] = c->x - i.x;
    y[n] = c->y - i.y;
    p[n] = x[n] * x[n] + y[n] * y[n];
    largest = std::max(largest, std::max(absolute(x[n]), absolute(y[n])));
  }
  if (!(largest > powerOfTwo(-100) && largest < powerOfTwo(100))) return {};

  const auto haveDigits = [&](int digits) {
    const double shift = 1.5 * powerOfTwo(exponentOf(largest) - digits + 53);
    const auto areMultiples = [shift](const Site& s) {
      return (s.x + shift) - shift == s.x && (s.y + shift) - shift == s.y;
    };
    return areMultiples(i) && std::all_of(corners.begin(), corners.end(), [&](Corner c) {
             return c == nullptr || areMultiples(*c);
           });
  };
  const bool isExact = haveDigits(11), hasExactMinors = isExact || haveDigits(25);
  double sum = 0, size = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t a = n < 2 ? n + 1 : 0, b = n > 0 ? n - 1 : 2;
    const double ab = x[a] * y[b], ba = x[b] * y[a];
    sum += p[n] * (ab - ba);
    size += p[n] * (hasExactMinors ? absolute(ab - ba) : absolute(ab) + absolute(ba));
  }
  if (isExact || (hasExactMinors && size == 0)) return {-signOf(sum), true};
  const MaybeSign sign = filteredSign({sum, size}, errorFactor(kVertex.xy));
  return {-sign.sign, sign.known};
}

MaybeSign vertexFilter(const Site& i, Corner j, Corner k, Corner q) {
  FilterKernel kernel(i, {j, k, q});
  const Sign sign = vertexSign(kernel);
  return {sign, !kernel.failed()};
}

MaybeSign vertexMiddle(const Site& i, Corner j, Corner k, Corner q) {
  UnitKernel kernel(i, {j, k, q});
  const Sign sign = vertexSign(kernel);
  return {sign, !kernel.failed()};
}

bool vertexDegenerate(const Site& i, Corner j, Corner k, Corner q) {
  // Only the largest of the four, z, matters: infinity if it is among them, else i or q
  // (docs/PREDICATES.md, "Degenerate position").
  if (q == nullptr) return true;
  const FaceCorner z = j == nullptr   ? FaceCorner::kJ
                       : k == nullptr ? FaceCorner::kK
                                      : FaceCorner::kReference;
  if (z == FaceCorner::kReference && precedes(i, *q)) return true;
  if (const MaybeSign quick = isOppositeOfPoints(i, j, k, q, z); quick.known)
    return quick.sign == Sign::kPositive;
  FilterKernel filter(i, {j, k, q});
  const bool probably = isOpposite(filter, z);
  if (!filter.failed()) return probably;
  return isOppositeExact(i, j, k, q, z);
}

// --- Edge conflict

MaybeSign edgeFilter(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  FilterKernel kernel(i, {j, k, l, &q});
  bool spanFailed = false;
  const Sign sign =
      edgeSign(kernel, j == nullptr, probe, [&] { return roundedSpanSign(kernel, spanFailed); });
  return {sign, !kernel.failed() && !spanFailed};
}

MaybeSign edgeMiddle(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  UnitKernel kernel(i, {j, k, l, &q});
  bool spanFailed = false;
  const Sign sign =
      edgeSign(kernel, j == nullptr, probe, [&] { return roundedSpanSign(kernel, spanFailed); });
  return {sign, !kernel.failed() && !spanFailed};
}

// --- Rays

MaybeSign rayFilter(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  const Site point{x, y, i.r};
  FilterKernel kernel(i, {j, k, &point});
  const Sign sign = raySign(kernel, part);
  return {sign, !kernel.failed()};
}

MaybeSign rayMiddle(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  const Site point{x, y, i.r};
  UnitKernel kernel(i, {j, k, &point});
  const Sign sign = raySign(kernel, part);
  return {sign, !kernel.failed()};
}

Counts& counts() {
  thread_local Counts counts;
  return counts;
}

// --- Order along an edge

MaybeSign shadowTurnFilter(const Site& i, const Site& j, const Site& l, const Site& k) {
  FilterKernel kernel(i, {&j, &l, &k});
  const Sign sign = shadowTurnSign(kernel);
  return {sign, !kernel.failed()};
}

}  // namespace apollonius::stages
