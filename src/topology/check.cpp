// Graph::check: the invariants of the surface, one after the other, trusting nothing that has not
// been checked before.
#include "base/flat_array.h"
#include "topology/graph.h"

namespace apollonius::internal {

const char* Graph::check(std::uint32_t& where) const {
  const std::size_t halfedges = halfedges_.size();
  const auto fail = [&](const char* what, std::size_t at) {
    where = static_cast<std::uint32_t>(at);
    return what;
  };
  if (halfedges % 3 != 0) return fail("half-edges are not three a face: half-edges", halfedges);

  // Half-edges: corners, twins.
  std::size_t live = 0;
  FlatArray<std::uint32_t> degree(outgoing_.size(), 0);
  for (std::size_t i = 0; i < halfedges; ++i) {
    const HalfedgeId h{static_cast<std::uint32_t>(i)};
    if (!isLive(faceOf(h))) {
      if (origin(h) != kNoVertex) return fail("a free face has a corner: half-edge", i);
      continue;
    }
    ++live;
    if (index(origin(h)) >= outgoing_.size()) return fail("a corner is no vertex: half-edge", i);
    ++degree[index(origin(h))];
    if (index(twin(h)) >= halfedges || twin(h) == h || !isLive(faceOf(twin(h))))
      return fail("no live twin: half-edge", i);
    if (twin(twin(h)) != h) return fail("the twin's twin is another: half-edge", i);
    if (target(h) != origin(twin(h))) return fail("ends differ from the twin's: half-edge", i);
    if (origin(h) == target(h)) return fail("a loop: half-edge", i);
  }

  // Vertices: each has one star that contains all of its half-edges.
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < outgoing_.size(); ++i) {
    const VertexId v{static_cast<std::uint32_t>(i)};
    if (outgoing(v) == kNoHalfedge) {
      if (degree[i] != 0) return fail("half-edges start at a vertex that has none: vertex", i);
      continue;
    }
    ++vertices;
    if (index(outgoing(v)) >= halfedges || origin(outgoing(v)) != v)
      return fail("its half-edge starts elsewhere: vertex", i);
    std::size_t turned = 0;
    HalfedgeId h = outgoing(v);
    do {
      h = rotateCcw(h);
      ++turned;
    } while (h != outgoing(v) && turned <= degree[i]);
    if (turned != degree[i])
      return fail("turning around it does not visit its half-edges once: vertex", i);
  }

  // A sphere: connected, Euler's formula V - E + F = 2.
  const std::size_t faces = live / 3;
  if (faces != 0) {  // without faces no vertex is in the graph, by the checks above
    FlatArray<char> reached(faceSlots(), 0);
    FlatArray<FaceId> queue;
    for (std::size_t f = 0; queue.empty(); ++f) {
      if (isLive(FaceId{static_cast<std::uint32_t>(f)}))
        queue.push_back(FaceId{static_cast<std::uint32_t>(f)});
    }
    reached[index(queue[0])] = 1;
    for (std::size_t done = 0; done < queue.size(); ++done) {
      for (unsigned c = 0; c < 3; ++c) {
        const FaceId g = faceOf(twin(halfedgeOf(queue[done], c)));
        if (reached[index(g)] == 0) {
          reached[index(g)] = 1;
          queue.push_back(g);
        }
      }
    }
    if (queue.size() != faces) return fail("not connected: faces reached", queue.size());
    if (vertices + faces != live / 2 + 2) return fail("not a sphere: vertices", vertices);
    if (!hasVertex(kInfinity)) return fail("infinity is not in the graph: vertex", 0);
  }

  // Free faces: all of them in the list.
  std::size_t listed = 0;
  for (HalfedgeId h = firstFree_; h != kNoHalfedge && listed <= freeFaces_; h = twin(h), ++listed) {
    if (index(h) >= halfedges || isLive(faceOf(h)))
      return fail("the free list leads to a live face: half-edge", index(h));
  }
  if (listed != freeFaces_ || listed + faces != faceSlots())
    return fail("free faces are lost: listed", listed);
  return nullptr;
}

}  // namespace apollonius::internal
