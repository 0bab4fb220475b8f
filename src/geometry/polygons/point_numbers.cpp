#include "geometry/polygons/point_numbers.h"

#include <bit>

namespace apollonius::internal {

namespace {

constexpr std::uint32_t kNoPoint = 0xFFFFFFFFu;
constexpr std::size_t kFirst = 64;

std::uint64_t mixed(double x) {
  auto bits = std::bit_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u;
  return bits ^ (bits >> 29);
}

}  // namespace

std::size_t PointNumbers::entryOf(Point p) const {
  const std::size_t mask = table_.size() - 1;
  const std::uint64_t hash = (mixed(p.x) ^ std::rotl(mixed(p.y), 31)) * 0x9E3779B97F4A7C15u;
  std::size_t entry = static_cast<std::size_t>(hash >> 32) & mask;
  while (table_[entry] != kNoPoint && !(points_[table_[entry]] == p)) entry = (entry + 1) & mask;
  return entry;
}

std::uint32_t PointNumbers::add(Point p) {
  if (2 * points_.size() >= table_.size()) grow();
  p = p + Point{};  // -0 becomes 0
  const std::size_t entry = entryOf(p);
  if (table_[entry] == kNoPoint) {
    table_[entry] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
  }
  return table_[entry];
}

/// A table that was for many more begins anew: it would be cleared for every cell after a large
/// one.
void PointNumbers::clear() {
  table_.assign(table_.size() > 16 * points_.size() ? 0 : table_.size(), kNoPoint);
  points_.clear();
}

void PointNumbers::grow() {
  table_.assign(table_.empty() ? kFirst : 2 * table_.size(), kNoPoint);
  for (std::uint32_t k = 0; k < points_.size(); ++k) table_[entryOf(points_[k])] = k;
}

}  // namespace apollonius::internal
