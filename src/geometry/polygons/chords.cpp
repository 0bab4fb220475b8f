#include "geometry/polygons/chords.h"

#include <algorithm>

#include "number/fp.h"
#include "predicate/orientation.h"

namespace apollonius::internal {

namespace {

/// A chord whose deviation is less than this share of the piece's size is fine enough for any
/// tolerance: at most 2^18 points.
constexpr double kFinestShare = powerOfTwo(-36);
/// If a chord deviates by less than this share of its coordinates, and of its distance from the
/// site, the deviation is rounding: halving the chord does not bring it closer to the cells'
/// shapes.
constexpr double kRounding = powerOfTwo(-46);
/// A chord of two cells that deviates by less than this share of the piece's size is not halved for
/// the border: at most 2^10 points where the border runs along the edge.
constexpr double kFinestBetweenCells = powerOfTwo(-20);
/// The error of an edge's points can be this share of their coordinates, of their distances from
/// the sites and of the size of the edge (docs/PROOFS.md, "Polygons").
constexpr double kMostOff = powerOfTwo(-38);

/// Does the direction of a curve change by more than about 27 degrees?
bool bends(const Conic& curve) {
  const Point first = curve.p1 - curve.p0, last = curve.p2 - curve.p1;
  return dot(first, last) < 2 * absolute(cross(first, last));
}

}  // namespace

std::span<const Point> ChordFinder::find(const EdgePiece& piece) {
  const Conic& curve = piece.curve;
  left_ = piece.left;
  right_ = piece.right;
  avoided_ = piece.avoided;
  size_ = length(curve.p1 - curve.p0) + length(curve.p2 - curve.p1);
  const double numbers =
      std::max({absolute(curve.p0.x), absolute(curve.p0.y), length(curve.p0 - left_)});
  finest_ = std::max(kFinestShare * size_, kRounding * numbers);
  finestAtBorder_ = isBetweenCells() ? kFinestBetweenCells * size_ : finest_;
  allowed_ = std::max(tolerance_.distance, kFinestShare * size_);
  points_.clear();
  points_.push_back(curve.p0);
  halve(curve, piece.fromSegment, piece.toSegment, Conic::kMostHalvings);
  // An edge that touches a side can go beyond it by rounding.
  isAtBorder_ = false;
  for (std::size_t k = 1; k + 1 < points_.size(); ++k)
    isAtBorder_ = border_.moveInside(points_[k]) || isAtBorder_;
  straighten();
  return points_;
}

void ChordFinder::halve(const Conic& curve, std::uint32_t fromSegment, std::uint32_t toSegment,
                        int depth) {
  Conic first, second;
  if (!curve.isStraight() && depth > 0) {
    curve.halve(first, second);
    if (curve.isSplitBy(first.p2) && isHalved(curve, first, second, fromSegment, toSegment)) {
      halve(first, fromSegment, kNoSegment, depth - 1);
      halve(second, kNoSegment, toSegment, depth - 1);
      return;
    }
  }
  points_.push_back(curve.p2);
}

/// Is the chord of a curve not good enough?
bool ChordFinder::isHalved(const Conic& curve, const Conic& first, const Conic& second,
                           std::uint32_t fromSegment, std::uint32_t toSegment) const {
  const double sagitta = curve.sagitta();
  if (sagitta > allowed_) return true;
  // If a curve turns, so does the chord of at least one of its halves. If none does, rounding hides
  // the turn, and halving will not help, unless the curve goes around close sites between its ends.
  if (!turns(curve.p0, curve.p2))
    return (sagitta > finest_ && bends(curve)) || turns(first.p0, first.p2) ||
           turns(second.p0, second.p2);
  return !spansLittle(curve.p0, curve.p2) ||
         (sagitta > finest_ &&
          (isLarge(sagitta, curve, left_, fromSegment, toSegment) ||
           (isBetweenCells() && isLarge(sagitta, curve, right_, fromSegment, toSegment)))) ||
         (sagitta > finestAtBorder_ &&
          (entersDisc(curve.p0, curve.p2) || border_.isNear(curve, fromSegment, toSegment)));
}

/// Is the sagitta more than the allowed share of the height over the chord, towards a site?
bool ChordFinder::isLarge(double sagitta, const Conic& curve, Point site, std::uint32_t fromSegment,
                          std::uint32_t toSegment) const {
  const Point way = curve.p2 - curve.p0, from = middle(curve.p0, curve.p2);
  // 0 without a share
  const double least = sagitta / tolerance_.share * length(way);
  const double most = absolute(cross(way, site - from));
  return least > most || (least > 0 && !border_.holds(curve, from + (least / most) * (site - from),
                                                      fromSegment, toSegment));
}

/// Does a chord turn counter-clockwise about the site on its left, and clockwise about the other?
bool ChordFinder::turns(Point from, Point to) const {
  return orient2d(left_, from, to) == Sign::kPositive &&
         orient2d(right_, from, to) == Sign::kNegative;
}

/// Does a chord that turns span less than a quarter turn, seen from both sites?
bool ChordFinder::spansLittle(Point from, Point to) const {
  return dot(from - left_, to - left_) > 0 && dot(from - right_, to - right_) > 0;
}

/// Does a chord go into the disc that is avoided? Not if it leads away from the centre.
bool ChordFinder::entersDisc(Point from, Point to) const {
  if (isBetweenCells()) return false;
  const Point a = from - right_, b = to - right_, way = to - from;
  return dot(way, a) < 0 && dot(way, b) > 0 && absolute(cross(a, b)) < avoided_ * length(way);
}

/// Has rounding put p before `from`, seen from one of the sites?
bool ChordFinder::isLate(Point from, Point p) const {
  const double size =
      absolute(p.x) + absolute(p.y) + std::max(length(p - left_), length(p - right_)) + size_;
  return length(p - from) <= kMostOff * size && (orient2d(left_, from, p) == Sign::kNegative ||
                                                 orient2d(right_, from, p) == Sign::kPositive);
}

/// Drops the inner points that come before their predecessors by rounding.
void ChordFinder::straighten() {
  std::size_t kept = 0;
  for (std::size_t k = 1; k < points_.size(); ++k) {
    const bool isEnd = k + 1 == points_.size();
    const Point p = points_[k];
    while (isEnd && kept > 0 && (p == points_[kept] || isLate(points_[kept], p))) --kept;
    if (!isEnd && (p == points_[kept] || isLate(points_[kept], p))) continue;
    points_[++kept] = p;
  }
  points_.resize(kept + 1);
}

}  // namespace apollonius::internal
