// The surface in a snapshot: the twins, and one half-edge of each vertex. The origins follow: they
// are the stars that the twins turn around. Giving each half-edge its origin that way checks nearly
// all there is to check.
#include "base/byte_stream.h"
#include "topology/graph.h"

namespace apollonius::internal {

void Graph::save(WordWriter& out, std::size_t vertexSlots) const {
  out.word(static_cast<std::uint32_t>(firstFree_));
  for (const Halfedge& halfedge : halfedges_) out.word(static_cast<std::uint32_t>(halfedge.twin));
  for (std::size_t v = 0; v < vertexSlots; ++v) {
    out.word(static_cast<std::uint32_t>(v < outgoing_.size() ? outgoing_[v] : kNoHalfedge));
  }
}

bool Graph::restore(WordReader& in, std::size_t vertexSlots, std::size_t faceSlots) {
  firstFree_ = HalfedgeId{in.word()};
  halfedges_.resize(3 * faceSlots);
  for (Halfedge& halfedge : halfedges_) halfedge.twin = HalfedgeId{in.word()};
  outgoing_.resize(vertexSlots);
  for (HalfedgeId& h : outgoing_) h = HalfedgeId{in.word()};

  // Every half-edge is in one star at most, so this ends.
  std::size_t vertices = 0;
  for (std::size_t v = 0; v < vertexSlots; ++v) {
    const HalfedgeId begin = outgoing_[v];
    if (begin == kNoHalfedge) continue;
    ++vertices;
    HalfedgeId h = begin;
    do {
      if (index(h) >= halfedges_.size() || origin(h) != kNoVertex) return false;
      halfedges_[index(h)].origin = VertexId{static_cast<std::uint32_t>(v)};
      const HalfedgeId across = twin(previous(h));
      if (index(across) >= halfedges_.size() || twin(across) != previous(h)) return false;
      h = across;
    } while (h != begin);
  }

  // The three half-edges of a face have three different origins, or none has an origin.
  freeFaces_ = 0;
  for (std::size_t i = 0; i < halfedges_.size(); i += 3) {
    const VertexId a = halfedges_[i].origin, b = halfedges_[i + 1].origin,
                   c = halfedges_[i + 2].origin;
    const bool isFree = a == kNoVertex && b == kNoVertex && c == kNoVertex;
    if (!isFree &&
        (a == b || b == c || c == a || a == kNoVertex || b == kNoVertex || c == kNoVertex))
      return false;
    freeFaces_ += isFree;
    if (isFree && (halfedges_[i + 1].twin != kNoHalfedge || halfedges_[i + 2].twin != kNoHalfedge))
      return false;
  }
  // Euler's formula, with infinity among the vertices.
  const std::size_t faces = faceSlots - freeFaces_;
  if (faces == 0 ? vertices != 0 : 2 * vertices != faces + 4 || !hasVertex(kInfinity)) return false;

  // The list of free faces has as many, and an end: so it has all.
  HalfedgeId free = firstFree_;
  for (std::size_t k = 0; k < freeFaces_; ++k, free = twin(free)) {
    if (index(free) >= halfedges_.size() || index(free) % 3 != 0 || isLive(faceOf(free)))
      return false;
  }
  return free == kNoHalfedge;
}

}  // namespace apollonius::internal
