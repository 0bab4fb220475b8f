#include "apollonius/spherical_diagram.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "api/spherical_checks.h"
#include "number/fp.h"
#include "number/invariant.h"
#include "sphere/empty_circles.h"
#include "sphere/listing.h"
#include "sphere/nearby.h"
#include "sphere/nearest.h"

namespace apollonius {

using namespace internal;
using namespace internal::sphere;

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
  if (sites.size() != 3 * ids.size()) return Error::kBadLength;
  if (const Error error = checkSites(sites, radius()); error != Error::kNone) return error;
  if (ids.size() > kMostSites - size()) return Error::kTooLarge;
  return guarded(*core_, [&] { core_->insertMany(sites, ids); });
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
  if (sites.size() != 3 * ids.size()) return Error::kBadLength;
  for (const SiteId id : ids) {
    if (!has(id)) return Error::kUnknownSite;
  }
  if (const Error error = checkSites(sites, radius()); error != Error::kNone) return error;
  return guarded(*core_, [&] { core_->updateMany(ids, sites); });
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
  return guarded(*core_, [&] {
    ids.clear();
    ids.reserve(size());
    for (SiteId id = 0; id < core_->sites().idLimit(); ++id) {
      if (has(id)) ids.push_back(id);
    }
  });
}

Error SphericalDiagram::sites(SiteArrays& sites) const {
  if (const Error error = ids(sites.ids); error != Error::kNone) return error;
  return guarded(*core_, [&] {
    sites.xyr.resize(3 * size());
    sites.hidden.resize(size());
    for (std::size_t k = 0; k < size(); ++k) {
      const SphericalSite& site = core_->sites()[sites.ids[k]];
      sites.xyr[3 * k] = site.centre.lon;
      sites.xyr[3 * k + 1] = site.centre.lat;
      sites.xyr[3 * k + 2] = site.r;
      sites.hidden[k] = core_->projected().isHidden(sites.ids[k]) ? 1 : 0;
    }
  });
}

Error SphericalDiagram::isHidden(SiteId id, bool& hidden) const noexcept {
  if (!has(id)) return Error::kUnknownSite;
  hidden = core_->projected().isHidden(id);
  return Error::kNone;
}

Error SphericalDiagram::coverOf(SiteId id, SiteId& cover) const {
  if (!has(id)) return Error::kUnknownSite;
  return guarded(*core_, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    // As in the plane, the site nearest to its centre covers it.
    cover = diagram.isHidden(id)
                ? diagram.siteOf(nearestNode(diagram, directionOf(core_->sites()[id].centre)))
                : kNoSite;
  });
}

// --- Queries

Error SphericalDiagram::find(double lon, double lat, SiteId& id) const {
  if (const Error error = checkPoint(lon, lat); error != Error::kNone) return error;
  return guarded(*core_, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    id =
        diagram.isEmpty() ? kNoSite : diagram.siteOf(nearestNode(diagram, directionOf({lon, lat})));
  });
}

Error SphericalDiagram::find(double lon, double lat, SiteId& id, double& distance) const {
  if (const Error error = find(lon, lat, id); error != Error::kNone) return error;
  distance = id == kNoSite ? std::numeric_limits<double>::infinity()
                           : distanceTo(core_->sites(), id, directionOf({lon, lat}));
  return Error::kNone;
}

Error SphericalDiagram::find(double lon, double lat, double maxDistance, SiteId& id) const {
  double distance = 0;
  return find(lon, lat, maxDistance, id, distance);
}

Error SphericalDiagram::find(double lon, double lat, double maxDistance, SiteId& id,
                             double& distance) const {
  if (const Error error = checkPoint(lon, lat); error != Error::kNone) return error;
  if (std::isnan(maxDistance)) return Error::kNotFinite;
  if (const Error error = find(lon, lat, id, distance); error != Error::kNone) return error;
  if (distance > maxDistance) {
    id = kNoSite;
    distance = std::numeric_limits<double>::infinity();
  }
  return Error::kNone;
}

