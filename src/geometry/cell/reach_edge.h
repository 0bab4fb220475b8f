// The part of an edge within a distance from its two sites. Along a bisector the distance from both
// circles is (D/2) cosh t - (ra + rb)/2, so the part is where cosh t is small enough: no equation
// has to be solved.
#pragma once

#include <array>
#include <utility>

#include "geometry/curve/bisector.h"
#include "geometry/curve/conic.h"
#include "predicate/site.h"

namespace apollonius::internal {

/// How far a site reaches: from its circle and from its centre. Both are kept, each as accurate as
/// it is known.
struct ReachOfSite {
  double distance, radius;
};
[[nodiscard]] inline ReachOfSite reachOf(const Site& site, double distance) {
  return {distance, site.r + distance};
}

/// A part of an edge, counter-clockwise about the site that asks.
struct ReachedPiece {
  Conic curve;
  bool isShared;  ///< is it within the neighbor's reach, too, and more than a touch of it?
  /// Does it end where the site's reach does, rather than where the edge given does?
  bool isFromCut = false, isToCut = false;
};

/// At most three pieces, in the order of the edge: beyond the neighbor's reach, within both,
/// beyond.
struct ReachedEdge {
  std::array<ReachedPiece, 3> pieces;
  std::size_t count = 0;
};

/// The parameters E of a piece's ends. Where a circle nearly covers the other, both sides of the
/// branch are one ray in doubles; then the conic's weight tells how far the piece extends to both
/// sides of its middle. REQUIRES: the piece runs counter-clockwise about the reference site.
[[nodiscard]] std::pair<double, double> rangeOf(const Bisector& bisector, const Conic& piece);

/// Cuts a piece of the edge of two sites, counter-clockwise about the first one, at the distances
/// that these reach. Both sites get the same bits for what they share.
[[nodiscard]] ReachedEdge reachedEdge(const Site& site, ReachOfSite reach, const Site& neighbor,
                                      ReachOfSite itsReach, const Conic& curve);

}  // namespace apollonius::internal
