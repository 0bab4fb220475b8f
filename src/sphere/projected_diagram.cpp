#include "sphere/projected_diagram.h"

#include <algorithm>
#include <utility>

namespace apollonius::internal::sphere {

namespace {

using Kind = Projection::Kind;

void append(FlatArray<double>& circles, const Site& circle) {
  for (const double number : {circle.x, circle.y, circle.r}) circles.push_back(number);
}

}  // namespace

ProjectedDiagram::Filling::Filling(ProjectedDiagram& diagram, const SiteTable& sites,
                                   const FlatArray<Cap>& caps, FlatArray<SiteId> ids)
    : diagram_(diagram), caps_(caps), ids_(std::move(ids)) {
  circles_.reserve(3 * ids_.size());
  diagram_.reserve(sites.idLimit(), ids_.size());
}

bool ProjectedDiagram::Filling::advance(std::size_t steps) {
  switch (step_) {
    case Step::kProject:
      project(BulkInsertion::visits(steps, 16));
      return step_ == Step::kDone;
    case Step::kStage:
      if (insertion_->stage({circles_.data(), circles_.size()},
                            BulkInsertion::visits(steps, BulkInsertion::kStageVisits))) {
        FlatArray<double>().swap(circles_);
        step_ = Step::kInsert;
      }
      return false;
    case Step::kInsert:
      if (insertion_->insert({ids_.data(), circleCount_}, steps)) {
        insertion_.reset();
        step_ = Step::kEnter;
      }
      return false;
    case Step::kEnter:
      enter(BulkInsertion::visits(steps, 64));
      return step_ == Step::kDone;
    case Step::kDone:
      return true;
  }
  return true;
}

void ProjectedDiagram::Filling::project(std::size_t most) {
  const std::size_t end = done_ + std::min(most, ids_.size() - done_);
  for (; done_ < end; ++done_) {
    const SiteId id = ids_[done_];
    const Projection::Image image = diagram_.projection_.image(caps_[id]);
    if (image.kind != Kind::kCircle) {
      diagram_.enterBelowPole(id, caps_[id]);
      continue;
    }
    diagram_.loss_ = std::max(diagram_.loss_, image.loss);
    append(circles_, image.circle);
    ids_[circleCount_++] = id;
  }
  if (done_ < ids_.size()) return;
  done_ = 0;
  step_ = circleCount_ > 0 ? Step::kStage : Step::kDone;
  if (circleCount_ == 0) return;
  diagram_.grid_.reset(circleCount_);
  insertion_.emplace(diagram_.plane_);
}

void ProjectedDiagram::Filling::enter(std::size_t most) {
  const std::size_t end = done_ + std::min(most, circleCount_ - done_);
  for (; done_ < end; ++done_) diagram_.setCap(ids_[done_], caps_[ids_[done_]]);
  if (done_ < circleCount_) return;
  diagram_.grid_.fill();
  step_ = Step::kDone;
}

double ProjectedDiagram::Filling::progress() const {
  switch (step_) {
    case Step::kProject:
      return 0;
    case Step::kStage:
    case Step::kInsert:
      return 0.05 + 0.9 * insertion_->progress();
    case Step::kEnter:
      return 0.95;
    case Step::kDone:
      return 1;
  }
  return 1;
}

bool ProjectedDiagram::enterHidden(const FlatArray<Cap>& caps, std::span<const HiddenSite> hidden) {
  const SiteId pole = pole_;
  reserve(caps.size(), hidden.size());
  FlatArray<bool> isEntered(caps.size(), true);
  for (const HiddenSite& pair : hidden) isEntered[pair.site] = false;
  for (const HiddenSite& pair : hidden) {
    if (!isEntered[pair.cover] || !enterBelow(pair, caps[pair.site])) return false;
    isEntered[pair.site] = true;
  }
  return pole_ == pole;
}

bool ProjectedDiagram::enterBelow(const HiddenSite& hidden, const Cap& cap) {
  const Projection::Image image = projection_.image(cap);
  const bool isPoles = hidden.cover == pole_;
  if (image.kind != (isPoles ? Kind::kBelowPole : Kind::kCircle)) return false;
  if (isPoles) {
    enterBelowPole(hidden.site, cap);
    return true;
  }
  if (isBelowPole(hidden.cover) || !plane_.insertBelow(image.circle, hidden.site, hidden.cover))
    return false;
  setCap(hidden.site, cap);
  loss_ = std::max(loss_, image.loss);
  return true;
}

FlatArray<HiddenSite> ProjectedDiagram::hidden(const SiteTable& sites) const {
  FlatArray<HiddenSite> all;
  all.reserve(sites.size() - visibleCount());
  for (const SiteId id : belowPole_) all.push_back({id, pole_});
  const HiddenForest& forest = plane_.hidden();
  const auto addChildren = [&](SiteId cover) {
    for (Slot child = forest.firstChild(plane_.ids().slotOf(cover)); child != HiddenForest::kNone;
         child = forest.nextSibling(child))
      all.push_back({plane_.ids().idOf(child), cover});
  };
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (sites.has(id) && id != pole_ && !isHidden(id)) addChildren(id);
  }
  for (std::size_t k = belowPole_.size(); k < all.size(); ++k) addChildren(all[k].site);
  return all;
}

