#include "geometry/cell/natural_neighbors.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "apollonius/types.h"
#include "base/infinite.h"
#include "base/radix_sort.h"
#include "diagram/queries.h"
#include "geometry/cell/cell_measures.h"
#include "geometry/curve/moments.h"
#include "predicate/covers.h"
#include "predicate/distance.h"
#include "predicate/precise_circle.h"

namespace apollonius::internal {

namespace {

EdgeEnd endAt(const VoronoiCircle& circle) {
  if (circle.isHalfPlane()) return {};
  return {{circle.x, circle.y}, true};
}

bool holds(const Rectangle& box, const Site& q) {
  return q.x >= box.xmin && q.x <= box.xmax && q.y >= box.ymin && q.y <= box.ymax;
}

}  // namespace

NaturalNeighbors::NaturalNeighbors(const DiagramCore& core, const Rectangle& window)
    : core_(core), delaunay_(core.delaunay()), window_(window) {}

NaturalNeighbors::NaturalNeighbors(const ClippedDiagram& clippedDiagram, const PolygonGrid& border)
    : core_(clippedDiagram.core()),
      delaunay_(core_.delaunay()),
      clippedDiagram_(&clippedDiagram),
      border_(&border),
      window_(clippedDiagram.polygon().box) {}

std::span<const NaturalShare> NaturalNeighbors::find(const Site& q, VertexId start,
                                                     Centers centers) {
  shares_.clear();
  if (centers == Centers::kInWindow && !holds(window_, q)) return {};
  const VertexId cover = findConflict(q, start);
  if (cover != kNoVertex) {
    if (centers == Centers::kAll || isInWindow(q)) shares_.push_back({cover, 1});
    return shares_;
  }
  origin_ = window_.nearestTo({q.x, q.y});
  contacts_.clear();
  extent_ = {kInfinite, kInfinite, -kInfinite, -kInfinite};
  findNewVertices(q);
  addNewEdges(q);
  addOldEdges();
  if (clippedDiagram_ != nullptr) {
    findInRegion(q, centers);
  } else {
    addBorder(q);
  }
  normalize();
  if (shares_.empty() && isInWindow(q)) {
    const VertexId near = delaunay_.locate(q.x, q.y, start, core_.locationIndex().walk()).nearest;
    shares_.push_back({near, 1});
  }
  return shares_;
}

bool NaturalNeighbors::isInWindow(const Site& q) const {
  return clippedDiagram_ == nullptr ? holds(window_, q)
                                    : clippedDiagram_->polygon().holds({q.x, q.y});
}

/// Finds q's conflicts. Returns the site that covers q, or kNoVertex.
VertexId NaturalNeighbors::findConflict(const Site& q, VertexId start) {
  if (core_.visibleCount() == 1) {
    expectShares(1);
    const VertexId only = delaunay_.anyVisible();
    return covers(delaunay_.site(only), q) ? only : kNoVertex;
  }
  const VertexId cover = delaunay_.findConflict(conflicts_, q, start, core_.locationIndex().walk());
  // Each site with a share is at a corner of the hole, or covered by q and then inside the hole.
  expectShares(conflicts_.boundary().size() + conflicts_.faces().size());
  return cover;
}

/// Computes the Voronoi vertices of the faces between q and the sides of the hole.
void NaturalNeighbors::findNewVertices(const Site& q) {
  const Graph& graph = delaunay_.graph();
  newVertices_.clear();
  sides_.clear();
  if (core_.visibleCount() == 1) return;
  const std::span<const HalfedgeId> boundary = conflicts_.boundary();
  const std::size_t count = boundary.size();
  fan_.reserve(count);
  circles_.resize(count);
  for (std::size_t k = 0; k < count; ++k)
    fan_.setCorner(k, delaunay_.corner(graph.origin(boundary[k])));
  fan_.compute(q, circles_);
  for (std::size_t k = 0; k < count; ++k) {
    const Corner a = delaunay_.corner(graph.origin(boundary[k])),
                 b = delaunay_.corner(graph.target(boundary[k]));
    newVertices_.push_back(
        endAt(isEnough(circles_[k], q) ? circles_[k] : preciseVoronoiCircle(a, b, &q)));
  }
  if (!conflicts_.mayHaveSlits()) return;
  for (const HalfedgeId h : boundary) sides_.push_back({static_cast<std::uint32_t>(h), 0});
  sortByKey(sides_);
}

void NaturalNeighbors::addNewEdges(const Site& q) {
  const auto add = [&](VertexId v, EdgeEnd from, EdgeEnd to) {
    const Site& other = delaunay_.site(v);
    if (precedes(other, q)) {
      addEdge(q, other, from, to, v, kNoVertex);
    } else {
      addEdge(other, q, to, from, kNoVertex, v);
    }
  };
  if (core_.visibleCount() == 1) {
    const VertexId only = delaunay_.anyVisible();
    if (!covers(q, delaunay_.site(only))) add(only, {}, {});
    return;
  }
  const std::span<const HalfedgeId> boundary = conflicts_.boundary();
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    const VertexId v = delaunay_.graph().origin(boundary[k]);
    if (v != kInfinity) add(v, newVertices_[(k == 0 ? boundary.size() : k) - 1], newVertices_[k]);
  }
}

