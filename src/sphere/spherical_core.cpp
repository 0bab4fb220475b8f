// Insertion, removal and moves are the plane's. All is projected anew where the pole is concerned,
// and where the sites have become twice as many since it was chosen: so the pole is a random one of
// the sites also where they come one by one, for the price of building once more in all. A removal
// that does not look at the pole meets it with probability 1 / h.
#include "sphere/spherical_core.h"

#include <algorithm>
#include <utility>

#include "diagram/validate.h"

namespace apollonius::internal::sphere {

namespace {

SphericalSite siteAt(std::span<const double> sites, std::size_t k) {
  return {{sites[3 * k], sites[3 * k + 1]}, sites[3 * k + 2]};
}

}  // namespace

void SphericalCore::project() {
  if (sites_.size() == 0) {
    projected_ = ProjectedDiagram();
    sizeAtChoice_ = 0;
    return;
  }
  Projecting projecting(sites_, seed_);
  projecting.finish();
  take(projecting);
}

void SphericalCore::take(Projecting& finished) noexcept {
  projected_ = std::move(finished.diagram());
  seed_ = finished.seed();
  sizeAtChoice_ = sites_.size();
}

void SphericalCore::enter(std::span<const SiteId> ids) {
  // Where no good pole was found, as of two sites of which one nearly covers the other, it may be
  // among those that come. Tried at sizes in geometric progression, too: O(n) in all.
  const std::size_t rougher = sizeAtChoice_ + sizeAtChoice_ / 16 + 1;
  const std::size_t limit = projected_.isRough() ? rougher : 2 * sizeAtChoice_;
  if (sites_.size() >= limit || !projected_.insert(sites_, ids)) project();
}

SiteId SphericalCore::insert(const SphericalSite& site) {
  const double numbers[] = {site.centre.lon, site.centre.lat, site.r};
  SiteId id = kNoSite;
  insertMany(numbers, {&id, 1});
  return id;
}

void SphericalCore::insertMany(std::span<const double> sites, std::span<SiteId> ids) {
  ++revision_;
  if (ids.empty()) return;
  sites_.reserve(ids.size());
  const SiteId limit = sites_.idLimit();
  for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = sites_.take(siteAt(sites, k));
  try {
    enter(ids);
  } catch (...) {
    for (std::size_t k = ids.size(); k-- > 0;) sites_.undoTake(ids[k], limit);
    throw;
  }
}

std::size_t SphericalCore::removeMany(std::span<const SiteId> ids) {
  ++revision_;
  removed_.clear();
  removed_.reserve(ids.size());
  // Released first, so that ids that are repeated are seen to be free.
  for (const SiteId id : ids) {
    if (!sites_.has(id)) continue;
    sites_.release(id);
    removed_.push_back(id);
  }
  if (removed_.empty()) return 0;
  try {
    if (!projected_.remove({removed_.data(), removed_.size()})) project();
  } catch (...) {
    for (std::size_t k = removed_.size(); k-- > 0;) sites_.undoRelease(removed_[k]);
    throw;
  }
  return removed_.size();
}

void SphericalCore::update(SiteId id, const SphericalSite& site) {
  const double numbers[] = {site.centre.lon, site.centre.lat, site.r};
  updateMany({&id, 1}, numbers);
}

void SphericalCore::updateMany(std::span<const SiteId> ids, std::span<const double> sites) {
  ++revision_;
  if (ids.empty()) return;
  before_.clear();
  before_.reserve(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) {
    before_.push_back(sites_[ids[k]]);
    sites_.set(ids[k], siteAt(sites, k));
  }
  try {
    if (!projected_.update(sites_, ids)) project();
  } catch (...) {
    for (std::size_t k = ids.size(); k-- > 0;) sites_.set(ids[k], before_[k]);
    throw;
  }
}

void SphericalCore::clear() noexcept {
  ++revision_;
  sites_.clear();
  projected_ = ProjectedDiagram();
  sizeAtChoice_ = 0;
}

void SphericalCore::become(SiteTable&& sites, Projecting& finished) noexcept {
  ++revision_;
  sites_ = std::move(sites);
  take(finished);
}

Violation SphericalCore::validate() const {
  Violation violation = internal::validate(projected_.plane());
  if (!violation.isFound()) violation.what = projected_.check(sites_, violation.where);
  return violation;
}

}  // namespace apollonius::internal::sphere
