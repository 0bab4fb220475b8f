// The public interface: checks arguments, translates lack of memory into an error, and
// leaves the work to the core.
#include "apollonius/diagram.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "api/checks.h"
#include "base/flat_array.h"
#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"
#include "diagram/listing.h"
#include "diagram/queries.h"
#include "diagram/validate.h"
#include "number/fp.h"
#include "number/invariant.h"
#include "predicate/distance.h"

namespace apollonius {

using namespace internal;

namespace {

Error checkCircle(double x, double y, double r) {
  const double values[] = {x, y, r};
  return checkNumbers(values);
}

}  // namespace

Diagram::Diagram(Location location) : core_(std::make_unique<DiagramCore>(location)) {
  const char* violation = arithmeticViolation();
  invariant(violation == nullptr, violation);
  change();
}

void Diagram::change() noexcept {
  static std::atomic<std::uint64_t> states{0};
  state_ = ++states;
}
Diagram::~Diagram() = default;
Diagram::Diagram(Diagram&&) noexcept = default;
Diagram& Diagram::operator=(Diagram&&) noexcept = default;

// --- Sites

Error Diagram::insert(double x, double y, double r, SiteId& id) {
  change();
  if (const Error error = checkCircle(x, y, r); error != Error::kNone) return error;
  if (size() == kMostSites) return Error::kTooLarge;
  return guarded(*core_, [&] { id = core_->insert({x, y, r}); });
}

Error Diagram::insertMany(std::span<const double> xyr, std::span<SiteId> ids) {
  change();
  if (xyr.size() != 3 * ids.size()) return Error::kBadLength;
  if (const Error error = checkNumbers(xyr); error != Error::kNone) return error;
  if (ids.size() > kMostSites - size()) return Error::kTooLarge;
  if (ids.empty()) return Error::kNone;  // without making the room that any insertion needs
  return guarded(*core_, [&] { insertAll(*core_, xyr, ids); });
}

Error Diagram::insertMany(std::vector<double>&& xyr, std::vector<SiteId>& ids) {
  change();
  const std::size_t count = xyr.size() / 3;
  if (xyr.size() != 3 * count) return Error::kBadLength;
  if (const Error error = checkNumbers(xyr); error != Error::kNone) return error;
  if (count > kMostSites - size()) return Error::kTooLarge;
  if (count == 0) {
    ids.clear();
    return Error::kNone;
  }
  return guarded(*core_, [&] {
    BulkInsertion insertion(*core_);
    insertion.stage(xyr);
    std::vector<double>().swap(xyr);
    ids.resize(count);
    insertion.insert(ids);
  });
}

Error Diagram::remove(SiteId id, bool& removed) {
  change();
  return guarded(*core_, [&] { removed = core_->remove(id); });
}

Error Diagram::removeMany(std::span<const SiteId> ids, std::size_t& removed) {
  change();
  return guarded(*core_, [&] { removed = core_->removeMany(ids); });
}

Error Diagram::update(SiteId id, double x, double y, double r) {
  change();
  if (!has(id)) return Error::kUnknownSite;
  if (const Error error = checkCircle(x, y, r); error != Error::kNone) return error;
  return guarded(*core_, [&] { core_->update(id, {x, y, r}); });
}

Error Diagram::updateMany(std::span<const SiteId> ids, std::span<const double> xyr) {
  change();
  if (xyr.size() != 3 * ids.size()) return Error::kBadLength;
  for (const SiteId id : ids) {
    if (!has(id)) return Error::kUnknownSite;
  }
  if (const Error error = checkNumbers(xyr); error != Error::kNone) return error;
  return guarded(*core_, [&] { core_->updateMany(ids, xyr); });
}

void Diagram::clear() noexcept {
  change();
  core_->clear();
}

std::size_t Diagram::size() const noexcept { return core_->ids().size(); }
std::size_t Diagram::visibleSize() const noexcept { return core_->visibleCount(); }
std::size_t Diagram::hiddenSize() const noexcept { return core_->ids().hiddenCount(); }
bool Diagram::has(SiteId id) const noexcept { return core_->ids().slotOf(id) != kNoSlot; }
std::size_t Diagram::idLimit() const noexcept { return core_->ids().idLimit(); }

Error Diagram::site(SiteId id, Circle& circle) const noexcept {
  const Slot slot = core_->ids().slotOf(id);
  if (slot == kNoSlot) return Error::kUnknownSite;
  const Site& site = core_->site(slot);
  circle = {site.x, site.y, site.r};
  return Error::kNone;
}

Error Diagram::ids(std::vector<SiteId>& ids) const {
  return guarded(*core_, [&] {
    ids.clear();
    ids.reserve(size());
    for (SiteId id = 0; id < core_->ids().idLimit(); ++id) {
      if (has(id)) ids.push_back(id);
    }
  });
}

Error Diagram::sites(SiteArrays& sites) const {
  if (const Error error = ids(sites.ids); error != Error::kNone) return error;
  return guarded(*core_, [&] {
    sites.xyr.resize(3 * size());
    sites.hidden.resize(size());
    for (std::size_t k = 0; k < size(); ++k) {
      const Slot slot = core_->ids().slotOf(sites.ids[k]);
      const Site& site = core_->site(slot);
      sites.xyr[3 * k] = site.x;
      sites.xyr[3 * k + 1] = site.y;
      sites.xyr[3 * k + 2] = site.r;
      sites.hidden[k] = core_->ids().state(slot) == SiteState::kHidden ? 1 : 0;
    }
  });
}

Error Diagram::isHidden(SiteId id, bool& hidden) const noexcept {
  const Slot slot = core_->ids().slotOf(id);
  if (slot == kNoSlot) return Error::kUnknownSite;
  hidden = core_->ids().state(slot) == SiteState::kHidden;
  return Error::kNone;
}

Error Diagram::coverOf(SiteId id, SiteId& cover) const {
  const Slot slot = core_->ids().slotOf(id);
  if (slot == kNoSlot) return Error::kUnknownSite;
  return guarded(*core_, [&] {
    const Site& site = core_->site(slot);
    // Lemma 1 of the paper: the site nearest to its centre covers it.
    cover = core_->ids().state(slot) == SiteState::kHidden
                ? core_->ids().idOf(core_->nearest(site.x, site.y))
                : kNoSite;
  });
}

// --- Queries

Error Diagram::find(double x, double y, SiteId& id) const {
  if (const Error error = checkNumbers(x, y); error != Error::kNone) return error;
  return guarded(
      *core_, [&] { id = idOrNone(*core_, visibleSize() == 0 ? kNoSlot : core_->nearest(x, y)); });
}

Error Diagram::find(double x, double y, SiteId& id, double& distance) const {
  if (const Error error = find(x, y, id); error != Error::kNone) return error;
  distance = distanceTo(*core_, core_->ids().slotOf(id), x, y);
  return Error::kNone;
}

Error Diagram::find(double x, double y, double maxDistance, SiteId& id) const {
  if (const Error error = checkNumbers(x, y); error != Error::kNone) return error;
  if (const Error error = checkLimit(maxDistance); error != Error::kNone) return error;
  return guarded(*core_, [&] {
    const Slot nearest = visibleSize() == 0 ? kNoSlot : core_->nearest(x, y);
    id = idOrNone(*core_, orNone(*core_, nearest, x, y, maxDistance));
  });
}

Error Diagram::find(double x, double y, double maxDistance, SiteId& id, double& distance) const {
  if (const Error error = find(x, y, maxDistance, id); error != Error::kNone) return error;
  distance = distanceTo(*core_, core_->ids().slotOf(id), x, y);
  return Error::kNone;
}

Error Diagram::findMany(std::span<const double> xy, double maxDistance, std::span<SiteId> ids,
                        std::span<double> distances) const {
  if (xy.size() != 2 * ids.size() || (!distances.empty() && distances.size() != ids.size()))
    return Error::kBadLength;
  if (const Error error = checkNumbers(xy); error != Error::kNone) return error;
  if (const Error error = checkLimit(maxDistance); error != Error::kNone) return error;
  return guarded(*core_, [&] { listNearest(*core_, xy, maxDistance, ids, distances); });
}

Error Diagram::kNearest(double x, double y, std::size_t k, double maxDistance,
                        std::vector<SiteId>& sites) const {
  if (const Error error = checkNumbers(x, y); error != Error::kNone) return error;
  if (const Error error = checkLimit(maxDistance); error != Error::kNone) return error;
  return guarded(*core_, [&] { listNearby(*core_, x, y, k, maxDistance, sites); });
}

Error Diagram::kNearestMany(std::span<const double> xy, std::size_t k, double maxDistance,
                            bool withDistances, NearbyLists& lists) const {
  if (xy.size() % 2 != 0) return Error::kBadLength;
  if (const Error error = checkNumbers(xy); error != Error::kNone) return error;
  if (const Error error = checkLimit(maxDistance); error != Error::kNone) return error;
  return guarded(*core_, [&] { listNearbyMany(*core_, xy, k, maxDistance, withDistances, lists); });
}

Error Diagram::pick(double x, double y, double maxDistance, Top top, SiteId& id) const {
  if (const Error error = checkNumbers(x, y); error != Error::kNone) return error;
  if (const Error error = checkLimit(maxDistance); error != Error::kNone) return error;
  if (maxDistance < 0) return Error::kOutOfRange;
  return guarded(*core_, [&] { id = internal::pick(*core_, x, y, maxDistance, top); });
}

Error Diagram::farthest(double x, double y, SiteId& id, double& distance) const {
  if (const Error error = checkNumbers(x, y); error != Error::kNone) return error;
  return guarded(*core_, [&] {
    const Slot slot = farthestSite(*core_, x, y);
    id = idOrNone(*core_, slot);
    distance = slot == kNoSlot ? -std::numeric_limits<double>::infinity()
                               : roundedDistance(x, y, opposite(core_->site(slot)));
  });
}

Error Diagram::search(double xmin, double ymin, double xmax, double ymax,
                      std::vector<SiteId>& sites) const {
  for (const double value : {xmin, ymin, xmax, ymax}) {
    if (checkNumber(value) != Error::kNone) return Error::kBadBounds;
  }
  if (xmin > xmax || ymin > ymax) return Error::kBadBounds;
  return guarded(*core_, [&] { listMeeting(*core_, xmin, ymin, xmax, ymax, sites); });
}

Error Diagram::neighbors(SiteId id, std::vector<SiteId>& neighbors) const {
  if (!has(id)) return Error::kUnknownSite;
  return guarded(*core_, [&] { listNeighbors(*core_, id, neighbors); });
}

Error Diagram::conflict(double x, double y, double r, std::vector<SiteId>& sites,
                        bool& isCovered) const {
  if (const Error error = checkCircle(x, y, r); error != Error::kNone) return error;
  return guarded(*core_, [&] { listConflict(*core_, normalized({x, y, r}), sites, isCovered); });
}

Error Diagram::vertices(VertexArrays& vertices) const {
  return guarded(*core_, [&] { listVertices(*core_, vertices); });
}

Error Diagram::edges(EdgeArrays& edges) const {
  return guarded(*core_, [&] { listEdges(*core_, edges); });
}

Error Diagram::faces(std::vector<SiteId>& sites) const {
  return guarded(*core_, [&] { listFaces(*core_, sites); });
}

Error Diagram::hull(std::vector<SiteId>& sites) const {
  return guarded(*core_, [&] { listHull(*core_, sites); });
}

Error Diagram::levels(std::vector<std::uint8_t>& levels) const {
  return guarded(*core_, [&] { listLevels(*core_, levels); });
}

Error Diagram::toBytes(std::vector<std::uint8_t>& bytes) const {
  return guarded(*core_, [&] { core_->save(bytes); });
}

Error Diagram::fromBytes(std::span<const std::uint8_t> bytes, Source source) {
  change();
  try {
    auto restored = std::make_unique<DiagramCore>(core_->location());
    if (!restored->restore(bytes, source)) return Error::kCorruptSnapshot;
    core_ = std::move(restored);
    return Error::kNone;
  } catch (const std::bad_alloc&) {
    return Error::kOutOfMemory;
  }
}

Error Diagram::validate(Violation& violation) const {
  return guarded(*core_, [&] { violation = internal::validate(*core_); });
}

}  // namespace apollonius