/// Adds the parts of old edges inside q's cell: of an edge across a side of the hole, the part from
/// its new vertex to the old one in the hole; edges between two faces of the hole as a whole.
void NaturalNeighbors::addOldEdges() {
  if (core_.visibleCount() == 1) return;
  const Graph& graph = delaunay_.graph();
  const std::span<const HalfedgeId> boundary = conflicts_.boundary();
  if (conflicts_.faces().empty()) return addOldEdge(boundary[0], newVertices_[0], newVertices_[1]);
  for (std::size_t k = 0; k < boundary.size(); ++k)
    addOldEdge(boundary[k], newVertices_[k], oldVertex(faceOf(boundary[k])));
  for (const FaceId f : conflicts_.faces()) {
    for (unsigned c = 0; c < 3; ++c) {
      const HalfedgeId h = halfedgeOf(f, c), twin = graph.twin(h);
      if (twin < h || !conflicts_.isInRegion(faceOf(twin)) || isSide(h)) continue;
      addOldEdge(h, oldVertex(faceOf(twin)), oldVertex(f));
    }
  }
}

/// Is h on the hole's boundary, with hole faces on both sides?
bool NaturalNeighbors::isSide(HalfedgeId h) const {
  const auto isBefore = [](const Keyed& side, HalfedgeId other) {
    return HalfedgeId{side.key} < other;
  };
  const Keyed* const at = std::lower_bound(sides_.begin(), sides_.end(), h, isBefore);
  return at != sides_.end() && HalfedgeId{at->key} == h;
}

/// Is a cached circle accurate enough? The error of a vertex moves area from one neighbour to
/// another: at most the error times the width of q's cell in the window, of which the distance from
/// the vertex to one of its sites is no small part. So the error is compared with this distance;
/// and, where coordinates are large, with their rounding.
bool NaturalNeighbors::isEnough(const VoronoiCircle& circle, const Site& corner) const {
  if (circle.isHalfPlane()) return true;
  const double size = std::min(absolute(circle.s + corner.r), window_.diagonal());
  const double coordinates = std::max(absolute(window_.xmin), absolute(window_.xmax)) +
                             std::max(absolute(window_.ymin), absolute(window_.ymax));
  return circle.error <= powerOfTwo(-34) * size + powerOfTwo(-46) * coordinates;
}

EdgeEnd NaturalNeighbors::oldVertex(FaceId f) {
  const VoronoiCircle& circle = delaunay_.circle(f);
  if (circle.isHalfPlane()) return {};
  const VertexId v = delaunay_.graph().origin(halfedgeOf(f, 0));
  if (isEnough(circle, delaunay_.site(v))) return endAt(circle);
  constexpr std::size_t kMostKept = 1024;
  if (kept_.empty()) kept_.resize(kMostKept);
  KeptVertex& kept = kept_[index(f) % kMostKept];
  if (kept.face != f) kept = {endAt(delaunay_, f, VertexPrecision::kReproducible), f};
  return kept.vertex;
}

/// Adds a part of an old edge, the origin of h on its left.
void NaturalNeighbors::addOldEdge(HalfedgeId h, EdgeEnd from, EdgeEnd to) {
  const VertexId a = delaunay_.graph().origin(h), b = delaunay_.graph().target(h);
  if (a == kInfinity || b == kInfinity) return;
  if (startsAtReference(delaunay_, h)) {
    addEdge(delaunay_.site(a), delaunay_.site(b), from, to, a, b);
  } else {
    addEdge(delaunay_.site(b), delaunay_.site(a), to, from, b, a);
  }
}

