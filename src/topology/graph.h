// The Delaunay graph as pure topology: a closed triangulated surface (a sphere) in flat arrays,
// vertex 0 being the site at infinity. It knows no coordinates; which faces go and which come is
// decided by the diagram.
//
//     halfedges[h].origin   vertex where half-edge h starts
//     halfedges[h].twin     the other half of its edge
//     outgoing[v]           one half-edge that starts at v, or kNoHalfedge if v is not in the
//                           graph
//     next(h), previous(h), faceOf(h) = h / 3: by index arithmetic (topology/ids.h)
//
// Two vertices can share several edges, a vertex can have degree 2, a face can meet the same
// neighbour twice: an edge is a half-edge id, never a pair of vertices. With fewer than two visible
// sites there are no faces at all.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "topology/ids.h"
#include "topology/ranges.h"

namespace apollonius::internal {

class WordReader;
class WordWriter;

class Graph {
 public:
  // --- Reading

  [[nodiscard]] VertexId origin(HalfedgeId h) const { return halfedges_[index(h)].origin; }
  [[nodiscard]] VertexId target(HalfedgeId h) const { return halfedges_[index(next(h))].origin; }
  /// The corner of h's face that is not on h.
  [[nodiscard]] VertexId apex(HalfedgeId h) const { return halfedges_[index(previous(h))].origin; }
  [[nodiscard]] HalfedgeId twin(HalfedgeId h) const { return halfedges_[index(h)].twin; }
  [[nodiscard]] HalfedgeId outgoing(VertexId v) const { return outgoing_[index(v)]; }
  [[nodiscard]] bool hasVertex(VertexId v) const {
    return index(v) < outgoing_.size() && outgoing(v) != kNoHalfedge;
  }
  /// The next half-edge around the origin of h.
  [[nodiscard]] HalfedgeId rotateCcw(HalfedgeId h) const { return twin(previous(h)); }
  [[nodiscard]] HalfedgeId rotateCw(HalfedgeId h) const { return next(twin(h)); }
  /// All half-edges that start at v, counter-clockwise; none if it is not in the graph.
  /// Each one's face is at its left.
  [[nodiscard]] auto star(VertexId v) const { return Star<Graph>(*this, outgoing(v)); }
  /// All faces.
  [[nodiscard]] auto faces() const {
    return Filtered<FaceId, IsLive>(static_cast<std::uint32_t>(faceSlots()), {this});
  }
  /// All edges, each as that of its half-edges with the smaller number.
  [[nodiscard]] auto edges() const {
    return Filtered<HalfedgeId, IsFirstHalf>(static_cast<std::uint32_t>(halfedges_.size()), {this});
  }

  /// Live and free ones.
  [[nodiscard]] std::size_t faceSlots() const { return halfedges_.size() / 3; }
  /// Their number after an operation that takes `removed` faces away and brings `created` new
  /// ones.
  [[nodiscard]] std::size_t faceSlotsAfter(std::size_t removed, std::size_t created) const {
    return faceSlots() + (created > removed + freeFaces_ ? created - removed - freeFaces_ : 0);
  }
  [[nodiscard]] std::size_t vertexSlots() const { return outgoing_.size(); }
  [[nodiscard]] std::size_t faceCount() const { return faceSlots() - freeFaces_; }
  [[nodiscard]] bool isLive(FaceId f) const { return origin(halfedgeOf(f, 0)) != kNoVertex; }
  [[nodiscard]] bool isEmpty() const { return faceCount() == 0; }
  /// Lists all vertices in the graph except infinity; replaces the contents. Cost: as clear().
  /// Throws std::bad_alloc.
  void listVertices(FlatArray<VertexId>& vertices) const;

  // --- Room
  // The operations below allocate nothing: the caller makes room first, and can fail only there.

  void reserveVertices(std::size_t slots);  ///< room for vertices of index < slots
  /// Makes room for an operation that removes `removed` faces and creates `created` new ones.
  void reserveFaces(std::size_t removed, std::size_t created);
  /// Makes room for this many faces in all, in one piece; operations still reserve the faces that
  /// they need.
  void reserveFacesInAll(std::size_t faces) { halfedges_.reserve(3 * faces); }

  // --- Operations

  /// Forgets everything but the room. Cost: O(faceSlots()), however many vertex slots there are.
  void clear();

  /// The surface of two sites and infinity: two faces, three edges. REQUIRES isEmpty(),
  /// reserveFaces(0, 2), faces.size() == 2.
  ///
  ///             infinity                    face 0 = (u, v, infinity)
  ///            /        \                   face 1 = (v, u, infinity), on the back
  ///           u -------- v
  void makePair(VertexId u, VertexId v, std::span<FaceId> faces);