bool ProjectedDiagram::isTooRough(double loss) const {
  return loss > std::max(kMostLoss, 16 * loss_);
}

void ProjectedDiagram::reserve(std::size_t idLimit, std::size_t circles) {
  plane_.reserveIds(idLimit);
  if (placeBelowPole_.size() < idLimit) placeBelowPole_.resize(idLimit, 0);
  if (belowPole_.capacity() < idLimit) belowPole_.reserve(idLimit + idLimit / 2);
  const std::size_t slots = plane_.ids().slots() + circles;
  if (caps_.size() < slots) caps_.resize(slots);
}

void ProjectedDiagram::enterBelowPole(SiteId id, const Cap& cap) noexcept {
  if (id < pole_ && areIdentical(cap, poleCap_)) std::swap(id, pole_);
  placeBelowPole_[id] = static_cast<std::uint32_t>(belowPole_.size());
  belowPole_.push_back(id);
}

void ProjectedDiagram::leaveBelowPole(SiteId id) noexcept {
  const std::uint32_t place = placeBelowPole_[id];
  const SiteId last = belowPole_.back();
  belowPole_[place] = last;
  placeBelowPole_[last] = place;
  belowPole_.pop_back();
}

bool ProjectedDiagram::insertOne(const SiteTable& sites, SiteId id) {
  const Cap cap = sites.cap(id);
  const Projection::Image image = projection_.image(cap);
  if (image.kind == Kind::kCoversPole) return false;
  if (image.kind == Kind::kBelowPole) {
    reserve(sites.idLimit(), 0);
    enterBelowPole(id, cap);
    return true;
  }
  if (isTooRough(image.loss)) return false;
  reserve(sites.idLimit(), 1);
  (void)plane_.insert(image.circle, id);
  setCap(id, cap);
  loss_ = std::max(loss_, image.loss);
  return true;
}

bool ProjectedDiagram::insert(const SiteTable& sites, std::span<const SiteId> ids) {
  if (isEmpty()) return false;
  if (ids.size() == 1) return insertOne(sites, ids[0]);
  FlatArray<double> circles;
  circles.reserve(3 * ids.size());
  FlatArray<SiteId> projected;
  projected.reserve(ids.size());
  double loss = loss_;
  for (const SiteId id : ids) {
    const Projection::Image image = projection_.image(sites.cap(id));
    if (image.kind == Kind::kCoversPole) return false;
    if (image.kind == Kind::kBelowPole) continue;
    if (isTooRough(image.loss)) return false;
    loss = std::max(loss, image.loss);
    append(circles, image.circle);
    projected.push_back(id);
  }
  reserve(sites.idLimit(), projected.size());
  if (!projected.empty())
    insertAll(plane_, {circles.data(), circles.size()}, {projected.data(), projected.size()});
  loss_ = loss;
  for (const SiteId id : ids) {
    const Cap cap = sites.cap(id);
    if (plane_.ids().slotOf(id) == kNoSlot)
      enterBelowPole(id, cap);
    else
      setCap(id, cap);
  }
  return true;
}

