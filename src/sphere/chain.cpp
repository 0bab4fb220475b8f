#include "sphere/chain.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <tuple>
#include <utility>

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
Deviation fromSegment(const MapPoint& from, const LonLat& at, const MapPoint& to) {
  const auto unrolled = [&](const MapPoint& end) {
    // A pole has any longitude.
    const bool isPole = end.point.x == 0 && end.point.y == 0;
    const double way = end.at.lon - at.lon;
    const double turn = way > 180 ? 360 : way < -180 ? -360 : 0;
    return LonLat{isPole ? 0 : way - turn, end.at.lat - at.lat};
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

MapPoint ChainMaker::shown(const Direction& point) const {
  if (joint_ == Joint::kGreatArc) return {point, {}};
  const Direction snapped = snappedToBorder(point);
  return {snapped, lonLatOf(snapped)};
}

void ChainMaker::locate(MapPoint& point) const {
  if (joint_ == Joint::kGreatArc) point.at = lonLatOf(point.point);
}

const MapPoint& ChainMaker::vertexOf(FaceId face) {
  auto& [newer, older] = vertexPoints_;
  if (newer.first == face) return newer.second;
  std::swap(newer, older);
  if (newer.first == face) return newer.second;
  newer = {face, shown(vertices_[face].point)};
  locate(newer.second);
  return newer.second;
}

bool ChainMaker::isFine(const MapPoint& a, const MapPoint& middle, const MapPoint& b) const {
  // Lines of the plane that deviate from their curves by more than a small part of their length
  // could cross others.
  constexpr double kLongest = 45, kFlat = 1.0 / 32;
  if (joint_ == Joint::kGreatArc)
    return toGreatCircle(a.point, middle.point, b.point) <= tolerance_;
  const Deviation line = fromSegment(a, middle.at, b);
  return line.length <= kLongest &&
         line.distance <= std::min(tolerance_ * (180 / std::numbers::pi), kFlat * line.length);
}

void ChainMaker::follow(VertexId node, VertexId neighbor, const Sector& sector,
                        const MapPoint& first, const MapPoint& last, FlatArray<MapPoint>& points) {
  // Beside a pole, pieces become as short as the distance within which points are moved there.
  constexpr int kDeepest = 45;
  const Direction centre = diagram_.cap(node).centre, other = diagram_.cap(neighbor).centre;
  const Frame frame(centre);
  // Then the edge goes from one vertex to the other in their direction.
  const bool isStraight = missesVertices(sector, centre, frame, first.point, last.point);
  const double rho = angleBetween(centre, first.point).angle();
  const double rise = angleBetween(centre, last.point).angle() - rho;
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
  if (lengthOf(last.point - first.point) == 0 && sector.width < std::numbers::pi &&
      (!diagram_.areClose(node, neighbor) || lengthOf(pointAt(0.5).point - first.point) < kNone))
    return;
  MapPoint a = first;
  ends_.assign(1, last);
  // The piece under way is the one with this number of 2^depth.
  std::uint64_t number = 0;
  for (int depth = 0; !ends_.empty();) {
    const double part = 1 / static_cast<double>(std::uint64_t{1} << depth);
    const double width = part * sector.width;
    const double from = part * static_cast<double>(number);
    const MapPoint b = ends_.back();
    const MapPoint middle = pointAt(from + part / 2);
    const bool isDone = depth == kDeepest ||
                        (width < std::numbers::pi / 2 &&
                         (isShort(a.point, middle.point, b.point) ||
                          (isLessThanQuarter(other, a.point, b.point) && isFine(a, middle, b))));
    if (!isDone) {
      ends_.push_back(middle);
      ++depth;
      number *= 2;
      continue;
    }
    ends_.pop_back();
    if (!ends_.empty()) points.push_back(b);
    a = b;
    for (++number; depth > 0 && number % 2 == 0; --depth) number /= 2;
  }
}

bool ChainMaker::isOnePiece(VertexId node, VertexId neighbor, const MapPoint& from,
                            const MapPoint& to) const {
  constexpr double kClear = 0x1p-20;
  const Cap &cap = diagram_.cap(node), &other = diagram_.cap(neighbor);
  const Frame frame(cap.centre);
  const Direction &first = from.point, &last = to.point;
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
  return isFine(from, shown(bisector.at(x / length, y / length).point(cap.centre, frame)), to);
}

std::span<const MapPoint> ChainMaker::innerOf(HalfedgeId h, const MapPoint& first,
                                              const MapPoint& last) {
  if (!chains_.empty()) {
    const Chain& known = chains_[index(h)];
    if (known.isKnown) return {kept_.data() + known.begin, known.count};
  }
  const Graph& graph = diagram_.graph();
  const VertexId node = graph.origin(h), neighbor = graph.target(h);
  inner_.clear();
  if (!isOnePiece(node, neighbor, first, last))
    follow(node, neighbor, sectorOf(diagram_, h, vertices_), first, last, inner_);
  for (MapPoint& point : inner_) locate(point);
  if (!chains_.empty() && kept_.size() + inner_.size() <= kMostKept) {
    chains_[index(h)] = {static_cast<std::uint32_t>(kept_.size()),
                         static_cast<std::uint32_t>(inner_.size()), true};
    kept_.append({inner_.data(), inner_.size()});
  }
  return {inner_.data(), inner_.size()};
}

void ChainMaker::append(HalfedgeId h, FlatArray<MapPoint>& points) {
  const Graph& graph = diagram_.graph();
  const HalfedgeId twin = graph.twin(h);
  const MapPoint first = vertexOf(faceOf(twin)), last = vertexOf(faceOf(h));
  points.push_back(first);
  if (isFollowedFrom(graph.origin(h), graph.target(h))) {
    points.append(innerOf(h, first, last));
    return;
  }
  // The other site has the edge from `last` to `first`.
  const std::span<const MapPoint> inner = innerOf(twin, last, first);
  for (std::size_t k = inner.size(); k-- > 0;) points.push_back(inner[k]);
}

void ChainMaker::appendClosed(VertexId node, FlatArray<MapPoint>& points) {
  const VertexId other = otherOfTwo(diagram_, node);
  const bool isOwn = isFollowedFrom(node, other);
  const VertexId from = isOwn ? node : other, to = isOwn ? other : node;
  FlatArray<Sector> sectors;
  listSectors(diagram_, from, vertices_, sectors);
  Sector& sector = sectors[0];
  sector.from = sector.bisector.middle();
  const Direction centre = diagram_.cap(from).centre;
  const MapPoint start = shown(sector.bisector.at(sector.from).point(centre, Frame(centre)));
  const std::size_t begin = points.size();
  points.push_back(start);
  follow(from, to, sector, start, start, points);
  for (std::size_t k = begin; k < points.size(); ++k) locate(points[k]);
  if (!isOwn) std::reverse(points.begin() + begin + 1, points.end());
}

}  // namespace apollonius::internal::sphere
