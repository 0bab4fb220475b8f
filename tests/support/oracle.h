// The additively weighted Voronoi diagram of a few circles by brute force, exactly, from the
// definition. It shares nothing with src/ but the public struct Circle: neither numbers nor
// predicates nor the way the equations are solved. Meant for about a dozen circles (time n^4).
//
// Degenerate position: infinity begins where the nearest site is further than an immense clearance,
// the horizon; and weights get r + epsilon, where a larger site (by r, then x, then y) has the
// infinitely larger epsilon, all of them infinitely small against the horizon's inverse. The oracle
// does that literally: where an exact test comes out zero, it repeats it with a concrete horizon if
// infinity is involved, then with the weight of the largest site involved enlarged by a concrete
// tiny number, then that of the two largest, and so on.
#pragma once

#include <array>
#include <vector>

#include "apollonius/diagram.h"
#include "support/generators.h"

namespace apollonius::test {

inline constexpr int kInfinity = -1;  ///< the site at infinity in a Triple

/// Three indices of circles, counter-clockwise around the Voronoi circle that touches them, the
/// smallest first.
using Triple = std::array<int, 3>;

struct OracleDiagram {
  std::vector<bool> visible;  ///< per circle; of identical circles the first one is the visible one
  /// The faces of the Delaunay graph, those with infinity included, sorted.
  std::vector<Triple> triples;
  /// The edges that run to infinity: i, j with i's cell on the left of the way outwards, sorted.
  /// Two cells can share two. Found without any perturbation; they are the triples with infinity
  /// (oracle_test).
  std::vector<std::array<int, 2>> unboundedEdges;
};

/// Ways of the oracle to make degenerate input generic. kWhereNeeded: as said above, the default.
/// kEverything: all weights are perturbed from the start, by other amounts; slower, for checking
/// the oracle against itself.
enum class Perturb { kWhereNeeded, kEverything };

OracleDiagram oracleDiagram(const Circles& circles, Perturb perturb = Perturb::kWhereNeeded);

/// Index of the circle nearest to (x, y); ties go to the larger r, then x, then y, then the smaller
/// index. -1 if empty.
int oracleNearest(const Circles& circles, double x, double y);

/// Is `inner` covered by `outer` (closed: internal tangency and identity count)?
bool oracleCovers(const Circle& outer, const Circle& inner);

/// The order of sites: r, then x, then y.
bool oracleSmaller(const Circle& a, const Circle& b);

/// Does the Voronoi circle of the counter-clockwise face (i, j, k) exist, and is it free of q?
/// Sites are rows of `circles`, kInfinity for infinity (j or k or q, not i). The first question's
/// answer is kNoCircle or one of the other two.
enum class CircleAnswer { kNoCircle, kFree, kInConflict };
CircleAnswer oracleCircle(const Circles& circles, int i, int j, int k, int q);

/// Is the Voronoi circle of the counter-clockwise face (i, j, k), which exists, within `error` of
/// an estimate (x and y of its centre, r for its clearance), each of the three numbers for itself?
bool oracleCircleIsWithin(const Circle& i, const Circle& j, const Circle& k, const Circle& estimate,
                          double error);

/// Sign of (|p - a| - r_a) - (|p - b| - r_b).
int oracleCompareDistance(double x, double y, const Circle& a, const Circle& b);

}  // namespace apollonius::test