bool ProjectedDiagram::removeOne(SiteId id) {
  if (id == pole_) return false;
  if (isBelowPole(id))
    leaveBelowPole(id);
  else
    (void)plane_.remove(id);
  return true;
}

bool ProjectedDiagram::remove(std::span<const SiteId> ids) {
  if (ids.size() == 1) return removeOne(ids[0]);
  if (std::ranges::find(ids, pole_) != ids.end()) return false;
  FlatArray<SiteId> below;
  below.reserve(ids.size());
  for (const SiteId id : ids) {
    if (isBelowPole(id)) below.push_back(id);
  }
  (void)plane_.removeMany(ids);  // passes over those below the pole, which have no slot
  for (const SiteId id : below) leaveBelowPole(id);
  return true;
}

bool ProjectedDiagram::updateOne(const SiteTable& sites, SiteId id) {
  const Cap cap = sites.cap(id);
  const Projection::Image image = projection_.image(cap);
  if (image.kind == Kind::kCoversPole) return false;
  if (image.kind == Kind::kBelowPole) {
    reserve(sites.idLimit(), 0);
    (void)removeOne(id);
    enterBelowPole(id, cap);
    return true;
  }
  if (isTooRough(image.loss)) return false;
  if (isBelowPole(id)) {
    reserve(sites.idLimit(), 1);
    (void)plane_.insert(image.circle, id);
    leaveBelowPole(id);
  } else {
    plane_.update(id, image.circle);
  }
  setCap(id, cap);
  loss_ = std::max(loss_, image.loss);
  return true;
}

bool ProjectedDiagram::update(const SiteTable& sites, std::span<const SiteId> ids) {
  if (std::ranges::find(ids, pole_) != ids.end()) return false;
  if (ids.size() == 1) return updateOne(sites, ids[0]);
  FlatArray<double> circles;
  circles.reserve(3 * ids.size());
  double loss = loss_;
  for (const SiteId id : ids) {
    const Projection::Image image = projection_.image(sites.cap(id));
    if (image.kind != Kind::kCircle || isBelowPole(id) || isTooRough(image.loss)) return false;
    loss = std::max(loss, image.loss);
    append(circles, image.circle);
  }
  const std::uint32_t layout = plane_.layout();
  plane_.updateMany(ids, {circles.data(), circles.size()});
  loss_ = loss;
  if (plane_.layout() == layout) {
    for (const SiteId id : ids) setCap(id, sites.cap(id));
  } else {
    for (SiteId id = 0; id < sites.idLimit(); ++id) {
      if (sites.has(id) && id != pole_ && !isBelowPole(id)) setCap(id, sites.cap(id));
    }
  }
  return true;
}

const char* ProjectedDiagram::check(const SiteTable& sites, std::uint32_t& where) const {
  std::size_t found = 0;
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (!sites.has(id)) continue;
    where = id;
    ++found;
    if (id == pole_) continue;
    const Projection::Image image = projection_.image(sites.cap(id));
    if (isBelowPole(id)) {
      const std::uint32_t place = placeBelowPole_[id];
      if (place >= belowPole_.size() || belowPole_[place] != id)
        return "is not in the list of sites that the pole covers: site";
      if (image.kind != Kind::kBelowPole) return "is not covered by the pole: site";
      if (id < pole_ && areIdentical(sites.cap(id), poleCap_))
        return "is identical to the pole and has a lesser id: site";
      continue;
    }
    const Slot slot = plane_.ids().slotOf(id);
    const Site& circle = plane_.site(slot);
    if (image.kind != Kind::kCircle || image.circle.x != circle.x || image.circle.y != circle.y ||
        image.circle.r != circle.r)
      return "has another circle than its image: site";
    if (!areIdentical(caps_[slot], sites.cap(id))) return "has another cap in the graph: site";
  }
  where = static_cast<std::uint32_t>(found);
  if (found != sites.size() || plane_.ids().size() + belowPole_.size() + !isEmpty() != found)
    return "sites are not counted right:";
  return nullptr;
}

}  // namespace apollonius::internal::sphere
