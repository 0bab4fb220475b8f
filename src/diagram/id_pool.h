// Ids and slots of sites. A site's public id is stable while it lives; its slot is its index in the
// arrays of the diagram. They are two numbers so that sites that are inserted in bulk can lie in
// memory as they lie in the plane, and still have the ids 0, 1, 2, … in the order of the input. One
// word per id, one per slot.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "apollonius/types.h"
#include "base/byte_stream.h"
#include "base/flat_array.h"
#include "number/invariant.h"
#include "topology/ids.h"

namespace apollonius::internal {

/// A site's index in the arrays; its vertex is the slot's number + 1.
using Slot = std::uint32_t;
inline constexpr Slot kNoSlot = 0xFFFFFFFFu;

constexpr VertexId vertexOf(Slot slot) { return VertexId{slot + 1}; }
constexpr Slot slotOf(VertexId v) { return static_cast<Slot>(v) - 1; }

/// kPending: in use, but the site is in no structure; only within operations of several steps.
enum class SiteState : std::uint8_t { kFree = 0, kVisible = 1, kHidden = 2, kPending = 3 };

/// Who chooses the id of a new site: the pool, or the caller, who then keeps the list of free ids.
enum class Naming : std::uint8_t { kOwn, kGiven };

class IdPool {
 public:
  explicit IdPool(Naming naming = Naming::kOwn) : naming_(naming) {}

  [[nodiscard]] std::size_t slots() const { return slots_.size(); }  ///< slots in use are below
  [[nodiscard]] std::size_t idLimit() const { return ids_.size(); }  ///< ids in use are below
  [[nodiscard]] std::size_t size() const { return slots_.size() - freeSlots_; }
  [[nodiscard]] std::size_t hiddenCount() const { return hiddenCount_; }
  [[nodiscard]] SiteState state(Slot slot) const {
    return slot < slots_.size() ? static_cast<SiteState>(slots_[slot] >> kShift) : SiteState::kFree;
  }
  /// Id of a slot in use; kNoSite beyond the last slot.
  [[nodiscard]] SiteId idOf(Slot slot) const {
    return slot < slots_.size() ? slots_[slot] & kMask : kNoSite;
  }
  /// Slot of an id; kNoSlot if the id is not in use.
  [[nodiscard]] Slot slotOf(SiteId id) const {
    return id < ids_.size() && (ids_[id] & kFreeId) == 0 ? ids_[id] : kNoSlot;
  }

  /// Makes room for one more site and returns the slot that it will get; it is not in use before
  /// take(). REQUIRES, if ids are given: reserveIds().
  [[nodiscard]] Slot next() {
    if (naming_ == Naming::kOwn && firstFreeId_ == kEnd) {
      ids_.push_back(kFreeId | kEnd);
      firstFreeId_ = static_cast<SiteId>(ids_.size() - 1);
    }
    if (firstFreeSlot_ == kEnd) {
      slots_.push_back(kEnd);
      firstFreeSlot_ = static_cast<Slot>(slots_.size() - 1);
      ++freeSlots_;
    }
    return firstFreeSlot_;
  }

  /// Takes the next slot and the next id, or the one that is given. REQUIRES: next().
  SiteId take(SiteState state, SiteId given = kNoSite) {
    const SiteId id = takeId(given);
    (void)takeSlot(id, state);
    return id;
  }

  /// The two halves of take(), for many sites whose slots are in another order than their ids.
  /// REQUIRES: reserve().
  [[nodiscard]] SiteId takeId(SiteId given = kNoSite) {
    if (naming_ == Naming::kGiven) {
      ids_[given] = kNoSlot;
      return given;
    }
    if (firstFreeId_ == kEnd) {
      ids_.push_back(kNoSlot);
      return static_cast<SiteId>(ids_.size() - 1);
    }
    const SiteId id = firstFreeId_;
    firstFreeId_ = ids_[id] & kMask;
    ids_[id] = kNoSlot;
    return id;
  }
  [[nodiscard]] Slot takeSlot(SiteId id, SiteState state) {
    Slot slot = firstFreeSlot_;
    if (slot == kEnd) {
      slot = static_cast<Slot>(slots_.size());
      slots_.push_back(0);
    } else {
      firstFreeSlot_ = slots_[slot] & kMask;
      --freeSlots_;
    }
    ids_[id] = slot;
    slots_[slot] = word(state, id);
    hiddenCount_ += state == SiteState::kHidden;
    return slot;
  }

