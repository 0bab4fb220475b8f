#include "geometry/cell/ring_sorter.h"

#include <algorithm>

#include "geometry/curve/moments.h"

namespace apollonius::internal {

namespace {

/// How far rounding moves a region's boundary at most where it meets an edge, relative to the
/// coordinates there and the distance from the site. Thinner parts are discarded.
constexpr double kThinnest = powerOfTwo(-46);

}  // namespace

void RingSorter::clear(Point center) {
  center_ = center;
  found_.pieces.clear();
  found_.starts.assign(1, 0);
  areas_.clear();
  nesting_.clear();
}

void RingSorter::closeRing(bool isGiven) {
  const std::uint32_t start = found_.starts.back();
  const auto pieces = std::span(found_.pieces).subspan(start);
  if (pieces.empty()) return;
  double reach = 0, size = 0;
  const Point first = pieces.front().curve.p0;
  Rectangle box{first.x, first.y, first.x, first.y};
  for (const BoundaryPiece& piece : pieces) {
    const Point from = piece.curve.p0;
    reach += length(piece.curve.p2 - from);
    size = std::max({size, absolute(from.x), absolute(from.y), length(from - center_)});
    for (const Point p : {piece.curve.p1, piece.curve.p2}) box.include(p);
  }
  const Area area = areaOf(pieces, pieces.front().curve.p0);
  // A ring of the window has an area (polygon.h).
  const double thinnest = std::max(area.rounding, kThinnest * size * reach);
  if (isGiven || absolute(area.value) > thinnest || parts_ == Parts::kThinToo) {
    found_.starts.push_back(static_cast<std::uint32_t>(found_.pieces.size()));
    if (area.value > 0) nesting_.add(static_cast<std::uint32_t>(areas_.size()), area.value, box);
    areas_.push_back(area.value);
  } else {
    found_.pieces.resize(start);
  }
}

bool crossesRay(const Conic& c, Point p) {
  bool isCrossed = false;
  if ((c.p0.y > p.y) != (c.p2.y > p.y)) {
    const double turn = cross(c.p2 - c.p0, p - c.p0);
    isCrossed = (turn > 0) == (c.p2.y > c.p0.y);
  }
  if (c.isStraight()) return isCrossed;
  // Between chord and curve? There the barycentric coordinates in the control triangle are
  // positive, and b² < 4 w² a c.
  const double whole = cross(c.p1 - c.p0, c.p2 - c.p0);
  const double a = cross(c.p1 - p, c.p2 - p) / whole, b = cross(c.p2 - p, c.p0 - p) / whole,
               g = cross(c.p0 - p, c.p1 - p) / whole;
  return isCrossed != (a > 0 && b > 0 && g > 0 && b * b < 4 * c.w * c.w * a * g);
}

void RingSorter::sortInto(Cell& cell) {
  const auto take = [&](std::size_t k) {
    cell.pieces.append(found_.ring(k));
    cell.starts.push_back(static_cast<std::uint32_t>(cell.pieces.size()));
  };
  const std::size_t count = areas_.size();
  if (parts_ == Parts::kThinToo) {  // nesting is not determined
    for (std::uint32_t k = 0; k < count; ++k) take(k);
    if (count > 0) cell.outers.push_back(static_cast<std::uint32_t>(count));
    return;
  }
  FlatArray<Keyed> holes;  // by the smallest ring around each
  for (std::uint32_t hole = 0; hole < count; ++hole) {
    if (areas_[hole] > 0) continue;
    const Conic& first = found_.ring(hole).front().curve;
    asked_ = middle(first.p0, first.p2);
    const std::uint32_t around = nesting_.find(asked_, -areas_[hole]);
    holes.push_back({around == RingNesting::kNoRing ? 0 : around, hole});
  }
  sortByKey(holes);
  std::size_t next = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    const bool isOuter = areas_[k] > 0;
    if (isOuter) take(k);
    for (; next < holes.size() && holes[next].key == k; ++next) {
      if (isOuter) take(holes[next].value);
    }
    if (!isOuter) continue;
    cell.outers.push_back(static_cast<std::uint32_t>(cell.ringCount()));
  }
}

}  // namespace apollonius::internal
