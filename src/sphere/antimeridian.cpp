// The ring is divided into arcs that run inside of the rectangle from border to border. The cell is
// on the left of each, so along the border, counter-clockwise, it reaches from the end of an arc to
// the next beginning of one. A pole is a side of the rectangle: a ring that comes to it on one
// longitude ends there, and begins again on another.
//
// Points are within a tolerance of the cell. Where the cell is thinner, an arc may begin behind the
// point where another one ends instead of before it, and a ring may be clockwise that should not
// be. So the area of the cell decides: each turn around the border adds the area of the sphere, 4
// pi.
#include "sphere/antimeridian.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace apollonius::internal::sphere {

namespace {

bool isOnBorder(const Direction& p) { return p.y == 0 && p.x <= 0; }

/// A point of the border as the end of a chord whose other end is not on the border.
LonLat borderPoint(const MapPoint& p, const MapPoint& other) {
  if (p.point.x == 0) return {other.at.lon, p.at.lat};  // a pole
  return {other.point.y < 0 ? -180.0 : 180.0, p.at.lat};
}

/// Does a chord between two points that are not on the border cross it? Then `latitude` receives
/// the latitude at which the line on the map crosses, which is close to the curve: the same bits in
/// both directions.
bool crossesBorder(const MapPoint& a, const MapPoint& b, double& latitude) {
  if ((a.point.y < 0) == (b.point.y < 0)) return false;
  const MapPoint &east = a.point.y < 0 ? b : a, &west = a.point.y < 0 ? a : b;
  // x where y is 0, times the difference of the two y, which is positive.
  if (!(west.point.x * east.point.y - east.point.x * west.point.y < 0)) return false;
  const double toEast = 180 - east.at.lon, toWest = 180 + west.at.lon;
  latitude = (east.at.lat * toWest + west.at.lat * toEast) / (toEast + toWest);
  return true;
}

// Positions on the border: degrees from the lower left corner, counter-clockwise.
constexpr double kRight = 360, kTop = 540, kLeft = 900, kWhole = 1080;

double positionOf(const LonLat& p) {
  if (p.lat <= -90) return p.lon + 180;
  if (p.lat >= 90) return kTop + 180 - p.lon;
  return p.lon > 0 ? kRight + 90 + p.lat : kLeft + 90 - p.lat;
}

/// Twice the area on the map, positive for a counter-clockwise ring.
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

/// Length of a ring on the map: the sum of both coordinates' changes.
double lengthOf(const FlatArray<LonLat>& ring) {
  double sum = 0;
  const LonLat* before = &ring.back();
  for (const LonLat& p : ring) {
    sum += std::abs(p.lon - before->lon) + std::abs(p.lat - before->lat);
    before = &p;
  }
  return sum;
}

/// The area on the sphere between a chord and the equator, positive westwards in the north: as
/// accurate as the chords, which are within a tolerance.
double areaBelow(const LonLat& a, const LonLat& b) {
  return (a.lon - b.lon) * kRadian * (std::sin(a.lat * kRadian) + std::sin(b.lat * kRadian)) / 2;
}

/// The area on the sphere between a part of the border, counter-clockwise, and the equator: 2 pi
/// for each pole.
double areaOfBorder(double from, double to) {
  const auto upTo = [](double position) {
    const double turns = std::floor(position / kWhole), rest = position - turns * kWhole;
    const double bottom = std::min(rest, kRight);
    const double top = std::clamp(rest - kTop, 0.0, kLeft - kTop);
    return turns * (kRight + kLeft - kTop) + bottom + top;
  };
  return (upTo(to) - upTo(from)) * kRadian;
}

double areaOfRing(const FlatArray<LonLat>& ring) {
  double area = 0;
  const LonLat* before = &ring.back();
  for (const LonLat& p : ring) {
    area += areaBelow(*before, p);
    before = &p;
  }
  return area;
}

/// By how many whole spheres an area is too large.
int surplusOf(double area, double ofCell) {
  return static_cast<int>(std::lround((area - ofCell) / (4 * std::numbers::pi)));
}

bool areSame(const LonLat& a, const LonLat& b) { return a.lon == b.lon && a.lat == b.lat; }

}  // namespace

Direction snappedToBorder(const Direction& p) {
  if (p.x * p.x + p.y * p.y < kNearPole * kNearPole) return {0, 0, p.z > 0 ? 1.0 : -1.0};
  if (p.x < 0 && std::abs(p.y) < kNearBorder) return {p.x, 0, p.z};
  return p;
}

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

void AntimeridianCutter::followChords(std::span<const MapPoint> ring, std::size_t first) {
  for (std::size_t k = 0; k <= ring.size(); ++k) {
    // The first chord crosses the border, or begins there; its part before that comes at the end.
    const bool isAgain = k == ring.size();
    const MapPoint& from = ring[(first + k) % ring.size()];
    const MapPoint& to = ring[(first + k + 1) % ring.size()];
    const Direction &a = from.point, &b = to.point;
    double latitude = 0;
    if (isOnBorder(a)) {
      if (isAgain) return;
      if (isOnBorder(b)) continue;
      beginArc(borderPoint(from, to));
    } else if (k > 0) {
      points_.push_back(from.at);
    }
    if (isOnBorder(b)) {
      endArc(borderPoint(to, from));
    } else if (!isOnBorder(a) && crossesBorder(from, to, latitude)) {
      if (k > 0) endArc({a.y < 0 ? -180.0 : 180.0, latitude});
      if (isAgain) return;
      beginArc({b.y < 0 ? -180.0 : 180.0, latitude});
    }
  }
}

