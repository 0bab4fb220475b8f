// Nearest neighbour location by walking: the paper's way (section 4), which tests all neighbours,
// and the sector walk, which tests the one in the direction of the point.
#include "delaunay/delaunay_graph.h"
#include "predicate/direction.h"
#include "predicate/distance.h"
#include "predicate/predicates.h"
#include "predicate/stage_counts.h"

namespace apollonius::internal {

namespace {

/// A site and its distance to a fixed point. Distances that doubles cannot tell apart are compared
/// exactly; ties have a winner, so that walks end. (The filter is distanceFilter's, which the
/// shadow check compares with the exact stage.)
class Nearest {
 public:
  Nearest(double x, double y, const Site& first)
      : x_(x), y_(y), site_(&first), distance_(x, y, first) {}
  Nearest(const Nearest&) = delete;
  Nearest& operator=(const Nearest&) = delete;
  ~Nearest() { stages::counts().distanceAtOnce += settled_; }

  /// Takes the candidate if it is nearer.
  bool improve(const Site& candidate) {
    const ApproxDistance distance(x_, y_, candidate);
    const double gain = distance_.value - distance.value;
    const double bound = distance_.bound + distance.bound;
    const bool isSettled = gain < -bound || gain > bound;
    settled_ += isSettled;
    if (gain < -bound || (!isSettled && !isNearer(x_, y_, *site_, candidate))) return false;
    site_ = &candidate;
    distance_ = distance;
    return true;
  }

 private:
  double x_, y_;
  const Site* site_;
  ApproxDistance distance_;
  unsigned settled_ = 0;
};

/// Up to this many neighbours are tested one after the other, which is cheaper than finding out
/// which one to test.
constexpr int kFewNeighbors = 12;

/// Finds where the ray from a site's centre through a point lies among the directions of the site's
/// faces. Every answer is exact: the proof that a walk has ended needs that a sector holds the ray.
class Sectors {
 public:
  /// REQUIRES: (x, y) is not the reference site's centre.
  Sectors(const DelaunayGraph& delaunay, double x, double y, VertexId reference)
      : delaunay_(delaunay), reference_(delaunay.site(reference)), x_(x), y_(y) {}

  /// A half-edge around the reference site whose sector, its bounds included, holds the ray,
  /// rotating from `begin` towards it; or kNoHalfedge, if doubles cannot tell a sector of nearly a
  /// whole turn from one of nearly none.
  [[nodiscard]] HalfedgeId find(HalfedgeId begin) const {
    const Graph& graph = delaunay_.graph();
    HalfedgeId h = begin;
    Bearing first = bearing(graph.rotateCw(h)), last = bearing(h);
    const bool clockwise = first == Bearing::kRight;
    for (;;) {
      if (holds(h, first, last)) return h;
      h = clockwise ? graph.rotateCw(h) : graph.rotateCcw(h);
      if (h == begin) return kNoHalfedge;
      (clockwise ? last : first) = clockwise ? first : last;
      (clockwise ? first : last) = bearing(clockwise ? graph.rotateCw(h) : h);
    }
  }

  /// Does the ray run along the direction of the face to the left of h?
  [[nodiscard]] bool runsAlong(HalfedgeId h) const { return bearing(h) == Bearing::kAlong; }

 private:
  [[nodiscard]] const VoronoiCircle& circle(HalfedgeId h) const {
    return delaunay_.circle(faceOf(h));
  }

  /// The bearing seen along the direction of the face to the left of h. REQUIRES: h starts at the
  /// reference site.
  [[nodiscard]] Bearing bearing(HalfedgeId h) const {
    const Graph& graph = delaunay_.graph();
    return bearingOf(x_, y_, circle(h), reference_, delaunay_.corner(graph.target(h)),
                     delaunay_.corner(graph.apex(h)));
  }

  /// Does the sector from the direction of h's right face counter-clockwise to that of its left
  /// face contain the ray, given its bearings from the two directions? The ray is turned from the
  /// last direction by as much as from the first, less the span of the sector: by more means that a
  /// whole turn was added, so the ray is within. Bearings are listed in the order of such turns.
  [[nodiscard]] bool holds(HalfedgeId h, Bearing first, Bearing last) const {
    if (first == Bearing::kAlong || last == Bearing::kAlong) return true;
    if (first != last) return last > first;
    // On the same side of both, or opposite to both: within if the sector spans more than half a
    // turn.
    if (first == Bearing::kOpposite) return false;
    const Arrow from = directionOf(circle(delaunay_.graph().rotateCw(h)), reference_),
                to = directionOf(circle(h), reference_);
    return turn(from, to).sign == Sign::kNegative;
  }

