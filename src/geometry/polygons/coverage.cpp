#include "geometry/polygons/coverage.h"

#include <cmath>

#include "geometry/polygons/tiling_proof.h"
#include "number/sum.h"

namespace apollonius::internal {

namespace {

/// Sums of areas are off by less than this share of the box around the window: a cross product is
/// off by four roundings of the box that its ring fills, and a ring is shorter than 2^10 boxes.
constexpr double kAreaRounding = powerOfTwo(-40);

/// Of all rings, those of holes negative.
double areaOf(const RawRings& raw) {
  Sum twice;
  for (const RawRings::Ring& ring : raw.rings) {
    const std::span<const Point> points = raw.pointsOf(ring);
    for (std::size_t k = 1; k + 1 < points.size(); ++k)
      twice.add(cross(points[k] - points[0], points[k + 1] - points[0]));
  }
  return twice.value() / 2;
}

void list(const RawRings& raw, Coverage& coverage) {
  Rings& all = coverage.rings;
  all.clear();
  coverage.sites.clear();
  coverage.cells.assign(1, 0);
  Tracer tracer;
  Rings rings;
  for (const RawRings::Cell& cell : raw.cells) {
    rings.clear();
    for (const RawRings::Ring& ring : raw.ringsOf(cell)) {
      if (ring.count == 0) continue;
      const std::span<const Point> points = raw.pointsOf(ring);
      for (const Point p : points) rings.add(p);
      rings.add(points[0]);
      rings.endRing();
    }
    if (cell.isTraced) {
      tracer.clear();
      for (std::size_t k = 0; k < rings.ringCount(); ++k) tracer.addRing(rings.ring(k));
      tracer.trace(rings);
    } else {
      rings.endPart();  // inside the window a cell is one ring
    }
    if (rings.ringCount() == 0) continue;
    coverage.sites.push_back(cell.site);
    const auto firstRing = static_cast<std::uint32_t>(all.ringCount());
    const auto firstPoint = static_cast<std::uint32_t>(all.coordinates.size() / 2);
    all.coordinates.append(rings.coordinates);
    for (std::size_t k = 1; k < rings.starts.size(); ++k)
      all.starts.push_back(firstPoint + rings.starts[k]);
    for (std::size_t k = 1; k < rings.parts.size(); ++k)
      all.parts.push_back(firstRing + rings.parts[k]);
    coverage.cells.push_back(static_cast<std::uint32_t>(all.parts.size() - 1));
  }
}

double areaOf(const Rings& rings) {
  Sum twice;
  for (std::size_t k = 0; k < rings.ringCount(); ++k) {
    const std::span<const double> ring = rings.ring(k);
    const auto at = [&](std::size_t m) { return Point{ring[2 * m], ring[2 * m + 1]}; };
    for (std::size_t m = 1; m + 2 < ring.size() / 2; ++m)
      twice.add(cross(at(m) - at(0), at(m + 1) - at(0)));
  }
  return twice.value() / 2;
}

}  // namespace

bool coverWindow(const DiagramCore& core, PolygonFinder& finder, const Rectangle& box, double area,
                 Coverage& coverage) {
  RawRings raw = listRawRings(core, finder);
  const bool isFilled = !std::isnan(area);
  if (!isFilled) area = areaOf(raw);
  const TilingProof proof(core, box, raw);
  coverage.work = raw.points.size();
  double closeness = 1;
  if (!proof.holds() || !isFilled) {
    Mesh mesh(core, box, raw);
    const bool isMended = mesh.mend();
    coverage.work += mesh.work();
    if (!isMended) return false;
    closeness = mesh.closeness();
  }
  list(raw, coverage);
  if (coverage.sites.empty()) return core.visibleCount() == 0 || !isFilled;
  return absolute(areaOf(coverage.rings) - area) <=
         closeness * proof.borderRounding() + kAreaRounding * box.width() * box.height();
}

}  // namespace apollonius::internal
