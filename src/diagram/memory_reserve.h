// Memory held back for undoing: an operation of several steps takes it first; should a later step
// run out of memory, giving it back makes room for the small things that undoing the earlier steps
// may need. Room for the large ones, which grow with a site's neighbours, is made step by step
// (DiagramCore::Undo).
#pragma once

#include <cstddef>
#include <memory>

namespace apollonius::internal {

class MemoryReserve {
 public:
  /// Throws std::bad_alloc.
  void take() {
    if (!memory_) memory_ = std::make_unique_for_overwrite<std::byte[]>(kBytes);
  }
  void giveBack() noexcept { memory_.reset(); }

 private:
  static constexpr std::size_t kBytes = std::size_t{64} * 1024;
  std::unique_ptr<std::byte[]> memory_;
};

}  // namespace apollonius::internal
