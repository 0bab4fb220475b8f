#include "diagram/nearby_search.h"

namespace apollonius::internal {

bool SlotSet::write(Slot slot) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t at = (slot * 0x9E3779B1u) >> 7 & mask;
  for (; slots_[at] != kNoSlot; at = (at + 1) & mask) {
    if (slots_[at] == slot) {
      --size_;
      return false;
    }
  }
  slots_[at] = slot;
  return true;
}

void SlotSet::grow() {
  FlatArray<Slot> old(2 * slots_.size(), kNoSlot);
  old.swap(slots_);
  for (const Slot slot : old) {
    if (slot != kNoSlot) static_cast<void>(write(slot));
  }
}

}  // namespace apollonius::internal
