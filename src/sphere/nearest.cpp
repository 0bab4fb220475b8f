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
#include "sphere/nearest.h"

#include <algorithm>
#include <limits>

#include "base/flat_array.h"
#include "base/radix_sort.h"

namespace apollonius::internal::sphere {

namespace {

constexpr int kManyNeighbors = 24;

class SphericalWalk {
 public:
  SphericalWalk(const ProjectedDiagram& diagram, const Direction& point)
      : diagram_(diagram), point_(point) {
    // The pole has no circle that the plane could find.
    (void)moveTo(kInfinity);
  }

  /// Goes to a node if that is nearer.
  bool moveTo(VertexId node) {
    const Cap& cap = diagram_.cap(node);
    if (node_ != kNoVertex && isCertainlyFarther(cap)) return false;
    const HalfAngle there = distance(point_, cap);
    if (node_ != kNoVertex && !(there < toNode_)) return false;
    node_ = node;
    toNode_ = there;
    return true;
  }

  /// To the nearest site, in at most this many steps; kNoVertex if it takes more.
  VertexId run(int most = std::numeric_limits<int>::max()) {
    if (diagram_.graph().isEmpty()) return node_;
    while (step()) {
      if (most-- == 0) return kNoVertex;
    }
    return node_;
  }

 private:
  /// A filter without roots. A nearer site's centre is within the angle toNode_ + weight of the
  /// point.
  [[nodiscard]] bool isCertainlyFarther(const Cap& cap) const {
    constexpr double kRounding = 0x1p-48;
    const HalfAngle half = toNode_ + cap.radius;
    if (half.cosine < 0) return false;  // above pi: all are within
    const double cosine = half.cosine * half.cosine - half.sine * half.sine;
    return half.sine < -kRounding || dot(point_, cap.centre) < cosine - kRounding;
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
    if (circle.kind != Projection::Kind::kCircle || circle.loss > kUsualLoss) {
      // The cap nearly touches the pole, and its circle is inaccurate.
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

  const ProjectedDiagram& diagram_;
  Direction point_;
  VertexId node_ = kNoVertex;
  HalfAngle toNode_;
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
  // In the order of the grid, so that what a walk reads is still in the cache.
  FlatArray<Direction> points(ids.size());
  FlatArray<Keyed> order(ids.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    points[k] = directionOf({lonLat[2 * k], lonLat[2 * k + 1]});
    order[k] = {diagram.cellOf(points[k]), k};
  }
  sortByKey(order);
  for (const Keyed& point : order)
    ids[point.value] = diagram.siteOf(nearestNode(diagram, points[point.value]));
}

}  // namespace apollonius::internal::sphere
