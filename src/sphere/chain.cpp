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

/// Is the turn about a site less than a quarter? Then the arcs between a cell's points are in
/// sectors of their own, and never meet.
bool isLessThanQuarter(const Direction& up, const Direction& a, const Direction& b) {
  // Uses the differences from the site, or from its antipode: close to these, vectors themselves
  // would lose most digits.
  const auto away = [&](const Direction& p) { return dot(p, up) > 0 ? p - up : p + up; };
  const Direction toA = away(a), toB = away(b);
  return dot(toA, toB) - dot(toA, up) * dot(toB, up) > 0;
}

/// The square of the sine of the angle to the nearer pole.
double fromAxis(const Direction& p) { return p.x * p.x + p.y * p.y; }
bool isAtPole(const Direction& p) { return p.x == 0 && p.y == 0; }

/// The distance from a point to the great circle through two others. Uses differences, which are
/// more accurate for close points: with `b` and `point` themselves, rounding would grow as pieces
/// are halved.
double toGreatCircle(const Direction& a, const Direction& point, const Direction& b) {
  const Direction normal = cross(a, b - a);
  const double length = lengthOf(normal);
  return length == 0 ? lengthOf(point - a) : std::abs(dot(normal, point - a)) / length;
}

/// A segment of the plane of longitude and latitude, in degrees. The plane is unrolled about a
/// point of the segment's curve, the origin.
struct Segment {
  Segment(const MapPoint& from, const LonLat& at, const MapPoint& to)
      : a(unrolled(from, at)), b(unrolled(to, at)) {}

  static LonLat unrolled(const MapPoint& end, const LonLat& at) {
    const double way = end.at.lon - at.lon;
    const double turn = way > 180 ? 360 : way < -180 ? -360 : 0;
    // A pole has any longitude.
    return {isAtPole(end.point) ? 0 : way - turn, end.at.lat - at.lat};
  }

  [[nodiscard]] double squaredLength(double width = 1) const {
    const double x = width * (b.lon - a.lon), y = b.lat - a.lat;
    return x * x + y * y;
  }
  /// The squared distance from the origin. A degree of longitude is as wide as `width` of latitude.
  [[nodiscard]] double squaredDistance(double width = 1) const {
    const double x = width * (b.lon - a.lon), y = b.lat - a.lat, square = x * x + y * y;
    const double along = -(width * a.lon * x + a.lat * y);
    const double part = square == 0 ? 0 : std::clamp(along / square, 0.0, 1.0);
    const double aside = width * a.lon + part * x, up = a.lat + part * y;
    return aside * aside + up * up;
  }

  LonLat a, b;
};

/// The point at an angle and a bearing from a centre.
Direction pointAt(const Direction& centre, const Frame& frame, double angle, double bearing) {
  const double x = std::cos(bearing), y = std::sin(bearing);
  return std::cos(angle) * centre + std::sin(angle) * (x * frame.first + y * frame.second);
}

/// Is an edge as narrow as rounding, seen from its site, and does the computed bisector miss its
/// vertices? This is possible if sites are close to each other, or one nearly covers another: then
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
  const Direction& vertex = vertices_[face].point;
  const Direction point = joint_ == Joint::kGreatArc ? vertex : snappedToBorder(vertex);
  newer = {face, {point, {}}};
  LonLat& at = places_.empty() ? newer.second.at : places_[index(face)];
  if (places_.empty() || at.lat == kUnknown) at = lonLatOf(point);
  newer.second.at = at;
  return newer.second;
}

bool ChainMaker::isFine(const MapPoint& a, const MapPoint& middle, const MapPoint& b) const {
  if (joint_ == Joint::kGreatArc)
    return toGreatCircle(a.point, middle.point, b.point) <= tolerance_;
  constexpr double kLongest = 45, kFlat = 1.0 / 32;
  const Segment line(a, middle.at, b);
  if (line.squaredLength() > kLongest * kLongest) return false;
  // Measured in degrees on the sphere, as longitude means little beside a pole. Deviations within
  // the distance by which points are moved do not come from the curve.
  const double width = std::sqrt(fromAxis(middle.point));
  const double aside = kRadian * kRadian * line.squaredDistance(width);
  if (aside <= kNearBorder * kNearBorder) return true;
  // Lines that deviate from their curves by more than a small part of their length could cross
  // others. So could lines near a pole, where others may be shorter, if they deviate by more than a
  // small part of their distance from the pole.
  const double length = kRadian * kRadian * line.squaredLength(width);
  const auto toPole = [](const Direction& end) { return isAtPole(end) ? 1 : fromAxis(end); };
  return aside <= kFlat * kFlat * std::min({length, toPole(a.point), toPole(b.point)}) &&
         kRadian * kRadian * line.squaredDistance() <= tolerance_ * tolerance_;
}

