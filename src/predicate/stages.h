// The stages of each predicate under fixed names, for predicates.cpp and for tests that assert
// which stage answers. A filter never contradicts the exact stage; it says "unknown" instead. There
// are two middle stages: `Middle` computes in doubles without rounding (small integers),
// `FixedInteger` in integers of fixed room (number/fixed_integer.h). REQUIRES of each: as of its
// predicate in predicates.h.
#pragma once

#include "number/approx.h"
#include "number/sign.h"
#include "predicate/predicates.h"
#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius::stages {

/// p of two sites: (xa-xb)² + (ya-yb)² - (ra-rb)².
[[nodiscard]] MaybeSign lorentzFilter(const Site& a, const Site& b);
[[nodiscard]] MaybeSign lorentzMiddle(const Site& a, const Site& b);
[[nodiscard]] Sign lorentzExact(const Site& a, const Site& b);

[[nodiscard]] MaybeSign distanceFilter(double x, double y, const Site& a, const Site& b);
/// For sites of equal weights only.
[[nodiscard]] MaybeSign distanceMiddle(double x, double y, const Site& a, const Site& b);
[[nodiscard]] MaybeSign distanceFixed(double x, double y, const Site& a, const Site& b);
[[nodiscard]] Sign distanceExact(double x, double y, const Site& a, const Site& b);

/// i is finite and the largest of the finite ones among i, j, k; q covers none of them; at most one
/// of the four is infinite (q = nullptr asks whether infinity is nearer, that is, whether the face
/// has no Voronoi circle). Positive: conflict; zero: q touches the circle. The first stage where
/// all weights are equal, for which it is made: doubles, exact on grids. Unknown where weights
/// differ.
[[nodiscard]] MaybeSign vertexOfPoints(const Site& i, Corner j, Corner k, Corner q);
[[nodiscard]] MaybeSign vertexFilter(const Site& i, Corner j, Corner k, Corner q);
[[nodiscard]] MaybeSign vertexMiddle(const Site& i, Corner j, Corner k, Corner q);
[[nodiscard]] MaybeSign vertexFixed(const Site& i, Corner j, Corner k, Corner q);
[[nodiscard]] Sign vertexExact(const Site& i, Corner j, Corner k, Corner q);
/// The answer where vertexExact is zero.
[[nodiscard]] bool vertexDegenerate(const Site& i, Corner j, Corner k, Corner q);
/// Its geometric part in long integers: of four sites that touch one circle (or line: one is
/// infinite), is q opposite to this corner?
enum class FaceCorner : unsigned char { kReference, kJ, kK };
[[nodiscard]] bool isOppositeExact(const Site& i, Corner j, Corner k, Corner q, FaceCorner corner);

/// The direction from the reference site whose membership in the edge's range of directions decides
/// an edge conflict: the middle of q's shadow on the bisector (neither end in conflict), or its
/// opposite (both ends in conflict).
enum class Probe : signed char { kMiddle = 1, kOpposite = -1 };

/// The first filter of edge conflicts: as edgeFilter, but the directions of the edge's ends come
/// from the cached circles of the faces (i, j, k) and (j, i, l).
[[nodiscard]] MaybeSign edgeCircleFilter(const Site& i, Corner j, const VoronoiCircle& atK,
                                         const VoronoiCircle& atL, const Site& q, Probe probe);

/// Positive: the direction is strictly within the range; zero or negative: it is not. i is finite,
/// and the larger of i and j if both are; q covers neither.
[[nodiscard]] MaybeSign edgeFilter(const Site& i, Corner j, Corner k, Corner l, const Site& q,
                                   Probe probe);
[[nodiscard]] MaybeSign edgeMiddle(const Site& i, Corner j, Corner k, Corner l, const Site& q,
                                   Probe probe);
[[nodiscard]] MaybeSign edgeFixed(const Site& i, Corner j, Corner k, Corner l, const Site& q,
                                  Probe probe);
[[nodiscard]] Sign edgeExact(const Site& i, Corner j, Corner k, Corner l, const Site& q,
                             Probe probe);

/// Two coordinates of a ray from i's centre through (x, y) in the frame of the direction d from
/// there to the vertex of the face (i, j, k): positive to the left of d, and positive along d.
enum class RayPart : signed char { kLeftwards, kAlong };
[[nodiscard]] MaybeSign rayFilter(double x, double y, const Site& i, Corner j, Corner k,
                                  RayPart part);
[[nodiscard]] MaybeSign rayMiddle(double x, double y, const Site& i, Corner j, Corner k,
                                  RayPart part);
[[nodiscard]] MaybeSign rayFixed(double x, double y, const Site& i, Corner j, Corner k,
                                 RayPart part);
[[nodiscard]] Sign rayExact(double x, double y, const Site& i, Corner j, Corner k, RayPart part);

/// The turn from the middle of l's shadow on the bisector of i and j to that of k's. i is larger
/// than j; none of the four covers i or j.
[[nodiscard]] MaybeSign shadowTurnFilter(const Site& i, const Site& j, const Site& l,
                                         const Site& k);
[[nodiscard]] Sign shadowTurnExact(const Site& i, const Site& j, const Site& l, const Site& k);
/// Is the angle of the outer normal of the face (i, j, infinity) in [0, pi)?
[[nodiscard]] bool normalIsUpExact(const Site& i, const Site& j);
/// The turn from the outer normal of the face (i, l, infinity) to that of (k, i, infinity).
[[nodiscard]] Sign spanExact(const Site& i, const Site& l, const Site& k);

/// How often each stage answered in this thread since the last reset (`cached`: the filter by
/// cached circles). Vertex conflicts and distances that are settled where they arise (circleFilter,
/// walks) are not counted.
struct Counts {
  unsigned long long lorentzFilter = 0;
  unsigned long long lorentzMiddle = 0;
  unsigned long long lorentzExact = 0;
  unsigned long long distanceFilter = 0;
  unsigned long long distanceMiddle = 0;
  unsigned long long distanceFixed = 0;
  unsigned long long distanceExact = 0;
  unsigned long long vertexOfPoints = 0;
  unsigned long long vertexFilter = 0;
  unsigned long long vertexMiddle = 0;
  unsigned long long vertexFixed = 0;
  unsigned long long vertexExact = 0;
  unsigned long long vertexDegenerate = 0;
  unsigned long long edgeCached = 0;
  unsigned long long edgeFilter = 0;
  unsigned long long edgeMiddle = 0;
  unsigned long long edgeFixed = 0;
  unsigned long long edgeExact = 0;
  unsigned long long rayCached = 0;
  unsigned long long rayFilter = 0;
  unsigned long long rayMiddle = 0;
  unsigned long long rayFixed = 0;
  unsigned long long rayExact = 0;
};
[[nodiscard]] Counts& counts();

}  // namespace apollonius::stages
