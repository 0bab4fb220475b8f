#include "geometry/polygons/coverage.h"

#include <cmath>

#include "apollonius/types.h"
#include "base/radix_sort.h"
#include "geometry/polygons/tiling_proof.h"
#include "number/sum.h"

namespace apollonius::internal {

namespace {

/// The error of a sum of areas is less than this share of the box around the window: the error of a
/// cross product is four roundings of the box that its ring fills, and a ring is shorter than 2^10
/// boxes.
constexpr double kAreaRounding = powerOfTwo(-40);

/// Total area of the rings from `first` to before `end`, with holes negative.
double areaOf(const Rings& rings, std::size_t first, std::size_t end) {
  Sum twice;
  for (std::size_t k = first; k < end; ++k) {
    const Corners ring = rings.corners(k);
    for (std::uint32_t m = 1; m + 1 < ring.size(); ++m)
      twice.add(cross(ring[m] - ring[0], ring[m + 1] - ring[0]));
  }
  return twice.value() / 2;
}

double areaOf(const Rings& rings) { return areaOf(rings, 0, rings.ringCount()); }

/// Puts the cells of each group side by side, with the group in place of the site, and drops those
/// of none; returns the area of the others.
double groupCells(std::span<const std::uint32_t> groups, CellList& list) {
  FlatArray<Keyed> order;
  for (std::uint32_t k = 0; k < list.cells.size(); ++k) {
    const SiteId site = list.cells[k].site;
    if (site < groups.size() && groups[site] != kNoGroup) order.push_back({groups[site], k});
  }
  sortByKey(order);
  FlatArray<CellList::Cell> cells(order.size());
  double area = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    cells[k] = list.cells[order[k].value];
    cells[k].site = order[k].key;
    area += areaOf(list.rings, list.firstRing(cells[k]), list.endRing(cells[k]));
  }
  list.cells.swap(cells);
  return area;
}

}  // namespace

void assemble(const CellList& list, Coverage& coverage) {
  coverage.rings.clear();
  coverage.sites.clear();
  coverage.cells.assign(1, 0);
  Tracer tracer;
  Rings traced;
  for (std::size_t k = 0, end = 0; k < list.cells.size(); k = end) {
    const CellList::Cell& cell = list.cells[k];
    end = k + 1;
    while (end < list.cells.size() && list.cells[end].site == cell.site) ++end;
    if (cell.isTraced || end > k + 1) {
      tracer.clear();
      for (const CellList::Cell& one : std::span(list.cells).subspan(k, end - k)) {
        for (std::uint32_t ring = list.firstRing(one); ring < list.endRing(one); ++ring)
          tracer.addRing(list.rings.ring(ring));
      }
      tracer.trace(traced);
      coverage.rings.append(traced, 0, traced.partCount());
    } else {
      coverage.rings.append(list.rings, cell.firstPart, cell.endPart);
    }
    if (coverage.rings.partCount() == coverage.cells.back()) continue;
    coverage.sites.push_back(cell.site);
    coverage.cells.push_back(static_cast<std::uint32_t>(coverage.rings.partCount()));
  }
}

bool coverWindow(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box, double area,
                 std::span<const std::uint32_t> groups, Coverage& coverage) {
  CellList raw = listCells(core, finder, RingsAre::kRaw, 0, core.ids().idLimit());
  const bool isFilled = !std::isnan(area);
  if (!isFilled) area = areaOf(raw.rings);
  TilingProof proof(core, box, raw);
  coverage.work = raw.isBorder.size();
  double closeness = 1;
  if (!isFilled || !proof.holds()) {
    Mesh mesh(core, box, raw);
    const bool isMended = mesh.mend();
    coverage.work += mesh.work();
    if (!isMended) return false;
    closeness = mesh.closeness();
  }
  const auto isNearly = [&](double sum) {
    return absolute(sum - area) <=
           closeness * proof.borderRounding() + kAreaRounding * box.width() * box.height();
  };
  const bool isGrouped = !groups.empty() && core.visibleCount() > 0;
  if (isGrouped) {
    if (!isNearly(areaOf(raw.rings))) return false;  // the window's; from here on, the groups'
    area = groupCells(groups, raw);
  }
  assemble(raw, coverage);
  if (coverage.sites.empty() && !isGrouped) return core.visibleCount() == 0 || !isFilled;
  return isNearly(areaOf(coverage.rings));
}

}  // namespace apollonius::internal
