// Seeded sets of circles, from harmless to exactly degenerate. Deterministic on every platform: + -
// * / and sqrt only; directions come from the rational parametrisation of the circle. Units are
// non-dimensional; "hidden" means covered by another circle of the set (internal tangency
// included).
#pragma once

#include <cstddef>
#include <vector>

#include "apollonius/diagram.h"
#include "support/random.h"

namespace apollonius::test {

using Circles = std::vector<Circle>;

/// x, y, r of each, as batches take them.
inline std::vector<double> flat(const Circles& circles) {
  std::vector<double> xyr;
  for (const Circle& c : circles) xyr.insert(xyr.end(), {c.x, c.y, c.r});
  return xyr;
}

/// A point of the unit circle, correct to rounding, every direction possible (not uniform in angle,
/// but nearly).
struct Direction {
  double x;
  double y;
};
Direction randomDirection(Random& random);

// --- General position

/// Share of hidden circles in randomCircles.
enum class Hidden { kNone, k5Percent, k20Percent, k50Percent, k95Percent };

/// Centres uniform in [-1e6, 1e6]^2 and radii uniform in [0, R] as in Table 1 of the paper, R
/// chosen for the share of hidden circles (kNone: points, R = 0). For small n the share is only
/// roughly met.
Circles randomCircles(Random& random, std::size_t n, Hidden hidden);

/// Radii over six orders of magnitude, many small and few large ones (r = 1e6 / 10^(6u), u uniform,
/// made by square roots).
Circles powerLaw(Random& random, std::size_t n);

/// A circle of radius 1e6 and n small ones with centres close to its rim.
Circles giantDisk(Random& random, std::size_t n);

// --- Natural data

/// randomCircles with 5 percent hidden, of which one is this many times the mean spacing away: a
/// fault of a receiver, or a number that stands for "unknown".
Circles outlier(Random& random, std::size_t n, double spacings);

/// Eight towns, 100 m wide, on a continent of 8e7 m; circles that hardly overlap.
Circles towns(Random& random, std::size_t n);

/// Circles at distances from the origin between 2^-40 and 2^40, every power of two as often, in all
/// directions; radii up to the spacing there.
Circles everyScale(Random& random, std::size_t n);

// --- Degenerate position

/// Integers: coordinates in 0..maxCoordinate, radii in 0..maxRadius; duplicates and covered circles
/// as they come.
Circles tinyGrid(Random& random, std::size_t n, int maxCoordinate, int maxRadius);

/// Centres (i, j) * spacing for 0 <= i < columns, 0 <= j < rows, all with radius r, in random
/// order. With spacing 0.1 the cocircularities are broken by rounding only.
Circles lattice(Random& random, int columns, int rows, double spacing, double r);

/// Random integer centres, one radius.
Circles equalRadii(Random& random, std::size_t n);

/// Chains of circles of which each is exactly tangent to its predecessor, from outside or from
/// inside (then it is hidden).
Circles tangentOutside(Random& random, std::size_t n);
Circles tangentInside(Random& random, std::size_t n);

/// Few centres, many radii: of each centre only the largest circle can be visible.
Circles concentric(Random& random, std::size_t n);

/// Families of nested circles side by side, each of one kind: identical, concentric, touching in
/// one point from inside, or nested ones with a small circle in each gap; and now and then a giant
/// around some of them. Integers, in random order.
Circles nestedFamilies(Random& random, std::size_t n);

/// The line of centres of `collinear`.
enum class Line { kHorizontal, kVertical, kDiagonal, kRandomSlope };

/// Centres exactly on one line, equally spaced or not; radii 0..maxRadius (0: points).
Circles collinear(Random& random, std::size_t n, Line line, bool equalSpacing, int maxRadius);

/// Circles that touch a line of any rational direction from one side, exactly; with `lines` 2 also
/// a parallel one from the other side, so that some touch both. Weights are 0..heaviest times a
/// common factor (0: points on the lines).
Circles tangentLines(Random& random, std::size_t n, int lines, int heaviest);

/// Integer points with x^2 + y^2 = 32045^2 (5 * 13 * 17 * 29, 324 points), all of one radius.
Circles cocircularPoints(Random& random, std::size_t n);

/// Integer circles that all touch the circle of radius `common` about the origin from outside:
/// centre (a, b) of a Pythagorean triple (a, b, c) and weight c - common, negative where c <
/// common. No two cover each other unless they share a direction.
Circles commonTangent(Random& random, std::size_t n, int common);

/// Integer circles (x (m + 1), y (m + 1), m c) for x² + y² = c², c = 32045: all touch the circle of
/// radius c about the origin from outside, and so one vertex has as many edges of length zero; many
/// directions coincide; m is 0 for half of them and huge for a few. Some are resized by one unit.
Circles tangentInLayers(Random& random, std::size_t n);

/// A giant circle and n integer circles, each exactly tangent to it: from outside (visible), from
/// inside (hidden), or with its centre exactly on the rim.
Circles giantDiskExact(Random& random, std::size_t n);

// --- Extremes of the number range

/// The magnitudes of the coordinates and radii of rangeEnds.
enum class Range { kHuge, kTiny, kMixed };

/// kHuge: up to 1e100. kTiny: between 1e-100 and 1e-97, or 0. kMixed: any power of two in the
/// range, and 0.
Circles rangeEnds(Random& random, std::size_t n, Range range);

/// Clusters within clusters: each circle is another one plus offsets of any magnitude from the
/// cluster's size down to one ulp. With farApart, two such families of sizes about 2^-250 and
/// 2^250.
Circles nestedClusters(Random& random, std::size_t n, bool farApart);

/// Coordinates and radii that differ by a few units in the last place from a common circle.
Circles oneUlpApart(Random& random, std::size_t n);

}  // namespace apollonius::test