  /// The slots that takeSlot() will give, in that order: the first, and the one after another.
  [[nodiscard]] Slot nextSlot() const {
    return firstFreeSlot_ == kEnd ? static_cast<Slot>(slots_.size()) : firstFreeSlot_;
  }
  [[nodiscard]] Slot nextSlotAfter(Slot slot) const {
    if (slot >= slots_.size()) return slot + 1;
    const Slot next = slots_[slot] & kMask;
    return next == kEnd ? static_cast<Slot>(slots_.size()) : next;
  }

  /// Changes the state of a slot in use.
  void setState(Slot slot, SiteState state) {
    invariant(slot < slots_.size(), "only a slot in use has a state");
    hiddenCount_ += state == SiteState::kHidden;
    hiddenCount_ -= this->state(slot) == SiteState::kHidden;
    slots_[slot] = word(state, idOf(slot));
  }

  /// Frees a slot in use, and its id.
  void release(Slot slot) {
    invariant(slot < slots_.size(), "only a slot in use is freed");
    hiddenCount_ -= state(slot) == SiteState::kHidden;
    const SiteId id = idOf(slot);
    ids_[id] = kFreeId | firstFreeId_;
    if (naming_ == Naming::kOwn) firstFreeId_ = id;
    slots_[slot] = word(SiteState::kFree, firstFreeSlot_);
    firstFreeSlot_ = slot;
    ++freeSlots_;
  }

  /// Gives the sites 0, 1, 2, … these ids, and takes over the free ids and the naming of `other`.
  /// REQUIRES: no free slots or ids; the names are all ids that `other` has in use. Throws
  /// std::bad_alloc with nothing changed.
  void rename(std::span<const SiteId> names, const IdPool& other) {
    ids_ = other.ids_;
    firstFreeId_ = other.firstFreeId_;
    naming_ = other.naming_;
    for (Slot slot = 0; slot < slots_.size(); ++slot) {
      const SiteId name = names[idOf(slot)];
      ids_[name] = slot;
      slots_[slot] = word(state(slot), name);
    }
  }

  /// Makes room for this many sites in all.
  void reserve(std::size_t sites) {
    for (auto* array : {&ids_, &slots_}) {
      if (array->capacity() < sites)
        array->reserve(std::max(sites, array->capacity() + array->capacity() / 2));
    }
  }

  /// Makes room for given ids below this limit.
  void reserveIds(std::size_t idLimit) {
    if (ids_.size() < idLimit) ids_.resize(idLimit, kFreeId | kEnd);
  }

  /// Writes a pool that chooses the ids to a snapshot: for each slot its id, or kNoSite; then the
  /// free slots and the free ids, in the order in which they will be used.
  void save(WordWriter& out) const {
    for (Slot slot = 0; slot < slots_.size(); ++slot)
      out.word(state(slot) == SiteState::kFree ? kNoSite : idOf(slot));
    for (Slot slot = firstFreeSlot_; slot != kEnd; slot = slots_[slot] & kMask) out.word(slot);
    for (SiteId id = firstFreeId_; id != kEnd; id = ids_[id] & kMask) out.word(id);
  }
  /// Reads what save() wrote, with all sites pending; false if that is no numbering. REQUIRES: size
  /// <= slots, size <= idLimit.
  [[nodiscard]] bool restore(WordReader& in, std::size_t slots, std::size_t idLimit,
                             std::size_t size);

  /// Forgets all sites but keeps the room.
  void clear() {
    ids_.clear();
    slots_.clear();
    firstFreeId_ = firstFreeSlot_ = kEnd;
    freeSlots_ = hiddenCount_ = 0;
  }

 private:
  // A slot's word has the state in the upper two bits; below, the id, or in a free slot the next
  // free one. An id's word is the slot, or with the top bit set the next free id.
  static constexpr unsigned kShift = 30;
  static constexpr std::uint32_t kMask = (std::uint32_t{1} << kShift) - 1;
  static constexpr std::uint32_t kEnd = kMask;
  static constexpr std::uint32_t kFreeId = 0x80000000u;
  static_assert(kMostSites < kEnd - 1);

  static constexpr std::uint32_t word(SiteState state, std::uint32_t value) {
    return static_cast<std::uint32_t>(state) << kShift | value;
  }

  static constexpr std::uint32_t kNotListed = kEnd - 1;  // a free slot, while a snapshot is read

  Naming naming_;
  FlatArray<std::uint32_t> ids_;    // by id
  FlatArray<std::uint32_t> slots_;  // by slot
  SiteId firstFreeId_ = kEnd;
  Slot firstFreeSlot_ = kEnd;
  std::size_t freeSlots_ = 0;
  std::size_t hiddenCount_ = 0;
};

}  // namespace apollonius::internal
