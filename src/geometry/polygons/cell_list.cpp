#include "geometry/polygons/cell_list.h"

#include "base/radix_sort.h"

namespace apollonius::internal {

CellList listCells(const DiagramCore& core, PolygonFinder& finder, RingsAre what, SiteId first,
                   std::size_t end) {
  FlatArray<Keyed> bySlot;  // as sites lie in memory, they lie in the plane
  for (SiteId id = first; id < end && id < core.ids().idLimit(); ++id) {
    const Slot slot = core.ids().slotOf(id);
    if (slot != kNoSlot) bySlot.push_back({slot, id});
  }
  sortByKey(bySlot);
  finder.expectAll();
  CellList list;
  Rings rings;
  FlatArray<char> isBorder;
  FlatArray<CellList::Cell> cells;
  FlatArray<Keyed> bySite;
  for (const auto [slot, site] : bySlot) {
    bool isTraced = false;
    if (what == RingsAre::kRaw) {
      isTraced = finder.findRaw(slot, rings, &isBorder) != PolygonFinder::Soundness::kSure;
      list.isBorder.append(isBorder);
    } else {
      finder.find(slot, rings);
    }
    if (rings.ringCount() == 0) continue;
    bySite.push_back({site, static_cast<std::uint32_t>(cells.size())});
    const auto part = static_cast<std::uint32_t>(list.rings.partCount());
    list.rings.append(rings, 0, rings.partCount());
    cells.push_back(
        {site, slot, part, static_cast<std::uint32_t>(list.rings.partCount()), isTraced});
  }
  sortByKey(bySite);
  list.cells.reserve(cells.size());
  for (const Keyed& entry : bySite) list.cells.push_back(cells[entry.value]);
  return list;
}

}  // namespace apollonius::internal
