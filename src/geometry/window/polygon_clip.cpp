#include "geometry/window/polygon_clip.h"

#include <algorithm>
#include <limits>

#include "geometry/window/boundary_walk.h"

namespace apollonius::internal {

namespace {

constexpr std::int32_t kUnknown = std::numeric_limits<std::int32_t>::min();
/// If at most one face in this many is inside, they are listed.
constexpr std::size_t kFewFaces = 16;

}  // namespace

ClippedDiagram::ClippedDiagram(const DiagramCore& core, const NormalizedPolygon& polygon)
    : core_(core), polygon_(polygon) {
  if (core.visibleCount() == 0) return;
  core.delaunay().computeMissingCircles();
  (void)walkRings(core, polygon, crossings_, interiorRings_);
  sortByKey(interiorRings_);
  sortCrossings();
  wind();
}

std::span<const Keyed> ClippedDiagram::interiorRingsOf(Slot cell) const {
  const Keyed* const first = std::lower_bound(
      interiorRings_.begin(), interiorRings_.end(), cell,
      [](const Keyed& interiorRing, Slot slot) { return interiorRing.key < slot; });
  const Keyed* last = first;
  while (last != interiorRings_.end() && last->key == cell) ++last;
  return {first, last};
}

void ClippedDiagram::sortCrossings() {
  byEdge_.resize(crossings_.size());
  for (std::uint32_t k = 0; k < byEdge_.size(); ++k) byEdge_[k] = k;
  std::partial_sort(byEdge_.begin(), byEdge_.end(), byEdge_.end(),
                    [&](std::uint32_t k, std::uint32_t m) {
                      const Crossing &a = crossings_[k], &b = crossings_[m];
                      return a.edge != b.edge ? a.edge < b.edge : a.e != b.e ? a.e < b.e : k < m;
                    });
  const Graph& graph = core_.delaunay().graph();
  touched_.assign(graph.faceSlots() / 8 + 1, 0);
  for (const Crossing& crossing : crossings_) {
    touch(faceOf(crossing.edge));
    touch(faceOf(graph.twin(crossing.edge)));
  }
}

std::span<const std::uint32_t> ClippedDiagram::crossingsOf(HalfedgeId edge) const {
  if (!isCrossed(edge)) return {};
  const auto isBefore = [&](std::uint32_t k, HalfedgeId h) { return crossings_[k].edge < h; };
  const std::uint32_t* const first =
      std::lower_bound(byEdge_.begin(), byEdge_.end(), edge, isBefore);
  const std::uint32_t* last = first;
  while (last != byEdge_.end() && crossings_[*last].edge == edge) ++last;
  return {first, last};
}

bool ClippedDiagram::isAnyInside(HalfedgeId h) const {
  const DelaunayGraph& delaunay = core_.delaunay();
  const Graph& graph = delaunay.graph();
  const bool isInside = windingOf(faceOf(graph.twin(h))) != 0;
  if ((!isInside && !isCrossed(h)) || graph.origin(h) == kInfinity ||
      graph.target(h) == kInfinity || !startsAtReference(delaunay, h))
    return false;
  return isInside || !crossingsOf(h).empty();
}

Edge ClippedDiagram::edgeInside(HalfedgeId h, VertexPrecision precision,
                                FlatArray<InsideInterval>& pieces, KeptVertices* kept) const {
  const DelaunayGraph& delaunay = core_.delaunay();
  const Edge edge(delaunay, h, precision, kept);
  pieces.clear();
  int multiplicity = windingOf(faceOf(delaunay.graph().twin(h)));
  double e = edge.e0;
  Point at = edge.from.point;
  bool isFinite = edge.from.isFinite, isVertex = true;
  const auto goTo = [&](double nextE, Point next, bool isNextFinite, bool isNextVertex) {
    if (multiplicity != 0 && isFinite && isNextFinite)
      pieces.push_back(
          {e, nextE, pieceInside(edge, e, nextE, at, next), multiplicity, isVertex, isNextVertex});
    e = nextE;
    at = next;
    isFinite = isNextFinite;
    isVertex = isNextVertex;
  };
  for (const std::uint32_t k : crossingsOf(h)) {
    goTo(crossings_[k].e, crossings_[k].point, true, false);
    multiplicity += crossings_[k].isForward ? 1 : -1;
  }
  goTo(edge.e1, edge.to.point, edge.to.isFinite, true);
  return edge;
}

Conic ClippedDiagram::pieceInside(const Edge& edge, double e0, double e1, Point from,
                                  Point to) const {
  const Rectangle& box = polygon_.box;
  const Conic curve = pieceOf(edge.bisector, e0, e1, box.nearestTo(from), box.nearestTo(to));
  // The middle of a curve inside is in the box, like that of its chord, and is at least half way
  // from there to p1, as w >= 1: so p1 is at most twice the box away. Rounding may make it more.
  const Point way = curve.p1 - middle(curve.p0, curve.p2);
  const bool isNear = absolute(way.x) <= 4 * box.width() && absolute(way.y) <= 4 * box.height();
  return isNear ? curve : Conic::segment(curve.p0, curve.p2);
}

/// Computes the winding numbers: 0 for the faces at infinity, and from there over all edges.
void ClippedDiagram::wind() {
  const Graph& graph = core_.delaunay().graph();
  windings_.assign(graph.faceSlots(), kUnknown);
  if (graph.isEmpty()) return;
  FlatArray<FaceId> found;
  const FaceId outside = faceOf(graph.outgoing(kInfinity));
  windings_[index(outside)] = 0;
  found.push_back(outside);
  while (!found.empty()) {
    const FaceId f = found.back();
    found.pop_back();
    for (unsigned c = 0; c < 3; ++c) {
      const HalfedgeId h = halfedgeOf(f, c), twin = graph.twin(h);
      std::int32_t& next = windings_[index(faceOf(twin))];
      if (next != kUnknown) continue;
      int winding = windings_[index(f)];
      // Crossings are kept with one half-edge of the two. In the direction of growing E, from the
      // vertex on its right to that on its left, they are added; the other way, subtracted.
      const auto sum = [&](HalfedgeId edge) {
        int steps = 0;
        for (const std::uint32_t k : crossingsOf(edge)) steps += crossings_[k].isForward ? 1 : -1;
        return steps;
      };
      if (isCrossed(h)) winding += sum(twin) - sum(h);
      next = winding;
      found.push_back(faceOf(twin));
    }
  }
  thinOut();
}

void ClippedDiagram::thinOut() {
  const auto isInside = [&](std::size_t f) {
    return windings_[f] != 0 && windings_[f] != kUnknown;
  };
  std::size_t count = 0;
  for (std::size_t f = 0; f < windings_.size(); ++f) count += isInside(f) ? 1 : 0;
  if (count > windings_.size() / kFewFaces) return;
  for (std::uint32_t f = 0; f < windings_.size(); ++f) {
    if (!isInside(f)) continue;
    inside_.push_back({f, static_cast<std::uint32_t>(windings_[f])});
    touch(FaceId{f});
  }
  windings_ = FlatArray<std::int32_t>();
}

int ClippedDiagram::sparseWindingOf(FaceId f) const {
  const auto isBefore = [](const Keyed& entry, std::uint32_t face) { return entry.key < face; };
  const Keyed* const at = std::lower_bound(inside_.begin(), inside_.end(), index(f), isBefore);
  return at != inside_.end() && at->key == index(f) ? static_cast<std::int32_t>(at->value) : 0;
}

}  // namespace apollonius::internal
