#include "geometry/clipping/edge_graph.h"

#include <algorithm>
#include <array>

#include "base/flat_array.h"
#include "base/infinite.h"
#include "diagram/listing.h"
#include "geometry/cell/reach_edge.h"
#include "geometry/curve/edge.h"

namespace apollonius::internal {

namespace {

using Ends = std::array<std::int32_t, 2>;  // rows of vertices; -1 at infinity
using Triple = std::array<SiteId, 3>;

void append(Point p, double clearance, VertexArrays& places) {
  places.coordinates.push_back(p.x);
  places.coordinates.push_back(p.y);
  places.clearance.push_back(clearance);
}

Point pointOf(const VertexArrays& vertices, std::int32_t row) {
  const auto k = static_cast<std::size_t>(row);
  return {vertices.coordinates[2 * k], vertices.coordinates[2 * k + 1]};
}

/// The narrowest place between E = e0 and e1, at which these ends are.
void appendNarrowest(const Bisector& bisector, double e0, double e1, double sumOfWeights,
                     const VertexArrays& vertices, const Ends& ends, VertexArrays& places) {
  double least = kInfinite;
  Point place = bisector.at(1);
  for (const std::int32_t row : ends) {
    if (row < 0) continue;
    const double clearance = vertices.clearance[static_cast<std::size_t>(row)];
    if (clearance > least) continue;
    least = clearance;
    place = pointOf(vertices, row);
  }
  const double between = (bisector.distance() - sumOfWeights) / 2;
  if (e0 < 1 && e1 > 1 && between < least) {
    least = between;
    place = bisector.at(1);
  }
  append(place, least, places);
}

class GraphLister final : public EdgeVisitor {  // NOLINT: nothing derives from it
 public:
  GraphLister(const DiagramCore& core, VertexArrays& vertices, EdgeArrays& edges,
              VertexArrays& narrowest)
      : core_(core),
        vertices_(vertices),
        edges_(edges),
        narrowest_(narrowest),
        rows_(core.delaunay().graph().faceSlots(), -1) {}

  void visit(HalfedgeId h, const EdgePart& piece) override {
    const DelaunayGraph& delaunay = core_.delaunay();
    const HalfedgeId twin = delaunay.graph().twin(h);
    const VertexId from = delaunay.graph().origin(h), to = delaunay.graph().origin(twin);
    const Site &a = delaunay.site(from), &b = delaunay.site(to);
    const Conic& curve = piece.curve;
    // Counter-clockwise about their vertex, sites are as at the third one that is not there.
    const Ends ends{
        piece.startsAtVertex ? vertexOf(faceOf(twin), curve.p0) : cutAt(curve.p0, b, {to, from}),
        piece.endsAtVertex ? vertexOf(faceOf(h), curve.p2) : cutAt(curve.p2, b, {from, to})};
    for (const VertexId v : {from, to}) edges_.sites.push_back(core_.siteOf(v));
    for (const std::int32_t end : ends) edges_.vertices.push_back(end);
    const Bisector bisector(a, b);
    const auto [e0, e1] = rangeOf(bisector, curve);
    appendNarrowest(bisector, e0, e1, a.r + b.r, vertices_, ends, narrowest_);
  }

 private:
  std::int32_t add(Point p, double clearance, const Triple& sites) {
    append(p, clearance, vertices_);
    for (const SiteId site : sites) vertices_.sites.push_back(site);
    return static_cast<std::int32_t>(vertices_.clearance.size()) - 1;
  }
  /// The row of a new vertex, at this distance from a site and another one.
  std::int32_t cutAt(Point p, const Site& site, const std::array<VertexId, 2>& sites) {
    return add(p, length(p - Point{site.x, site.y}) - site.r,
               {core_.siteOf(sites[0]), core_.siteOf(sites[1]), kNoSite});
  }
  /// The row of a face's vertex, which all faces have that are there.
  std::int32_t vertexOf(FaceId face, Point p) {
    std::int32_t row = rows_[index(face)];
    if (row >= 0) return row;
    const DelaunayGraph& delaunay = core_.delaunay();
    Triple least = tripleOf(face);
    found_.assign(1, face);
    rows_[index(face)] = row = static_cast<std::int32_t>(vertices_.clearance.size());
    while (!found_.empty()) {
      const FaceId f = found_.back();
      found_.pop_back();
      least = std::min(least, tripleOf(f));
      for (unsigned c = 0; c < 3; ++c) {
        const HalfedgeId h = halfedgeOf(f, c);
        const FaceId next = faceOf(delaunay.graph().twin(h));
        if (rows_[index(next)] >= 0 || !delaunay.isPoint(h)) continue;
        rows_[index(next)] = row;
        found_.push_back(next);
      }
    }
    return add(p, delaunay.voronoiVertex(face).s, least);
  }
  /// The sites of a face, the least one first.
  [[nodiscard]] Triple tripleOf(FaceId face) const {
    Triple sites{};
    for (unsigned c = 0; c < 3; ++c)
      sites[c] = core_.siteOf(core_.delaunay().graph().origin(halfedgeOf(face, c)));
    const auto [i, j, k] = sites;
    return i < j && i < k ? sites : j < k ? Triple{j, k, i} : Triple{k, i, j};
  }

  const DiagramCore& core_;
  VertexArrays& vertices_;
  EdgeArrays& edges_;
  VertexArrays& narrowest_;
  FlatArray<std::int32_t> rows_;  // by face; -1 for those not met
  FlatArray<FaceId> found_;       // scratch
};

}  // namespace

void listEdgeGraph(const DiagramCore& core, const Clipping& clipping, VertexArrays& vertices,
                   EdgeArrays& edges, VertexArrays& narrowest) {
  vertices = narrowest = {};
  edges = {};
  GraphLister lister(core, vertices, edges, narrowest);
  clipping.visitEdges(lister);
}

void listNarrowest(const DiagramCore& core, VertexArrays& places) {
  places = {};
  VertexArrays vertices;
  EdgeArrays edges;
  listVertices(core, vertices);
  listEdges(core, edges);
  for (std::size_t k = 0; k < edges.sites.size(); k += 2) {
    const Site &a = core.site(core.ids().slotOf(edges.sites[k])),
               &b = core.site(core.ids().slotOf(edges.sites[k + 1]));
    // Counter-clockwise about the reference site.
    const bool isReference = precedes(b, a);
    const Ends ends{edges.vertices[isReference ? k : k + 1],
                    edges.vertices[isReference ? k + 1 : k]};
    const auto endOf = [&](std::int32_t row) {
      return row < 0 ? EdgeEnd{} : EdgeEnd{pointOf(vertices, row), true};
    };
    const Edge edge(isReference ? Bisector(a, b) : Bisector(b, a), endOf(ends[0]), endOf(ends[1]));
    appendNarrowest(edge.bisector, edge.e0, edge.e1, a.r + b.r, vertices, ends, places);
  }
}

}  // namespace apollonius::internal
