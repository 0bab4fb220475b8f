// One sort for everything that is sorted by a small integer: positions along a curve, slots, ids. A
// template for each would be some kilobytes of code each, which every visitor of a page downloads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/flat_array.h"

namespace apollonius::internal {

/// A key-value pair.
struct Keyed {
  std::uint32_t key;
  std::uint32_t value;
};

/// A stable sort by key, in steps: a radix sort between two arrays of equal size. Cost: O(n).
class KeySort {
 public:
  KeySort(std::span<Keyed> entries, std::span<Keyed> other) : entries_(entries), other_(other) {}

  /// Goes on by at most this many entries, of which each is visited some times; are they sorted?
  bool advance(std::size_t most);
  /// The entries, which are in one of the two arrays. REQUIRES: sorted.
  [[nodiscard]] std::span<Keyed> sorted() const { return entries_; }

 private:
  static constexpr unsigned kDigitBits = 8, kDigits = 32 / kDigitBits;
  static constexpr unsigned kSorted = kDigits, kCounting = kDigits + 1;

  [[nodiscard]] static unsigned digitOf(std::uint32_t key, unsigned digit) {
    return key >> (digit * kDigitBits) & ((1u << kDigitBits) - 1);
  }
  /// Passes that would move nothing are left out. REQUIRES: some entries.
  void beginPass(unsigned digit);

  std::span<Keyed> entries_, other_;
  std::size_t at_ = 0;          // the entry that is next in this pass
  unsigned digit_ = kCounting;  // this pass's digit; the least significant comes first
  std::array<std::array<std::uint32_t, 1u << kDigitBits>, kDigits> starts_{};
};

/// Sorts in place, with a second array of its own.
void sortByKey(FlatArray<Keyed>& entries);

}  // namespace apollonius::internal
