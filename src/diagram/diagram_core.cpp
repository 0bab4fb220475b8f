#include "diagram/diagram_core.h"

#include <algorithm>

#include "diagram/sort_by_key.h"
#include "diagram/spatial_order.h"
#include "memory/flat_array.h"
#include "number/invariant.h"

namespace apollonius {

void DiagramCore::reserve(std::size_t slots) {
  ids_.reserve(slots);
  hidden_.reserve(slots);
  base_.reserve(slots + 1);  // last: who looks at its size finds room for all
}

VertexId DiagramCore::startFor(double x, double y) const {
  const Slot close = grid_.near(x, y);
  if (close != kNoSlot && base_.isVisible(vertexOf(close))) return vertexOf(close);
  if (isHierarchyDue_) buildHierarchy();
  const Slot start = hierarchy_.locate(x, y);
  return start == kNoSlot || !base_.isVisible(vertexOf(start)) ? base_.anyVisible() : vertexOf(start);
}

Slot DiagramCore::nearest(double x, double y, Slot hint) const {
  const VertexId start = hint != kNoSlot ? vertexOf(hint) : startFor(x, y);
  return slotOf(base_.locate(x, y, start, walk_).nearest);
}

SiteId DiagramCore::insert(const Site& site) {
  const Slot slot = ids_.next();
  if (slot + std::size_t{2} > base_.graph().vertexSlots()) {
    hidden_.reserve(slot + std::size_t{1});
    base_.reserve(slot + std::size_t{2});  // last: see reserve
  }
  return ids_.take(place(slot, site, kNoVertex));
}

SiteState DiagramCore::place(Slot slot, const Site& site, VertexId start) {
  const VertexId v = vertexOf(slot);
  base_.setSite(v, normalized(site));
  if (start == kNoVertex) start = startFor(site.x, site.y);
  const DelaunayGraph::Insertion insertion = base_.insert(v, start, walk_, &hidden_);
  if (insertion.cover != kNoVertex) {
    hidden_.reserveChildren(1);
    hidden_.attach(slot, slotOf(insertion.cover));
    return SiteState::kHidden;
  }
  // From here on nothing throws.
  for (const VertexId covered : insertion.covered) {
    hidden_.attach(slotOf(covered), slot);
    ids_.setState(slotOf(covered), SiteState::kHidden);
    leaveLocation(slotOf(covered));
  }
  enterLocation(slot);
  return SiteState::kVisible;
}

bool DiagramCore::remove(SiteId id) {
  const Slot slot = ids_.slotOf(id);
  if (slot == kNoSlot) return false;
  displace(slot);
  ids_.release(slot);
  return true;
}

std::size_t DiagramCore::removeMany(std::span<const SiteId> ids) {
  ballast_.load();
  FlatArray<Slot> gone;
  gone.reserve(ids.size());
  try {
    for (const SiteId id : ids) {
      const Slot slot = ids_.slotOf(id);
      if (slot == kNoSlot || ids_.state(slot) == SiteState::kPending) continue;  // pending: repeated
      displace(slot);
      gone.push_back(slot);
    }
  } catch (...) {
    ballast_.drop();
    for (const Slot slot : gone) restore(slot, site(slot));
    throw;
  }
  for (const Slot slot : gone) ids_.release(slot);
  return gone.size();
}

void DiagramCore::displace(Slot slot) {
  if (ids_.state(slot) == SiteState::kHidden) {
    hidden_.dissolve(slot);  // what it covered is covered by its parent, too
  } else {
    displaceVisible(slot);
  }
  ids_.setState(slot, SiteState::kPending);
}

void DiagramCore::displaceVisible(Slot slot) {
  children_.clear();
  for (Slot child = hidden_.firstChild(slot); child != HiddenForest::kNone; child = hidden_.nextSibling(child)) {
    children_.push_back(vertexOf(child));
  }
  const std::span<const Remover::Fate> fates = remover_.remove(base_, vertexOf(slot), children_);
  // From here on nothing throws.
  for (const Remover::Fate& fate : fates) {
    const Slot child = slotOf(fate.vertex);
    hidden_.detach(child);
    if (fate.cover == kNoVertex) {
      ids_.setState(child, SiteState::kVisible);
    } else {
      hidden_.attach(child, slotOf(fate.cover));
    }
  }
  leaveLocation(slot);
  // The fates were the remover's scratch, which the line above may have used.
  for (const VertexId child : children_) {
    if (ids_.state(slotOf(child)) == SiteState::kVisible) enterLocation(slotOf(child));
  }
}

void DiagramCore::enterLocation(Slot slot) noexcept {
  if (!usesHierarchy_) return;
  if (!isHierarchyDue_) hierarchy_.insert(slot, site(slot));
  if (walk_ != Walk::kSectors || isBulk_) return;
  grid_.insert(slot, site(slot));
  if (grid_.isOutgrown()) rebuildGrid();
}

void DiagramCore::leaveLocation(Slot slot) noexcept {
  if (!isHierarchyDue_) hierarchy_.remove(slot, remover_);
  grid_.remove(site(slot));
}

void DiagramCore::buildHierarchy() const noexcept {
  isHierarchyDue_ = false;
  for (Slot slot = 0; slot < ids_.slots(); ++slot) {
    if (ids_.state(slot) == SiteState::kVisible) hierarchy_.insert(slot, site(slot));
  }
}

void DiagramCore::rebuildGrid() noexcept {
  Site low = base_.site(base_.anyVisible()), high = low;
  const auto forEachVisible = [&](auto&& visit) {
    for (Slot slot = 0; slot < ids_.slots(); ++slot) {
      if (base_.graph().hasVertex(vertexOf(slot))) visit(slot);
    }
  };
  forEachVisible([&](Slot slot) {
    const Site& s = site(slot);
    low = {std::min(low.x, s.x), std::min(low.y, s.y), 0};
    high = {std::max(high.x, s.x), std::max(high.y, s.y), 0};
  });
  grid_.rebuild(base_.visibleCount(), low, high);
  forEachVisible([&](Slot slot) { grid_.insert(slot, site(slot)); });
  grid_.fillGaps();
}

void DiagramCore::update(SiteId id, const Site& site) {
  ballast_.load();
  move(ids_.slotOf(id), site);
}

void DiagramCore::move(Slot slot, const Site& site) {
  const Site old = this->site(slot);
  if (old.x == site.x && old.y == site.y && old.r == site.r) return;
  if (moveInPlace(slot, site)) return;
  displace(slot);
  try {
    ids_.setState(slot, place(slot, site, kNoVertex));
  } catch (...) {
    ballast_.drop();
    restore(slot, old);
    throw;
  }
}

void DiagramCore::restore(Slot slot, const Site& site) noexcept {
  if (isBroken()) return;
  try {
    ids_.setState(slot, place(slot, site, kNoVertex));
  } catch (...) {
    invariant(isBroken(), "there is room to undo");
  }
}

bool DiagramCore::moveInPlace(Slot slot, const Site& site) {
  const Site to = normalized(site);
  if (!coversChildren(slot, to)) return false;
  if (ids_.state(slot) == SiteState::kHidden) {
    const Slot parent = hidden_.parentIfNear(slot);
    if (parent == HiddenForest::kNone || !covers(this->site(parent), to)) return false;
    base_.setSite(vertexOf(slot), to);
    return true;
  }
  if (!base_.graph().hasVertex(vertexOf(slot))) return false;  // the only visible one
  const SiteMoves::Move move{vertexOf(slot), to};
  if (siteMoves_.apply(base_, {&move, 1})[0] == 0) return false;
  followMove(slot, siteMoves_.siteBefore(0));
  return true;
}

bool DiagramCore::coversChildren(Slot slot, const Site& to) const {
  for (Slot child = hidden_.firstChild(slot); child != HiddenForest::kNone; child = hidden_.nextSibling(child)) {
    if (!covers(to, site(child))) return false;
  }
  return true;
}

/// What location needs to know of a site that moved and is visible as before.
void DiagramCore::followMove(Slot slot, const Site& from) noexcept {
  if (!isHierarchyDue_) hierarchy_.move(slot, site(slot), remover_);
  grid_.move(slot, from, site(slot));
  if (grid_.isOutgrown()) rebuildGrid();
}

void DiagramCore::moveManyInPlace(std::span<const SiteId> ids, std::span<const double> xyr, std::span<const std::uint32_t> order) {
  moves_.clear();
  moves_.reserve(ids.size());
  for (const std::size_t k : order) {
    const Slot slot = ids_.slotOf(ids[k]);
    const Site to = normalized({xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]});
    const Site& from = site(slot);
    const bool isAtRest = from.x == to.x && from.y == to.y && from.r == to.r;
    if (!base_.graph().hasVertex(vertexOf(slot)) || isAtRest || !coversChildren(slot, to)) continue;
    moves_.push_back({vertexOf(slot), to});
  }
  const std::span<const std::uint8_t> isMade = siteMoves_.apply(base_, moves_);
  for (std::size_t k = 0; k < moves_.size(); ++k) {
    if (isMade[k] != 0) followMove(slotOf(moves_[k].vertex), siteMoves_.siteBefore(k));
  }
}