/// Adds a part of the bisector of two sites, counter-clockwise about the reference site.
void NaturalNeighbors::addEdge(const Site& reference, const Site& other, EdgeEnd from, EdgeEnd to,
                               VertexId left, VertexId right) {
  if (reference.r == other.r && from.isFinite && to.isFinite && window_.holds(from.point) &&
      window_.holds(to.point))
    return addPiece({Conic::segment(from.point, to.point)}, left, right);
  clipEdge(Edge(Bisector(reference, other), from, to), window_, clipped_);
  for (int k = 0; k < clipped_.count; ++k)
    addPiece(clipped_.pieces[static_cast<std::size_t>(k)], left, right);
}

void NaturalNeighbors::addPiece(const ClippedPiece& piece, VertexId left, VertexId right) {
  const Conic& curve = piece.curve;
  const double area = cross(curve.p0 - origin_, curve.p2 - origin_) / 2 + areaBeyondChord(curve);
  addArea(left, area);
  addArea(right, -area);
  if (left == kNoVertex || right == kNoVertex) {
    extent_.include(curve.p0);
    extent_.include(curve.p1);
    extent_.include(curve.p2);
  }
  if (piece.fromSide != kNoSide)
    addContact({window_.positionOf(piece.fromSide, curve.p0), curve.p0, left, right});
  if (piece.toSide != kNoSide)
    addContact({window_.positionOf(piece.toSide, curve.p2), curve.p2, right, left});
}

/// Inserts a contact into the sorted list. There are few, or they come in runs.
void NaturalNeighbors::addContact(const Contact& contact) {
  contacts_.push_back(contact);
  std::size_t k = contacts_.size() - 1;
  for (; k > 0 && contacts_[k - 1].position > contact.position; --k)
    contacts_[k] = contacts_[k - 1];
  contacts_[k] = contact;
}

/// Makes room for this many sites.
void NaturalNeighbors::expectShares(std::size_t most) {
  shares_.reserve(most);
  places_.assign(std::max(std::size_t{16}, std::bit_ceil(2 * most)), 0);
}

void NaturalNeighbors::addArea(VertexId site, double area) {
  if (site == kNoVertex) return;
  const std::size_t mask = places_.size() - 1;
  constexpr std::uint32_t kFactor = 0x9E3779B1;  // 2^32 over the golden ratio: neighbours part
  std::size_t k = (static_cast<std::uint32_t>(site) * kFactor >> 7) & mask;
  for (;; k = (k + 1) & mask) {
    if (places_[k] == 0) break;
    NaturalShare& share = shares_[places_[k] - 1];
    if (share.site != site) continue;
    share.weight += area;
    return;
  }
  shares_.push_back({site, area});
  places_[k] = static_cast<std::uint32_t>(shares_.size());
}

/// Adds the part of the border that is in q's cell.
void NaturalNeighbors::addBorder(const Site& q) {
  const double width = window_.width(), height = window_.height();
  if (contacts_.empty()) {
    // The whole border is in q's cell, or none of it.
    if (extent_.xmin <= extent_.xmax) return;
    addArea(takenAt(q, window_.corner(0)), width * height);
    return;
  }
  // The fixed place is in the middle of the widest gap, where rounding matters least.
  const std::size_t count = contacts_.size();
  std::size_t first = 0;  // after the gap
  double widest = contacts_[0].position + 4 - contacts_[count - 1].position;
  for (std::size_t k = 1; k < count; ++k) {
    const double gap = contacts_[k].position - contacts_[k - 1].position;
    if (gap <= widest) continue;
    widest = gap;
    first = k;
  }
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Contact &contact = contacts_[(first + k) % count],
                  &next = contacts_[(first + k + 1) % count];
    addArea(contact.before, sum);
    addArea(contact.after, -sum);
    const double length = next.position - contact.position;
    const bool isGap = k + 1 == count;
    sum += areaAlongBorder(contact, next.point, isGap ? widest : length < 0 ? length + 4 : length);
  }
  double middle = contacts_[first].position - widest / 2;
  if (middle < 0) middle += 4;
  addArea(takenAt(q, window_.at(middle)), sum);
}

