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
      if (insertion_->insert({planeIds_.data(), circleCount_}, steps)) {
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
      diagram_.enterBelowPole(id);
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
  planeIds_.resize(circleCount_);
  insertion_.emplace(diagram_.plane_);
}

void ProjectedDiagram::Filling::enter(std::size_t most) {
  const std::size_t end = done_ + std::min(most, circleCount_ - done_);
  for (; done_ < end; ++done_) diagram_.enter(ids_[done_], planeIds_[done_], caps_[ids_[done_]]);
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

bool ProjectedDiagram::restore(const SiteTable& sites, SiteId pole,
                               std::span<const HiddenSite> hidden) {
  FlatArray<bool> isPlaced(sites.idLimit(), true);
  for (const HiddenSite& pair : hidden) {
    if (!sites.has(pair.site) || !sites.has(pair.cover) || !isPlaced[pair.site]) return false;
    isPlaced[pair.site] = false;
  }
  if (!isPlaced[pole]) return false;
  FlatArray<SiteId> visible;
  visible.reserve(sites.size());
  for (SiteId id = 0; id < sites.idLimit(); ++id) {
    if (sites.has(id) && id != pole && isPlaced[id]) visible.push_back(id);
  }
  const FlatArray<Cap> caps = sites.caps();
  const std::size_t expected = visible.size() + 1;
  *this = ProjectedDiagram(caps[pole], pole);
  Filling filling(*this, sites, caps, std::move(visible));
  while (!filling.advance(BulkInsertion::kAllAtOnce)) {
  }
  if (visibleCount() != expected) return false;
  reserve(sites.idLimit(), hidden.size());
  for (const HiddenSite& pair : hidden) {
    if (!isPlaced[pair.cover] || !enterBelow(pair, caps[pair.site])) return false;
    isPlaced[pair.site] = true;
  }
  return true;
}

bool ProjectedDiagram::enterBelow(const HiddenSite& hidden, const Cap& cap) {
  const Projection::Image image = projection_.image(cap);
  const bool isPoles = hidden.cover == pole_;
  if (image.kind != (isPoles ? Kind::kBelowPole : Kind::kCircle)) return false;
  if (isPoles) {
    enterBelowPole(hidden.site);
    return true;
  }
  if (isBelowPole(hidden.cover)) return false;
  const SiteId plane = plane_.insertBelow(image.circle, places_[hidden.cover]);
  if (plane == kNoSite) return false;
  enter(hidden.site, plane, cap);
  loss_ = std::max(loss_, image.loss);
  return true;
}

FlatArray<HiddenSite> ProjectedDiagram::hidden(const SiteTable& sites) const {
  FlatArray<HiddenSite> all;
  all.reserve(sites.size() - visibleCount());
  for (const SiteId id : belowPole_) all.push_back({id, pole_});
  const HiddenForest& forest = plane_.hidden();
  const auto addChildren = [&](SiteId cover) {
    for (Slot child = forest.firstChild(plane_.ids().slotOf(places_[cover]));
         child != HiddenForest::kNone; child = forest.nextSibling(child))
      all.push_back({siteOfPlane_[plane_.ids().idOf(child)], cover});
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
  if (places_.size() < idLimit) places_.resize(idLimit, 0);
  if (belowPole_.capacity() < idLimit) belowPole_.reserve(idLimit + idLimit / 2);
  const std::size_t slots = plane_.ids().slots() + circles;
  if (caps_.size() < slots) caps_.resize(slots);
  const std::size_t names = plane_.ids().idLimit() + circles;
  if (siteOfPlane_.size() < names) siteOfPlane_.resize(names, kNoSite);
}

void ProjectedDiagram::enter(SiteId id, SiteId plane, const Cap& cap) noexcept {
  places_[id] = plane;
  siteOfPlane_[plane] = id;
  setCap(plane, cap);
}

void ProjectedDiagram::enterBelowPole(SiteId id) noexcept {
  places_[id] = kBelowPole | static_cast<std::uint32_t>(belowPole_.size());
  belowPole_.push_back(id);
}

void ProjectedDiagram::leaveBelowPole(SiteId id) noexcept {
  const std::uint32_t place = places_[id] & ~kBelowPole;
  const SiteId last = belowPole_.back();
  belowPole_[place] = last;
  places_[last] = kBelowPole | place;
  belowPole_.pop_back();
}

bool ProjectedDiagram::insertOne(const SiteTable& sites, SiteId id) {
  const Cap cap = sites.cap(id);
  const Projection::Image image = projection_.image(cap);
  if (image.kind == Kind::kCoversPole) return false;
  if (image.kind == Kind::kBelowPole) {
    reserve(sites.idLimit(), 0);
    enterBelowPole(id);
    return true;
  }
  if (isTooRough(image.loss)) return false;
  reserve(sites.idLimit(), 1);
  enter(id, plane_.insert(image.circle), cap);
  loss_ = std::max(loss_, image.loss);
  return true;
}

bool ProjectedDiagram::insert(const SiteTable& sites, std::span<const SiteId> ids) {
  if (isEmpty()) return false;
  if (ids.size() == 1) return insertOne(sites, ids[0]);
  FlatArray<double> circles;
  circles.reserve(3 * ids.size());
  double loss = loss_;
  for (const SiteId id : ids) {
    const Projection::Image image = projection_.image(sites.cap(id));
    if (image.kind == Kind::kCoversPole) return false;
    if (image.kind == Kind::kBelowPole) continue;
    if (isTooRough(image.loss)) return false;
    loss = std::max(loss, image.loss);
    append(circles, image.circle);
  }
  const std::size_t images = circles.size() / 3;
  reserve(sites.idLimit(), images);
  FlatArray<SiteId> planeIds(images);
  if (images > 0) insertAll(plane_, {circles.data(), circles.size()}, {planeIds.data(), images});
  loss_ = loss;
  std::size_t next = 0;
  for (const SiteId id : ids) {
    const Cap cap = sites.cap(id);
    if (projection_.image(cap).kind == Kind::kCircle)
      enter(id, planeIds[next++], cap);
    else
      enterBelowPole(id);
  }
  return true;
}

bool ProjectedDiagram::removeOne(SiteId id) {
  if (id == pole_) return false;
  if (isBelowPole(id))
    leaveBelowPole(id);
  else
    (void)plane_.remove(places_[id]);
  return true;
}

bool ProjectedDiagram::remove(std::span<const SiteId> ids) {
  if (ids.size() == 1) return removeOne(ids[0]);
  FlatArray<SiteId> planeIds;
  planeIds.reserve(ids.size());
  for (const SiteId id : ids) {
    if (id == pole_) return false;
    if (!isBelowPole(id)) planeIds.push_back(places_[id]);
  }
  (void)plane_.removeMany({planeIds.data(), planeIds.size()});
  for (const SiteId id : ids) {
    if (isBelowPole(id)) leaveBelowPole(id);
  }
  return true;
}

bool ProjectedDiagram::updateOne(const SiteTable& sites, SiteId id) {
  const Cap cap = sites.cap(id);
  const Projection::Image image = projection_.image(cap);
  const bool wasBelowPole = isBelowPole(id);
  if (image.kind == Kind::kCoversPole) return false;
  if (image.kind == Kind::kBelowPole) {
    if (!wasBelowPole) {
      reserve(sites.idLimit(), 0);
      (void)plane_.remove(places_[id]);
      enterBelowPole(id);
    }
    return true;
  }
  if (isTooRough(image.loss)) return false;
  if (wasBelowPole) {
    reserve(sites.idLimit(), 1);
    const SiteId plane = plane_.insert(image.circle);
    leaveBelowPole(id);
    enter(id, plane, cap);
  } else {
    plane_.update(places_[id], image.circle);
    setCap(places_[id], cap);
  }
  loss_ = std::max(loss_, image.loss);
  return true;
}

bool ProjectedDiagram::update(const SiteTable& sites, std::span<const SiteId> ids) {
  if (std::ranges::find(ids, pole_) != ids.end()) return false;
  if (ids.size() == 1) return updateOne(sites, ids[0]);
  FlatArray<double> circles;
  circles.reserve(3 * ids.size());
  FlatArray<SiteId> planeIds;
  planeIds.reserve(ids.size());
  double loss = loss_;
  for (const SiteId id : ids) {
    const Projection::Image image = projection_.image(sites.cap(id));
    if (image.kind != Kind::kCircle || isBelowPole(id) || isTooRough(image.loss)) return false;
    loss = std::max(loss, image.loss);
    append(circles, image.circle);
    planeIds.push_back(places_[id]);
  }
  const std::uint32_t layout = plane_.layout();
  plane_.updateMany({planeIds.data(), planeIds.size()}, {circles.data(), circles.size()});
  loss_ = loss;
  if (plane_.layout() == layout) {
    for (const SiteId id : ids) setCap(places_[id], sites.cap(id));
  } else {
    for (SiteId id = 0; id < sites.idLimit(); ++id) {
      if (sites.has(id) && id != pole_ && !isBelowPole(id)) setCap(places_[id], sites.cap(id));
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
      const std::uint32_t place = places_[id] & ~kBelowPole;
      if (place >= belowPole_.size() || belowPole_[place] != id)
        return "is not in the list of sites that the pole covers: site";
      if (image.kind != Kind::kBelowPole) return "is not covered by the pole: site";
      continue;
    }
    const Slot slot = plane_.ids().slotOf(places_[id]);
    if (slot == kNoSlot || siteOfPlane_[places_[id]] != id)
      return "is not that of its circle: site";
    const Site& circle = plane_.site(slot);
    if (image.kind != Kind::kCircle || image.circle.x != circle.x || image.circle.y != circle.y ||
        image.circle.r != circle.r)
      return "has another circle than its image: site";
    const Cap &cap = caps_[slot], expected = sites.cap(id);
    if (cap.centre.x != expected.centre.x || cap.centre.y != expected.centre.y ||
        cap.centre.z != expected.centre.z || cap.weight != expected.weight)
      return "has another cap in the graph: site";
  }
  where = static_cast<std::uint32_t>(found);
  if (found != sites.size() || plane_.ids().size() + belowPole_.size() + !isEmpty() != found)
    return "sites are not counted right:";
  return nullptr;
}

}  // namespace apollonius::internal::sphere
