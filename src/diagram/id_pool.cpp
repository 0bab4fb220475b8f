#include "diagram/id_pool.h"

#include "base/byte_stream.h"

namespace apollonius::internal {

bool IdPool::restore(WordReader& in, std::size_t slots, std::size_t idLimit, std::size_t size) {
  ids_.assign(idLimit, kNoSlot);
  slots_.assign(slots, kNotListed);
  freeSlots_ = slots;
  for (Slot slot = 0; slot < slots; ++slot) {
    const SiteId id = in.word();
    if (id == kNoSite) continue;
    if (id >= idLimit || ids_[id] != kNoSlot) return false;
    ids_[id] = slot;
    slots_[slot] = word(SiteState::kPending, id);
    --freeSlots_;
  }
  if (this->size() != size) return false;
  std::uint32_t* last = &firstFreeSlot_;
  for (std::size_t k = 0; k < freeSlots_; ++k) {
    const Slot slot = in.word();
    if (slot >= slots || slots_[slot] != kNotListed) return false;
    *last = slot;
    last = &slots_[slot];
    *last = kEnd;
  }
  std::uint32_t freeId = 0;  // marks ids in the list
  last = &firstFreeId_;
  for (std::size_t k = size; k < idLimit; ++k) {
    const SiteId id = in.word();
    if (id >= idLimit || ids_[id] != kNoSlot) return false;
    *last = freeId | id;
    freeId = kFreeId;
    last = &ids_[id];
    *last = kFreeId | kEnd;
  }
  return true;
}

}  // namespace apollonius::internal