/// The area between origin_ and the border from a contact to a point `length` positions further on.
double NaturalNeighbors::areaAlongBorder(const Contact& from, Point to, double length) const {
  double sum = 0;
  Point at = from.point;
  const auto goTo = [&](Point next) {
    sum += cross(at - origin_, next - origin_) / 2;
    at = next;
  };
  for (int k = static_cast<int>(from.position) + 1; k < from.position + length; ++k)
    goTo(window_.corner(k % 4));
  goTo(to);
  return sum;
}

/// The site from whose cell q takes the point p; kNoVertex if p is not in q's cell.
VertexId NaturalNeighbors::takenAt(const Site& q, Point p) const {
  const double x = taken(p.x), y = taken(p.y);
  const VertexId near = vertexOf(core_.nearest(x, y));
  return isNearer(x, y, delaunay_.site(near), q) ? near : kNoVertex;
}

/// Corrects the sums for a region. If q's cell is away from the region's border, it is inside or
/// outside as a whole, as a Voronoi vertex in it is; if it is inside, the sums are right. Otherwise
/// a small diagram answers.
void NaturalNeighbors::findInRegion(const Site& q, Centers centers) {
  const bool isClear = contacts_.empty() && extent_.xmin <= extent_.xmax &&
                       !conflicts_.faces().empty() && border_->isClearOf(extent_);
  if (isClear) {
    if (clippedDiagram_->windingOf(conflicts_.faces()[0]) == 0) shares_.clear();
    return;
  }
  if (centers == Centers::kInWindow && !isInWindow(q)) return shares_.clear();
  findWithSmallDiagram(q);
}

/// Inside q's cell only the sites matter from which it takes something. So a diagram of these
/// alone, with q and without it, tells what q takes from each.
void NaturalNeighbors::findWithSmallDiagram(const Site& q) {
  // So far, shares_ has only the sites whose edges are in the region's box.
  const Graph& graph = delaunay_.graph();
  const auto list = [&](VertexId v) { addArea(v == kInfinity ? kNoVertex : v, 0); };
  if (core_.visibleCount() == 1) {
    list(delaunay_.anyVisible());
  } else {
    for (const HalfedgeId h : conflicts_.boundary()) list(graph.origin(h));
    for (const FaceId f : conflicts_.faces()) {
      for (unsigned c = 0; c < 3; ++c) list(graph.origin(halfedgeOf(f, c)));
    }
  }
  DiagramCore local(Location::kWalk);
  for (const NaturalShare& share : shares_) (void)local.insert(delaunay_.site(share.site));
  const SiteId own = local.insert(q);
  std::vector<double> before, after;
  const NormalizedPolygon& polygon = clippedDiagram_->polygon();
  measureCells(ClippedDiagram(local, polygon), Measure::kAreas, after);
  (void)local.remove(own);
  measureCells(ClippedDiagram(local, polygon), Measure::kAreas, before);
  for (std::size_t k = 0; k < shares_.size(); ++k) shares_[k].weight = before[k] - after[k];
}

/// Scales the weights to a sum of 1, and drops those of 0. Rounding can have made some negative.
void NaturalNeighbors::normalize() {
  double sum = 0;
  for (NaturalShare& share : shares_) sum += share.weight = std::max(0.0, share.weight);
  if (!(sum > 0 && sum < kInfinite)) return shares_.clear();
  std::size_t kept = 0;
  for (const auto& [site, weight] : shares_) {
    if (weight > 0) shares_[kept++] = {site, weight / sum};
  }
  shares_.resize(kept);
}

void interpolate(const DiagramCore& core, NaturalNeighbors& neighbors,
                 std::span<const double> values, std::span<const double> xy, double r,
                 std::span<double> results) {
  constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
  if (core.visibleCount() == 0) return std::fill(results.begin(), results.end(), kNoValue);
  visitPoints(core, xy, [&](std::size_t k, Slot hint) {
    const double x = xy[2 * k], y = xy[2 * k + 1];
    // The search always starts at the nearest site, so that the order of the shares, and with it
    // the bits of their sum, does not depend on the points before.
    const Slot start = core.nearest(x, y, hint);
    const auto shares = neighbors.find(normalized({x, y, r}), vertexOf(start), Centers::kInWindow);
    if (shares.empty()) {
      results[k] = kNoValue;
      return start;
    }
    double sum = 0;
    for (const NaturalShare& share : shares) sum += share.weight * values[core.siteOf(share.site)];
    results[k] = sum;
    return slotOf(shares.front().site);
  });
}

}  // namespace apollonius::internal