bool ChainMaker::isShort(const Direction& a, const Direction& middle, const Direction& b) const {
  const bool isBesidePole = joint_ == Joint::kLonLatLine && (isAtPole(a) || isAtPole(b));
  const double most = isBesidePole ? 2 * kNearPole : 0x1p-46;
  return lengthOf(b - a) < most && lengthOf(middle - a) < most;
}

bool ChainMaker::mayTurnBack(const MapPoint& a, const MapPoint& b) const {
  if (joint_ == Joint::kGreatArc) return false;
  // The deviation of a great circle that crosses the equator is about 2^-5 of the cubed length.
  const double length = std::sqrt(Segment(a, a.at, b).squaredLength()) * kRadian;
  return length * length * length > 16 * tolerance_;
}

void ChainMaker::subdivide(double width, const MapPoint& first, const MapPoint& last,
                           PointAt pointAt, FitOf fitOf, FlatArray<MapPoint>& points) {
  // Where an edge passes a pole, pieces become as short as the distance within which points are
  // moved to the pole.
  constexpr int kDeepest = 45;
  constexpr double kAside =
      19.0 / 64;  // share of a piece at which an S is away from it, unlike at its middle
  MapPoint a = first;
  const std::size_t outer = ends_.size();
  ends_.push_back(last);
  // The current piece has this number, of 2^depth.
  std::uint64_t number = 0;
  for (int depth = 0; ends_.size() > outer;) {
    const double part = 1 / static_cast<double>(std::uint64_t{1} << depth);
    const double from = part * static_cast<double>(number);
    const MapPoint b = ends_.back();
    const MapPoint middle = pointAt(from + part / 2);
    Fit fit = Fit::kCoarse;
    if (depth == kDeepest) {
      fit = width > 0 ? Fit::kRadial : Fit::kFine;
    } else if (part * width < std::numbers::pi / 2) {
      if (isShort(a.point, middle.point, b.point)) {
        fit = Fit::kFine;
      } else {
        const auto isFineAt = [&](double share) {
          return isFine(a, pointAt(from + share * part), b);
        };
        const bool isClose = isFine(a, middle, b) &&
                             (!mayTurnBack(a, b) || (isFineAt(kAside) && isFineAt(1 - kAside)));
        if (isClose) fit = fitOf(a, b);
      }
    }
    if (fit == Fit::kCoarse) {
      ends_.push_back(middle);
      ++depth;
      number *= 2;
      continue;
    }
    ends_.pop_back();
    if (fit == Fit::kRadial) appendArc(a, b, points);
    if (ends_.size() > outer) points.push_back(b);
    a = b;
    for (++number; depth > 0 && number % 2 == 0; --depth) number /= 2;
  }
}

/// An edge as it is followed, from one site. Its points are given by a part of it, from 0 to 1.
struct ChainMaker::Edge {
  Edge(const ProjectedDiagram& diagram, VertexId from, VertexId to, const Sector& along,
       const MapPoint& begin, const MapPoint& end)
      : node(from),
        neighbor(to),
        sector(along),
        first(begin),
        last(end),
        centre(diagram.cap(from).centre),
        frame(centre),
        isStraight(missesVertices(sector, centre, frame, first.point, last.point)),
        rho(angleBetween(centre, first.point).angle()),
        rise(angleBetween(centre, last.point).angle() - rho) {
    // Between close sites an edge that ends where it begins may come round from the other end of
    // the sphere.
    constexpr double kNone = 0x1p-40;
    isPoint = lengthOf(last.point - first.point) == 0 && sector.width < std::numbers::pi &&
              (!diagram.areClose(node, neighbor) || lengthOf(at(0.5) - first.point) < kNone);
  }

  [[nodiscard]] Direction at(double part) const {
    const double bearing = sector.from + part * sector.width;
    if (!isStraight) return sector.bisector.at(bearing).point(centre, frame);
    const double angle = rho + part * rise;
    return pointAt(centre, frame, angle, bearing);
  }
  /// Calls visit(from, to) for each part that is nearer to the site than the angle `reach`, which
  /// is above 0.
  template <class Visit>
  void visitWithin(double reach, Visit&& visit) const {
    const bool isFirstWithin = rho <= reach, isLastWithin = rho + rise <= reach;
    if (isPoint || sector.width == 0) {
      if (isFirstWithin) visit(0.0, 1.0);
    } else if (!isStraight) {
      sphere::visitWithin(sector, reach, [&](double from, double to) {
        visit(from / sector.width, to / sector.width);
      });
    } else if (isFirstWithin || isLastWithin) {
      const double cut = isFirstWithin && isLastWithin ? 1 : (reach - rho) / rise;
      if (isFirstWithin) {
        visit(0.0, cut);
      } else {
        visit(cut, 1.0);
      }
    }
  }

