#include "topology/graph.h"

#include <algorithm>

namespace apollonius::internal {

void Graph::reserveVertices(std::size_t slots) {
  if (outgoing_.size() < slots) outgoing_.resize(slots, kNoHalfedge);
}

void Graph::reserveFaces(std::size_t removed, std::size_t created) {
  const auto grow = [](auto& array, std::size_t needed) {
    if (array.capacity() < needed)
      array.reserve(std::max(needed, array.capacity() + array.capacity() / 2));
  };
  grow(halfedges_, 3 * faceSlotsAfter(removed, created));
  grow(boundary_, std::max(removed, created));
  grow(lost_, 3 * removed);
}

void Graph::clear() {
  if (hasFewFaces()) {
    for (const Halfedge& h : halfedges_) {
      if (h.origin != kNoVertex) outgoing_[index(h.origin)] = kNoHalfedge;
    }
  } else {
    outgoing_.assign(outgoing_.size(), kNoHalfedge);
  }
  halfedges_.clear();
  firstFree_ = kNoHalfedge;
  freeFaces_ = 0;
}

void Graph::listVertices(FlatArray<VertexId>& vertices) const {
  vertices.clear();
  if (hasFewFaces()) {
    for (std::size_t i = 0; i < halfedges_.size(); ++i) {
      const VertexId v = halfedges_[i].origin;
      if (v != kNoVertex && v != kInfinity && index(outgoing(v)) == i) vertices.push_back(v);
    }
  } else {
    for (std::uint32_t v = 1; v < vertexSlots(); ++v) {
      if (hasVertex(VertexId{v})) vertices.push_back(VertexId{v});
    }
  }
}

FaceId Graph::takeFace() {
  if (firstFree_ == kNoHalfedge) {
    const FaceId f{static_cast<std::uint32_t>(faceSlots())};
    halfedges_.resize(halfedges_.size() + 3);
    return f;
  }
  const FaceId f = faceOf(firstFree_);
  firstFree_ = twin(firstFree_);
  --freeFaces_;
  return f;
}

void Graph::freeFace(FaceId f) {
  for (unsigned c = 0; c < 3; ++c) {
    halfedges_[index(halfedgeOf(f, c))] = Halfedge{};
  }
  halfedges_[index(halfedgeOf(f, 0))].twin = firstFree_;
  firstFree_ = halfedgeOf(f, 0);
  ++freeFaces_;
}

void Graph::setFace(FaceId f, VertexId a, VertexId b, VertexId c) {
  const std::array<VertexId, 3> corners{a, b, c};
  for (unsigned k = 0; k < 3; ++k) {
    const HalfedgeId h = halfedgeOf(f, k);
    halfedges_[index(h)].origin = corners[k];
    outgoing_[index(corners[k])] = h;
  }
}

void Graph::flip(HalfedgeId h) {
  const HalfedgeId t = twin(h);
  const VertexId i = origin(h), j = origin(t), k = apex(h), l = apex(t);
  const HalfedgeId jk = twin(next(h)), ki = twin(previous(h)), il = twin(next(t)),
                   lj = twin(previous(t));
  halfedges_[index(h)].origin = l;
  halfedges_[index(t)].origin = k;
  // None of the four sides has another one as its twin: k and l are not one vertex.
  const auto setSide = [&](HalfedgeId side, VertexId from, HalfedgeId outer) {
    halfedges_[index(side)].origin = from;
    outgoing_[index(from)] = side;
    sew(side, outer);
  };
  setSide(next(h), k, ki);
  setSide(previous(h), i, il);
  setSide(next(t), l, lj);
  setSide(previous(t), j, jk);
}

void Graph::replaceVertex(VertexId v, VertexId w) {
  for (const HalfedgeId h : star(v)) halfedges_[index(h)].origin = w;
  outgoing_[index(w)] = outgoing_[index(v)];
  outgoing_[index(v)] = kNoHalfedge;
}

void Graph::makePair(VertexId u, VertexId v, std::span<FaceId> faces) {
  for (FaceId& f : faces) f = takeFace();
  setFace(faces[0], u, v, kInfinity);
  setFace(faces[1], v, u, kInfinity);
  sew(halfedgeOf(faces[0], 0), halfedgeOf(faces[1], 0));  // u → v
  sew(halfedgeOf(faces[0], 1), halfedgeOf(faces[1], 2));  // v → infinity
  sew(halfedgeOf(faces[0], 2), halfedgeOf(faces[1], 1));  // infinity → u
}

/// An outer side within the hole is on the boundary itself and is replaced, too: says so in
/// boundary_, with what replaces it.
void Graph::replaceSlits(std::span<const FaceId> hole, std::span<const HalfedgeId> boundary,
                         std::span<const FaceId> newFaces) {
  for (const FaceId f : hole) halfedges_[index(halfedgeOf(f, 0))].origin = kNoVertex;
  const auto isInHole = [&](HalfedgeId h) { return !isLive(faceOf(h)); };
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (isInHole(boundary[k])) halfedges_[index(boundary[k])].twin = halfedgeOf(newFaces[k], 0);
  }
  for (BoundaryEdge& edge : boundary_) {
    if (isInHole(edge.outer)) edge.outer = twin(edge.outer);
  }
}

