#include "geometry/window/boundary_walk.h"

#include <algorithm>

#include "apollonius/types.h"
#include "base/infinite.h"
#include "geometry/window/neighbor_search.h"

namespace apollonius::internal {

namespace {

/// The line of a segment, and how far along it the walk is.
struct Line {
  Point from, to, direction, normal;
  double length;
  double at = 0;

  Line(Point a, Point b)
      : from(a),
        to(b),
        direction(unit(b - a)),
        normal(leftOf(direction)),
        length(internal::length(b - a)) {}
  /// A point of the segment at this distance from its start, within the segment's box whatever
  /// rounding does.
  [[nodiscard]] Point pointAt(double place) const {
    if (place >= length) return to;
    const Point p = from + place * direction;
    return {std::clamp(p.x, std::min(from.x, to.x), std::max(from.x, to.x)),
            std::clamp(p.y, std::min(from.y, to.y), std::max(from.y, to.y))};
  }
  [[nodiscard]] Point point() const { return pointAt(at); }
  [[nodiscard]] double placeOf(Point p) const { return dot(direction, p - from); }
};

/// A way out of a cell.
struct Exit {
  HalfedgeId halfedge = kNoHalfedge;  // the cell's
  HalfedgeId edge = kNoHalfedge;      // the one of the two at the reference site
  double e = 0;
  double at = kInfinite;     // distance along the line
  double score = kInfinite;  // the exit with the least score is next
};

class BoundaryWalker {
 public:
  BoundaryWalker(const DiagramCore& core, FlatArray<Crossing>& crossings)
      : core_(core),
        graph_(core.delaunay().graph()),
        crossings_(crossings),
        neighbors_(core.delaunay()) {}

  [[nodiscard]] std::size_t asked() const { return neighbors_.asked(); }