  VertexId node, neighbor;
  Sector sector;
  MapPoint first, last;
  Direction centre;
  Frame frame;
  bool isStraight;   // it goes from one vertex to the other in their direction
  bool isPoint;      // it has no length
  double rho, rise;  // how far the first one is from the site, and the last one farther
};

void ChainMaker::follow(const Edge& edge, double from, double to, const MapPoint& first,
                        const MapPoint& last, FlatArray<MapPoint>& points) {
  if (edge.isPoint) return;
  const Direction other = diagram_.cap(edge.neighbor).centre;
  const auto pointAt = [&](double part) { return shown(edge.at(from + part * (to - from))); };
  const auto fitOf = [&](const MapPoint& a, const MapPoint& b) {
    if (!isLessThanQuarter(other, a.point, b.point)) return Fit::kCoarse;
    return edge.isStraight ? Fit::kFine : fitAtChord(edge, a, b);
  };
  subdivide((to - from) * edge.sector.width, first, last, pointAt, fitOf, points);
}

void ChainMaker::appendArc(const MapPoint& a, const MapPoint& b, FlatArray<MapPoint>& points) {
  if (joint_ == Joint::kGreatArc) return;
  const auto pointAt = [&](double part) {
    const Direction point = (1 - part) * a.point + part * b.point;
    return shown(1 / lengthOf(point) * point);
  };
  subdivide(0, a, b, pointAt, kIsFine, points);
}

ChainMaker::Fit ChainMaker::fitTowards(const SphericalBisector& bisector, const Direction& centre,
                                       const Frame& frame, double x, double y, const MapPoint& a,
                                       const MapPoint& b) const {
  const double length = std::sqrt(x * x + y * y);
  const SphericalBisector::At at = bisector.at(x / length, y / length);
  constexpr double kPart = 0x1p-10;
  if (at.rounding > std::min(tolerance_, kPart * lengthOf(b.point - a.point))) return Fit::kRadial;
  return isFine(a, shown(at.point(centre, frame)), b) ? Fit::kFine : Fit::kCoarse;
}

ChainMaker::Fit ChainMaker::fitAtChord(const Edge& edge, const MapPoint& a,
                                       const MapPoint& b) const {
  const Frame& frame = edge.frame;
  const double x1 = dot(a.point, frame.first), y1 = dot(a.point, frame.second);
  const double x2 = dot(b.point, frame.first), y2 = dot(b.point, frame.second);
  constexpr double kStraight = 0x1p-16;  // away from the site
  const double turn = std::abs(x1 * y2 - x2 * y1), both = (x1 * x1 + y1 * y1) * (x2 * x2 + y2 * y2);
  return turn * turn <= kStraight * kStraight * both
             ? Fit::kRadial
             : fitTowards(edge.sector.bisector, edge.centre, frame, x1 + x2, y1 + y2, a, b);
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
  const SphericalBisector bisector(diagram_, node, frame, neighbor);
  const double x = x1 * length2 + x2 * length1, y = y1 * length2 + y2 * length1;
  const double length = std::sqrt(x * x + y * y);
  const MapPoint middle = shown(bisector.at(x / length, y / length).point(cap.centre, frame));
  if (!isFine(from, middle, to) || mayTurnBack(from, to)) return false;
  return fitTowards(bisector, cap.centre, frame, x1 + x2, y1 + y2, from, to) == Fit::kFine;
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
    follow({diagram_, node, neighbor, sectorOf(diagram_, h, vertices_), first, last}, 0, 1, first,
           last, inner_);
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
  // For the other site, the edge runs from `last` to `first`.
  const std::span<const MapPoint> inner = innerOf(twin, last, first);
  for (std::size_t k = inner.size(); k-- > 0;) points.push_back(inner[k]);
}

