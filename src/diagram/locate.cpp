// Nearest neighbour location by walking: the paper's way (section 4), which asks all neighbours, and the sector walk, which asks
// the one in the direction of the point.
#include "diagram/delaunay_graph.h"
#include "predicate/approx_distance.h"
#include "predicate/direction.h"
#include "predicate/predicates.h"

namespace apollonius {

namespace {

/// A site and its distance to a fixed point. Distances that doubles cannot tell apart are compared exactly; ties have a winner, so
/// that walks end.
class Nearest {
 public:
  Nearest(double x, double y, const Site& first) : x_(x), y_(y), site_(&first), distance_(x, y, first) {}

  /// Takes the candidate's place if it is nearer.
  bool improve(const Site& candidate) {
    const ApproxDistance distance(x_, y_, candidate);
    const double gain = distance_.value - distance.value;
    const double bound = distance_.bound + distance.bound;
    if (gain < -bound || (!(gain > bound) && !isNearer(x_, y_, *site_, candidate))) return false;
    site_ = &candidate;
    distance_ = distance;
    return true;
  }

 private:
  double x_, y_;
  const Site* site_;
  ApproxDistance distance_;
};

/// Up to this many neighbours are asked one after the other, which is cheaper than finding out which one to ask.
constexpr int kFewNeighbors = 12;

/// Where the ray from a site's centre through a point lies among the directions of the site's faces.
class Sectors {
 public:
  Sectors(const DelaunayGraph& diagram, double x, double y, VertexId pole)
      : diagram_(diagram), pole_(diagram.site(pole)), ray_(directionOf(x, y, pole_)) {}

  /// The half-edge around the pole whose sector holds the ray, rotating from `begin` towards it; if the ray runs along a boundary,
  /// one of those beside. kNoHalfedge if doubles cannot tell.
  [[nodiscard]] HalfedgeId find(HalfedgeId begin) const {
    const Graph& graph = diagram_.graph();
    HalfedgeId h = begin;
    Side first = sideOf(graph.twin(h)), last = sideOf(h);
    const bool clockwise = first == Side::kRight;
    for (;;) {
      if (first == Side::kUnknown || last == Side::kUnknown) return kNoHalfedge;
      if (first == Side::kAlong || last == Side::kAlong) return h;
      // To the left of the first direction and to the right of the last: inside. To the same side of both: inside if the sector
      // is wider than half a turn.
      if (first == Side::kLeft && last == Side::kRight) return h;
      if (first == last && turn(direction(graph.twin(h)), direction(h)).sign == Sign::kNegative) return h;
      h = clockwise ? graph.rotateCw(h) : graph.rotateCcw(h);
      if (h == begin) return kNoHalfedge;
      (clockwise ? last : first) = clockwise ? first : last;
      (clockwise ? first : last) = sideOf(clockwise ? graph.twin(h) : h);
    }
  }

  /// Does the ray run along the direction of h's face, as far as doubles can tell?
  [[nodiscard]] bool runsAlong(HalfedgeId h) const { return sideOf(h) == Side::kAlong; }

 private:
  /// Of the ray as seen along a direction. An opposite ray counts as left: half a turn to the left.
  enum class Side { kLeft, kRight, kAlong, kUnknown };

  [[nodiscard]] Arrow direction(HalfedgeId h) const { return directionOf(diagram_.circle(faceOf(h)), pole_); }

  [[nodiscard]] Side sideOf(HalfedgeId h) const {
    const Arrow d = direction(h);
    if (const MaybeSign side = turn(d, ray_); side.known) return side.sign == Sign::kPositive ? Side::kLeft : Side::kRight;
    const MaybeSign along = turn({d.y, -d.x, d.error}, ray_);  // turned by a quarter: the sign of the scalar product
    if (!along.known) return Side::kUnknown;
    return along.sign == Sign::kPositive ? Side::kAlong : Side::kLeft;
  }

  const DelaunayGraph& diagram_;
  const Site& pole_;
  Arrow ray_;
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

/// The plain walk where degrees are small. At a site with more than kFewNeighbors, the ray from its centre through the point decides:
/// it leaves the site's cell across one Voronoi edge, that of the sector (the range of directions of a half-edge v → j, from the
/// vertex of the face on its right to that on its left) which holds the ray. Cells are star-shaped about the centre, so if j is not
/// nearer than v, nothing is. Directions come from the cached circles; where the ray runs along a boundary between sectors, as far
/// as doubles can tell, both sides are asked, and where they tell nothing, all neighbours.
DelaunayGraph::Located DelaunayGraph::walkSectors(double x, double y, VertexId start) const {
  Nearest nearest(x, y, site(start));
  HalfedgeId better = kNoHalfedge;
  const auto ask = [&](HalfedgeId candidate) {
    const VertexId j = graph_.target(candidate);
    if (j != kInfinity && nearest.improve(site(j))) better = candidate;
    return better != kNoHalfedge;
  };
  HalfedgeId begin = graph_.outgoing(start);
  for (;;) {
    better = kNoHalfedge;
    HalfedgeId h = begin;
    int asked = 0;
    do {
      h = graph_.rotateCcw(h);
      ++asked;
    } while (!ask(h) && h != begin && asked < kFewNeighbors);
    if (better == kNoHalfedge && h == begin) return {graph_.origin(h), kNoHalfedge};

    HalfedgeId sector = kNoHalfedge;
    if (better == kNoHalfedge) {
      const Sectors sectors(*this, x, y, graph_.origin(h));
      sector = sectors.find(begin);
      if (sector == kNoHalfedge) {
        do {
          h = graph_.rotateCcw(h);
        } while (!ask(h) && h != begin);
      } else if (!ask(sector)) {
        for (HalfedgeId right = sector; sectors.runsAlong(graph_.twin(right));) {
          right = graph_.rotateCw(right);
          if (right == sector || ask(right)) break;
        }
        for (HalfedgeId left = sector; better == kNoHalfedge && sectors.runsAlong(left);) {
          left = graph_.rotateCcw(left);
          if (left == sector || ask(left)) break;
        }
      }
      if (better == kNoHalfedge) return {graph_.origin(begin), sector};
    }
    // The edge back, whose other end is not nearer, and the one after it, whose other end was probably asked before, come last.
    begin = graph_.rotateCcw(graph_.twin(better));
  }
}

}  // namespace apollonius
