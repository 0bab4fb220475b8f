// Breaks a diagram on purpose, for tests of the checks: the one friend that may write to its parts.
#pragma once

#include <utility>
#include <vector>

#include "diagram/diagram_core.h"
#include "predicate/compute_circle.h"

namespace apollonius::internal {

class DiagramBreaker {
 public:
  static Graph& graph(DelaunayGraph& diagram) { return diagram.graph_; }
  static std::size_t& visibleCount(DelaunayGraph& diagram) { return diagram.visibleCount_; }
  static VertexId& recent(DelaunayGraph& diagram) { return diagram.recent_; }
  static VoronoiCircle& circle(DelaunayGraph& diagram, FaceId f) {
    return diagram.circles_[index(f)];
  }
  /// Makes the cached circles fit sites that were changed behind the diagram's back.
  static void computeCircles(DelaunayGraph& diagram) {
    for (std::uint32_t f = 0; f < diagram.graph_.faceSlots(); ++f) {
      if (!diagram.graph_.isLive(FaceId{f})) continue;
      const EdgeCorners e = diagram.edge(halfedgeOf(FaceId{f}, 0));
      diagram.circles_[f] = voronoiCircle(e.i, e.j, e.k);
    }
  }

  static DelaunayGraph& delaunay(DiagramCore& core) { return core.delaunay_; }
  static IdPool& ids(DiagramCore& core) { return core.ids_; }
  static HiddenForest& hidden(DiagramCore& core) { return core.hidden_; }
  static unsigned levelCount(DiagramCore& core) { return core.index_.levels_.levelCount_; }
  static void dropGrid(DiagramCore& core) { core.index_.grid_.clear(); }
  /// Lets each cell of the grid name what `slot` gives.
  template <class Give>
  static void fillGrid(DiagramCore& core, Give&& slot) {
    for (std::size_t k = 0; k < core.index_.grid_.cells_.size(); ++k) {
      core.index_.grid_.cells_[k].site = slot() & HintGrid::kEmptySlot;
      core.index_.grid_.cells_[k].count = 1;
    }
  }
  /// Removes a site from everything but the levels and the grid.
  static void forget(DiagramCore& core, Slot slot) {
    Hierarchy levels = std::move(core.index_.levels_);
    core.index_.levels_ = Hierarchy(core.index_.walk_);
    core.detachSite(slot);
    core.ids_.release(slot);
    core.index_.levels_ = std::move(levels);
  }
  static DelaunayGraph& level(DiagramCore& core, unsigned k) {
    return *core.index_.levels_.levels_[k];
  }
};

}  // namespace apollonius::internal
