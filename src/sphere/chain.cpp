#include "sphere/chain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>

#include "sphere/antimeridian.h"
#include "sphere/bisector.h"

namespace apollonius::internal::sphere {

namespace {

/// Less than a quarter turn about a site: the arcs between a cell's points are in sectors of their
/// own then, and never meet.
bool isLessThanQuarter(const Direction& up, const Direction& a, const Direction& b) {
  // By the ways from the site, or from its antipode: little is left of long vectors close to those.
  const auto away = [&](const Direction& p) { return dot(p, up) > 0 ? p - up : p + up; };
  const Direction toA = away(a), toB = away(b);
  return dot(toA, toB) - dot(toA, up) * dot(toB, up) > 0;
}

/// A piece so short that its direction and its bend are rounding, and halving it would not end.
bool isShort(const Direction& a, const Direction& middle, const Direction& b) {
  constexpr double kShort = 0x1p-46;
  return lengthOf(b - a) < kShort && lengthOf(middle - a) < kShort;
}

/// From a point to the great circle through two others.
double toGreatCircle(const Direction& a, const Direction& point, const Direction& b) {
  const Direction normal = cross(a, b);
  const double length = lengthOf(normal);
  return length == 0 ? lengthOf(point - a) : std::abs(dot(normal, point)) / length;
}

/// A segment of the plane of longitude and latitude, in degrees, and how far a point of its curve
/// is from it.
struct Deviation {
  double distance, length;
};

/// The plane is unrolled about the point.
Deviation fromSegment(const Direction& from, const Direction& point, const Direction& to) {
  const LonLat at = lonLatOf(point);
  const auto unrolled = [&](const Direction& end) {
    const LonLat there = lonLatOf(end);
    // A pole has any longitude.
    const bool isPole = end.x == 0 && end.y == 0;
    return LonLat{isPole ? 0 : std::remainder(there.lon - at.lon, 360), there.lat - at.lat};
  };
  const LonLat a = unrolled(from), b = unrolled(to);
  const double x = b.lon - a.lon, y = b.lat - a.lat;
  const double square = x * x + y * y;
  const double along = square == 0 ? 0 : std::clamp(-(a.lon * x + a.lat * y) / square, 0.0, 1.0);
  return {std::hypot(a.lon + along * x, a.lat + along * y), std::sqrt(square)};
}

/// Is an edge as narrow as rounding, seen from its site, and does the bisector as computed miss its
/// vertices? So it can be where sites are close to each other, or one nearly covers another: there
/// rounding moves vertices along the edge, and the bisector to the side.
bool missesVertices(const Sector& sector, const Direction& centre, const Frame& frame,
                    const Direction& first, const Direction& last) {
  constexpr double kThin = 0x1p-16, kNear = 0x1p-20;
  const auto isMissed = [&](double bearing, const Direction& vertex) {
    return lengthOf(sector.bisector.at(bearing).point(centre, frame) - vertex) > kNear;
  };
  return sector.width < kThin &&
         (isMissed(sector.from, first) || isMissed(sector.from + sector.width, last));
}

}  // namespace

bool ChainMaker::isFollowedFrom(VertexId node, VertexId neighbor) const {
  const auto key = [](const Cap& cap) {
    return std::tuple(cap.weight, cap.centre.x, cap.centre.y, cap.centre.z);
  };
  return key(diagram_.cap(node)) > key(diagram_.cap(neighbor));
}

Direction ChainMaker::shown(const Direction& point) const {
  return joint_ == Joint::kGreatArc ? point : snappedToBorder(point);
}

bool ChainMaker::isFine(const Direction& a, const Direction& middle, const Direction& b) const {
  // Lines of the plane that deviate from their curves by more than a small part of their length
  // could cross others.
  constexpr double kLongest = 45, kFlat = 1.0 / 32;
  if (joint_ == Joint::kGreatArc) return toGreatCircle(a, middle, b) <= tolerance_;
  const Deviation line = fromSegment(a, middle, b);
  return line.length <= kLongest &&
         line.distance <= std::min(tolerance_ * (180 / std::numbers::pi), kFlat * line.length);
}

void ChainMaker::follow(VertexId node, VertexId neighbor, const Sector& sector,
                        const Direction& first, const Direction& last,
                        FlatArray<Direction>& points) const {
  // Beside a pole, pieces become as short as the distance within which points are moved there.
  constexpr int kDeepest = 45;
  const Direction centre = diagram_.cap(node).centre, other = diagram_.cap(neighbor).centre;
  const Frame frame(centre);
  points.push_back(first);
  // Then the edge goes from one vertex to the other in their direction.
  const bool isStraight = missesVertices(sector, centre, frame, first, last);
  const double rho = angleBetween(centre, first).angle();
  const double rise = angleBetween(centre, last).angle() - rho;
  const auto pointAt = [&](double part) {
    const double bearing = sector.from + part * sector.width;
    if (!isStraight) return shown(sector.bisector.at(bearing).point(centre, frame));
    const double x = std::cos(bearing), y = std::sin(bearing);
    const SphericalBisector::At at = {std::cos(rho + part * rise), std::sin(rho + part * rise), x,
                                      y, 0};
    return shown(at.point(centre, frame));
  };
  // An edge that ends where it begins has no length; between close sites it may come round from the
  // other end of the sphere.
  constexpr double kNone = 0x1p-40;
  if (lengthOf(last - first) == 0 && sector.width < std::numbers::pi &&
      (!diagram_.areClose(node, neighbor) || lengthOf(pointAt(0.5) - first) < kNone))
    return;
  Direction a = first;
  // The piece under way is the one with this number of 2^depth.
  std::uint64_t number = 0;
  for (int depth = 0; number < std::uint64_t{1} << depth;) {
    const std::uint64_t pieces = std::uint64_t{1} << depth;
    const double part = 1 / static_cast<double>(pieces), width = part * sector.width;
    const double from = part * static_cast<double>(number);
    const Direction b = number + 1 == pieces ? last : pointAt(from + part);
    const Direction middle = pointAt(from + part / 2);
    const bool isDone =
        depth == kDeepest ||
        (width < std::numbers::pi / 2 &&
         (isShort(a, middle, b) || (isLessThanQuarter(other, a, b) && isFine(a, middle, b))));
    if (!isDone) {
      ++depth;
      number *= 2;
      continue;
    }
    if (number + 1 < pieces) points.push_back(b);
    a = b;
    for (++number; depth > 0 && number % 2 == 0; --depth) number /= 2;
  }
}

bool ChainMaker::isOnePiece(VertexId node, VertexId neighbor, const Direction& first,
                            const Direction& last) const {
  constexpr double kClear = 0x1p-20;
  const Cap &cap = diagram_.cap(node), &other = diagram_.cap(neighbor);
  const Frame frame(cap.centre);
  const double x1 = dot(first, frame.first), y1 = dot(first, frame.second);
  const double x2 = dot(last, frame.first), y2 = dot(last, frame.second);
  const double length1 = std::sqrt(x1 * x1 + y1 * y1), length2 = std::sqrt(x2 * x2 + y2 * y2);
  const double turn = x1 * y2 - x2 * y1;  // the sine, times both lengths
  if (!(turn > kClear * length1 * length2) || !(x1 * x2 + y1 * y2 > 0) ||
      !isLessThanQuarter(other.centre, first, last))
    return false;
  const double x = x1 * length2 + x2 * length1, y = y1 * length2 + y2 * length1;
  const double length = std::sqrt(x * x + y * y);
  const SphericalBisector bisector(diagram_, node, frame, neighbor);
  return isFine(first, shown(bisector.at(x / length, y / length).point(cap.centre, frame)), last);
}

void ChainMaker::append(HalfedgeId h, FlatArray<Direction>& points) {
  const Graph& graph = diagram_.graph();
  const HalfedgeId twin = graph.twin(h);
  const VertexId node = graph.origin(h), neighbor = graph.target(h);
  const Direction first = shown(vertices_[faceOf(twin)].point);
  const Direction last = shown(vertices_[faceOf(h)].point);
  const bool isFollowed = isFollowedFrom(node, neighbor);
  if (isFollowed ? isOnePiece(node, neighbor, first, last)
                 : isOnePiece(neighbor, node, last, first)) {
    points.push_back(first);
    return;
  }
  if (isFollowed) {
    follow(node, neighbor, sectorOf(diagram_, h, vertices_), first, last, points);
    return;
  }
  // The other site has the edge from `last` to `first`.
  const std::size_t begin = points.size();
  follow(neighbor, node, sectorOf(diagram_, twin, vertices_), last, first, points);
  points.push_back(first);
  std::reverse(points.begin() + begin, points.end());
  points.pop_back();
}

void ChainMaker::appendClosed(VertexId node, FlatArray<Direction>& points) {
  const VertexId other = otherOfTwo(diagram_, node);
  const bool isOwn = isFollowedFrom(node, other);
  const VertexId from = isOwn ? node : other, to = isOwn ? other : node;
  FlatArray<Sector> sectors;
  listSectors(diagram_, from, vertices_, sectors);
  Sector& sector = sectors[0];
  sector.from = sector.bisector.middle();
  const std::size_t begin = points.size();
  const Direction centre = diagram_.cap(from).centre;
  const Direction start = shown(sector.bisector.at(sector.from).point(centre, Frame(centre)));
  follow(from, to, sector, start, start, points);
  if (!isOwn) std::reverse(points.begin() + begin + 1, points.end());
}

}  // namespace apollonius::internal::sphere