Error SphericalDiagram::farthest(double lon, double lat, SiteId& id, double& distance) const {
  if (const Error error = checkPoint(lon, lat); error != Error::kNone) return error;
  return guarded(*core_, [&] {
    const ProjectedDiagram& diagram = core_->projected();
    const Direction opposite = -1 * directionOf({lon, lat});
    id = diagram.isEmpty() ? kNoSite : diagram.siteOf(nearestNode(diagram, opposite));
    // A way and the rest of it to the opposite point are half a great circle.
    distance = id == kNoSite
                   ? -std::numeric_limits<double>::infinity()
                   : std::numbers::pi * radius() - distanceTo(core_->sites(), id, opposite);
  });
}

Error SphericalDiagram::findMany(std::span<const double> lonLat, double maxDistance,
                                 std::span<SiteId> ids, std::span<double> distances) const {
  if (lonLat.size() != 2 * ids.size() || (!distances.empty() && distances.size() != ids.size()))
    return Error::kBadLength;
  if (const Error error = checkPoints(lonLat); error != Error::kNone) return error;
  if (std::isnan(maxDistance)) return Error::kNotFinite;
  return guarded(*core_, [&] {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    listNearest(core_->projected(), lonLat, ids);
    if (distances.empty() && maxDistance == kNone) return;
    for (std::size_t k = 0; k < ids.size(); ++k) {
      double distance = kNone;
      if (ids[k] != kNoSite) {
        distance =
            distanceTo(core_->sites(), ids[k], directionOf({lonLat[2 * k], lonLat[2 * k + 1]}));
        if (distance > maxDistance) {
          ids[k] = kNoSite;
          distance = kNone;
        }
      }
      if (!distances.empty()) distances[k] = distance;
    }
  });
}

Error SphericalDiagram::kNearest(double lon, double lat, std::size_t k, double maxDistance,
                                 std::vector<SiteId>& sites) const {
  if (const Error error = checkPoint(lon, lat); error != Error::kNone) return error;
  if (std::isnan(maxDistance)) return Error::kNotFinite;
  return guarded(*core_, [&] {
    sites.clear();
    if (k == 0) return;
    SphericalSearch search(core_->projected(), core_->sites(), directionOf({lon, lat}),
                           maxDistance);
    for (SiteId id = search.next(); id != kNoSite; id = search.next()) {
      sites.push_back(id);
      if (sites.size() == k) return;
    }
  });
}

Error SphericalDiagram::kNearestMany(std::span<const double> lonLat, std::size_t k,
                                     double maxDistance, bool withDistances,
                                     NearbyLists& lists) const {
  if (lonLat.size() % 2 != 0) return Error::kBadLength;
  if (const Error error = checkPoints(lonLat); error != Error::kNone) return error;
  if (std::isnan(maxDistance)) return Error::kNotFinite;
  return guarded(*core_, [&] {
    listNearbyMany(core_->projected(), core_->sites(), lonLat, k, maxDistance, withDistances,
                   lists);
  });
}

Error SphericalDiagram::pick(double lon, double lat, double maxDistance, Top top,
                             SiteId& id) const {
  if (const Error error = checkPoint(lon, lat); error != Error::kNone) return error;
  if (std::isnan(maxDistance)) return Error::kNotFinite;
  if (maxDistance < 0) return Error::kOutOfRange;
  return guarded(*core_, [&] {
    id =
        sphere::pick(core_->projected(), core_->sites(), directionOf({lon, lat}), maxDistance, top);
  });
}

Error SphericalDiagram::neighbors(SiteId id, std::vector<SiteId>& neighbors) const {
  if (!has(id)) return Error::kUnknownSite;
  return guarded(*core_, [&] { listNeighbors(core_->projected(), id, neighbors); });
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
    core_ = std::move(restored);
    return Error::kNone;
  } catch (const std::bad_alloc&) {
    return Error::kOutOfMemory;
  } catch (const std::length_error&) {
    return Error::kOutOfMemory;
  }
}

Error SphericalDiagram::validate(Violation& violation) const {
  return guarded(*core_, [&] { violation = core_->validate(); });
}

}  // namespace apollonius
