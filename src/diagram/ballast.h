// Memory held back for undoing: an operation of several steps loads the ballast first; should a later step run out of memory,
// dropping it makes room to take the earlier steps back.
#pragma once

#include <cstddef>
#include <memory>

namespace apollonius {

class Ballast {
 public:
  /// Throws std::bad_alloc.
  void load() {
    if (!memory_) memory_ = std::make_unique_for_overwrite<std::byte[]>(kBytes);
  }
  void drop() noexcept { memory_.reset(); }

 private:
  static constexpr std::size_t kBytes = 64 * 1024;
  std::unique_ptr<std::byte[]> memory_;
};

}  // namespace apollonius
