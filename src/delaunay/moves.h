// A certificate that moving sites, one or many at once, changes no face: for the small moves of
// animations.
//
// Let the circles of all faces around moved sites be computed anew, each once. The graph is that of
// the new diagram if
//   1. all of them exist, and neighbours do not cover each other;
//   2. along each edge of these faces its two ends come in the right order;
//   3. the normal of each face at infinity turns by less than a quarter.
// Why. By 1 and 2, all that proves the graph (proof.h) is there but for the hull: around infinity
// the normals are to make one turn. They did before, so the angles from each to the next summed up
// to it; each angle changes by what its two normals turn more than one another, and these
// differences sum up to nothing.
//
// On 2. Seen from the larger of its sites, a bounded edge spans at most half a turn
// (docs/PREDICATES.md), so the turn from one end to the other tells. An unbounded one may span
// more: its turn must have the sign that it had. As by 3 each end has turned by less than a
// quarter, a span of less than half a turn cannot have become one of more than half a turn then,
// nor the reverse, nor less than none or more than a whole one: it is the angle above. (That the
// corner beyond an edge is in no conflict with a face, seen from either side, would not do: a small
// site that has jumped over the vertex at the edge's other end is in none.)
//
// Everything is asked of the filters; what they do not know counts as no, and the sites concerned
// stay where they are.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"
#include "predicate/circle_fan.h"

namespace apollonius::internal {

class SiteMoves {
 public:
  struct Move {
    VertexId vertex;
    Site to;
  };

  /// Moves as many of the sites as certainly leave the graph as it is, and returns for each move
  /// whether it was made. The others stay where they are: all of them, if more than `mostLeft`
  /// would have to (there are cheaper ways then), which a sample of them tells quickly in most
  /// cases. REQUIRES: visible vertices, each at most once; no move is from a place to itself.
  /// Throws std::bad_alloc with the diagram unchanged. Cost: O(sum of the degrees).
  std::span<const std::uint8_t> apply(
      DelaunayGraph& delaunay, std::span<const Move> moves,
      std::size_t mostLeft = std::numeric_limits<std::size_t>::max());

  /// Puts sites back that moves in place have moved, `moves` telling where to. The graph is the one
  /// of these places. Cost: O(sum of the degrees).
  static void takeBack(DelaunayGraph& delaunay, std::span<const Move> moves) noexcept;

  /// Where the site of move k was before the last apply().
  [[nodiscard]] const Site& siteBefore(std::size_t k) const { return before_[k]; }

 private:
  void reserveMoves(const DelaunayGraph& delaunay);
  void reserveFaces(const Graph& graph);
  [[nodiscard]] bool areHopeless(std::size_t mostLeft);
  [[nodiscard]] bool keepsItsStar(VertexId v) const;
  void makeAll();
  void collectFaces();
  [[nodiscard]] bool isMoved(VertexId v) const { return isMoved_[index(v)] != 0; }
  [[nodiscard]] const Site& siteBefore(VertexId v) const;
  [[nodiscard]] bool hasMovedCorner(FaceId f) const;
  void computeCircles();
  void computeCircle(std::uint32_t position);
  void check(std::uint32_t position);
  [[nodiscard]] bool endsAreInOrder(HalfedgeId h, const VoronoiCircle& left,
                                    const VoronoiCircle& right) const;
  void takeBack(VertexId v);
  void takeBackOneOf(FaceId f);
  void takeBackAll() noexcept;
  void queue(FaceId f);

  DelaunayGraph* delaunay_ = nullptr;  // during apply only
  std::span<const Move> moves_;
  std::size_t left_ = 0;                 // moves that have been taken back
  FlatArray<Site> before_;               // by move
  FlatArray<std::uint8_t> isMade_;       // by move
  FlatArray<std::uint8_t> isMoved_;      // by vertex; 0 between calls
  FlatArray<std::uint32_t> moveOf_;      // by vertex that moves or has been taken back
  FlatArray<std::uint32_t> positionOf_;  // by face: its index in changed_; kNoIndex between calls

  /// A face with a corner that moves.
  struct ChangedFace {
    FaceId face;
    bool isQueued;
    bool isActive;         ///< some corner is moved (now, that is: not taken back)
    VoronoiCircle circle;  ///< its new one; an infinite error if there may be none
  };
  FlatArray<ChangedFace> changed_;
  FlatArray<std::uint32_t> queue_;  // positions of faces to check (again)
};

}  // namespace apollonius::internal