FlatArray<std::uint32_t> DiagramCore::stage(std::span<const double> xyr) {
  FlatArray<std::uint32_t> order = hilbertOrder({xyr, 3});
  base_.reserveSites(slotsWith(order.size()) + 1);
  // What is close in the plane is close in memory. Nobody looks at sites of slots that are not in use.
  Slot slot = ids_.nextSlot();
  for (const std::uint32_t k : order) {
    const double* circle = &xyr[3 * std::size_t{k}];
    base_.setSite(vertexOf(slot), {circle[0], circle[1], circle[2]});
    slot = ids_.nextSlotAfter(slot);
  }
  return order;
}

void DiagramCore::insertStaged(FlatArray<std::uint32_t> order, std::span<SiteId> ids) {
  const std::size_t n = ids.size();
  ballast_.load();
  const std::size_t slots = slotsWith(n);
  const bool isBulk = n > (ids_.size() + n) / 4;
  reserve(slots);
  if (isBulk && usesHierarchy_) hierarchy_.reserveBulk(slots);
  // Ids are given in the order of the input, slots along the curve.
  for (SiteId& id : ids) id = ids_.takeId();
  Slot largest = kNoSlot;
  for (std::uint32_t& k : order) {
    k = ids_.takeSlot(ids[k], SiteState::kPending);
    if (largest == kNoSlot || precedes(site(largest), site(k))) largest = k;
  }
  // Walks start beside, so the grid need not be kept while it changes a lot.
  isBulk_ = isBulk;
  std::size_t done = 0;
  try {
    order = inRandomizedRounds(order);
    // The largest first: where sites are in line, it is in all the faces at infinity, and later each new largest one would take them over.
    std::iter_swap(order.begin(), std::find(order.begin(), order.end(), largest));
    if (isBulk) base_.reserveBulk(n);  // a few would be paid for by copying all
    for (; done < n; ++done) {
      const Slot slot = order[done];
      const Site circle = site(slot);
      ids_.setState(slot, place(slot, circle, visibleBeside(slot)));
    }
    order = FlatArray<std::uint32_t>();  // the grid fits where it was
    endBulk();
  } catch (...) {
    endBulk();
    ballast_.drop();
    if (isBroken()) throw;
    for (std::size_t k = 0; k < done; ++k) displace(order[k]);
    for (std::size_t k = n; k-- > 0;) ids_.release(ids_.slotOf(ids[k]));  // so that the next ids are given in the same order again
    throw;
  }
}

