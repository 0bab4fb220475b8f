// Deletion of a visible site (paper, section 5.1): its star is filled with a part of the small
// diagram of its neighbours and of the sites that it hid: the part with which the site would be in
// conflict. If the site hid none and its degree is not large, clipping ears does the same at less
// cost (ears.h).
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"
#include "delaunay/ears.h"

namespace apollonius::internal {

class Remover {
 public:
  /// New state of a site that the removed one had covered.
  struct Outcome {
    VertexId vertex;
    VertexId cover;  ///< its new cover (a visible site or another of the formerly covered);
                     ///< kNoVertex if it is visible now
  };

  /// Removes v from the diagram. `hidden` are the vertices that it covered and that may become
  /// visible (their sites are set), in the order in which they are tried: for many, pass
  /// them in the order of a bulk insertion. Returns their outcomes, valid until the next call:
  /// first those that are covered, each before its cover if that is covered, too. Throws
  /// std::bad_alloc with the diagram unchanged. Cost: as building a diagram of its d neighbours and
  /// of `hidden`. With `mayReturn`, all room is made that the site needs to be inserted again.
  std::span<const Outcome> remove(DelaunayGraph& delaunay, VertexId v,
                                  std::span<const VertexId> hidden, bool mayReturn = false);

  /// Makes all room for removing a site with this many neighbours and hidden sites together.
  void reserve(std::size_t sites);

  /// Scratch for the caller: hidden vertices, and outcomes of others; reserve() makes room there,
  /// too.
  [[nodiscard]] FlatArray<VertexId>& hiddenList() { return hidden_; }
  [[nodiscard]] FlatArray<Outcome>& adoptedList() { return adopted_; }

 private:
  void collectLink(const Graph& graph, VertexId v);
  void buildSmall(const DelaunayGraph& delaunay, std::span<const VertexId> hidden);
  VertexId addLocal(const DelaunayGraph& delaunay, VertexId v, VertexId start);
  void findPatch(const DelaunayGraph& delaunay, VertexId v);
  [[nodiscard]] bool hasAllNeighbors(const Graph& graph) const;
  void takeAllAsPatch();
  void alignLink(const DelaunayGraph& delaunay);
  void makePatch();
  [[nodiscard]] VertexId global(VertexId local) const {
    return local == kInfinity ? kInfinity : global_[index(local)];
  }

  EarClipper ears_;
  std::size_t room_ = 0;  // the room that reserve() has made

  // The small diagram; its vertex k is the big one's global_[k], covered by the small one's
  // cover_[k].
  DelaunayGraph small_;
  ConflictSearch conflicts_;  // conflict region of the removed site in the small diagram
  FlatArray<VertexId> global_;
  FlatArray<VertexId> cover_;
  FlatArray<VertexId> fallen_;  // vertices covered there, in the order in which they became so

  FlatArray<HalfedgeId> link_;  // half-edges opposite to the site in its star, counter-clockwise
  FlatArray<VertexId> order_;   // neighbours in the order in which they enter the small diagram
  FlatArray<std::uint32_t>
      patchOf_;  // by face of the small diagram: index in the patch, or kNoIndex
  FlatArray<std::uint32_t>
      linkOf_;                    // by half-edge of the small diagram: index in link_, or kNoIndex
  FlatArray<FaceId> patchFaces_;  // faces of the small diagram that make the patch
  FlatArray<Graph::PatchFace> patch_;
  FlatArray<VoronoiCircle> patchCircles_;
  FlatArray<Outcome> outcomes_;
  FlatArray<VertexId> hidden_;
  FlatArray<Outcome> adopted_;
};

}  // namespace apollonius::internal
