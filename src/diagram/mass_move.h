// Many sites move at once, mostly without consequences for the graph: the certificate of move.cpp for all of them together, so that
// each face is computed and checked once instead of once for each of its corners.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "diagram/delaunay_graph.h"

namespace apollonius {

class MassMove {
 public:
  struct Move {
    VertexId vertex;
    Site to;
  };

  /// Moves as many of the sites as certainly leave the graph as it is, and returns for each move whether it was made. The others
  /// stay where they are. REQUIRES: visible vertices, each at most once; no move is from a place to itself.
  /// Throws std::bad_alloc with the diagram unchanged. Cost: O(sum of the degrees).
  std::span<const std::uint8_t> apply(DelaunayGraph& diagram, std::span<const Move> moves);

  /// Where the site of move k was before the last apply().
  [[nodiscard]] const Site& siteBefore(std::size_t k) const { return before_[k]; }

 private:
  void reserve(const DelaunayGraph& diagram, std::size_t moves);
  void collectFaces();
  [[nodiscard]] bool isMoved(VertexId v) const { return isMoved_[index(v)] != 0; }
  [[nodiscard]] const Site& siteBefore(VertexId v) const;
  [[nodiscard]] bool hasMovedCorner(FaceId f) const;
  void computeCircle(std::uint32_t position);
  void check(std::uint32_t position);
  void takeBack(VertexId v);
  void takeBackCorners(FaceId f);
  void queue(FaceId f);

  DelaunayGraph* diagram_ = nullptr;  // during apply only
  std::span<const Move> moves_;
  std::vector<Site> before_;          // by move
  std::vector<std::uint8_t> isMade_;  // by move
  std::vector<std::uint8_t> isMoved_;      // by vertex; 0 between calls
  std::vector<std::uint32_t> moveOf_;      // by vertex that moves or has been taken back
  std::vector<std::uint32_t> positionOf_;  // by face: its place in changed_; kNoIndex between calls

  /// A face with a corner that moves.
  struct ChangedFace {
    FaceId face;
    bool isQueued;
    bool isActive;         ///< some corner is moved (now, that is: not taken back)
    VoronoiCircle circle;  ///< its new one; an infinite error if there may be none
  };
  std::vector<ChangedFace> changed_;
  std::vector<std::uint32_t> queue_;  // positions of faces to check (again)
};

}  // namespace apollonius
