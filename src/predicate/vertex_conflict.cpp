#include "predicate/vertex_conflict.h"

#include <algorithm>
#include <array>

#include "number/root_sign.h"
#include "number/twofold.h"
#include "predicate/covers.h"
#include "predicate/kernels.h"
#include "predicate/long_kernels.h"
#include "predicate/question.h"
#include "predicate/reference_site.h"

namespace apollonius::internal {

namespace stages {

namespace {

/// The decision of all stages but the first. Rows 0, 1, 2 are j, k, q.
template <class Kernel>
Sign vertexSign(Kernel& kernel) {
  using T = typename Kernel::Number;
  using roundings::kVertex;
  if (kernel.hasEqualWeights())
    return -kernel.sign(VertexForm<T>::xyOf(kernel.row(0), kernel.row(1), kernel.row(2)),
                        kVertex.xy);
  const VertexForm<T> form(kernel.row(0), kernel.row(1), kernel.row(2));
  return signOfSum(kernel.sign(form.x, kVertex.x), -kernel.sign(form.xy, kVertex.xy),
                   [&] { return kernel.sign(form.squares(), kVertex.squares()); });
}

constexpr auto kVertexDecision = [](auto& kernel) { return vertexSign(kernel); };

}  // namespace

/// The sign of xy (see VertexForm): d = p_j |k q| + p_k |q j| + p_q |j k|, with p = x² + y² of rows
/// of differences to i.
///
/// Let e be the exponent of the largest difference. If all coordinates are multiples of W =
/// 2^(e-11), then so are differences, of less than 2^12 W; p and the minors |k q| … are less than
/// 2^25 W² each, and d's terms less than 2^50 W^4: all exact. (With infinity, p = 1, the only term
/// is a minor.) If they are multiples of W = 2^(e-25) only, p and minors are still exact, at most
/// 2^53 W², hence d, too, if all minors are zero; else three roundings of d's terms bound its
/// error. If not, the 12 roundings of xy do, of the terms with + for -. Multiples: adding 1.5 ·
/// 2^53 W and taking it away again leaves nothing else as it was, for ulp(sum) >= W.
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
  const MaybeSign sign = filteredSign({sum, size}, errorFactor(roundings::kVertex.xy));
  return {-sign.sign, sign.known};
}

namespace {

/// Are a and b mirror images of each other in an axis-parallel line, and c and d in the same one?
/// `along` is the axis that a and b are compared on, `across` the other one. Sums are compared
/// exactly: rounded, and by what rounding took away.
bool areMirrored(const Site& a, const Site& b, const Site& c, const Site& d, double Site::* along,
                 double Site::* across) {
  if (a.*across != b.*across || c.*across != d.*across) return false;
  const Twofold ab = Twofold(a.*along) + b.*along, cd = Twofold(c.*along) + d.*along;
  return ab.value == cd.value && ab.rest == cd.rest;
}

/// Four points, two pairs of which are mirror images in one axis-parallel line: the corners of a
/// rectangle, or of a trapezoid whose legs are as long as each other. The centre of the circle
/// through three of them is on that line, so that the fourth is as far from it as its image.
bool areMirrored(const Site& i, const std::array<Corner, 3>& others) {
  for (std::size_t n = 0; n < 3; ++n) {
    const Site &image = *others[n], &a = *others[(n + 1) % 3], &b = *others[(n + 2) % 3];
    if (areMirrored(i, image, a, b, &Site::x, &Site::y) ||
        areMirrored(i, image, a, b, &Site::y, &Site::x))
      return true;
  }
  return false;
}

/// Does vertexTwofold() know no underflow and no overflow of such coordinates?
bool fitsTwofold(const Site& s) {
  const auto fits = [](double x) {
    return x == 0 || (absolute(x) >= powerOfTwo(-200) && absolute(x) < powerOfTwo(200));
  };
  return fits(s.x) && fits(s.y);
}

}  // namespace

/// The sign of xy (see VertexForm), as in vertexOfPoints, of differences that are exact. Each of
/// the 7 roundings that a term passes (kVertexOfPoints; the first sum is that of 0) is less than
/// kTwofoldRoundoff / 2, so 7/2 of those and what their products add bound the error; 7 are
/// allowed, which covers the roundings of `size`, too, at most 2^-48 of it, and the last place of
/// `value`.
///
/// Coordinates that are zero or at least 2^-200 are multiples of 2^-252, and so are both parts of a
/// difference. Hence all that products of four are made of, halves of digits among them, are
/// multiples of 2^-1008: nothing is subnormal. Below 2^200, nothing overflows.
MaybeSign vertexTwofold(const Site& i, Corner j, Corner k, Corner q) {
  const std::array<Corner, 3> corners{j, k, q};
  bool areFinite = true, areFit = fitsTwofold(i);
  for (const Corner c : corners) {
    areFinite = areFinite && c != nullptr;
    if (c == nullptr) continue;
    if (c->r != i.r) return {};
    areFit = areFit && fitsTwofold(*c);
  }
  if (areFinite && areMirrored(i, corners)) return {Sign::kZero, true};
  if (!areFit) return {};

  std::array<Twofold, 3> x, y, p{1, 1, 1};
  for (std::size_t n = 0; n < 3; ++n) {
    const Corner c = corners[n];
    if (c == nullptr) continue;
    x[n] = Twofold(c->x) - i.x;
    y[n] = Twofold(c->y) - i.y;
    p[n] = x[n] * x[n] + y[n] * y[n];
  }
  Twofold sum;
  double size = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t a = n < 2 ? n + 1 : 0, b = n > 0 ? n - 1 : 2;
    const Twofold ab = x[a] * y[b], ba = x[b] * y[a];
    sum = sum + p[n] * (ab - ba);
    size += p[n].value * (absolute(ab.value) + absolute(ba.value));
  }
  const MaybeSign sign =
      filteredSign({sum.value, size}, roundings::kVertexOfPoints.count * kTwofoldRoundoff);
  return {-sign.sign, sign.known};
}

