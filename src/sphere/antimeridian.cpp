// The ring is taken apart into arcs that run inside of the rectangle from border to border. The
// cell is at the left of each, so along the border, counter-clockwise, it reaches from the end of
// an arc to the next beginning of one. A pole is a side of the rectangle: a ring that comes to it
// on one longitude ends there, and begins again on another.
//
// Where an arc ends and one begins in the same place, up to rounding, either nothing of the border
// is between them or all of it: all of it, where the ring would be clockwise without.
#include "sphere/antimeridian.h"

#include <algorithm>
#include <cmath>

namespace apollonius::internal::sphere {

namespace {

bool isPole(const Direction& p) { return p.x == 0 && p.y == 0; }
bool isOnBorder(const Direction& p) { return p.y == 0 && p.x <= 0; }

/// A point of the border as the end of a chord whose other end is not there.
LonLat borderPoint(const Direction& p, const Direction& other) {
  if (isPole(p)) return {lonLatOf(other).lon, lonLatOf(p).lat};
  return {other.y < 0 ? -180.0 : 180.0, lonLatOf(p).lat};
}

/// Does a chord between two points that are not on the border cross it? Then `latitude` receives
/// where: the same bits in both directions.
bool crossesBorder(const Direction& a, const Direction& b, double& latitude) {
  if ((a.y < 0) == (b.y < 0)) return false;
  const Direction &east = a.y < 0 ? b : a, &west = a.y < 0 ? a : b;
  // Where y is 0, times the difference of the two y, which is positive.
  const double x = west.x * east.y - east.x * west.y;
  if (!(x < 0)) return false;
  latitude = lonLatOf({x, 0, west.z * east.y - east.z * west.y}).lat;
  return true;
}

// Positions on the border: degrees from the lower left corner, counter-clockwise.
constexpr double kRight = 360, kTop = 540, kLeft = 900, kWhole = 1080;

double positionOf(const LonLat& p) {
  if (p.lat <= -90) return p.lon + 180;
  if (p.lat >= 90) return kTop + 180 - p.lon;
  return p.lon > 0 ? kRight + 90 + p.lat : kLeft + 90 - p.lat;
}

/// In degrees: as far as rounding can move a crossing of the border, where a ring is thin.
constexpr double kRounding = 0x1p-20;

/// Twice the area, positive for a counter-clockwise ring.
double signedArea(const FlatArray<LonLat>& ring) {
  double sum = 0;
  const LonLat *before = &ring.back(), origin = ring[0];
  for (const LonLat& p : ring) {
    sum += (before->lon - origin.lon) * (p.lat - origin.lat) -
           (p.lon - origin.lon) * (before->lat - origin.lat);
    before = &p;
  }
  return sum;
}

/// In both coordinates.
double lengthOf(const FlatArray<LonLat>& ring) {
  double sum = 0;
  const LonLat* before = &ring.back();
  for (const LonLat& p : ring) {
    sum += std::abs(p.lon - before->lon) + std::abs(p.lat - before->lat);
    before = &p;
  }
  return sum;
}

bool areSame(const LonLat& a, const LonLat& b) { return a.lon == b.lon && a.lat == b.lat; }

}  // namespace

Direction snappedToBorder(const Direction& p) {
  constexpr double kNear = 1e-12;
  if (p.x * p.x + p.y * p.y < kNear * kNear) return {0, 0, p.z > 0 ? 1.0 : -1.0};
  if (p.x < 0 && std::abs(p.y) < kNear) return {p.x, 0, p.z};
  return p;
}

AntimeridianCutter::AntimeridianCutter(double tolerance)
    : thinnest_(std::max(tolerance, kRounding)) {}

void AntimeridianCutter::beginArc(const LonLat& point) {
  Arc arc;
  arc.begin = points_.size();
  arc.from = positionOf(point);
  arcs_.push_back(arc);
  points_.push_back(point);
}

void AntimeridianCutter::endArc(const LonLat& point) {
  points_.push_back(point);
  arcs_.back().end = points_.size();
  arcs_.back().to = positionOf(point);
}

void AntimeridianCutter::followChords(std::span<const Direction> ring, std::size_t first) {
  for (std::size_t k = 0; k <= ring.size(); ++k) {
    // The first chord crosses the border, or begins there; before that, it comes again at the end.
    const bool isAgain = k == ring.size();
    const Direction& a = ring[(first + k) % ring.size()];
    const Direction& b = ring[(first + k + 1) % ring.size()];
    double latitude = 0;
    if (isOnBorder(a)) {
      if (isAgain) return;
      if (isOnBorder(b)) continue;
      beginArc(borderPoint(a, b));
    } else if (k > 0) {
      points_.push_back(lonLatOf(a));
    }
    if (isOnBorder(b)) {
      endArc(borderPoint(b, a));
    } else if (!isOnBorder(a) && crossesBorder(a, b, latitude)) {
      if (k > 0) endArc({a.y < 0 ? -180.0 : 180.0, latitude});
      if (isAgain) return;
      beginArc({b.y < 0 ? -180.0 : 180.0, latitude});
    }
  }
}

void AntimeridianCutter::cut(std::span<const Direction> ring, bool isHoleIfThin,
                             LonLatRings& output) {
  points_.clear();
  arcs_.clear();
  ring_.clear();
  const auto addRectangle = [&] { addBorder(-1, kWhole); };
  if (ring.empty()) {
    addRectangle();
    if (emitRing(output)) output.endPart();
    return;
  }
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Direction &a = ring[k], &b = ring[(k + 1) % ring.size()];
    double latitude = 0;
    if (!isOnBorder(a) && (isOnBorder(b) || !crossesBorder(a, b, latitude))) continue;
    followChords(ring, k);
    linkArcs();
    joinArcs(isHoleIfThin, output);
    return;
  }
  for (const Direction& p : ring) ring_.push_back(lonLatOf(p));
  const bool isInHole = isHole(isHoleIfThin);
  if (isInHole) {
    const FlatArray<LonLat> hole = ring_;
    ring_.clear();
    addRectangle();
    (void)emitRing(output);
    ring_ = hole;
  }
  if (emitRing(output) || isInHole) output.endPart();
}

