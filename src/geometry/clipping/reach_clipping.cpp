#include "geometry/clipping/reach_clipping.h"

#include "geometry/cell/cell_sums.h"
#include "geometry/cell/reach_cell.h"
#include "geometry/draw/cubics.h"

namespace apollonius::internal {

namespace {

/// Passes on the parts of edges that are within the reach of both sites.
class SharedEdges final : public EdgeVisitor {  // NOLINT: nothing derives from it
 public:
  SharedEdges(const DiagramCore& core, const Reach& reach, EdgeVisitor& visitor)
      : core_(core), reach_(reach), visitor_(visitor) {}

  void visit(HalfedgeId h, const EdgePart& piece) override {
    const Graph& graph = core_.delaunay().graph();
    const VertexId from = graph.origin(h), to = graph.target(h);
    const Site &a = core_.delaunay().site(from), &b = core_.delaunay().site(to);
    const ReachedEdge edge = reachedEdge(a, reachOf(a, reach_.of(core_.siteOf(from))), b,
                                         reachOf(b, reach_.of(core_.siteOf(to))), piece.curve);
    for (std::size_t k = 0; k < edge.count; ++k) {
      const ReachedPiece& reached = edge.pieces[k];
      if (!reached.isShared) continue;
      const bool isFirst = k == 0 && !reached.isFromCut;
      const bool isLast = k + 1 == edge.count && !reached.isToCut;
      visitor_.visit(
          h, {reached.curve, isFirst && piece.startsAtVertex, isLast && piece.endsAtVertex});
    }
  }

 private:
  const DiagramCore& core_;
  const Reach& reach_;
  EdgeVisitor& visitor_;
};

}  // namespace

void ReachClipping::visitRings(FunctionRef<void(std::span<const Point>)> visit) const {
  window_.visitRings(visit);
}

std::unique_ptr<CellClipper> ReachClipping::cells(Parts parts) const {
  return std::make_unique<ReachCellClipper>(core_, reach_, window_.cells(parts));
}

void ReachClipping::visitEdges(EdgeVisitor& visitor) const {
  SharedEdges shared(core_, reach_, visitor);
  window_.visitEdges(shared);
}

std::unique_ptr<NaturalNeighbors> ReachClipping::naturalNeighbors() const {
  return window_.naturalNeighbors();
}

void ReachClipping::measureCells(Measure what, std::vector<double>& measures) const {
  CellSums sums(core_, box(), what);
  const auto clipper = cells(Parts::kWithArea);
  for (Slot slot = 0; slot < core_.ids().slots(); ++slot) {
    for (const BoundaryPiece& piece : clipper->find(slot).pieces) sums.addBorder(slot, piece.curve);
  }
  sums.list(measures);
}

void ReachClipping::drawEdges(Tolerance tolerance, Portion& portion, Path& path) const {
  const IdPool& ids = core_.ids();
  const auto clipper = cells(Parts::kWithArea);
  for (; portion.cursor < ids.slots(); ++portion.cursor) {
    if (path.commands.size() >= portion.commands) return;
    const auto slot = static_cast<Slot>(portion.cursor);
    if (ids.state(slot) != SiteState::kVisible) continue;
    for (const BoundaryPiece& piece : clipper->find(slot).pieces) {
      const SiteId neighbor = piece.sharedWith();
      // A piece that two cells share is drawn for one of them.
      if (neighbor == kNoSite ? !piece.isAtReach
                              : !precedes(core_.site(ids.slotOf(neighbor)), core_.site(slot)))
        continue;
      path.move(piece.curve.p0.x, piece.curve.p0.y);
      drawConic(piece.curve, tolerance, path);
    }
  }
  portion.isDone = true;
}

}  // namespace apollonius::internal
