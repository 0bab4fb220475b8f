#include "geometry/polygons/coverage.h"

#include <cmath>

#include "geometry/polygons/tiling_proof.h"
#include "number/sum.h"

namespace apollonius::internal {

namespace {

/// The error of a sum of areas is less than this share of the box around the window: the error of a
/// cross product is four roundings of the box that its ring fills, and a ring is shorter than 2^10
/// boxes.
constexpr double kAreaRounding = powerOfTwo(-40);

/// Total area of all rings, with holes negative.
double areaOf(const Rings& rings) {
  Sum twice;
  for (std::size_t k = 0; k < rings.ringCount(); ++k) {
    const Corners ring = rings.corners(k);
    for (std::uint32_t m = 1; m + 1 < ring.size(); ++m)
      twice.add(cross(ring[m] - ring[0], ring[m + 1] - ring[0]));
  }
  return twice.value() / 2;
}

}  // namespace

void assemble(const CellList& list, Coverage& coverage) {
  coverage.rings.clear();
  coverage.sites.clear();
  coverage.cells.assign(1, 0);
  Tracer tracer;
  Rings traced;
  for (const CellList::Cell& cell : list.cells) {
    if (cell.isTraced) {
      tracer.clear();
      for (std::uint32_t ring = list.firstRing(cell); ring < list.endRing(cell); ++ring)
        tracer.addRing(list.rings.ring(ring));
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
                 Coverage& coverage) {
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
  assemble(raw, coverage);
  if (coverage.sites.empty()) return core.visibleCount() == 0 || !isFilled;
  return absolute(areaOf(coverage.rings) - area) <=
         closeness * proof.borderRounding() + kAreaRounding * box.width() * box.height();
}

}  // namespace apollonius::internal