  /// Walks a ring. Returns the slot of its only cell if it stays in one, else kNoSlot.
  Slot walk(std::span<const Point> ring, std::uint32_t number) {
    ring_ = number;
    const Point start = ring.front();
    const VertexId home = cellOf({taken(start.x), taken(start.y)});
    cell_ = home;
    reach_ = 0;
    const std::size_t first = crossings_.size();
    if (graph_.hasVertex(home)) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        next_ = static_cast<std::uint32_t>(k + 1);
        walkSegment(ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]);
      }
      if (cell_ != home) goTo(home, start);
    }
    const std::size_t end = crossings_.size();
    for (std::size_t k = first; k < end; ++k) {
      Crossing& crossing = crossings_[k];
      const bool isLast = k + 1 == end;
      crossing.next = static_cast<std::uint32_t>(isLast ? first : k + 1);
      const auto around = static_cast<std::uint32_t>(isLast ? ring.size() : 0);
      crossing.pointCount = crossings_[crossing.next].firstPoint + around - crossing.firstPoint;
    }
    return first == end ? slotOf(home) : kNoSlot;
  }

 private:
  /// The cell in which a ring begins.
  [[nodiscard]] VertexId cellOf(Point p) {
    if (cell_ == kNoVertex) return vertexOf(core_.nearest(p.x, p.y));
    // Location may go around the whole cell, once for each of many rings within it.
    if (neighbors_.surelyHolds(cell_, p)) return cell_;
    return vertexOf(core_.nearest(p.x, p.y, slotOf(cell_)));
  }

  void walkSegment(Point from, Point to) {
    if (length(from - clearing_) < reach_ && length(to - clearing_) < reach_) return;
    Line line(from, to);
    crossed_.clear();
    while (true) {
      const Exit exit = findExit(line);
      if (exit.halfedge == kNoHalfedge) return;
      if (exit.at > line.at) {
        line.at = exit.at;
        crossed_.clear();
      }
      crossed_.push_back(exit.edge);
      cross(exit.halfedge, exit.edge, exit.e, line.point());
    }
  }

  void cross(HalfedgeId halfedge, HalfedgeId edge, double e, Point p) {
    const VertexId to = graph_.target(halfedge);
    crossings_.push_back(
        {edge, e, p, slotOf(cell_), slotOf(to), halfedge == edge, ring_, 0, next_, 0});
    cell_ = to;
    reach_ = 0;
  }

  /// Finds where the line leaves the cell next, if before the segment's end. If it does not,
  /// `reach_` becomes a lower bound of the distance from here to the cell's border.
  Exit findExit(const Line& line) {
    const DelaunayGraph& delaunay = core_.delaunay();
    const Point here = line.point();
    const double ahead = 2 * (line.length - line.at);
    const CellPlace place(delaunay.site(cell_), here);
    const bool areAll = neighbors_.list(cell_, place, line.from, line.to, candidates_);
    double gap = kInfinite;
    Exit best;
    for (const HalfedgeId h : candidates_) {
      // Along the way, the difference of the two distances falls by at most twice the way's length.
      const Site& other = delaunay.site(graph_.target(h));
      const double rounding = place.roundingOf(other), more = place.extraOf(other, rounding);
      gap = std::min(gap, more);
      if (more > ahead) continue;
      considerExit(h, line, rounding, best);
    }
    findMissing(line, best);
    clearing_ = here;
    if (!areAll && best.halfedge == kNoHalfedge) gap = neighbors_.leastExtra(cell_, place);
    reach_ = best.halfedge == kNoHalfedge ? gap / 2 : 0;
    return best;
  }

  /// Is a neighbour nearer at the end of the way through the cell? Where the line and a bisector
  /// touch up to rounding, there may be no crossing; if the line then continues beyond the
  /// bisector, the cell ends where they are closest, or where the way begins.
  void findMissing(const Line& line, Exit& best) const {
    const DelaunayGraph& delaunay = core_.delaunay();
    const double end = std::min(best.at, line.length);
    for (const HalfedgeId h : candidates_) {
      if (h == best.halfedge) continue;
      const Site &own = delaunay.site(cell_), &other = delaunay.site(graph_.target(h));
      if (!isNearer(other, own, line.pointAt(end))) continue;
      double low = line.at, high = end;
      for (int step = 0; step < 60 && low < high; ++step) {
        const double at = low / 2 + high / 2;
        (isNearer(other, own, line.pointAt(at)) ? high : low) = at;
      }
      if (low <= line.at && isCrossed(h)) continue;
      const EdgePlace place = placeOn(h, line.pointAt(low));
      const double score = low + place.away;
      if (score < best.score && place.e > 0 && place.e < kInfinite)
        best = {h, place.edge, place.e, low, score};
    }
  }

  /// Is a site nearer than another, by more than rounding? The difference of the distances is
  /// computed from that of their squares, so that it is accurate for sites that are close together.
  static bool isNearer(const Site& site, const Site& than, Point p) {
    const Point way{site.x - than.x, site.y - than.y};
    const Point a = p - Point{site.x, site.y}, b = p - Point{than.x, than.y};
    const double sum = length(a) + length(b), apart = length(way), weights = site.r - than.r;
    if (!(sum > 0)) return weights > 0;
    const double nearer = dot(way, a + b) / sum + weights;
    const double moved = powerOfTwo(-50) * (absolute(p.x) + absolute(p.y));
    return nearer >
           powerOfTwo(-48) * (apart + absolute(weights)) + moved * std::min(2.0, 4 * apart / sum);
  }

  /// The place on an edge for a point near it, and the distance from the point.
  struct EdgePlace {
    HalfedgeId edge;  // the one of the two at the reference site
    double e, away;
  };
  [[nodiscard]] EdgePlace placeOn(HalfedgeId h, Point p) const {
    const DelaunayGraph& delaunay = core_.delaunay();
    const HalfedgeId edge = startsAtReference(delaunay, h) ? h : graph_.twin(h);
    const Edge whole(delaunay, edge, VertexPrecision::kFast);
    return placeOn(edge, whole, whole.bisector.parameterOf(p), p);
  }
  static EdgePlace placeOn(HalfedgeId edge, const Edge& whole, double e, Point p) {
    const double clamped = std::clamp(e > 0 ? e : 0, whole.e0, whole.e1);
    return {edge, clamped, length(whole.bisector.at(clamped) - p)};
  }

  /// Has the edge been crossed at the walk's current point?
  [[nodiscard]] bool isCrossed(HalfedgeId h) const {
    return std::any_of(crossed_.begin(), crossed_.end(),
                       [&](HalfedgeId edge) { return edge == h || edge == graph_.twin(h); });
  }

  void considerExit(HalfedgeId h, const Line& line, double rounding, Exit& best) const {
    const DelaunayGraph& delaunay = core_.delaunay();
    const bool isReference = startsAtReference(delaunay, h);
    const HalfedgeId edge = isReference ? h : graph_.twin(h);
    const Bisector bisector(delaunay.site(graph_.origin(edge)), delaunay.site(graph_.target(edge)));
    if (bisector.isLine() && considerAlong(h, edge, bisector, line, best)) return;
    const LineForm form(bisector, line.normal, line.from);
    // Counter-clockwise about the reference site, the bisector comes from the right of the line
    // where the line leaves the site's cell.
    const double e = isReference ? form.rise() : form.fall();
    const double back = isReference ? form.fall() : form.rise();
    if (!(e > 0)) return;
    const Point crossing = bisector.at(e);
    const double at = line.placeOf(crossing);
    if (!(at < line.length) || (at <= line.at && isCrossed(h))) return;
    if (isReference && back > 0) {
      // The other cell is on the convex side, so a line that leaves the reference site's cell for
      // it comes back further on. If rounding puts that first, line and bisector touch.
      const double comesBack = line.placeOf(bisector.at(back));
      if (at >= comesBack || line.at >= at / 2 + comesBack / 2) return;
    }
    const bool isBehind = at < line.at;  // by rounding: then the edge is here
    const double place = isBehind ? line.at : at;
    if (!(place < best.score)) return;
    const Edge whole(delaunay, edge, VertexPrecision::kFast);
    const Point here = line.point();
    const EdgePlace on = isBehind ? placeOn(edge, whole, bisector.parameterOf(here), here)
                                  : placeOn(edge, whole, e, crossing);
    if (isBehind && on.away > rounding) return;
    const double score = place + on.away;
    if (!(score < best.score) || !(on.e > 0 && on.e < kInfinite)) return;
    // An edge whose score is beyond the segment's end is ignored, unless the end is nearer to the
    // other site by more than rounding.
    const Site &own = delaunay.site(cell_), &other = delaunay.site(graph_.target(h));
    if (score > line.length && !isNearer(other, own, line.to)) return;
    best = {h, edge, on.e, place, score};
  }

  /// Does the segment run along a straight edge, where both exist? Then it belongs to the cell on
  /// its left, as the inside is there.
  bool considerAlong(HalfedgeId h, HalfedgeId edge, const Bisector& bisector, const Line& line,
                     Exit& best) const {
    if (absolute(dot(line.direction, bisector.axis())) > powerOfTwo(-20)) return false;
    // A few last places of the coordinates, but at most a tiny share of the distance of the sites.
    const Point center = bisector.reference();
    const double half = bisector.distance() / 2;
    const double size =
        absolute(center.x) + absolute(center.y) + absolute(line.from.x) + absolute(line.from.y);
    const double rounding = std::min(powerOfTwo(-50) * size, powerOfTwo(-20) * half);
    const auto isOn = [&](Point p) {
      return absolute(dot(bisector.axis(), p - center) - half) <= rounding;
    };
    if (!isOn(line.point())) return false;
    const Edge whole(core_.delaunay(), edge, VertexPrecision::kFast);
    double from = line.placeOf(whole.from.point), to = line.placeOf(whole.to.point);
    const bool isUpwards = dot(line.direction, leftOf(bisector.axis())) > 0;
    if (!whole.from.isFinite) from = isUpwards ? -kInfinite : kInfinite;
    if (!whole.to.isFinite) to = isUpwards ? kInfinite : -kInfinite;
    if (from > to) std::swap(from, to);
    const double begin = std::max(from, line.at), end = std::min(to, line.length);
    if (!(begin < end)) return isOn(line.to);  // not this edge
    if (!isOn(line.pointAt(end))) return false;
    // Upwards, the reference site is on the left.
    const bool isOnLeft = isUpwards == (h == edge);
    const double e = bisector.parameterOf(line.pointAt(begin));
    if (isOnLeft || isCrossed(h) || !(begin < best.score) || !(e > 0 && e < kInfinite)) return true;
    best = {h, edge, e, begin, begin};
    return true;
  }

  /// Goes to another cell that also holds p up to rounding: over cells that hold p and edges that
  /// pass p, up to rounding. (Two cells can have several edges in common.)
  void goTo(VertexId goal, Point p) {
    const DelaunayGraph& delaunay = core_.delaunay();
    const double distance = distanceOf(delaunay.site(goal), p);
    const double size = absolute(p.x) + absolute(p.y) + absolute(distance);
    struct Step {
      VertexId cell;
      HalfedgeId halfedge;  // the one that leads here
      std::uint32_t before;
    };
    FlatArray<Step> steps;
    for (double slack = kNegligible * size + powerOfTwo(-1000);; slack *= powerOfTwo(6)) {
      FlatArray<char> isSeen(graph_.vertexSlots(), 0);
      steps.assign(1, {cell_, kNoHalfedge, 0});
      isSeen[index(cell_)] = 1;
      for (std::uint32_t k = 0; k < steps.size() && isSeen[index(goal)] == 0; ++k) {
        for (const HalfedgeId h : graph_.star(steps[k].cell)) {
          const VertexId next = graph_.target(h);
          if (next == kInfinity || isSeen[index(next)] != 0) continue;
          if (slack < kInfinite && !(distanceOf(delaunay.site(next), p) <= distance + slack &&
                                     placeOn(h, p).away <= slack))
            continue;
          isSeen[index(next)] = 1;
          steps.push_back({next, h, k});
        }
      }
      if (isSeen[index(goal)] == 0 && slack < kInfinite) continue;
      delaunay.requireConsistent(isSeen[index(goal)] != 0, "all visible sites are connected");
      std::uint32_t k = 0;
      while (steps[k].cell != goal) ++k;
      FlatArray<HalfedgeId> way;
      for (; k != 0; k = steps[k].before) way.push_back(steps[k].halfedge);
      while (!way.empty()) {
        const EdgePlace place = placeOn(way.back(), p);
        cross(way.back(), place.edge, place.e, p);
        way.pop_back();
      }
      return;
    }
  }

  const DiagramCore& core_;
  const Graph& graph_;
  FlatArray<Crossing>& crossings_;
  std::uint32_t ring_ = 0;
  std::uint32_t next_ = 0;  // the ring's next point
  VertexId cell_ = kNoVertex;
  Point clearing_;  // the cell holds all points within `reach_` of this one
  double reach_ = 0;
  FlatArray<HalfedgeId> crossed_;  // edges crossed at the walk's current point
  NeighborSearch neighbors_;
  FlatArray<HalfedgeId> candidates_;  // half-edges of the cell that the line may cross
};

}  // namespace

std::size_t walkRings(const DiagramCore& core, const NormalizedPolygon& polygon,
                      FlatArray<Crossing>& crossings, FlatArray<Keyed>& interiorRings) {
  BoundaryWalker walker(core, crossings);
  for (std::uint32_t k = 0; k < polygon.ringCount(); ++k) {
    const Slot only = walker.walk(polygon.ring(k), k);
    if (only != kNoSlot) interiorRings.push_back({only, k});
  }
  return walker.asked();
}

}  // namespace apollonius::internal