MaybeSign vertexFilter(const Site& i, Corner j, Corner k, Corner q) {
  return decide<FilterKernel>(i, {j, k, q}, kVertexDecision);
}

MaybeSign vertexMiddle(const Site& i, Corner j, Corner k, Corner q) {
  return decide<UnitKernel>(i, {j, k, q}, kVertexDecision);
}

MaybeSign vertexFixed(const Site& i, Corner j, Corner k, Corner q) {
  return decide<FixedKernel>(i, {j, k, q}, kVertexDecision);
}

Sign vertexExact(const Site& i, Corner j, Corner k, Corner q) {
  return decide<ExactKernel>(i, {j, k, q}, kVertexDecision).sign;
}

// --- The rule for zeros: docs/PREDICATES.md, "Degenerate position"

namespace {

/// Rows 0, 1, 2 are j, k, q on one circle (or line) with the reference site. q is opposite to a
/// corner of the face on it exactly if, of the three ways to pair the four, the one that pairs q
/// with this corner has the largest product of tangent lengths (Casey's theorem).
template <class Kernel>
bool isOpposite(Kernel& kernel, FaceCorner corner) {
  using T = typename Kernel::Number;
  using roundings::kProducts;
  const Row<T> j = kernel.row(0), k = kernel.row(1), q = kernel.row(2);
  const std::array<T, 3> products{q.p * between(j, k), between(j, q) * k.p, between(k, q) * j.p};
  const auto n = static_cast<std::size_t>(corner);
  return kernel.sign(products[n] - products[(n + 1) % 3], kProducts) == Sign::kPositive &&
         kernel.sign(products[n] - products[(n + 2) % 3], kProducts) == Sign::kPositive;
}

/// isOpposite() if all weights are equal, so that each p is a sum of squares: the rounding of a
/// product is a factor of at most (1 + u)^9.
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

}  // namespace

bool isOpposite(const Site& i, Corner j, Corner k, Corner q, FaceCorner corner) {
  if (const MaybeSign quick = isOppositeOfPoints(i, j, k, q, corner); quick.known)
    return quick.sign == Sign::kPositive;
  FilterKernel filter(i, {j, k, q});
  const bool probably = isOpposite(filter, corner);
  return filter.failed() ? isOppositeExact(i, j, k, q, corner) : probably;
}

