#include "geometry/ring.h"

#include <vector>

#include "geometry/approximate.h"
#include "geometry/turn.h"
#include "number/fp.h"

namespace apollonius::internal {

namespace {

class Ring {
 public:
  Ring(Point center, std::vector<double>& points)
      : center_(center), points_(points), begin_(points.size()) {}

  void add(Point p) {
    points_.push_back(p.x);
    points_.push_back(p.y);
  }

  /// Of a chain of curves, which began at place `from`, drops the points that come before their
  /// predecessors by rounding. Its ends stay: points of the border, or the ring's start. Rounding
  /// can put points on the center itself, which from there is in no direction: what comes after
  /// them is compared with what came before.
  void straighten(std::size_t from) {
    std::size_t kept = from;
    const auto isLate = [&](Point p) {
      return isBefore(p, at(kept > from && at(kept) == center_ ? kept - 1 : kept));
    };
    for (std::size_t k = from + 1; k < count(); ++k) {
      const bool isFixed = k + 1 == count();
      while (isFixed && kept > from && isLate(at(k))) --kept;
      if (at(k) == at(kept) || (!isFixed && isLate(at(k)))) continue;
      put(++kept, at(k));
    }
    points_.resize(begin_ + 2 * (kept + 1));
  }

  [[nodiscard]] std::size_t count() const { return (points_.size() - begin_) / 2; }
  [[nodiscard]] Point at(std::size_t k) const {
    return {points_[begin_ + 2 * k], points_[begin_ + 2 * k + 1]};
  }

  /// Removes the ring if its area is not positive (a hole's negative): it has less than three
  /// different points, or is in the wrong order.
  bool finish(bool isHole) {
    double area = 0;
    for (std::size_t k = 1; k + 1 < count(); ++k) area += cross(at(k) - at(0), at(k + 1) - at(0));
    if (isHole ? area < 0 : area > 0) return true;
    points_.resize(begin_);
    return false;
  }

 private:
  void put(std::size_t k, Point p) {
    points_[begin_ + 2 * k] = p.x;
    points_[begin_ + 2 * k + 1] = p.y;
  }

  /// Is p clockwise of q, and by no more than vertices can be off (edge.h)?
  [[nodiscard]] bool isBefore(Point p, Point q) const {
    const double size = absolute(p.x) + absolute(p.y) + length(p - center_);
    return length(p - q) <= powerOfTwo(-38) * size && turnOf(center_, q, p) == Sign::kNegative;
  }

  Point center_;
  std::vector<double>& points_;
  std::size_t begin_;
};

}  // namespace

namespace {

/// Does a piece of the border not run counter-clockwise along a side, because rounding has
/// exchanged two contacts (border.h), which may be on the two sides of a corner? Then it counts as
/// a curve.
bool runsBackwards(const Window& window, const Conic& piece) {
  const Point a = piece.p0, b = piece.p2;
  const auto areOn = [](double side, double p, double q) { return p == side && q == side; };
  return !((areOn(window.ymin, a.y, b.y) && b.x >= a.x) ||
           (areOn(window.xmax, a.x, b.x) && b.y >= a.y) ||
           (areOn(window.ymax, a.y, b.y) && b.x <= a.x) ||
           (areOn(window.xmin, a.x, b.x) && b.y <= a.y));
}

/// One try; false, with nothing appended, if it is no ring.
bool tryRing(std::span<const BoundaryPiece> boundary, Point center, const Window* window,
             bool isHole, double tolerance, std::vector<double>& points) {
  Ring ring(center, points);
  ring.add(boundary.front().curve.p0);
  std::size_t from = 0;  // the start of a chain of curves
  bool isOnCurve = false;
  for (const BoundaryPiece& piece : boundary) {
    if (piece.neighbor == kNoSite && (window == nullptr || !runsBackwards(*window, piece.curve))) {
      if (isOnCurve) ring.straighten(from);
      isOnCurve = false;
      ring.add(piece.curve.p2);
      continue;
    }
    if (!isOnCurve) from = ring.count() - 1;
    isOnCurve = true;
    flattenConic(piece.curve, tolerance, points, &center);
  }
  if (isOnCurve) ring.straighten(from);
  return ring.finish(isHole);
}

/// Finer than this share of the tolerance is not tried.
constexpr double kFinestShare = powerOfTwo(-42);

}  // namespace

bool appendRing(std::span<const BoundaryPiece> boundary, Point center, const Window* window,
                bool isHole, double tolerance, std::vector<double>& points) {
  // Where a part is thinner than the tolerance, between a curve and the border, say, nothing may be
  // left of it: then finer.
  for (double share = 1; share >= kFinestShare; share *= powerOfTwo(-6)) {
    if (tryRing(boundary, center, window, isHole, share * tolerance, points)) return true;
  }
  return false;
}

}  // namespace apollonius::internal
