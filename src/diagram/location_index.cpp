#include "diagram/location_index.h"

#include <algorithm>
#include <limits>

#include "predicate/distance.h"

namespace apollonius::internal {

namespace {

/// For those with neighbours: a walk among fewer needs no start.
template <class Visit>
void forEachInGraph(const DelaunayGraph& delaunay, Visit&& visit) {
  const Graph& graph = delaunay.graph();
  for (Slot slot = 0; slot + std::size_t{1} < graph.vertexSlots(); ++slot) {
    if (graph.hasVertex(vertexOf(slot))) visit(slot, delaunay.site(vertexOf(slot)));
  }
}

}  // namespace

VertexId LocationIndex::startFor(const DelaunayGraph& delaunay, double x, double y) const {
  VertexId best = kNoVertex;
  double least = std::numeric_limits<double>::infinity();
  grid_.forEachNear(x, y, [&](Slot slot) {
    const VertexId v = vertexOf(slot);
    if (!delaunay.isVisible(v)) return;
    const double distance = ApproxDistance(x, y, delaunay.site(v)).value;
    if (distance >= least) return;
    best = v;
    least = distance;
  });
  if (best != kNoVertex && grid_.isClose(delaunay.site(best), x, y)) return best;
  const Slot start = filledLevels(delaunay).locate(x, y);
  return start == kNoSlot ? kNoVertex : vertexOf(start);
}

void LocationIndex::entered(const DelaunayGraph& delaunay, Slot slot) noexcept {
  const Site& site = delaunay.site(vertexOf(slot));
  if (hasLevels() && !areLevelsDue_ && !isUndoing_) levels_.insert(slot, site);
  if (!hasGrid() || isBulk_) return;
  grid_.insert(slot, site);
  rebuildOutgrownGrid(delaunay);
}

void LocationIndex::left(Slot slot, const Site& site, Remover& remover) noexcept {
  if (!areLevelsDue_) levels_.remove(slot, remover);
  grid_.remove(site);
}

void LocationIndex::followMoves(const DelaunayGraph& delaunay,
                                std::span<const SiteMoves::Move> moves, Remover& remover) noexcept {
  if (!areLevelsDue_) levels_.move(moves, remover);
  rebuildOutgrownGrid(delaunay);
}

void LocationIndex::buildLevels(const DelaunayGraph& delaunay) const noexcept {
  areLevelsDue_ = false;
  const VertexId only = delaunay.anyVisible();
  if (delaunay.visibleCount() == 1) levels_.insert(slotOf(only), delaunay.site(only));
  forEachInGraph(delaunay, [&](Slot slot, const Site& site) { levels_.insert(slot, site); });
}

void LocationIndex::rebuildGrid(const DelaunayGraph& delaunay) noexcept {
  if (!hasGrid()) return;
  if (delaunay.visibleCount() == 0) return grid_.clear();
  Site low = delaunay.site(delaunay.anyVisible()), high = low;
  forEachInGraph(delaunay, [&](Slot, const Site& s) {
    low = {std::min(low.x, s.x), std::min(low.y, s.y), 0};
    high = {std::max(high.x, s.x), std::max(high.y, s.y), 0};
  });
  grid_.rebuild(delaunay.visibleCount(), low, high);
  forEachInGraph(delaunay, [&](Slot slot, const Site& site) { grid_.insert(slot, site); });
  grid_.fillGaps();
}

void LocationIndex::rebuildOutgrownGrid(const DelaunayGraph& delaunay) noexcept {
  if (grid_.isOutgrown(delaunay.graph().vertexSlots())) rebuildGrid(delaunay);
}

}  // namespace apollonius::internal
