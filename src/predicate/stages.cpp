#include "predicate/stages.h"

#include "number/ball.h"
#include "number/root_sign.h"
#include "predicate/approx_distance.h"
#include "predicate/rows.h"

namespace apollonius::stages {

namespace {

// --- Depths of the formulas: how many roundings the filter's bound has to count (number/approx.h) --------------------------

constexpr Depth kInput{Depth::Input{}};
constexpr Row<Depth> kRow = rowOf(kInput, kInput, kInput);
constexpr VertexForm<Depth> kVertex{kRow, kRow, kRow};
constexpr Chord<Depth> kChord = chordOf(kRow, kRow);
constexpr EdgeForm<Depth> kEdge{kChord, kChord};
constexpr SpanForm<Depth> kSpan{kRow, kRow};
constexpr Depth kProducts = kRow.p * kRow.p - kRow.p * kRow.p;  // for signs that are computed without rounding

static_assert(kRow.p.roundings == 5, "x² and y² 3 each, their sum 4, less r² 5");
static_assert(kVertex.xy.roundings == 12, "minor 4, times p 10, two sums 12");
static_assert(kVertex.x.roundings == 22);
static_assert(kVertex.squares().roundings == 27);
static_assert(kEdge.along.roundings == 18 && kEdge.turn.roundings == 18, "chord 8, product 17, sum 18");
static_assert(EdgeForm<Depth>::squares(kChord, kChord, kEdge.along).roundings == 38);

// --- The decisions, once for both kinds of rows ------------------------------------------------------------------------------

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

/// The same where all weights are equal, so that a p is a sum of squares: each product is off by a factor of at most (1 + u)^9.
MaybeSign isOppositeOfPoints(const Site& i, Corner j, Corner k, Corner q) {
  const auto areEqual = [&](Corner c) { return c == nullptr || c->r == i.r; };
  if (!areEqual(j) || !areEqual(k) || !areEqual(q)) return {};
  const auto squared = [](Corner a, Corner b) {
    if (a == nullptr || b == nullptr) return 1.0;
    const double x = a->x - b->x, y = a->y - b->y;
    return x * x + y * y;
  };
  const double opposite = squared(&i, q) * squared(j, k);
  const double larger = std::max(squared(j, q) * squared(&i, k), squared(k, q) * squared(&i, j));
  constexpr double kMargin = 1 + 32 * kUnitRoundoff, kTiny = powerOfTwo(-400);
  if (!(opposite > kTiny && larger > kTiny && opposite < 1 / kTiny && larger < 1 / kTiny)) return {};
  if (opposite > larger * kMargin) return {Sign::kPositive, true};
  if (opposite * kMargin < larger) return {Sign::kNegative, true};
  return {};
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

/// Rows of doubles: roots are not among what they compute exactly.
template <class Rows>
Sign spanSign(const Rows& rows, bool& failed) {
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

template <class T, class Rows>
Sign exactSpanSign(const Rows& rows) {
  const SpanForm<T> form(rows.row(2), rows.row(1));
  return signOfTwoRoots(form.c0, form.cl, rows.row(2).p, form.ck, rows.row(1).p, form.clk);
}
template <>
Sign spanSign(const WholeRows& rows, bool&) { return exactSpanSign<Whole>(rows); }
template <>
Sign spanSign(const ExactRows& rows, bool&) { return exactSpanSign<Dyadic>(rows); }

/// Rows 0 … 3 are j, k, l, q; jIsInfinite tells whether the range may span more than a half turn.
template <class Rows>
Sign edgeSign(Rows& rows, bool jIsInfinite, Probe probe, bool& failed) {
  using T = typename Rows::Number;
  const Row<T> j = rows.row(0);
  Chord<T> shadow = chordOf(j, rows.row(3));
  if (probe == Probe::kOpposite) shadow = {T(0) - shadow.u, T(0) - shadow.v, shadow.w};
  const Sign beforeK = edgeEndSign(rows, chordOf(j, rows.row(1)), shadow, Sign::kPositive);
  const Sign afterL = edgeEndSign(rows, chordOf(j, rows.row(2)), shadow, Sign::kNegative);
  if (beforeK == Sign::kPositive && afterL == Sign::kPositive) return Sign::kPositive;
  // A range of at most half a turn (all bounded edges, seen from the larger site) asks for both, a larger one for either.
  if (!jIsInfinite || (beforeK != Sign::kPositive && afterL != Sign::kPositive)) return Sign::kNegative;
  return -spanSign(rows, failed);
}

Dyadic exactLorentz(const Site& a, const Site& b) {
  return lorentz(Dyadic(a.x) - Dyadic(b.x), Dyadic(a.y) - Dyadic(b.y), Dyadic(a.r) - Dyadic(b.r));
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

Sign lorentzExact(const Site& a, const Site& b) { return exactLorentz(a, b).sign(); }

Sign lorentzDifference(const Site& a, const Site& b, const Site& c, const Site& d) {
  const Approx difference = lorentz(Approx(a.x - b.x), Approx(a.y - b.y), Approx(a.r - b.r)) -
                            lorentz(Approx(c.x - d.x), Approx(c.y - d.y), Approx(c.r - d.r));
  const MaybeSign filtered = filteredSign(difference, boundFactor(kRow.p - kRow.p));
  if (filtered.known) return filtered.sign;
  return (exactLorentz(a, b) - exactLorentz(c, d)).sign();
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

// --- Vertex conflict ---------------------------------------------------------------------------------------------------------

/// The sign of xy (see VertexForm): d = p_j |k q| + p_k |q j| + p_q |j k|, with p = x² + y² of rows of differences to i.
///
/// Let e be the exponent of the largest difference. If all coordinates are multiples of W = 2^(e-11), then so are differences, of
/// less than 2^12 W; p and the minors |k q| … are less than 2^25 W² each, and d's terms less than 2^50 W^4: all exact. (With infinity, p = 1,
/// the only term is a minor.) If they are multiples of W = 2^(e-25) only, p and minors are still exact, at most 2^53 W², hence d, too, if
/// all minors are zero; else three roundings of d's terms bound its error. If not, depth 12 does, of the terms with + for -.
/// Multiples: adding 1.5 · 2^53 W and taking it away again leaves nothing else as it was, for ulp(sum) >= W.
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
    const auto areMultiples = [shift](const Site& s) { return (s.x + shift) - shift == s.x && (s.y + shift) - shift == s.y; };
    return areMultiples(i) && std::all_of(corners.begin(), corners.end(), [&](Corner c) { return c == nullptr || areMultiples(*c); });
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
  const MaybeSign sign = filteredSign({sum, size}, boundFactor(kVertex.xy));
  return {-sign.sign, sign.known};
}

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

MaybeSign vertexWhole(const Site& i, Corner j, Corner k, Corner q) {
  WholeRows rows(i, {j, k, q});
  if (rows.failed()) return {};
  return {vertexSign(rows), true};
}

Sign vertexExact(const Site& i, Corner j, Corner k, Corner q) {
  ExactRows rows(i, {j, k, q});
  return vertexSign(rows);
}

bool vertexDegenerate(const Site& i, Corner j, Corner k, Corner q) {
  // Perturbed weights: only the largest of the four, z, matters. It is i or q (docs/PREDICATES.md, "Degenerate position").
  if (q != nullptr && precedes(i, *q)) return true;
  if (const MaybeSign quick = isOppositeOfPoints(i, j, k, q); quick.known) return quick.sign == Sign::kPositive;
  FilterRows filter(i, {j, k, q});
  const bool probably = isOppositePole(filter);
  if (!filter.failed()) return probably;
  WholeRows whole(i, {j, k, q});
  if (!whole.failed()) return isOppositePole(whole);
  ExactRows exact(i, {j, k, q});
  return isOppositePole(exact);
}

// --- Edge conflict -----------------------------------------------------------------------------------------------------------

MaybeSign edgeFilter(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  FilterRows rows(i, {j, k, l, &q});
  bool spanFailed = false;
  const Sign sign = edgeSign(rows, j == nullptr, probe, spanFailed);
  return {sign, !rows.failed() && !spanFailed};
}

MaybeSign edgeMiddle(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  UnitRows rows(i, {j, k, l, &q});
  bool spanFailed = false;
  const Sign sign = edgeSign(rows, j == nullptr, probe, spanFailed);
  return {sign, !rows.failed() && !spanFailed};
}

MaybeSign edgeWhole(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  WholeRows rows(i, {j, k, l, &q});
  if (rows.failed()) return {};
  bool never = false;
  return {edgeSign(rows, j == nullptr, probe, never), true};
}

Sign edgeExact(const Site& i, Corner j, Corner k, Corner l, const Site& q, Probe probe) {
  ExactRows rows(i, {j, k, l, &q});
  bool never = false;
  return edgeSign(rows, j == nullptr, probe, never);
}

Counts& counts() {
  thread_local Counts counts;
  return counts;
}

}  // namespace apollonius::stages
