// Shared by the tests of the graph: reading a surface as plain integers, and calling its operations
// with room made for them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "support/degree.h"
#include "topology/graph.h"

namespace apollonius::test {

using namespace internal;

/// A face as its corners, counter-clockwise, the smallest first.
using Triple = std::array<std::uint32_t, 3>;

constexpr VertexId vertex(std::uint32_t i) { return VertexId{i}; }
constexpr std::uint32_t number(VertexId v) { return static_cast<std::uint32_t>(v); }

inline Triple triple(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  Triple t{a, b, c};
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

inline Triple triple(const Graph& graph, FaceId f) {
  return triple(number(graph.origin(halfedgeOf(f, 0))), number(graph.origin(halfedgeOf(f, 1))),
                number(graph.origin(halfedgeOf(f, 2))));
}

inline std::vector<FaceId> liveFaces(const Graph& graph) {
  std::vector<FaceId> faces;
  for (std::uint32_t f = 0; f < graph.faceSlots(); ++f) {
    if (graph.isLive(FaceId{f})) faces.push_back(FaceId{f});
  }
  return faces;
}

/// All faces, sorted.
inline std::vector<Triple> triples(const Graph& graph) {
  std::vector<Triple> all;
  for (const FaceId f : liveFaces(graph)) all.push_back(triple(graph, f));
  std::sort(all.begin(), all.end());
  return all;
}

inline std::vector<Triple> sorted(std::vector<Triple> all) {
  for (Triple& t : all) t = triple(t[0], t[1], t[2]);
  std::sort(all.begin(), all.end());
  return all;
}

/// Empty, or the first broken invariant with its id.
inline std::string broken(const Graph& graph) {
  std::uint32_t where = 0;
  const char* what = graph.check(where);
  return what == nullptr ? std::string() : std::string(what) + " " + std::to_string(where);
}

/// The first half-edge from a to b whose face has its third corner at c (any, without c).
inline HalfedgeId halfedge(const Graph& graph, std::uint32_t a, std::uint32_t b,
                           std::uint32_t c = kNoIndex) {
  for (std::uint32_t i = 0; i < 3 * graph.faceSlots(); ++i) {
    const HalfedgeId h{i};
    if (!graph.isLive(faceOf(h)) || graph.origin(h) != vertex(a) || graph.target(h) != vertex(b))
      continue;
    if (c == kNoIndex || graph.apex(h) == vertex(c)) return h;
  }
  ADD_FAILURE() << "no half-edge " << a << " to " << b;
  return kNoHalfedge;
}

/// The half-edges opposite to v in its star, counter-clockwise: what Graph::replaceStar wants.
inline std::vector<HalfedgeId> linkOf(const Graph& graph, VertexId v) {
  std::vector<HalfedgeId> link;
  HalfedgeId h = graph.outgoing(v);
  do {
    link.push_back(next(h));
    h = graph.rotateCcw(h);
  } while (h != graph.outgoing(v));
  return link;
}

/// Graph::makePair with room made.
inline std::array<FaceId, 2> makePair(Graph& graph, std::uint32_t u, std::uint32_t v) {
  graph.reserveVertices(std::max(u, v) + 1);
  graph.reserveFaces(0, 2);
  std::array<FaceId, 2> faces{};
  graph.makePair(vertex(u), vertex(v), faces);
  return faces;
}

struct Starred {
  std::vector<FaceId> faces;
  std::vector<std::uint32_t> lost;
};

/// Graph::starHole with room made; the lost vertices sorted.
inline Starred starHole(Graph& graph, std::uint32_t w, const std::vector<FaceId>& hole,
                        const std::vector<HalfedgeId>& boundary) {
  graph.reserveVertices(w + 1);
  graph.reserveFaces(hole.size(), boundary.size());
  Starred result;
  result.faces.resize(boundary.size());
  for (const VertexId v : graph.starHole(vertex(w), hole, boundary, result.faces))
    result.lost.push_back(number(v));
  std::sort(result.lost.begin(), result.lost.end());
  return result;
}

/// Puts w into one face.
inline Starred splitFace(Graph& graph, std::uint32_t w, FaceId f) {
  return starHole(graph, w, {f}, {halfedgeOf(f, 0), halfedgeOf(f, 1), halfedgeOf(f, 2)});
}

/// Opens one edge for w, which gets degree 2.
inline Starred openEdge(Graph& graph, std::uint32_t w, HalfedgeId h) {
  return starHole(graph, w, {}, {h, graph.twin(h)});
}

/// Graph::replaceStar with room made.
inline std::vector<FaceId> replaceStar(Graph& graph, std::uint32_t v,
                                       const std::vector<HalfedgeId>& link,
                                       const std::vector<Graph::PatchFace>& patch) {
  std::size_t slots = graph.vertexSlots();
  for (const Graph::PatchFace& face : patch) {
    for (const VertexId corner : face.corners) slots = std::max(slots, index(corner) + 1);
  }
  graph.reserveVertices(slots);
  graph.reserveFaces(link.size(), patch.size());
  std::vector<FaceId> faces(patch.size());
  graph.replaceStar(vertex(v), link, patch, faces);
  return faces;
}

/// PatchFace.across for the outer side of link edge k.
constexpr std::uint32_t outside(std::uint32_t k) { return Graph::kOutside | k; }
/// PatchFace.across for side `corner` of face `face` of the patch.
constexpr std::uint32_t inside(std::uint32_t face, std::uint32_t corner) {
  return 3 * face + corner;
}

}  // namespace apollonius::test
