// The Delaunay graph in a snapshot: the surface, and the site that searches start from.
#include "base/byte_stream.h"
#include "delaunay/delaunay_graph.h"

namespace apollonius::internal {

void DelaunayGraph::save(WordWriter& out, std::size_t vertexSlots) const {
  out.word(static_cast<std::uint32_t>(recent_));
  graph_.save(out, vertexSlots);
}

bool DelaunayGraph::restore(WordReader& in, std::size_t faceSlots) {
  recent_ = VertexId{in.word()};
  if (!graph_.restore(in, sites_.size(), faceSlots)) return false;
  if (recent_ != kNoVertex && (recent_ == kInfinity || index(recent_) >= sites_.size()))
    return false;
  if (graph_.isEmpty()) {
    visibleCount_ = recent_ != kNoVertex;
    return true;
  }
  if (!graph_.hasVertex(recent_)) return false;  // kNoVertex has none, either
  isProven_ = false;
  visibleCount_ = graph_.faceCount() / 2 + 1;  // Euler, without infinity
  circles_.resize(faceSlots, kMissingCircle);
  mayMissCircles_ = true;
  return true;
}

}  // namespace apollonius::internal
