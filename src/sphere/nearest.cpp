// A walk to neighbours that are nearer, from a site that was seen close by (direction_grid.h), or
// if that takes long from the plane's nearest site, which is nearly always the sphere's. It ends at
// the nearest site, as cells are star-shaped about their sites along geodesics: the way from a site
// to a point that is not in its cell leaves the cell into that of a neighbour, which is nearer from
// there on.
//
// A site with many neighbours does not ask all of them. Let its distance from the point p be d. The
// cap about p with radius d touches it; a nearer site would overlap that cap. In the plane the cap
// is a circle that touches the site's circle, and its centre, c, is in the cell of the site exactly
// if no other circle overlaps it. So the plane's nearest site of c, which the plane's walk finds in
// about log h steps, is this one if it is the nearest, and is nearer otherwise.
//
// Rounding may not end a walk early. The graph is that of rounded sites, whose distances d' are
// within delta of the true ones d. Let a walk be at a site s none of whose neighbours is nearer by
// d, and let the way from s to the point p go through the cells of n1, n2, ..., t. Where it enters
// a cell, both sites are equally near, and from there on d' grows by no more than d' of s does. So
// d'(p, nk) <= d'(p, s) for each k. The cell of n1 may be a beam, thinner than 10^-7, of a site
// that s nearly hides, and bar the way to sites that are nearer by much more than rounding. But all
// on the way have d <= d(p, s) + 2 delta: these are followed, too, and then what is found is the
// nearest to within 2 delta.
#include "sphere/nearest.h"

#include <algorithm>
#include <limits>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "diagram/nearby_search.h"

namespace apollonius::internal::sphere {

namespace {

constexpr int kManyNeighbors = 24;

/// delta, in radians, for a cap with this loss of accuracy (Projection::Image).
double roundingOf(double loss) { return 4 * (loss + 1) * 0x1p-53; }

class SphericalWalk {
 public:
  SphericalWalk(const ProjectedDiagram& diagram, const Direction& point)
      : diagram_(diagram), point_(point), slack_(2 * roundingOf(diagram.loss())) {
    // The pole has no circle that the plane could find.
    (void)moveTo(kInfinity);
  }

  /// Goes to a node if that is nearer.
  bool moveTo(VertexId node) {
    const Cap& cap = diagram_.cap(node);
    if (node_ != kNoVertex && isCertainlyFarther(cap)) return false;
    const HalfAngle there = distance(point_, cap);
    if (node_ != kNoVertex && !(there < toNode_)) {
      isTied_ = isTied_ || !isFarther(there);
      return false;
    }
    node_ = node;
    toNode_ = there;
    isTied_ = false;
    return true;
  }

  /// To the nearest site, in at most this many steps; kNoVertex if it takes more.
  VertexId run(int most = std::numeric_limits<int>::max()) {
    if (diagram_.graph().isEmpty()) return node_;
    while (step() || (isTied_ && passTies())) {
      if (most-- == 0) return kNoVertex;
    }
    return node_;
  }

 private:
  /// By more than rounding can be.
  [[nodiscard]] bool isFarther(const HalfAngle& there) const {
    return there.sine * toNode_.cosine - there.cosine * toNode_.sine > slack_ / 2;
  }

  /// A filter of this, without roots. The centre of a site that is not farther is within the angle
  /// toNode_ + weight + slack of the point.
  [[nodiscard]] bool isCertainlyFarther(const Cap& cap) const {
    const double rounding = 0x1p-48 + slack_;
    const HalfAngle half = toNode_ + cap.radius;
    if (half.cosine < 0) return false;  // above pi: all are within
    const double cosine = half.cosine * half.cosine - half.sine * half.sine;
    return half.sine < -rounding || dot(point_, cap.centre) < cosine - rounding;
  }

  bool step() {
    const Graph& graph = diagram_.graph();
    const VertexId from = node_;
    int asked = 0;
    for (const HalfedgeId h : graph.star(from)) {
      if (++asked > kManyNeighbors && from != kInfinity) return jump();
      if (moveTo(graph.target(h))) return true;
    }
    return false;
  }

  bool jump() {
    const Projection::Image circle = diagram_.projection().imageOfTouching(point_, toNode_);
    const VertexId from = node_;
    if (circle.loss > kUsualLoss) {
      // The cap nearly touches the pole, and its circle is inaccurate, or none.
      for (const HalfedgeId h : diagram_.graph().star(from))
        (void)moveTo(diagram_.graph().target(h));
      return node_ != from;
    }
    const DelaunayGraph::Located found =
        diagram_.plane().delaunay().locate(circle.circle.x, circle.circle.y, from);
    if (found.nearest != from) return moveTo(found.nearest);
    if (found.sector != kNoHalfedge) {
      // The centre was rounded, and may be on the wrong side of an edge close by.
      const Graph& graph = diagram_.graph();
      for (const HalfedgeId h :
           {graph.rotateCw(found.sector), found.sector, graph.rotateCcw(found.sector)})
        (void)moveTo(graph.target(h));
    }
    return node_ != from;
  }

  /// Goes to a nearer site beyond sites that are as far away as this one up to rounding.
  bool passTies() {
    const Graph& graph = diagram_.graph();
    const VertexId from = node_;
    SlotSet seen;  // by site
    FlatArray<VertexId> tied;
    (void)seen.insert(diagram_.siteOf(from));
    tied.push_back(from);
    for (std::size_t k = 0; k < tied.size(); ++k) {
      for (const HalfedgeId h : graph.star(tied[k])) {
        const VertexId node = graph.target(h);
        if (moveTo(node)) return true;
        const Cap& cap = diagram_.cap(node);
        if (!isCertainlyFarther(cap) && !isFarther(distance(point_, cap)) &&
            seen.insert(diagram_.siteOf(node)))
          tied.push_back(node);
      }
    }
    return false;
  }

  const ProjectedDiagram& diagram_;
  Direction point_;
  double slack_;  // tolerance of comparisons, in radians
  VertexId node_ = kNoVertex;
  HalfAngle toNode_;
  bool isTied_ = false;  // has a site been seen that is as far as this one, up to rounding?
};

}  // namespace

VertexId nearestNode(const ProjectedDiagram& diagram, const Direction& point) {
  constexpr int kFewSteps = 8;
  SphericalWalk walk(diagram, point);
  const VertexId hint = diagram.hintFor(point);
  if (hint != kNoVertex) {
    (void)walk.moveTo(hint);
    const VertexId nearest = walk.run(kFewSteps);
    if (nearest != kNoVertex) return nearest;
  }
  const DiagramCore& plane = diagram.plane();
  if (plane.visibleCount() > 0) {
    const Projection::Image image = diagram.projection().imageOfPoint(point);
    if (image.kind != Projection::Kind::kCircle) return kInfinity;  // at the pole, which is visible
    (void)walk.moveTo(vertexOf(plane.nearest(image.circle.x, image.circle.y)));
  }
  return walk.run();
}

void listNearest(const ProjectedDiagram& diagram, std::span<const double> lonLat,
                 std::span<SiteId> ids) {
  if (diagram.isEmpty()) {
    std::ranges::fill(ids, kNoSite);
    return;
  }
  visitPoints(diagram, lonLat, [&](std::size_t k, const Direction& point) {
    ids[k] = diagram.siteOf(nearestNode(diagram, point));
  });
}

}  // namespace apollonius::internal::sphere
