#include "apollonius/spherical_diagram.h"

#include <limits>
#include <new>
#include <numbers>

#include "api/sites.h"
#include "api/sphere/spherical_checks.h"
#include "diagram/nearby_lists.h"
#include "diagram/topmost.h"
#include "number/fp.h"
#include "number/invariant.h"
#include "sphere/empty_circles.h"
#include "sphere/listing.h"
#include "sphere/nearby.h"
#include "sphere/nearest.h"

namespace apollonius {

using namespace internal;
using namespace internal::sphere;

namespace {

/// The distance to a site. Beyond the limit, and without a site, it is infinite and the id becomes
/// kNoSite.
double limitedDistance(const SphericalCore& core, const Direction& point, double maxDistance,
                       SiteId& id) {
  const double distance = id == kNoSite ? kEverywhere : distanceTo(core.sites(), id, point);
  if (!(distance > maxDistance)) return distance;
  id = kNoSite;
  return kEverywhere;
}

}  // namespace

SphericalDiagram::SphericalDiagram(double radius) : core_(std::make_unique<SphericalCore>(radius)) {
  const char* violation = arithmeticViolation();
  invariant(violation == nullptr, violation);
}
SphericalDiagram::~SphericalDiagram() = default;
SphericalDiagram::SphericalDiagram(SphericalDiagram&&) noexcept = default;
SphericalDiagram& SphericalDiagram::operator=(SphericalDiagram&&) noexcept = default;

bool SphericalDiagram::isRadius(double radius) noexcept { return radius > 0 && isInRange(radius); }
double SphericalDiagram::radius() const noexcept { return core_->sites().radius(); }

std::uint64_t SphericalDiagram::revision() const noexcept { return core_->revision(); }

// --- Sites

Error SphericalDiagram::insert(double lon, double lat, double r, SiteId& id) {
  const double numbers[] = {lon, lat, r};
  return insertMany(numbers, {&id, 1});
}

Error SphericalDiagram::insertMany(std::span<const double> sites, std::span<SiteId> ids) {
  const Error error = firstOf(checkLength(sites.size() == 3 * ids.size()),
                              checkSites(*core_, sites), checkRoom(ids.size(), size()));
  return guarded(*core_, error, [&] { core_->insertMany(TakenNumbers(sites), ids); });
}

Error SphericalDiagram::remove(SiteId id, bool& removed) {
  return guarded(*core_, [&] { removed = core_->removeMany({&id, 1}) == 1; });
}

Error SphericalDiagram::removeMany(std::span<const SiteId> ids, std::size_t& removed) {
  return guarded(*core_, [&] { removed = core_->removeMany(ids); });
}

Error SphericalDiagram::update(SiteId id, double lon, double lat, double r) {
  const double numbers[] = {lon, lat, r};
  return updateMany({&id, 1}, numbers);
}

Error SphericalDiagram::updateMany(std::span<const SiteId> ids, std::span<const double> sites) {
  const Error error = firstOf(checkLength(sites.size() == 3 * ids.size()), checkIds(*this, ids),
                              checkSites(*core_, sites));
  return guarded(*core_, error, [&] { core_->updateMany(ids, TakenNumbers(sites)); });
}

void SphericalDiagram::clear() noexcept { core_->clear(); }

std::size_t SphericalDiagram::size() const noexcept { return core_->sites().size(); }
std::size_t SphericalDiagram::visibleSize() const noexcept {
  return core_->projected().visibleCount();
}
bool SphericalDiagram::has(SiteId id) const noexcept { return core_->sites().has(id); }
std::size_t SphericalDiagram::idLimit() const noexcept { return core_->sites().idLimit(); }

Error SphericalDiagram::site(SiteId id, SphericalCircle& circle) const noexcept {
  if (!has(id)) return Error::kUnknownSite;
  const SphericalSite& site = core_->sites()[id];
  circle = {site.centre.lon, site.centre.lat, site.r};
  return Error::kNone;
}

Error SphericalDiagram::ids(std::vector<SiteId>& ids) const {
  return guarded(*core_, [&] { listIds(*this, ids); });
}

Error SphericalDiagram::sites(SiteArrays& sites) const {
  return guarded(*core_, [&] { listSites<SphericalCircle>(*this, sites); });
}

Error SphericalDiagram::isHidden(SiteId id, bool& hidden) const noexcept {
  if (!has(id)) return Error::kUnknownSite;
  hidden = core_->projected().isHidden(id);
  return Error::kNone;
}

Error SphericalDiagram::coverOf(SiteId id, SiteId& cover) const {
  return guarded(*core_, checkIds(*this, {&id, 1}), [&] {
    // As in the plane, the site nearest to its centre covers it.
    cover = core_->projected().isHidden(id)
                ? Sphere(*core_).nearest(directionOf(core_->sites()[id].centre))
                : kNoSite;
  });
}

// --- Queries

Error SphericalDiagram::find(double lon, double lat, SiteId& id) const {
  return guarded(*core_, takePoint(*core_, lon, lat),
                 [&] { id = Sphere(*core_).nearest(directionOf({lon, lat})); });
}

Error SphericalDiagram::find(double lon, double lat, SiteId& id, double& distance) const {
  return find(lon, lat, kEverywhere, id, distance);
}

Error SphericalDiagram::find(double lon, double lat, double maxDistance, SiteId& id) const {
  double distance = 0;
  return find(lon, lat, maxDistance, id, distance);
}

Error SphericalDiagram::find(double lon, double lat, double maxDistance, SiteId& id,
                             double& distance) const {
  return guarded(*core_, firstOf(takePoint(*core_, lon, lat), takeLimit(maxDistance)), [&] {
    const Direction point = directionOf({lon, lat});
    id = Sphere(*core_).nearest(point);
    distance = limitedDistance(*core_, point, maxDistance, id);
  });
}

Error SphericalDiagram::farthest(double lon, double lat, SiteId& id, double& distance) const {
  return guarded(*core_, takePoint(*core_, lon, lat), [&] {
    const Direction opposite = -1 * directionOf({lon, lat});
    id = Sphere(*core_).nearest(opposite);
    // A way and the rest of it to the opposite point are half a great circle.
    distance = id == kNoSite
                   ? -std::numeric_limits<double>::infinity()
                   : std::numbers::pi * radius() - distanceTo(core_->sites(), id, opposite);
  });
}

Error SphericalDiagram::findMany(std::span<const double> lonLat, double maxDistance,
                                 std::span<SiteId> ids, std::span<double> distances) const {
  const Error error = firstOf(checkResults(lonLat, ids, distances), checkPoints(*core_, lonLat),
                              takeLimit(maxDistance));
  return guarded(*core_, error, [&] {
    const TakenNumbers numbers(lonLat);
    const std::span<const double> points = numbers;
    listNearest(core_->projected(), points, ids);
    if (distances.empty() && maxDistance == kEverywhere) return;
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const Direction point = directionOf({points[2 * k], points[2 * k + 1]});
      const double distance = limitedDistance(*core_, point, maxDistance, ids[k]);
      if (!distances.empty()) distances[k] = distance;
    }
  });
}