  const DelaunayGraph& delaunay_;
  const Site& reference_;
  double x_, y_;
};

}  // namespace

DelaunayGraph::Located DelaunayGraph::locate(double x, double y, VertexId start, Walk walk) const {
  if (visibleCount_ == 1) return {recent_, kNoHalfedge};
  start = visibleStart(start);
  return walk == Walk::kSectors ? walkSectors(x, y, start) : walkAllNeighbors(x, y, start);
}

DelaunayGraph::Located DelaunayGraph::walkAllNeighbors(double x, double y, VertexId start) const {
  VertexId best = start;
  Nearest nearest(x, y, site(best));
  HalfedgeId h = graph_.outgoing(best);
  HalfedgeId begin = h;
  do {
    const VertexId v = graph_.target(h);
    if (v != kInfinity && nearest.improve(site(v))) {
      best = v;
      begin = h = graph_.twin(h);  // the edge back: its other end is not nearer
    }
    h = graph_.rotateCcw(h);
  } while (h != begin);
  return {best, kNoHalfedge};
}

/// The plain walk where degrees are small. At a site with more than kFewNeighbors, the ray from its
/// centre through the point decides: it leaves the site's cell across one Voronoi edge, that of the
/// sector (the range of directions of a half-edge v → j, from the vertex of the face on its right
/// to that on its left) which holds the ray.
///
/// Why that proves the end. Cells are star-shaped about the centre. Beyond the place where the ray
/// leaves v's cell, into that of j, the distance to v grows as fast as any can, and that to j does
/// not: j is strictly nearer than v there. So if j is not nearer than v, the point is in v's cell.
/// It may be exactly at the end of the cell, at the same distance from both. Then all sites at that
/// distance touch one circle about it. If there are more than two, it is a Voronoi vertex, and the
/// canonical graph has faces of all of them there with the largest one: that one is the answer and
/// is among the neighbours across the edges that meet in the ray's direction; these are asked, too.
/// If the sector cannot be found, all neighbours are asked.
DelaunayGraph::Located DelaunayGraph::walkSectors(double x, double y, VertexId start) const {
  Nearest nearest(x, y, site(start));
  HalfedgeId better = kNoHalfedge;
  const auto ask = [&](HalfedgeId candidate) {
    const VertexId j = graph_.target(candidate);
    if (j != kInfinity && nearest.improve(site(j))) better = candidate;
    return better != kNoHalfedge;
  };
  HalfedgeId begin = graph_.outgoing(start);
  (void)ask(begin);
  for (;;) {
    // Goes around the site in both directions at once, until they meet: reads in one direction do
    // not wait for reads in the other.
    HalfedgeId ccw = begin, cw = begin;
    for (int asked = 1; better == kNoHalfedge && asked < kFewNeighbors; asked += 2) {
      ccw = graph_.rotateCcw(ccw);
      if (ccw == cw) return {graph_.origin(begin), kNoHalfedge};
      if (ask(ccw)) break;
      cw = graph_.rotateCw(cw);
      if (cw == ccw) return {graph_.origin(begin), kNoHalfedge};
      (void)ask(cw);
    }
    if (better == kNoHalfedge) {
      const VertexId reference = graph_.origin(begin);
      if (site(reference).x == x && site(reference).y == y)
        return {reference, kNoHalfedge};  // no other covers it, so none is as near
      const Sectors sectors(*this, x, y, reference);
      const HalfedgeId sector = sectors.find(begin);
      if (sector == kNoHalfedge) {
        HalfedgeId h = begin;
        do {
          h = graph_.rotateCcw(h);
        } while (!ask(h) && h != begin);
      } else if (!ask(sector)) {
        for (HalfedgeId right = sector; sectors.runsAlong(graph_.rotateCw(right));) {
          right = graph_.rotateCw(right);
          if (right == sector || ask(right)) break;
        }
        for (HalfedgeId left = sector; better == kNoHalfedge && sectors.runsAlong(left);) {
          left = graph_.rotateCcw(left);
          if (left == sector || ask(left)) break;
        }
      }
      if (better == kNoHalfedge) {
        shadowCheckNearest(reference, x, y);
        return {reference, sector};
      }
    }
    begin = graph_.twin(better);  // the edge back, whose other end is not nearer
    better = kNoHalfedge;
  }
}

/// In builds with the shadow check: checks that no neighbour of v is nearer, as the walk through
/// all neighbours proves.
void DelaunayGraph::shadowCheckNearest(VertexId v, double x, double y) const {
  if constexpr (!kShadowCheck) return;
  Nearest nearest(x, y, site(v));
  for (const HalfedgeId h : graph_.star(v)) {
    const VertexId j = graph_.target(h);
    shadowCheck({Sign::kNegative, true}, [&] {
      return j != kInfinity && nearest.improve(site(j)) ? Sign::kPositive : Sign::kNegative;
    });
  }
}

}  // namespace apollonius::internal
