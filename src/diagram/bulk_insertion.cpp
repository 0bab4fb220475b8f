#include "diagram/bulk_insertion.h"

#include <algorithm>

namespace apollonius::internal {

Undo DiagramCore::beginBulk(std::span<SiteId> ids) {
  transaction_.begin();
  const std::size_t slots = slotsWith(ids.size());
  const bool isBulk = ids.size() > (ids_.size() + ids.size()) / 4;
  reserve(slots);
  if (isBulk) index_.reserveBulk(slots);
  // From here on nothing throws. A diagram that is empty is emptied again, not undone by steps.
  const Undo undo = ids_.size() > 0 ? Undo::kMaybe : Undo::kNever;
  for (SiteId& id : ids) id = ids_.takeId(id);
  if (isBulk) index_.beginBulk();
  return undo;
}

void DiagramCore::rollbackBulk(std::span<const SiteId> ids,
                               std::span<const Slot> attached) noexcept {
  if (isBroken()) return index_.clear();
  transaction_.undo(index_, [&] {
    if (ids.size() == ids_.size()) {
      delaunay_.clear();
      hidden_.clear();
      index_.clear();
    } else {
      for (std::size_t k = attached.size(); k-- > 0;) rollbackInsertion(attached[k]);
    }
    index_.endBulk(delaunay_);
  });
  // So that the next ids are given in the same order again.
  for (std::size_t k = ids.size(); k-- > 0;) ids_.release(ids_.slotOf(ids[k]));
}

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
    diagram_.reserveStaged(order_.size());
    slot_ = diagram_.ids().nextSlot();
    firstNew_ = static_cast<Slot>(diagram_.ids().slots());
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
    diagram_.stage(slot_, {circle[0], circle[1], circle[2]});
    slot_ = diagram_.ids().nextSlotAfter(slot_);
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
      undo_ = diagram_.beginBulk(ids);
      ids_ = ids;
      done_ = 0;
      step_ = Step::kName;
      return false;
    case Step::kName:
      name(most);
      if (done_ == order_.size()) step_ = Step::kOrder;
      return false;
    case Step::kOrder:
      order_ = brioOrder(order_);
      diagram_.reserveAttached(order_.size());
      done_ = 0;
      step_ = Step::kAttach;
      return false;
    case Step::kAttach:
      attach(most);
      if (done_ < order_.size()) return false;
      order_ = FlatArray<std::uint32_t>();  // the grid fits where it was
      diagram_.endBulk();
      ids_ = {};
      return true;
  }
  return true;
}

/// The ids are in the order of the input, slots are given along the curve.
void BulkInsertion::name(std::size_t most) {
  const std::size_t end = done_ + std::min(most, order_.size() - done_);
  for (; done_ < end; ++done_) {
    std::uint32_t& k = order_[done_];
    k = diagram_.takeSlot(ids_[k]);
  }
}

void BulkInsertion::attach(std::size_t most) {
  const std::size_t end = done_ + std::min(most, order_.size() - done_);
  for (; done_ < end; ++done_) {
    const Slot slot = order_[done_];
    diagram_.attachStaged(slot, startFor(slot), undo_);
  }
}

double BulkInsertion::progress() const {
  if (order_.empty()) return done_ > 0 ? 1 : 0;
  if (step_ != Step::kAttach) return ids_.empty() ? 0.04 : 0.08;
  return 0.1 + 0.9 * static_cast<double>(done_) / static_cast<double>(order_.size());
}

void BulkInsertion::undo() noexcept {
  if (ids_.empty()) return;
  if (step_ == Step::kName) name(kAllAtOnce);
  diagram_.rollbackBulk(ids_, {order_.data(), step_ == Step::kAttach ? done_ : 0});
  ids_ = {};
}

VertexId BulkInsertion::startFor(Slot slot) const {
  // Few sites among many are far from each other.
  if (!diagram_.locationIndex().isBulk()) return kNoVertex;
  const DelaunayGraph& delaunay = diagram_.delaunay();
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