void AntimeridianCutter::cut(std::span<const MapPoint> ring, FunctionRef<double()> areaOfCell,
                             LonLatRings& output) {
  points_.clear();
  arcs_.clear();
  ring_.clear();
  const auto emitRectangle = [&] {
    ring_.clear();
    addBorder(-1, kWhole);
    (void)emitRing(output);
  };
  if (ring.empty()) {
    emitRectangle();
    output.endPart();
    return;
  }
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const MapPoint &a = ring[k], &b = ring[(k + 1) % ring.size()];
    double latitude = 0;
    if (!isOnBorder(a.point) && (isOnBorder(b.point) || !crossesBorder(a, b, latitude))) continue;
    followChords(ring, k);
    if (arcs_.empty()) {
      // The ring follows the border, as a needle along it does: the cell is all or nothing.
      if (surplusOf(0, areaOfCell()) == 0) return;
      emitRectangle();
      output.endPart();
      return;
    }
    linkArcs(areaOfCell());
    emitArcs(output);
    return;
  }
  for (const MapPoint& p : ring) ring_.push_back(p.at);
  const bool isOuter = signedArea(ring_) > thinnest_ * lengthOf(ring_);
  const bool isHole = !isOuter && surplusOf(areaOfRing(ring_), areaOfCell()) < 0;
  if (isHole) {
    const FlatArray<LonLat> hole = ring_;
    emitRectangle();
    ring_ = hole;
  }
  if (emitRing(output) || isHole) output.endPart();
}

/// Finds for each arc the one that follows it along the border.
void AntimeridianCutter::linkArcs(double areaOfCell) {
  double areaOfArcs = 0;
  for (const Arc& arc : arcs_) {
    for (std::size_t k = arc.begin + 1; k < arc.end; ++k)
      areaOfArcs += areaBelow(points_[k - 1], points_[k]);
  }
  const auto surplus = [&] {
    double area = areaOfArcs;
    for (const Arc& arc : arcs_) area += areaOfBorder(arc.to, arc.to + arc.border);
    return surplusOf(area, areaOfCell);
  };
  linkNext();
  // Some begin behind an end that they should be before: those that are behind by the least.
  for (std::size_t count = 1; count <= arcs_.size() && surplus() > 0; ++count) {
    for (Arc& arc : arcs_) arc.isLinked = arc.isFollowed = false;
    for (std::size_t k = 0; k < count; ++k) linkBehind();
    linkNext();
  }
  for (std::size_t k = 0; k < arcs_.size() && surplus() < 0; ++k)
    std::ranges::min_element(arcs_, {}, &Arc::border)->border += kWhole;
}

/// Links the end and the beginning behind it that are closest. REQUIRES: not all are linked.
void AntimeridianCutter::linkBehind() {
  double least = 2 * kWhole;
  Arc* before = nullptr;
  std::size_t next = 0;
  for (Arc& arc : arcs_) {
    if (arc.isLinked) continue;
    for (std::size_t k = 0; k < arcs_.size(); ++k) {
      const double behind = arc.to - arcs_[k].from;
      const double way = behind < 0 ? behind + kWhole : behind;
      if (arcs_[k].isFollowed || !(way < least)) continue;
      least = way;
      before = &arc;
      next = k;
    }
  }
  before->next = next;
  before->border = -least;
  before->isLinked = arcs_[next].isFollowed = true;
}

/// Links all others to the next beginning.
void AntimeridianCutter::linkNext() {
  for (Arc& arc : arcs_) {
    if (arc.isLinked) continue;
    arc.border = kWhole;
    for (std::size_t k = 0; k < arcs_.size(); ++k) {
      const double ahead = arcs_[k].from - arc.to;
      const double way = ahead < 0 ? ahead + kWhole : ahead;
      if (arcs_[k].isFollowed || !(way < arc.border)) continue;
      arc.border = way;
      arc.next = k;
    }
    arc.isLinked = arcs_[arc.next].isFollowed = true;
  }
}

void AntimeridianCutter::emitArcs(LonLatRings& output) {
  for (std::size_t first = 0; first < arcs_.size(); ++first) {
    if (arcs_[first].isDone) continue;
    trace(first);
    const bool isFlat = std::ranges::all_of(
        ring_, [&](const LonLat& p) { return p.lon == ring_[0].lon || p.lat == ring_[0].lat; });
    if (isFlat && signedArea(ring_) == 0) continue;  // made of arcs along the border only
    if (emitRing(output)) output.endPart();
  }
}

/// Traces the ring of an arc and those that follow it.
void AntimeridianCutter::trace(std::size_t first) {
  ring_.clear();
  std::size_t k = first;
  do {
    Arc& arc = arcs_[k];
    arc.isDone = true;
    ring_.append({points_.data() + arc.begin, arc.end - arc.begin});
    addBorder(arc.to, arc.to + arc.border);
    k = arc.next;
  } while (k != first);
}

/// Adds the corners of the rectangle between two positions.
void AntimeridianCutter::addBorder(double from, double to) {
  constexpr LonLat kCorners[] = {{-180, -90}, {180, -90}, {180, 90}, {-180, 90}};
  constexpr double kPositions[] = {0, kRight, kTop, kLeft};
  for (unsigned k = 0; k < 8; ++k) {
    const double position = kPositions[k % 4] + (k < 4 ? 0 : kWhole);
    if (position > from && position < to) ring_.push_back(kCorners[k % 4]);
  }
}

bool AntimeridianCutter::emitRing(LonLatRings& output) {
  // Writes a closed ring, no point twice in a row.
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
