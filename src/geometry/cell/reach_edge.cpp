#include "geometry/cell/reach_edge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/curve/edge.h"
#include "number/fp.h"

namespace apollonius::internal {

namespace {

/// The largest parameter E of a bisector within the reach of a site; the least is its reciprocal. 0
/// if there is none.
double endOfReach(const Site& site, ReachOfSite reach, const Site& other,
                  const Bisector& bisector) {
  const double cosh = (2 * reach.radius + (other.r - site.r)) / bisector.distance();
  if (!(cosh > 1)) return 0;
  const bool isImmense = cosh > powerOfTwo(500);  // its square may be infinite
  return cosh + (isImmense ? cosh : std::sqrt((cosh - 1) * (cosh + 1)));
}

/// A point on the bisector, with its parameter E.
struct Place {
  double e;
  Point point;
};

ReachedPiece reversed(const ReachedPiece& piece) {
  return {piece.curve.reversed(), piece.isShared, piece.isToCut, piece.isFromCut};
}

}  // namespace

std::pair<double, double> rangeOf(const Bisector& bisector, const Conic& piece) {
  const double e0 = bisector.parameterOf(piece.p0), e1 = bisector.parameterOf(piece.p2);
  constexpr double kWide = 2;
  const double half = piece.w + std::sqrt(std::max((piece.w - 1) * (piece.w + 1), 0.0));
  if (piece.w < kWide || e1 >= half * e0) return {e0, std::max(e0, e1)};
  const double middle = bisector.parameterOf(piece.at(0.5));
  return {middle / half, middle * half};
}

ReachedEdge reachedEdge(const Site& site, ReachOfSite reach, const Site& neighbor,
                        ReachOfSite itsReach, const Conic& curve) {
  // Computed from the reference site, whichever of the two asks.
  const bool isReference = precedes(neighbor, site);
  const Site &a = isReference ? site : neighbor, &b = isReference ? neighbor : site;
  const Conic piece = isReference ? curve : curve.reversed();
  const Bisector bisector(a, b);
  ReachedEdge found;
  const auto [first, last] = rangeOf(bisector, piece);
  const Place start{first, piece.p0}, end{last, piece.p2};
  // If both have the same distance, computed from one of them: the bits must not depend on which
  // one asks.
  const bool isSame = reach.distance == itsReach.distance && !isReference;
  const double own = isSame ? endOfReach(neighbor, itsReach, site, bisector)
                            : endOfReach(site, reach, neighbor, bisector);
  const double both =
      itsReach.distance < reach.distance ? endOfReach(neighbor, itsReach, site, bisector) : own;
  if (own == 0) return found;
  // An edge inside that has no length in doubles still says that the cell ends there.
  const auto add = [&](Place from, Place to, bool isShared) {
    const bool isWhole = from.e == start.e && to.e == end.e;
    if (from.point == to.point && !isWhole) return;
    const Conic part = isWhole ? piece : pieceOf(bisector, from.e, to.e, from.point, to.point);
    found.pieces[found.count++] = {part, isShared && (isWhole || !isTouch(bisector, part))};
  };
  // Cuts at the ends of the site's reach, and between them at the ends of what both reach.
  const bool isFromCut = start.e<1 / own, isToCut = end.e> own;
  const Place from = isFromCut ? Place{1 / own, bisector.at(1 / own)} : start;
  const Place to = isToCut ? Place{own, bisector.at(own)} : end;
  if (from.e > to.e) return found;
  const double low = both == 0 ? to.e : 1 / both;
  if (both == 0 || low >= to.e || both <= from.e) {
    add(from, to, false);
  } else {
    const bool isLow = low > from.e, isHigh = both < to.e;
    const Place in = isLow ? Place{low, bisector.at(low)} : from;
    const Place out = isHigh ? Place{both, bisector.at(both)} : to;
    if (isLow) add(from, in, false);
    add(in, out, true);
    if (isHigh) add(out, to, false);
  }
  if (found.count == 0) return found;
  found.pieces[0].isFromCut = isFromCut;
  found.pieces[found.count - 1].isToCut = isToCut;
  if (!isReference) {
    std::reverse(found.pieces.begin(), found.pieces.begin() + found.count);
    for (std::size_t k = 0; k < found.count; ++k) found.pieces[k] = reversed(found.pieces[k]);
  }
  return found;
}

}  // namespace apollonius::internal
