#include "geometry/polygons/rings.h"

namespace apollonius::internal {

void Rings::append(const Rings& other, std::size_t first, std::size_t end) {
  const std::size_t ring = other.parts[first], point = other.starts[ring];
  const std::size_t rings = other.parts[end] - ring, points = other.starts[ring + rings] - point;
  const std::size_t ringShift = ringCount() - ring, pointShift = coordinates.size() / 2 - point;
  coordinates.append(std::span(other.coordinates).subspan(2 * point, 2 * points));
  for (std::size_t k = 1; k <= rings; ++k)
    starts.push_back(static_cast<std::uint32_t>(other.starts[ring + k] + pointShift));
  for (std::size_t k = first + 1; k <= end; ++k)
    parts.push_back(static_cast<std::uint32_t>(other.parts[k] + ringShift));
}

}  // namespace apollonius::internal
