// Many moves at once that change the graph: all sites are inserted anew, beside the diagram that is
// there, which they then replace. Each moved on its own would cost a removal and an insertion, and
// the slots would no longer lie in memory as the sites lie in the plane. Ids stay; slots do not.
// Cost: that of building, O(n log n) on random sites, and the memory of both diagrams.
#include <new>
#include <utility>

#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

bool DiagramCore::rebuildWith(std::span<const SiteId> ids, std::span<const double> xyr,
                              std::span<const std::uint32_t> order) noexcept {
  DiagramCore fresh(location());
  try {
    FlatArray<SiteId> used;  // the ids, ascending: used[k] is site k of the fresh diagram
    used.reserve(ids_.size());
    BulkInsertion insertion(fresh);
    {
      FlatArray<std::uint32_t> moveOf(ids_.idLimit(), kNoIndex);
      for (const std::uint32_t k : order) moveOf[ids[k]] = k;
      FlatArray<double> circles;
      circles.reserve(3 * ids_.size());
      for (SiteId id = 0; id < ids_.idLimit(); ++id) {
        const Slot slot = ids_.slotOf(id);
        if (slot == kNoSlot) continue;
        const std::size_t k = moveOf[id];
        const Site circle =
            k == kNoIndex ? site(slot) : Site{xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]};
        used.push_back(id);
        for (const double number : {circle.x, circle.y, circle.r}) circles.push_back(number);
      }
      insertion.stage({circles.data(), circles.size()});
    }
    FlatArray<SiteId> newIds(used.size());
    insertion.insert(newIds);
    fresh.ids_.rename(used, ids_);
  } catch (const std::bad_alloc&) {
    return false;
  }
  std::swap(ids_, fresh.ids_);
  std::swap(delaunay_, fresh.delaunay_);
  std::swap(hidden_, fresh.hidden_);
  std::swap(index_, fresh.index_);
  ++layout_;
  return true;
}

}  // namespace apollonius::internal