bool vertexDegenerate(const Site& i, Corner j, Corner k, Corner q) {
  // Only the largest of the four, z, matters: infinity if it is among them, else i or q.
  if (q == nullptr) return true;
  const FaceCorner z = j == nullptr   ? FaceCorner::kJ
                       : k == nullptr ? FaceCorner::kK
                                      : FaceCorner::kReference;
  if (z == FaceCorner::kReference && precedes(i, *q)) return true;
  return isOpposite(i, j, k, q, z);
}

bool isOppositeExact(const Site& i, Corner j, Corner k, Corner q, FaceCorner corner) {
  FixedKernel fixed(i, {j, k, q});
  if (!fixed.failed()) return isOpposite(fixed, corner);
  ExactKernel exact(i, {j, k, q});
  return isOpposite(exact, corner);
}

}  // namespace stages

// --- The questions

namespace {

/// Vertex conflict before the degenerate rule, for any face and any one infinite site of the four.
Sign vertexSign(const Site& i, Corner j, Corner k, Corner q) {
  using stages::counts;
  Question question([&] { return stages::vertexExact(i, j, k, q); }, counts().vertexExact);
  if (question.isSettledBy(stages::vertexOfPoints(i, j, k, q), counts().vertexOfPoints) ||
      question.isSettledBy(stages::vertexTwofold(i, j, k, q), counts().vertexTwofold) ||
      question.isSettledBy(stages::vertexFilter(i, j, k, q), counts().vertexFilter) ||
      question.isSettledBy(stages::vertexMiddle(i, j, k, q), counts().vertexMiddle) ||
      question.isSettledBy(stages::vertexFixed(i, j, k, q), counts().vertexFixed))
    return question.settled();
  return question.exact();
}

/// Is the vertex of the face nearer to q than to the face's sites? q is infinite to ask whether the
/// face has no circle.
bool circleIsBeaten(Corner i, Corner j, Corner k, Corner q) {
  rotateToReference(i, j, k);
  const Sign sign = vertexSign(*i, j, k, q);
  if (sign != Sign::kZero) return sign == Sign::kPositive;
  ++stages::counts().vertexDegenerate;
  return stages::vertexDegenerate(*i, j, k, q);
}

}  // namespace

bool isVertexInConflict(Corner i, Corner j, Corner k, const Site& q) {
  if (coversCorner(q, i) || coversCorner(q, j) || coversCorner(q, k)) return true;
  return circleIsBeaten(i, j, k, &q);
}

bool isVertexInConflict(const VoronoiCircle& circle, Corner i, Corner j, Corner k, const Site& q) {
  const MaybeSign filtered = circleFilter(circle, q);
  shadowCheck(filtered,
              [&] { return isVertexInConflict(i, j, k, q) ? Sign::kPositive : Sign::kNegative; });
  if (filtered.known) return filtered.sign == Sign::kPositive;
  return isVertexInConflict(i, j, k, q);
}

bool hasVoronoiCircle(const Site& i, const Site& j, const Site& k) {
  return !circleIsBeaten(&i, &j, &k, nullptr);
}

bool touchesCircle(const Site& i, const Site& j, const Site& k, const Site& q) {
  Corner a = &i, b = &j, c = &k;
  rotateToReference(a, b, c);
  return vertexSign(*a, b, c, &q) == Sign::kZero;
}

bool touchesBetween(const Site& i, const Site& j, const Site& k, const Site& q) {
  using stages::FaceCorner;
  Corner a = &i, b = &j, c = &k;
  rotateToReference(a, b, c);
  const FaceCorner corner = a == &k   ? FaceCorner::kReference
                            : b == &k ? FaceCorner::kJ
                                      : FaceCorner::kK;
  return vertexSign(*a, b, c, &q) == Sign::kZero && stages::isOpposite(*a, b, c, &q, corner);
}

}  // namespace apollonius::internal
