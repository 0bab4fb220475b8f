// The Voronoi circles of two bounded faces at once, in doubles: what circle fans and restored snapshots spend most of their time on.
#pragma once

#include <limits>

#include "number/fp.h"
#include "number/pair.h"
#include "predicate/site.h"

namespace apollonius {

/// Differences of powers up to the twelfth are formed: no difference of coordinates may be larger.
inline constexpr double kLargestDifference = powerOfTwo(33);

/// A site of either face.
struct PairSite {
  Pair x, y, r;
};

/// The same less the pole of its face; p = x² + y² - r², m = x² + y² + r², l the largest of |x|, |y|, |r|.
struct PairRow {
  Pair x, y, r, p, m, l;
};

/// Centres, clearances and bounds as in VoronoiCircle; the error is infinite where it is not certain that there is a circle.
struct PairCircle {
  Pair x, y, s, error;
};

/// The circles of the faces (q, j, k); d = k - j. That an error is finite includes that no site of the face covers another.
///
/// The formulas and the bound are those of boundedCircle (voronoi_circle.cpp, where they are derived), seen from q. One division
/// serves all quotients, 1/(D den): 1/den = D · that, 1/p_j = p_k p_jk · den · that.
/// The computed D cancels, so f has five roundings more than the errors of p_j and den. Underflow: the last three conditions keep
/// D, D den and a component of the chord far above it, and what smaller products lose is far below the bound.
inline PairCircle circlePair(const PairSite& q, const PairRow& j, const PairRow& k, const PairSite& d) {
  constexpr double u1 = kUnitRoundoff;
  const Pair largestRelative = pairOf(powerOfTwo(-10)), zero = pairOf(0), tiny = pairOf(powerOfTwo(-900));
  const Pair dxy = d.x * d.x + d.y * d.y, drr = d.r * d.r;
  const Pair pjk = dxy - drr, mjk = dxy + drr;

  const Pair u = k.x * j.p - j.x * k.p, v = k.y * j.p - j.y * k.p, w = k.r * j.p - j.r * k.p;
  const Pair n2 = u * u + v * v;
  const Pair dd = pjk * (j.p * k.p);
  const Pair rootD = root(dd);
  const Pair a = v * rootD - w * u, b = -(u * rootD + w * v);
  const Pair den = a * j.x + b * j.y + n2 * j.r;
  const Pair inverse = 1 / (dd * den);
  const Pair inverseD = den * inverse, inverseDen = dd * inverse;
  const Pair f = 0.5 * j.p * inverseDen;
  const Pair rho = f * n2;
  const Pair x = q.x + f * a, y = q.y + f * b, s = rho - q.r;

  const Pair g = absolute(u) + absolute(v);
  const Pair eChord = 9 * u1 * (k.l * j.m + j.l * k.m);
  const Pair relativePj = 5 * u1 * j.m * (k.p * pjk * inverseD);
  const Pair relativeD = 2 * u1 + relativePj + 5 * u1 * ((mjk * k.p + k.m * pjk) * j.p * inverseD);
  const Pair eAb = g * (rootD * (0.5 * relativeD + 2 * u1) + 3 * eChord + 4 * u1 * g);
  const Pair eN = g * (2 * eChord + 3 * u1 * g);
  const Pair relativeDen = j.l * (2 * eAb + eN + 10 * u1 * g * g) * inverseDen;
  const Pair relativeF = relativePj + relativeDen + 8 * u1;
  const Pair error = f * (2 * eAb + eN) + 3 * rho * (relativeF + 2 * u1) + u1 * (absolute(x) + absolute(y) + absolute(s));
  const PairMask isGood = (eChord * g <= largestRelative * n2) & (relativeD <= largestRelative) & (relativeDen >= zero) &
                          (relativeDen <= largestRelative) & (pjk > zero) & (j.p > zero) & (k.p > zero) &
                          (n2 > pairOf(powerOfTwo(-400))) & (dd > tiny) & (dd * den > tiny);
  return {x, y, s, isGood ? error * (1 + powerOfTwo(-5)) : pairOf(std::numeric_limits<double>::infinity())};
}

}  // namespace apollonius
