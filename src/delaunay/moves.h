// Moving sites, one or many at once, with a certificate that proves the graph: for the small moves
// of animations, which change no face or few.
//
// Let the circles of all faces around moved sites be computed anew, each once. The graph is that of
// the new diagram if
//   1. all of them exist, and neighbours do not cover each other;
//   2. along each edge of these faces its two ends come in the right order;
//   3. the normal of each face at infinity turns by less than a quarter.
// Why. By 1 and 2, all conditions that prove the graph (proof.h) hold, except for the hull: around
// infinity the normals must make one turn. They did before, so the angles from each to the next
// summed up to it. Each angle changes by the difference of its two normals' turns, and these
// differences sum up to zero.
//
// On 2. Seen from the larger of its sites, a bounded edge spans at most half a turn
// (docs/PREDICATES.md), so the turn from one end to the other tells. An unbounded one may span
// more: its turn must have the sign that it had before. As by 3 each end has turned by less than a
// quarter, a span of less than half a turn cannot have become one of more than half a turn, nor the
// reverse, nor less than none or more than a whole one: it is the angle above. (It would not
// suffice that the corner beyond an edge is in no conflict with a face, seen from either side: a
// small site that has jumped over the vertex at the edge's other end is in no conflict.)
//
// Flips. An edge that contradicts 2 is replaced by the other diagonal, and the faces around are
// checked again (Lawson, Software for C1 surface interpolation, 1977: for points this ends with the
// Delaunay graph, from any triangulation). The result is proved by the same conditions, for new and
// old faces alike; its history does not matter. If a face at infinity has been flipped, it has no
// former normal: then condition 3 is that the normals of the whole hull make one turn, which is
// tested exactly (Proof::hullTurnsOnce). This needs no history, only that each turn at infinity is
// known.
//
// Flips can get stuck: in a set with weights the other diagonal may have no circles (Edelsbrunner
// and Shah, Incremental topological flipping works for regular triangulations, 1996), as where a
// site is to become hidden; and after moves faces may overlap, which is no triangulation to start
// from. So faces without a circle come first, and a site next to one that stays wrong is moved back
// to where it was. A site goes back at most once, and flips are limited: so this ends. If there is
// no site that could go back, or too many have, all moves are taken back.
//
// All tests are filters. If a filter does not know the order along an edge, it is decided exactly
// where edges may be flipped, and counts as wrong elsewhere.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"
#include "predicate/circle_fan.h"

namespace apollonius::internal {

/// May edges be flipped, or must the graph stay as it is?
enum class Flips : bool { kNone, kMaybe };

class SiteMoves {
 public:
  struct Move {
    VertexId vertex;
    Site to;
  };

  /// Moves as many of the sites as possible without changing the graph, or with some flips only,
  /// and returns for each move whether it was made. The other sites stay where they are. If these
  /// were more than `mostLeft`, all sites stay (there are cheaper ways then); in most cases a
  /// sample tells this quickly. REQUIRES: visible vertices, each at most once; no move is from a
  /// place to itself. Throws std::bad_alloc with the diagram unchanged. Cost: O(sum of the
  /// degrees), and O(sites on the hull) if most sites move. An unproved graph is not flipped.
  std::span<const std::uint8_t> apply(
      DelaunayGraph& delaunay, std::span<const Move> moves, Flips flips,
      std::size_t mostLeft = std::numeric_limits<std::size_t>::max());

  /// Moves sites back that have been moved in place; `moves` has their former places. REQUIRES: the
  /// graph is that of these places. Cost: O(sum of the degrees).
  static void takeBack(DelaunayGraph& delaunay, std::span<const Move> moves) noexcept;

  /// Has the last apply() flipped edges?
  [[nodiscard]] bool hasFlipped() const { return !flips_.empty(); }
  /// Undoes the flips of the last apply() in a graph as it left it: a Graph, or a DelaunayGraph,
  /// whose circles are invalid then.
  template <class Flippable>
  void takeFlipsBack(Flippable& graph) const noexcept {
    for (std::size_t k = flips_.size(); k-- > 0;) flipBack(graph, flips_[k]);
  }