bool AntimeridianCutter::isHole(bool ifThin) const {
  const double area = signedArea(ring_);
  return std::abs(area) > thinnest_ * lengthOf(ring_) ? area < 0 : ifThin;
}

/// Finds for each arc the one that follows it along the border.
void AntimeridianCutter::linkArcs() {
  for (Arc& arc : arcs_) {
    double least = kWhole;
    for (std::size_t k = 0; k < arcs_.size(); ++k) {
      if (arcs_[k].isFollowed) continue;
      const double ahead = arcs_[k].from - arc.to;
      const double way = ahead < -kRounding ? ahead + kWhole : ahead;
      // One that is behind by rounding comes before those that are ahead by more.
      if (!(way < least) || (way < 0 && least < kRounding)) continue;
      least = way;
      arc.next = k;
    }
    arc.border = least;
    arcs_[arc.next].isFollowed = true;
  }
}

void AntimeridianCutter::joinArcs(bool isHoleIfThin, LonLatRings& output) {
  for (std::size_t first = 0; first < arcs_.size(); ++first) {
    if (arcs_[first].isDone) continue;
    Arc* touching = nullptr;
    for (std::size_t k = first; !arcs_[k].isDone; k = arcs_[k].next) {
      Arc& arc = arcs_[k];
      arc.isDone = true;
      if (arc.border < kRounding) touching = &arc;
    }
    trace(first);
    if (touching != nullptr && isHole(isHoleIfThin)) {
      touching->border += kWhole;
      trace(first);
    }
    const bool isFlat = std::ranges::all_of(
        ring_, [&](const LonLat& p) { return p.lon == ring_[0].lon || p.lat == ring_[0].lat; });
    if (isFlat && signedArea(ring_) == 0) continue;  // of arcs along the border
    if (emitRing(output)) output.endPart();
  }
}

/// The ring of an arc and those that follow it.
void AntimeridianCutter::trace(std::size_t first) {
  ring_.clear();
  std::size_t k = first;
  do {
    const Arc& arc = arcs_[k];
    ring_.append({points_.data() + arc.begin, arc.end - arc.begin});
    addBorder(arc.to, arc.to + arc.border);
    k = arc.next;
  } while (k != first);
}

/// The corners between two positions.
void AntimeridianCutter::addBorder(double from, double to) {
  constexpr LonLat kCorners[] = {{-180, -90}, {180, -90}, {180, 90}, {-180, 90}};
  constexpr double kPositions[] = {0, kRight, kTop, kLeft};
  for (unsigned k = 0; k < 8; ++k) {
    const double position = kPositions[k % 4] + (k < 4 ? 0 : kWhole);
    if (position > from && position < to) ring_.push_back(kCorners[k % 4]);
  }
}

bool AntimeridianCutter::emitRing(LonLatRings& output) {
  // Closed, and no point twice in a row.
  std::size_t kept = 0;
  for (const LonLat& p : ring_) {
    if (kept == 0 || !areSame(p, ring_[kept - 1])) ring_[kept++] = p;
  }
  while (kept > 1 && areSame(ring_[kept - 1], ring_[0])) --kept;
  if (kept < 3) return false;
  for (std::size_t k = 0; k <= kept; ++k) {
    const LonLat& p = ring_[k == kept ? 0 : k];
    output.coordinates.push_back(p.lon);
    output.coordinates.push_back(p.lat);
  }
  output.endRing();
  return true;
}

}  // namespace apollonius::internal::sphere