std::span<const VertexId> Graph::starHole(VertexId w, std::span<const FaceId> hole,
                                          std::span<const HalfedgeId> boundary,
                                          std::span<FaceId> newFaces, bool mayHaveSlits) {
  const std::size_t n = boundary.size();
  // Faces of the hole are used again, so everything is read before anything is written.
  boundary_.setSize(n);
  BoundaryEdge* const edges = boundary_.data();
  for (std::size_t k = 0; k < n; ++k) edges[k] = {origin(boundary[k]), twin(boundary[k])};
  lost_.clear();
  // f faces that hang together by f - 1 edges, as a tree, have f + 2 sides and no vertex within. So
  // it is nearly always.
  const bool mayLose = n != hole.size() + 2;
  if (mayLose) collectCorners(hole);
  for (std::size_t k = 0; k < n; ++k) newFaces[k] = k < hole.size() ? hole[k] : takeFace();
  if (mayHaveSlits) replaceSlits(hole, boundary, newFaces);

  // Local pointers: the compiler cannot know that these writes leave the arrays where they are.
  Halfedge* const halfedges = halfedges_.data();
  HalfedgeId* const outgoing = outgoing_.data();
  HalfedgeId spoke = halfedgeOf(newFaces[n - 1], 1);  // to w, of the face before
  for (std::size_t k = 0; k < n; ++k) {
    const HalfedgeId side = halfedgeOf(newFaces[k], 0), toNew = halfedgeOf(newFaces[k], 1),
                     fromNew = halfedgeOf(newFaces[k], 2);
    const VertexId from = edges[k].from;
    halfedges[index(side)] = {from, edges[k].outer};
    halfedges[index(edges[k].outer)].twin = side;
    halfedges[index(toNew)].origin = edges[k + 1 < n ? k + 1 : 0].from;
    halfedges[index(fromNew)] = {w, spoke};
    halfedges[index(spoke)].twin = fromNew;
    outgoing[index(from)] = side;
    spoke = toNew;
  }
  outgoing_[index(w)] = halfedgeOf(newFaces[0], 2);
  for (std::size_t k = n; k < hole.size(); ++k) freeFace(hole[k]);
  if (mayLose) {
    const auto isThere = [&](VertexId v) { return outgoing[index(v)] != kNoHalfedge; };
    lost_.resize(static_cast<std::size_t>(std::remove_if(lost_.begin(), lost_.end(), isThere) -
                                          lost_.begin()));
  }
  return lost_;
}

/// Takes the corners of the hole out of the graph and lists them in lost_: those on the boundary
/// come back.
void Graph::collectCorners(std::span<const FaceId> hole) {
  for (const FaceId f : hole) {
    for (unsigned c = 0; c < 3; ++c) {
      const VertexId corner = origin(halfedgeOf(f, c));
      if (outgoing(corner) != kNoHalfedge) lost_.push_back(corner);  // once each
      outgoing_[index(corner)] = kNoHalfedge;
    }
  }
}

void Graph::replaceStar(VertexId v, std::span<const HalfedgeId> link,
                        std::span<const PatchFace> patch, std::span<FaceId> newFaces) {
  const std::size_t n = patch.size();
  // Faces of the star are used again, so everything is read before anything is written.
  boundary_.clear();
  for (const HalfedgeId h : link) boundary_.push_back({origin(h), twin(h)});
  for (const HalfedgeId h : link) {
    for (const HalfedgeId side : {h, next(h), previous(h)})
      halfedges_[index(side)].origin = kNoVertex;
  }
  for (std::size_t k = 0; k < n; ++k) newFaces[k] = k < link.size() ? faceOf(link[k]) : takeFace();
  outgoing_[index(v)] = kNoHalfedge;
  if (n == 0 && !link.empty()) {
    sew(boundary_[0].outer, boundary_[1].outer);
    outgoing_[index(boundary_[0].from)] = boundary_[1].outer;
    outgoing_[index(boundary_[1].from)] = boundary_[0].outer;
  }

  // An outer side within the star is a link edge itself and is replaced too: leave word there of
  // what replaces it.
  for (std::size_t k = 0; k < n; ++k) {
    for (unsigned c = 0; c < 3; ++c) {
      const std::uint32_t across = patch[k].across[c];
      if ((across & kOutside) != 0)
        halfedges_[index(link[across & ~kOutside])].twin = halfedgeOf(newFaces[k], c);
    }
  }
  for (BoundaryEdge& edge : boundary_) {
    if (origin(edge.outer) == kNoVertex) edge.outer = twin(edge.outer);
  }

  // Surplus faces of the star go first: `link` names them, and no new face does.
  for (std::size_t k = n; k < link.size(); ++k) freeFace(faceOf(link[k]));
  for (std::size_t k = 0; k < n; ++k) {
    const PatchFace& face = patch[k];
    setFace(newFaces[k], face.corners[0], face.corners[1], face.corners[2]);
    for (unsigned c = 0; c < 3; ++c) {
      const std::uint32_t across = face.across[c];
      const HalfedgeId other = (across & kOutside) != 0
                                   ? boundary_[across & ~kOutside].outer
                                   : halfedgeOf(newFaces[across / 3], across % 3);
      sew(halfedgeOf(newFaces[k], c), other);
    }
  }
}

}  // namespace apollonius::internal