  /// Puts vertex w into a hole: the faces `hole` go, and each half-edge of `boundary` gets a new
  /// face with w at its left. The boundary lists, counter-clockwise, the half-edges that bound the
  /// hole from inside; a boundary half-edge whose twin is on the boundary too is an edge with the
  /// hole on both sides, a slit (or, with no face in the hole, the one edge that is opened). A
  /// caller that knows that there is no slit passes mayHaveSlits = false, which saves the search.
  ///
  ///         b ______ a             b ______ a
  ///          |      |               | \  / |         boundary: a→b, b→c, c→d, d→a
  ///          | hole |       =>      |  w   |         new face k = (its origin, its target, w)
  ///          |______|               | /  \ |
  ///         c        d             c        d
  ///
  /// newFaces[k] receives the face of boundary[k]. Vertices that were within the hole leave
  /// the graph (hasVertex becomes false) and are returned; the span lives until the next operation.
  /// REQUIRES: room for w and reserveFaces(hole.size(), boundary.size()); newFaces.size() ==
  /// boundary.size() >= 2.
  std::span<const VertexId> starHole(VertexId w, std::span<const FaceId> hole,
                                     std::span<const HalfedgeId> boundary,
                                     std::span<FaceId> newFaces, bool mayHaveSlits = true);

  /// A face of a patch: three vertices and, for each of its half-edges, the other side.
  struct PatchFace {
    std::array<VertexId, 3> corners;
    /// Either the half-edge 3·face + corner of the patch, or kOutside | k for the outer side of
    /// link edge k.
    std::array<std::uint32_t, 3> across;
  };
  static constexpr std::uint32_t kOutside = 0x80000000u;

  /// The reverse of starHole: takes vertex v out and fills its star with `patch`.
  /// `link` lists the half-edges opposite to v in the faces of its star, counter-clockwise. An
  /// empty patch sews link[0] to link[1] (v had degree 2). A link edge with the star on both sides
  /// stays sewn to its partner. newFaces[k] receives the face of patch[k]. REQUIRES: room for all
  /// corners and reserveFaces(link.size(), patch.size()); newFaces.size() == patch.size().
  void replaceStar(VertexId v, std::span<const HalfedgeId> link, std::span<const PatchFace> patch,
                   std::span<FaceId> newFaces);

  /// Replaces the diagonal of the two faces beside h by the other one:
  ///
  ///          j ______ l             j ______ l
  ///          | \\     |              |     /|         h: before i→j, then l→k
  ///          |  h\\   |       =>     |  h/   |         faceOf(h): before (i, j, k), then (l, k, i)
  ///          |____\\_|              |/_____|         faceOf(twin): before (j, i, l), then (k, l,
  ///          j) k       i              k       i
  ///
  /// Four flips restore the graph, half-edges and faces included. REQUIRES: the corners k and l
  /// beyond h are not one vertex. Needs no room.
  void flip(HalfedgeId h);

  /// Vertex w takes the place of v, which leaves the graph. Cost: O(degree). REQUIRES: room for w.
  void replaceVertex(VertexId v, VertexId w);

  // --- Snapshots (snapshot.cpp)

  /// Writes 1 + 3 * faceSlots() + vertexSlots words. No vertex from vertexSlots on is in the graph.
  void save(WordWriter& out, std::size_t vertexSlots) const;
  /// Reads what save() wrote for this many slots; false if it is no closed surface of Euler
  /// characteristic 2, or the free faces are not in a list. That it is connected is left to
  /// geometry (delaunay/proof.h). REQUIRES: a new graph, which is unusable after a failure.
  [[nodiscard]] bool restore(WordReader& in, std::size_t vertexSlots, std::size_t faceSlots);

  /// Checks all invariants of the surface and returns the first broken one, or nullptr. `where`
  /// receives an id that it names.
  [[nodiscard]] const char* check(std::uint32_t& where) const;

 private:
  friend class GraphBreaker;  // tests break a structure on purpose

  struct IsLive {
    const Graph* graph;
    bool operator()(FaceId f) const { return graph->isLive(f); }
  };
  struct IsFirstHalf {
    const Graph* graph;
    bool operator()(HalfedgeId h) const {
      return graph->isLive(faceOf(h)) && index(h) < index(graph->twin(h));
    }
  };

  /// Then it is faster to look at these than at all vertices.
  [[nodiscard]] bool hasFewFaces() const { return halfedges_.size() < outgoing_.size() / 8; }
  [[nodiscard]] FaceId takeFace();
  void collectCorners(std::span<const FaceId> hole);
  void freeFace(FaceId f);
  void setFace(FaceId f, VertexId a, VertexId b, VertexId c);
  void sew(HalfedgeId h, HalfedgeId g) {
    halfedges_[index(h)].twin = g;
    halfedges_[index(g)].twin = h;
  }

  // Both fields of a half-edge, and mostly its whole face, are in one cache line.
  struct Halfedge {
    VertexId origin = kNoVertex;    // kNoVertex in free faces
    HalfedgeId twin = kNoHalfedge;  // in a free face, its first entry names the first half-edge of
                                    // the next free face
  };

  FlatArray<Halfedge> halfedges_;
  FlatArray<HalfedgeId> outgoing_;
  HalfedgeId firstFree_ = kNoHalfedge;
  std::size_t freeFaces_ = 0;

  // Scratch of starHole and replaceStar.
  void replaceSlits(std::span<const FaceId> hole, std::span<const HalfedgeId> boundary,
                    std::span<const FaceId> newFaces);

  struct BoundaryEdge {
    VertexId from;
    HalfedgeId outer;
  };
  FlatArray<BoundaryEdge> boundary_;
  FlatArray<VertexId> lost_;
};

}  // namespace apollonius::internal