void ChainMaker::appendWithin(const Edge& edge, VertexId node, const Sector& sector,
                              const AngularReach& reach, FlatArray<MapPoint>& points,
                              FlatArray<Strand>& strands) {
  const bool isOwn = node == edge.node;
  const double weight = diagram_.cap(edge.node).weight;
  // Adds the ends of the parts within the reach of a site, in pairs. On the edge, both sites'
  // circles are equally far, so the reach can be measured from the edge's own site.
  const auto cutBy = [&](VertexId of, FlatArray<double>& cuts) {
    const double most = weight + reach.beyondCircle(diagram_.siteOf(of));
    if (!(most > 0)) return;
    edge.visitWithin(most, [&](double from, double to) {
      cuts.push_back(from);
      cuts.push_back(to);
    });
  };
  parts_.clear();
  cutBy(node, parts_);
  cuts_ = parts_;
  cutBy(isOwn ? edge.neighbor : edge.node, cuts_);
  for (std::size_t k = 1; k < cuts_.size(); ++k) {  // few, in two runs that are in order
    for (std::size_t n = k; n > 0 && cuts_[n] < cuts_[n - 1]; --n)
      std::swap(cuts_[n], cuts_[n - 1]);
  }

  const auto pointAt = [&](double part) {
    // A part that ends within rounding of the edge's end ends there.
    constexpr double kHere = 0x1p-42;
    const MapPoint& end = part < 0.5 ? edge.first : edge.last;
    if (part <= 0 || part >= 1) return end;
    MapPoint point = shown(edge.at(part));
    if (lengthOf(point.point - end.point) <= kHere) return end;
    locate(point);
    return point;
  };
  const Frame frame(diagram_.cap(node).centre);
  const auto offsetOf = [&](double part, const MapPoint& point) {
    if (part <= 0 || part >= 1) return (part <= 0) == isOwn ? 0 : sector.width;
    if (isOwn) return part * sector.width;
    const double middle = sector.from + sector.width / 2;
    const double aside = std::remainder(frame.bearing(point.point) - middle, 2 * std::numbers::pi);
    return std::clamp(sector.width / 2 + aside, 0.0, sector.width);
  };
  const std::size_t before = strands.size();
  for (std::size_t pair = 0; pair < parts_.size(); pair += 2) {
    const double from = parts_[pair], to = parts_[pair + 1];
    const std::size_t begin = points.size();
    points.push_back(pointAt(from));
    double at = from;
    for (const double cut : cuts_) {
      if (!(cut > at && cut <= to)) continue;
      const MapPoint a = points.back(), b = pointAt(cut);
      const std::size_t inner = points.size();
      follow(edge, at, cut, a, b, points);
      for (std::size_t p = inner; p < points.size(); ++p) locate(points[p]);
      points.push_back(b);
      at = cut;
    }
    const double one = offsetOf(from, points[begin]), other = offsetOf(to, points.back());
    if (!isOwn) std::reverse(points.begin() + begin, points.end());
    strands.push_back({begin, points.size(), isOwn ? one : other, isOwn ? other : one});
  }
  if (!isOwn) std::reverse(strands.begin() + before, strands.end());
}

void ChainMaker::appendWithin(HalfedgeId h, const Sector& sector, const AngularReach& reach,
                              FlatArray<MapPoint>& points, FlatArray<Strand>& strands) {
  const Graph& graph = diagram_.graph();
  const VertexId node = graph.origin(h), neighbor = graph.target(h);
  const HalfedgeId g = isFollowedFrom(node, neighbor) ? h : graph.twin(h);
  const MapPoint first = vertexOf(faceOf(graph.twin(g))), last = vertexOf(faceOf(g));
  appendWithin(
      {diagram_, graph.origin(g), graph.target(g), sectorOf(diagram_, g, vertices_), first, last},
      node, sector, reach, points, strands);
}

void ChainMaker::appendClosedWithin(VertexId node, const Sector& sector, const AngularReach& reach,
                                    FlatArray<MapPoint>& points, FlatArray<Strand>& strands) {
  const VertexId other = otherOfTwo(diagram_, node);
  const bool isOwn = isFollowedFrom(node, other);
  const VertexId from = isOwn ? node : other, to = isOwn ? other : node;
  FlatArray<Sector> sectors;
  listSectors(diagram_, from, vertices_, sectors);
  const Sector& followed = sectors[0];
  const Direction centre = diagram_.cap(from).centre;
  MapPoint start = shown(followed.bisector.at(followed.from).point(centre, Frame(centre)));
  locate(start);
  appendWithin({diagram_, from, to, followed, start, start}, node, sector, reach, points, strands);
}

MapPoint ChainMaker::onCircle(VertexId node, double reach, double bearing) const {
  const Direction centre = diagram_.cap(node).centre;
  MapPoint point = shown(pointAt(centre, Frame(centre), reach, bearing));
  locate(point);
  return point;
}

void ChainMaker::appendCircle(VertexId node, double reach, const MapPoint& first, double from,
                              double width, const MapPoint& last, FlatArray<MapPoint>& points) {
  const auto pointAt = [&](double part) { return onCircle(node, reach, from + part * width); };
  subdivide(width, first, last, pointAt, kIsFine, points);
}

}  // namespace apollonius::internal::sphere
