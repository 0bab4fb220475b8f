#include "geometry/polygons/raw_rings.h"

#include <algorithm>

namespace apollonius::internal {

RawRings listRawRings(const DiagramCore& core, PolygonFinder& finder) {
  RawRings raw;
  Rings rings;
  FlatArray<char> isBorder;
  finder.expectAll();
  // By slot: as sites lie in memory, they lie in the plane.
  for (std::size_t k = 0; k < core.ids().slots(); ++k) {
    const auto slot = static_cast<Slot>(k);
    const PolygonFinder::Soundness soundness = finder.findRaw(slot, rings, &isBorder);
    if (rings.ringCount() == 0) continue;
    raw.cells.push_back({core.ids().idOf(slot), slot, static_cast<std::uint32_t>(raw.rings.size()),
                         static_cast<std::uint32_t>(rings.ringCount()),
                         soundness != PolygonFinder::Soundness::kSure});
    for (std::size_t ring = 0; ring < rings.ringCount(); ++ring) {
      const std::span<const double> coordinates = rings.ring(ring);
      const std::size_t count = coordinates.size() / 2 - 1;
      raw.rings.push_back(
          {static_cast<std::uint32_t>(raw.points.size()), static_cast<std::uint32_t>(count)});
      for (std::size_t m = 0; m < count; ++m) {
        const Point p{coordinates[2 * m], coordinates[2 * m + 1]};
        raw.points.push_back(p + Point{});  // -0 becomes 0
        raw.isBorder.push_back(isBorder[rings.starts[ring] + m]);
      }
    }
  }
  std::sort(raw.cells.begin(), raw.cells.end(),
            [](const RawRings::Cell& a, const RawRings::Cell& b) { return a.site < b.site; });
  return raw;
}

}  // namespace apollonius::internal
