// What of an edge is within a distance from its two sites: along a bisector the distance from the
// circles is (D/2) cosh t - (ra + rb)/2, the same for both, so it is within where cosh t is small
// enough: no equation is to be solved.
#pragma once

#include <array>
#include <utility>

#include "geometry/curve/bisector.h"
#include "geometry/curve/conic.h"
#include "predicate/site.h"

namespace apollonius::internal {

/// How far a site reaches: from its circle, and the same from its centre, each as accurate as it is
/// known.
struct ReachOfSite {
  double distance, radius;
};
[[nodiscard]] inline ReachOfSite reachOf(const Site& site, double distance) {
  return {distance, site.r + distance};
}

/// A part of an edge, counter-clockwise about the site that asks.
struct ReachedPiece {
  Conic curve;
  bool isShared;  ///< is it within the neighbor's reach, too, and not but touches it?
  /// Does it end where the site's reach does, rather than where the edge given does?
  bool isFromCut = false, isToCut = false;
};

/// At most three, in the order of the edge: beyond the neighbor's reach, within both, beyond.
struct ReachedEdge {
  std::array<ReachedPiece, 3> pieces;
  std::size_t count = 0;
};

/// The places E of a piece's ends. Where a circle nearly covers the other, both sides of the branch
/// are one ray in doubles; then the weight tells how far the piece goes to both sides of its
/// middle. REQUIRES: the piece runs counter-clockwise about the reference site.
[[nodiscard]] std::pair<double, double> rangeOf(const Bisector& bisector, const Conic& piece);

/// Cuts a piece of the edge of two sites, counter-clockwise about the first one, at the distances
/// that these reach. Both get the same bits of what they share.
[[nodiscard]] ReachedEdge reachedEdge(const Site& site, ReachOfSite reach, const Site& neighbor,
                                      ReachOfSite itsReach, const Conic& curve);

}  // namespace apollonius::internal