Error SphericalDiagram::kNearest(double lon, double lat, std::size_t k, double maxDistance,
                                 std::vector<SiteId>& sites) const {
  return guarded(*core_, firstOf(takePoint(*core_, lon, lat), takeLimit(maxDistance)), [&] {
    listNearby(NearbySearch(Sphere(*core_), directionOf({lon, lat}), maxDistance), k, sites);
  });
}

Error SphericalDiagram::kNearestMany(std::span<const double> lonLat, std::size_t k,
                                     double maxDistance, bool withDistances,
                                     NearbyLists& lists) const {
  const Error error = firstOf(checkLength(lonLat.size() % 2 == 0), checkPoints(*core_, lonLat),
                              takeLimit(maxDistance));
  return guarded(*core_, error, [&] {
    listNearbyMany(*core_, TakenNumbers(lonLat), k, maxDistance, withDistances, lists);
  });
}

Error SphericalDiagram::pick(double lon, double lat, double maxDistance, Top top,
                             SiteId& id) const {
  return guarded(*core_, firstOf(takePoint(*core_, lon, lat), takePick(maxDistance)), [&] {
    id = topmost(NearbySearch(Sphere(*core_), directionOf({lon, lat}), maxDistance), top);
  });
}

Error SphericalDiagram::neighbors(SiteId id, std::vector<SiteId>& neighbors) const {
  return guarded(*core_, checkIds(*this, {&id, 1}),
                 [&] { listNeighbors(core_->projected(), id, neighbors); });
}

Error SphericalDiagram::vertices(VertexArrays& vertices) const {
  return guarded(*core_, [&] { listVertices(core_->projected(), radius(), vertices); });
}

Error SphericalDiagram::emptyCircles(std::size_t most, VertexArrays& circles) const {
  return guarded(*core_,
                 [&] { listEmptyCircles(core_->projected(), core_->sites(), most, circles); });
}

Error SphericalDiagram::edges(EdgeArrays& edges) const {
  return guarded(*core_, [&] { listEdges(core_->projected(), edges); });
}

Error SphericalDiagram::narrowest(VertexArrays& places) const {
  return guarded(*core_, [&] { listNarrowest(core_->projected(), radius(), places); });
}

// --- Snapshots

Error SphericalDiagram::toBytes(std::vector<std::uint8_t>& bytes) const {
  return guarded(*core_, [&] { core_->save(bytes); });
}

Error SphericalDiagram::fromBytes(std::span<const std::uint8_t> bytes) {
  try {
    auto restored = std::make_unique<SphericalCore>(1);
    if (!restored->restore(bytes)) return Error::kCorruptSnapshot;
    become(std::move(restored));
    return Error::kNone;
  } catch (const std::bad_alloc&) {
    return Error::kOutOfMemory;
  } catch (const std::length_error&) {
    return Error::kOutOfMemory;
  }
}

void SphericalDiagram::become(std::unique_ptr<SphericalCore> restored) noexcept {
  restored->follow(*core_);
  core_ = std::move(restored);
}

Error SphericalDiagram::validate(Violation& violation) const {
  return guarded(*core_, [&] { violation = core_->validate(); });
}

}  // namespace apollonius
