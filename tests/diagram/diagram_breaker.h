// Breaks a diagram on purpose, for tests of the checks: the one friend that may write to its parts.
#pragma once

#include <vector>

#include "diagram/diagram_core.h"

namespace apollonius {

class DiagramBreaker {
 public:
  static Graph& graph(DelaunayGraph& diagram) { return diagram.graph_; }
  static std::size_t& visibleCount(DelaunayGraph& diagram) { return diagram.visibleCount_; }
  static VertexId& recent(DelaunayGraph& diagram) { return diagram.recent_; }
  static VoronoiCircle& circle(DelaunayGraph& diagram, FaceId f) { return diagram.circles_[index(f)]; }
  /// Makes the cached circles fit sites that were changed behind the diagram's back.
  static void computeCircles(DelaunayGraph& diagram) {
    for (std::uint32_t f = 0; f < diagram.graph_.faceSlots(); ++f) {
      if (!diagram.graph_.isLive(FaceId{f})) continue;
      const EdgeCorners e = diagram.edge(halfedgeOf(FaceId{f}, 0));
      diagram.circles_[f] = voronoiCircle(e.i, e.j, e.k);
    }
  }

  static DelaunayGraph& base(DiagramCore& core) { return core.base_; }
  static SiteIds& ids(DiagramCore& core) { return core.ids_; }
  static HiddenForest& hidden(DiagramCore& core) { return core.hidden_; }
  static unsigned levelCount(DiagramCore& core) { return core.hierarchy_.levelCount_; }
  static DelaunayGraph& level(DiagramCore& core, unsigned k) { return *core.hierarchy_.levels_[k]; }
};

}  // namespace apollonius
