// Region: checks rings, and turns lack of memory into an error.
#include "apollonius/region.h"

#include <cmath>
#include <new>
#include <stdexcept>
#include <utility>

#include "api/checks.h"
#include "api/shapes/region_state.h"
#include "geometry/curve/moments.h"
#include "number/sum.h"

namespace apollonius {

using namespace internal;

namespace {

bool areGood(std::span<const double> coordinates, std::span<const std::uint32_t> starts) {
  if (starts.empty() || starts.front() != 0 || coordinates.size() % 2 != 0 ||
      coordinates.size() / 2 != starts.back())
    return false;
  for (std::size_t k = 1; k < starts.size(); ++k) {
    if (starts[k] < starts[k - 1] || starts[k] - starts[k - 1] < 3) return false;
  }
  return checkNumbers(coordinates) == Error::kNone;
}

double insideOf(const NormalizedPolygon& polygon) {
  Sum sum;
  for (std::size_t k = 0; k < polygon.ringCount(); ++k) sum.add(areaOf(polygon.ring(k)).value);
  return sum.value();
}

Point centroidOf(const NormalizedPolygon& polygon) {
  const Point origin = polygon.box.center();
  Moments sum;
  for (std::size_t k = 0; k < polygon.ringCount(); ++k) {
    const auto ring = polygon.ring(k);
    for (std::size_t n = 0; n < ring.size(); ++n)
      sum.add(Conic::segment(ring[n], ring[n + 1 < ring.size() ? n + 1 : 0]), origin);
  }
  return origin + (1 / sum.area) * sum.first;
}

}  // namespace

Region::Region() noexcept = default;
Region::~Region() = default;
Region::Region(Region&&) noexcept = default;
Region& Region::operator=(Region&&) noexcept = default;

Error Region::assign(std::span<const double> coordinates, std::span<const std::uint32_t> starts) {
  if (!areGood(coordinates, starts)) return Error::kBadBounds;
  try {
    auto state = std::make_unique<RegionState>();
    state->polygon = normalizePolygon(TakenNumbers(coordinates), starts);
    state->area = insideOf(state->polygon);
    if (!(state->area > 0)) return Error::kBadBounds;
    state->centroid = centroidOf(state->polygon);
    state_ = std::move(state);
    return Error::kNone;
  } catch (const std::bad_alloc&) {
    return Error::kOutOfMemory;
  }
}

Bounds Region::box() const noexcept {
  if (state_ == nullptr) return {};
  const Rectangle& box = state_->polygon.box;
  return {box.xmin, box.ymin, box.xmax, box.ymax};
}

Error Region::draw(Path& path) const {
  path.clear();
  if (state_ == nullptr) return Error::kNone;
  const NormalizedPolygon& polygon = state_->polygon;
  try {
    for (std::size_t k = 0; k < polygon.ringCount(); ++k) {
      const auto ring = polygon.ring(k);
      path.move(ring[0].x, ring[0].y);
      for (const Point p : ring.subspan(1)) path.line(p.x, p.y);
      path.close();
    }
    return Error::kNone;
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  return Error::kOutOfMemory;
}

bool Region::contains(double x, double y) const noexcept {
  return state_ != nullptr && std::isfinite(x) && std::isfinite(y) &&
         state_->polygon.holds({taken(x), taken(y)});
}

double Region::area() const noexcept { return state_ == nullptr ? 0 : state_->area; }
double Region::centroidX() const noexcept { return state_ == nullptr ? 0 : state_->centroid.x; }
double Region::centroidY() const noexcept { return state_ == nullptr ? 0 : state_->centroid.y; }

}  // namespace apollonius