void DiagramCore::endBulk() noexcept {
  if (isBulk_ && walk_ == Walk::kSectors && base_.visibleCount() > 0) rebuildGrid();
  isBulk_ = false;
}

VertexId DiagramCore::visibleBeside(Slot slot) const {
  constexpr Slot kReach = 4;
  for (Slot distance = 1; distance <= kReach; ++distance) {
    if (slot >= distance && base_.isVisible(vertexOf(slot - distance))) return vertexOf(slot - distance);
    if (base_.isVisible(vertexOf(slot + distance))) return vertexOf(slot + distance);
  }
  return base_.anyVisible();
}

void DiagramCore::updateMany(std::span<const SiteId> ids, std::span<const double> xyr) {
  ballast_.load();
  const FlatArray<std::uint32_t> order = orderOfSlots(ids);
  FlatArray<Site> before(ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k) before[k] = site(ids_.slotOf(ids[k]));
  try {
    moveManyInPlace(ids, xyr, order);
    for (const std::size_t k : order) move(ids_.slotOf(ids[k]), {xyr[3 * k], xyr[3 * k + 1], xyr[3 * k + 2]});
  } catch (...) {
    ballast_.drop();
    if (isBroken()) throw;
    for (const std::size_t k : order) {
      const Slot slot = ids_.slotOf(ids[k]);
      displace(slot);
      restore(slot, before[k]);
    }
    throw;
  }
}

/// Positions in `ids` in the order of the slots, which is one of places; of an id that is given several times, the last one only.
FlatArray<std::uint32_t> DiagramCore::orderOfSlots(std::span<const SiteId> ids) const {
  FlatArray<Keyed> entries(ids.size());
  for (std::uint32_t k = 0; k < ids.size(); ++k) entries[k] = {ids_.slotOf(ids[k]), k};
  sortByKey(entries);
  FlatArray<std::uint32_t> order;
  order.reserve(ids.size());
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k + 1 == entries.size() || entries[k + 1].key != entries[k].key) order.push_back(entries[k].value);
  }
  return order;
}

void DiagramCore::clear() noexcept {
  base_.clear();
  hidden_.clear();
  hierarchy_.clear();
  isHierarchyDue_ = false;
  grid_.clear();
  ids_.clear();
}

}  // namespace apollonius