  /// The site of move k before the last apply().
  [[nodiscard]] const Site& siteBefore(std::size_t k) const { return before_[k]; }

 private:
  /// A face with a corner that moves, or beside an edge that has been flipped; or any face, if most
  /// sites move.
  struct ChangedFace {
    FaceId face;
    bool isQueued;         ///< in queue_
    bool isDeferred;       ///< in deferred_
    bool isActive;         ///< a corner is moved (and not taken back), or isFlipped
    bool isFlipped;        ///< a flip has made it
    VoronoiCircle circle;  ///< its new one; an infinite error if there may be none
  };

  template <class Flippable>
  static void flipBack(Flippable& graph, HalfedgeId h) noexcept {
    for (int quarter = 0; quarter < 3; ++quarter) graph.flip(h);
  }

  void reserveMoves(const DelaunayGraph& delaunay);
  void reserveFaces(const Graph& graph);
  [[nodiscard]] bool areMost() const;
  [[nodiscard]] bool areHopeless();
  [[nodiscard]] bool keepsItsStar(VertexId v) const;
  void makeAll();
  void collectFaces();
  ChangedFace& collect(FaceId f);
  [[nodiscard]] bool isMoved(VertexId v) const { return isMoved_[index(v)] != 0; }
  [[nodiscard]] const Site& siteBefore(VertexId v) const;
  [[nodiscard]] bool hasMovedCorner(FaceId f) const;
  void computeCircles();
  void computeCircle(std::uint32_t position);
  [[nodiscard]] bool hasCircle(std::uint32_t position) const {
    return changed_[position].circle.error < std::numeric_limits<float>::infinity();
  }
  [[nodiscard]] bool isTangled(std::uint32_t position) const {
    return changed_[position].isActive && !hasCircle(position);
  }
  [[nodiscard]] const VoronoiCircle& circleNow(FaceId f) const;
  void swapCircles() noexcept;
  [[nodiscard]] bool goesOn() const { return left_ <= mostLeft_ && !isStuck_; }
  void untangle();
  void checkAll();
  void check(std::uint32_t position, bool mayTakeBack);
  [[nodiscard]] Sign findDisorder(std::uint32_t position, HalfedgeId& edge);
  [[nodiscard]] Sign exactOrder(HalfedgeId h, const VoronoiCircle& left,
                                const VoronoiCircle& right);
  [[nodiscard]] Sign orderOfEnds(HalfedgeId h, const VoronoiCircle& left,
                                 const VoronoiCircle& right) const;
  [[nodiscard]] bool isFlipped(FaceId f) const;
  [[nodiscard]] bool flip(HalfedgeId h);
  [[nodiscard]] bool flipOneOf(FaceId f);
  [[nodiscard]] bool takeBackCovered(FaceId f);
  void takeBackOneOf(FaceId f);
  void takeBack(VertexId v);
  void takeBackAll() noexcept;
  void queue(FaceId f);
  void queueAt(std::uint32_t position);
  void queueAround(FaceId f);
  void defer(std::uint32_t position);

  DelaunayGraph* delaunay_ = nullptr;  // during apply only
  std::span<const Move> moves_;
  std::size_t left_ = 0;                 // number of moves that have been taken back
  std::size_t mostLeft_ = 0;             // limit of left_
  std::size_t mostFlips_ = 0;            // 0: none are tried
  bool isStuck_ = false;                 // neither a flip nor moving a site back helps
  bool asksHull_ = false;                // flips or exact answers at infinity: test condition 3
  FlatArray<Site> before_;               // by move
  FlatArray<std::uint8_t> isMade_;       // by move
  FlatArray<std::uint8_t> isMoved_;      // by vertex; 0 between calls
  FlatArray<std::uint32_t> moveOf_;      // by vertex that moves or has been taken back
  FlatArray<std::uint32_t> positionOf_;  // by face: its index in changed_; kNoIndex between calls
  FlatArray<ChangedFace> changed_;
  FlatArray<std::uint32_t> queue_;     // positions of faces to check (again)
  FlatArray<std::uint32_t> deferred_;  // positions of faces to check last
  FlatArray<HalfedgeId> flips_;        // as they were made
};

}  // namespace apollonius::internal
