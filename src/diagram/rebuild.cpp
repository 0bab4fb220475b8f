// Many moves at once that change the graph: all sites are inserted anew, beside the diagram that is there, which they then replace.
// Each moved on its own would cost a removal and an insertion, and the slots would no longer lie in memory as the sites lie in
// the plane. Ids stay; slots do not. Cost: that of building, O(n log n) on random sites, and the memory of both diagrams.
#include <utility>

#include "diagram/diagram_core.h"
#include "diagram/spatial_order.h"

namespace apollonius {

bool DiagramCore::rebuildWith(std::span<const SiteId> ids, std::span<const double> xyr,
                              std::span<const std::uint32_t> order) noexcept {
  const std::size_t n = ids_.size();
  DiagramCore fresh(location_);
  try {
    {
      FlatArray<double> circles(3 * ids_.idLimit());  // by id; then those in use follow each other
      const auto put = [&](SiteId id, const Site& to) {
        double* const circle = &circles[3 * std::size_t{id}];
        circle[0] = to.x;
        circle[1] = to.y;
        circle[2] = to.r;
      };
      FlatArray<SiteId> used;
      used.reserve(n);
      for (SiteId id = 0; id < ids_.idLimit(); ++id) {
        const Slot slot = ids_.slotOf(id);
        if (slot == kNoSlot) continue;
        put(id, site(slot));
        used.push_back(id);
      }
      for (const std::size_t k : order) put(ids[k], {xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]});
      for (std::size_t k = 0; k < n; ++k) {
        const double* const circle = &circles[3 * std::size_t{used[k]}];
        put(static_cast<SiteId>(k), {circle[0], circle[1], circle[2]});
      }
      fresh.reserve(n);
      FlatArray<SiteId> bySlot = hilbertOrder({{circles.data(), 3 * n}, 3});
      for (Slot slot = 0; slot < n; ++slot) {
        const double* const circle = &circles[3 * std::size_t{bySlot[slot]}];
        fresh.base_.setSite(vertexOf(slot), {circle[0], circle[1], circle[2]});
        bySlot[slot] = used[bySlot[slot]];
      }
      fresh.ids_.assignWithSlots(ids_, bySlot);
    }
    FlatArray<std::uint32_t> slots(n);
    for (Slot slot = 0; slot < n; ++slot) slots[slot] = slot;
    slots = inRandomizedRounds(slots);
    fresh.base_.reserveBulk(n);
    fresh.beginBulk(n);
    std::size_t done = 0;
    fresh.placeAll(slots, Undo::kNever, done);
  } catch (...) {
    return false;
  }
  fresh.endBulk();
  std::swap(ids_, fresh.ids_);
  std::swap(base_, fresh.base_);
  std::swap(hidden_, fresh.hidden_);
  std::swap(hierarchy_, fresh.hierarchy_);
  std::swap(grid_, fresh.grid_);
  isHierarchyDue_ = false;
  return true;
}

}  // namespace apollonius
