// The public interface: checks arguments, translates lack of memory into an error, and
// leaves the work to the core.
#include "apollonius/diagram.h"

#include <atomic>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "api/checks.h"
#include "api/sites.h"
#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"
#include "diagram/listing.h"
#include "diagram/plane.h"
#include "diagram/queries.h"
#include "diagram/topmost.h"
#include "diagram/validate.h"
#include "number/fp.h"
#include "number/invariant.h"
#include "predicate/distance.h"

namespace apollonius {

using namespace internal;

namespace {

Error takeCircle(double& x, double& y, double& r) {
  return firstOf(takeNumber(x), takeNumber(y), takeNumber(r));
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
  return guarded(*core_, firstOf(takeCircle(x, y, r), checkRoom(1, size())),
                 [&] { id = core_->insert({x, y, r}); });
}

Error Diagram::insertMany(std::span<const double> xyr, std::span<SiteId> ids) {
  change();
  const Error error = firstOf(checkLength(xyr.size() == 3 * ids.size()), checkNumbers(xyr),
                              checkRoom(ids.size(), size()));
  return guarded(*core_, error, [&] {
    // An empty list must not make the room that any insertion needs.
    if (!ids.empty()) insertAll(*core_, TakenNumbers(xyr), ids);
  });
}

Error Diagram::insertMany(std::vector<double>&& xyr, std::vector<SiteId>& ids) {
  change();
  const std::size_t count = xyr.size() / 3;
  const Error error =
      firstOf(checkLength(xyr.size() == 3 * count), checkNumbers(xyr), checkRoom(count, size()));
  return guarded(*core_, error, [&] {
    if (count == 0) return ids.clear();
    for (double& number : xyr) number = taken(number);
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
  return guarded(*core_, firstOf(checkIds(*this, {&id, 1}), takeCircle(x, y, r)),
                 [&] { core_->update(id, {x, y, r}); });
}

Error Diagram::updateMany(std::span<const SiteId> ids, std::span<const double> xyr) {
  change();
  const Error error =
      firstOf(checkLength(xyr.size() == 3 * ids.size()), checkIds(*this, ids), checkNumbers(xyr));
  return guarded(*core_, error, [&] { core_->updateMany(ids, TakenNumbers(xyr)); });
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
  return guarded(*core_, [&] { listIds(*this, ids); });
}

Error Diagram::sites(SiteArrays& sites) const {
  return guarded(*core_, [&] { listSites<Circle>(*this, sites); });
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

// Not by way of the next one: a limit costs this most frequent call a tenth.
Error Diagram::find(double x, double y, SiteId& id) const {
  return guarded(*core_, takePoint(*core_, x, y),
                 [&] { id = idOrNone(*core_, Plane(*core_).nearest({x, y})); });
}

Error Diagram::find(double x, double y, SiteId& id, double& distance) const {
  return find(x, y, std::numeric_limits<double>::infinity(), id, distance);
}

Error Diagram::find(double x, double y, double maxDistance, SiteId& id) const {
  return guarded(*core_, firstOf(takePoint(*core_, x, y), takeLimit(maxDistance)), [&] {
    const Slot nearest = Plane(*core_).nearest({x, y});
    id = idOrNone(*core_, orNone(*core_, nearest, x, y, maxDistance));
  });
}

Error Diagram::find(double x, double y, double maxDistance, SiteId& id, double& distance) const {
  if (const Error error = find(x, y, maxDistance, id); error != Error::kNone) return error;
  distance = distanceTo(*core_, core_->ids().slotOf(id), taken(x), taken(y));
  return Error::kNone;
}

Error Diagram::findMany(std::span<const double> xy, double maxDistance, std::span<SiteId> ids,
                        std::span<double> distances) const {
  const Error error =
      firstOf(checkResults(xy, ids, distances), checkPoints(*core_, xy), takeLimit(maxDistance));
  return guarded(*core_, error,
                 [&] { listNearest(*core_, TakenNumbers(xy), maxDistance, ids, distances); });
}

Error Diagram::kNearest(double x, double y, std::size_t k, double maxDistance,
                        std::vector<SiteId>& sites) const {
  return guarded(*core_, firstOf(takePoint(*core_, x, y), takeLimit(maxDistance)),
                 [&] { listNearby(*core_, x, y, k, maxDistance, sites); });
}

Error Diagram::kNearestMany(std::span<const double> xy, std::size_t k, double maxDistance,
                            bool withDistances, NearbyLists& lists) const {
  const Error error =
      firstOf(checkLength(xy.size() % 2 == 0), checkPoints(*core_, xy), takeLimit(maxDistance));
  return guarded(*core_, error, [&] {
    listNearbyMany(*core_, TakenNumbers(xy), k, maxDistance, withDistances, lists);
  });
}

Error Diagram::pick(double x, double y, double maxDistance, Top top, SiteId& id) const {
  return guarded(*core_, firstOf(takePoint(*core_, x, y), takePick(maxDistance)),
                 [&] { id = topmost(NearbySearch(Plane(*core_), {x, y}, maxDistance), top); });
}

Error Diagram::farthest(double x, double y, SiteId& id, double& distance) const {
  return guarded(*core_, takePoint(*core_, x, y), [&] {
    const Slot slot = farthestSite(*core_, x, y);
    id = idOrNone(*core_, slot);
    distance = slot == kNoSlot ? -std::numeric_limits<double>::infinity()
                               : roundedDistance(x, y, opposite(core_->site(slot)));
  });
}

Error Diagram::search(double xmin, double ymin, double xmax, double ymax,
                      std::vector<SiteId>& sites) const {
  bool isGood = true;
  for (double* bound : {&xmin, &ymin, &xmax, &ymax})
    isGood = takeNumber(*bound) == Error::kNone && isGood;
  isGood = isGood && xmin <= xmax && ymin <= ymax;
  return guarded(*core_, isGood ? Error::kNone : Error::kBadBounds,
                 [&] { listMeeting(*core_, xmin, ymin, xmax, ymax, sites); });
}

Error Diagram::neighbors(SiteId id, std::vector<SiteId>& neighbors) const {
  return guarded(*core_, checkIds(*this, {&id, 1}), [&] { listNeighbors(*core_, id, neighbors); });
}

Error Diagram::conflict(double x, double y, double r, std::vector<SiteId>& sites,
                        bool& isCovered) const {
  return guarded(*core_, takeCircle(x, y, r),
                 [&] { listConflict(*core_, {x, y, r}, sites, isCovered); });
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
