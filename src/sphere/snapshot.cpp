// Snapshots of the sphere: docs/SNAPSHOTS.md has the format. They hold the data that the diagram is
// built from: the sites, the pole, and the cover of each hidden site. They hold no graph: the same
// circles give the same graph, as the plane's is canonical, so nothing has to be proved. Circles do
// not determine which of identical sites is visible, and which sites hidden ones hang on.
#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <utility>

#include "base/byte_stream.h"
#include "sphere/restoring.h"
#include "sphere/spherical_core.h"

namespace apollonius::internal::sphere {

namespace {

constexpr std::uint64_t kMagic = 0x0A1A0A0D736F7041u;  // "Apos", and line ends as in the plane's
constexpr std::uint32_t kVersion = 2;
constexpr std::size_t kHeaderBytes = 48, kChecksumBytes = 8;

std::uint64_t bytesFor(std::uint64_t idLimit, std::uint64_t sites, std::uint64_t hidden) {
  const std::uint64_t ids = 4 * idLimit;  // and 4 bytes more where their number is odd
  return kHeaderBytes + 24 * sites + ids + 8 * hidden + ids % 8 + kChecksumBytes;
}

/// Could it have been saved? What calls take as 0 could not.
bool isSite(const SphericalSite& site, double radius) {
  for (const double number : {site.centre.lon, site.centre.lat, site.r}) {
    if (taken(number) != number) return false;
  }
  return std::isfinite(site.centre.lon) && std::abs(site.centre.lat) <= 90 &&
         std::abs(site.r) / radius < std::numbers::pi;
}

}  // namespace

void SphericalCore::save(std::vector<std::uint8_t>& bytes) const {
  const FlatArray<HiddenSite> hidden = projected_.hidden(sites_);
  const std::uint64_t size = bytesFor(sites_.idLimit(), sites_.size(), hidden.size());
  if (size > std::numeric_limits<std::size_t>::max() / 2) throw std::bad_alloc();
  bytes.assign(static_cast<std::size_t>(size), 0);
  WordWriter out(bytes);
  out.longWord(kMagic);
  out.word(kVersion);
  out.word(sites_.idLimit());
  out.word(static_cast<std::uint32_t>(sites_.size()));
  out.word(projected_.pole());
  out.word(static_cast<std::uint32_t>(sizeAtChoice_));
  out.word(static_cast<std::uint32_t>(hidden.size()));
  out.longWord(seed_);
  out.number(sites_.radius());
  for (SiteId id = 0; id < sites_.idLimit(); ++id) {
    if (!sites_.has(id)) continue;
    const SphericalSite& site = sites_[id];
    for (const double number : {site.centre.lon, site.centre.lat, site.r}) out.number(number);
  }
  for (SiteId id = 0; id < sites_.idLimit(); ++id) {
    if (sites_.has(id)) out.word(id);
  }
  sites_.visitFree([&](SiteId id) { out.word(id); });
  for (const HiddenSite& pair : hidden) {
    out.word(pair.site);
    out.word(pair.cover);
  }
  const std::span<const std::uint8_t> content(bytes.data(), bytes.size() - kChecksumBytes);
  WordWriter(std::span(bytes).last(kChecksumBytes)).longWord(checksumOf(content));
}

bool SphericalCore::restore(std::span<const std::uint8_t> bytes) {
  return Restoring(*this, bytes).finish() == Restoring::State::kDone;
}

Restoring::State Restoring::advance(std::size_t steps) {
  bool isRight = true;
  switch (step_) {
    case Step::kRead:
      isRight = read();
      if (isRight && !filling_) return State::kDone;  // no site
      step_ = Step::kFill;
      break;
    case Step::kFill:
      if (filling_->advance(steps)) step_ = Step::kHide;
      break;
    case Step::kHide:
      return hide() ? State::kDone : State::kCorrupt;
  }
  return isRight ? State::kUnderWay : State::kCorrupt;
}

double Restoring::progress() const { return filling_ ? 0.1 + 0.85 * filling_->progress() : 0; }

bool Restoring::read() {
  if (bytes_.size() < kHeaderBytes + kChecksumBytes) return false;
  WordReader in(bytes_);
  if (in.longWord() != kMagic || in.word() != kVersion) return false;
  const std::uint32_t idLimit = in.word(), size = in.word();
  const SiteId pole = in.word();
  const std::uint32_t sizeAtChoice = in.word(), hiddenCount = in.word();
  const std::uint64_t seed = in.longWord();
  const double radius = in.number();
  if (size > idLimit || idLimit > kMostSites ||
      bytes_.size() != bytesFor(idLimit, size, hiddenCount) || sizeAtChoice > kMostSites ||
      !(radius > 0) || !isInRange(radius))
    return false;
  const auto content = bytes_.first(bytes_.size() - kChecksumBytes);
  if (WordReader(bytes_.last(kChecksumBytes)).longWord() != checksumOf(content)) return false;

  FlatArray<SphericalSite> rows;
  rows.reserve(size);
  for (std::uint32_t k = 0; k < size; ++k) {
    const double lon = in.number(), lat = in.number(), r = in.number();
    if (!isSite({{lon, lat}, r}, radius)) return false;
    rows.push_back({{lon, lat}, r});
  }
  SiteTable& sites = diagram_.sites_;
  sites = SiteTable(radius);
  sites.reserve(idLimit);
  for (SiteId id = 0; id < idLimit; ++id) (void)sites.take({});
  FlatArray<bool> isListed(idLimit, false);
  FlatArray<SiteId> ids;
  ids.reserve(idLimit);
  for (std::uint32_t k = 0; k < idLimit; ++k) {
    const SiteId id = in.word();
    // Used ones ascend.
    if (id >= idLimit || isListed[id] || (k > 0 && k < size && id < ids.back())) return false;
    isListed[id] = true;
    ids.push_back(id);
  }
  for (std::uint32_t k = 0; k < size; ++k) sites.set(ids[k], rows[k]);
  // The one that is used first is freed last.
  for (std::uint32_t k = idLimit; k-- > size;) sites.release(ids[k]);
  hidden_.resize(hiddenCount);
  for (HiddenSite& pair : hidden_) {
    pair.site = in.word();
    pair.cover = in.word();
  }
  diagram_.sizeAtChoice_ = sizeAtChoice;
  diagram_.seed_ = seed;
  if (size == 0) return pole == kNoSite && hiddenCount == 0;
  return sites.has(pole) && beginToFill(pole);
}

/// The visible sites, seen from the pole.
bool Restoring::beginToFill(SiteId pole) {
  const SiteTable& sites = diagram_.sites_;
  FlatArray<bool> isVisible(sites.idLimit(), true);
  for (const HiddenSite& pair : hidden_) {
    if (!sites.has(pair.site) || !sites.has(pair.cover) || !isVisible[pair.site]) return false;
    isVisible[pair.site] = false;
  }
  if (!isVisible[pole]) return false;
  FlatArray<SiteId> others;
  others.reserve(sites.size());
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (sites.has(id) && id != pole && isVisible[id]) others.push_back(id);
  }
  caps_ = sites.caps();
  diagram_.projected_ = ProjectedDiagram(caps_[pole], pole);
  filling_.emplace(diagram_.projected_, sites, caps_, std::move(others));
  return true;
}

bool Restoring::hide() {
  filling_.reset();
  ProjectedDiagram& projected = diagram_.projected_;
  return projected.visibleCount() == diagram_.sites_.size() - hidden_.size() &&
         projected.enterHidden(caps_, {hidden_.data(), hidden_.size()});
}

}  // namespace apollonius::internal::sphere
