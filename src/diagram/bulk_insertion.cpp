#include "diagram/bulk_insertion.h"

#include <algorithm>

namespace apollonius::internal {

bool BulkInsertion::stage(std::span<const double> xyr, std::size_t most) {
  if (!sort_ && order_.empty()) sort_.emplace(PointArray{xyr, 3});
  if (sort_) {
    bool isSorted = false;
    do {
      isSorted = sort_->advance(most);
    } while (!isSorted && most == kAllAtOnce);
    if (!isSorted) return false;
    order_ = sort_->order();
    sort_.reset();
    diagram_.delaunay_.reserveSites(diagram_.slotsWith(order_.size()) + 1);
    slot_ = diagram_.ids_.nextSlot();
    firstNew_ = static_cast<Slot>(diagram_.ids_.slots());
    if (most != kAllAtOnce) return false;
  }
  copyStaged(xyr, most);
  return done_ == order_.size();
}

/// Nobody looks at sites of slots that are not in use.
void BulkInsertion::copyStaged(std::span<const double> xyr, std::size_t most) {
  const std::size_t end = done_ + std::min(most, order_.size() - done_);
  for (; done_ < end; ++done_) {
    const double* circle = &xyr[3 * std::size_t{order_[done_]}];
    diagram_.delaunay_.setSite(vertexOf(slot_), {circle[0], circle[1], circle[2]});
    slot_ = diagram_.ids_.nextSlotAfter(slot_);
  }
}

bool BulkInsertion::insert(std::span<SiteId> ids, std::size_t most) {
  try {
    bool isDone = false;
    do {
      isDone = goOn(ids, most);
    } while (!isDone && most == kAllAtOnce);
    return isDone;
  } catch (const std::bad_alloc&) {
    undo();
    throw;
  }
}

bool BulkInsertion::goOn(std::span<SiteId> ids, std::size_t most) {
  switch (step_) {
    case Step::kMakeRoom:
      makeRoom(ids);
      step_ = Step::kName;
      return false;
    case Step::kName:
      name(most);
      if (done_ == order_.size()) step_ = Step::kOrder;
      return false;
    case Step::kOrder:
      order_ = brioOrder(order_);
      // A few would be paid for by copying all.
      if (diagram_.index_.isBulk()) diagram_.delaunay_.reserveBulk(order_.size());
      done_ = 0;
      step_ = Step::kPlace;
      return false;
    case Step::kPlace:
      place(most);
      if (done_ < order_.size()) return false;
      order_ = FlatArray<std::uint32_t>();  // the grid fits where it was
      diagram_.index_.endBulk(diagram_.delaunay_);
      ids_ = {};
      return true;
  }
  return true;
}

void BulkInsertion::makeRoom(std::span<SiteId> ids) {
  DiagramCore& d = diagram_;
  const std::size_t n = order_.size();
  d.transaction_.begin();
  const std::size_t slots = d.slotsWith(n);
  const bool isBulk = n > (d.ids_.size() + n) / 4;
  d.reserve(slots);
  if (isBulk) d.index_.reserveBulk(slots);
  // From here on there is something to undo. A diagram that was empty is simply emptied.
  undo_ = d.ids_.size() > 0 ? DiagramCore::Undo::kMaybe : DiagramCore::Undo::kNever;
  ids_ = ids;
  for (SiteId& id : ids) id = d.ids_.takeId();
  done_ = 0;
  if (isBulk) d.index_.beginBulk();
}

/// The ids are in the order of the input, slots are given along the curve.
void BulkInsertion::name(std::size_t most) {
  const std::size_t end = done_ + std::min(most, order_.size() - done_);
  for (; done_ < end; ++done_) {
    std::uint32_t& k = order_[done_];
    k = diagram_.ids_.takeSlot(ids_[k], SiteState::kPending);
  }
}

void BulkInsertion::place(std::size_t most) {
  DiagramCore& d = diagram_;
  const std::size_t end = done_ + std::min(most, order_.size() - done_);
  for (; done_ < end; ++done_) {
    const Slot slot = order_[done_];
    const Site circle = d.site(slot);
    d.ids_.setState(slot, d.attachSite(slot, circle, startFor(slot), undo_));
  }
}

double BulkInsertion::progress() const {
  if (order_.empty()) return done_ > 0 ? 1 : 0;
  if (step_ != Step::kPlace) return ids_.empty() ? 0.04 : 0.08;
  return 0.1 + 0.9 * static_cast<double>(done_) / static_cast<double>(order_.size());
}

void BulkInsertion::undo() noexcept {
  if (ids_.empty()) return;
  DiagramCore& d = diagram_;
  if (step_ == Step::kName) name(kAllAtOnce);
  if (step_ != Step::kPlace) done_ = 0;
  if (d.isBroken()) return d.index_.clear();
  d.transaction_.undo(d.index_, [&] {
    if (ids_.size() == d.ids_.size()) {
      d.delaunay_.clear();
      d.hidden_.clear();
      d.index_.clear();
    } else {
      while (done_ > 0) d.rollbackInsertion(order_[--done_]);
    }
    d.index_.endBulk(d.delaunay_);
  });
  // So that the next ids are given in the same order again.
  for (std::size_t k = ids_.size(); k-- > 0;) d.ids_.release(d.ids_.slotOf(ids_[k]));
  ids_ = {};
}

VertexId BulkInsertion::startFor(Slot slot) const {
  // Few sites among many are far from each other.
  if (!diagram_.index_.isBulk()) return kNoVertex;
  const DelaunayGraph& delaunay = diagram_.delaunay_;
  constexpr Slot kReach = 4;
  if (slot >= firstNew_) {
    for (Slot distance = 1; distance <= kReach; ++distance) {
      if (slot >= firstNew_ + distance && delaunay.isVisible(vertexOf(slot - distance)))
        return vertexOf(slot - distance);
      if (delaunay.isVisible(vertexOf(slot + distance))) return vertexOf(slot + distance);
    }
  }
  return delaunay.anyVisible();  // the one before in this round
}

}  // namespace apollonius::internal
