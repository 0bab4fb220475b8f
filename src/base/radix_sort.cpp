#include "base/radix_sort.h"

#include <algorithm>
#include <utility>

#include "base/flat_array.h"

namespace apollonius::internal {

namespace {

constexpr std::size_t kFewEntries =
    32;  // up to here, insertion sort is cheaper than summing up the counters of a radix sort

void insertionSort(std::span<Keyed> entries) {
  for (std::size_t k = 1; k < entries.size(); ++k) {
    const Keyed entry = entries[k];
    std::size_t hole = k;
    for (; hole > 0 && entries[hole - 1].key > entry.key; --hole) entries[hole] = entries[hole - 1];
    entries[hole] = entry;
  }
}

}  // namespace

void KeySort::beginPass(unsigned digit) {
  at_ = 0;
  digit_ = digit;
  for (; digit_ < kDigits; ++digit_) {
    auto& starts = starts_[digit_];
    if (starts[digitOf(entries_[0].key, digit_)] == entries_.size()) continue;
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts) sum += std::exchange(start, sum);
    return;
  }
}

bool KeySort::advance(std::size_t most) {
  if (entries_.size() <= kFewEntries) {
    insertionSort(entries_);
    digit_ = kSorted;
  }
  if (digit_ == kSorted) return true;
  const std::span<const Keyed> portion =
      entries_.subspan(at_, std::min(most, entries_.size() - at_));
  at_ += portion.size();
  const bool isCounting = digit_ == kCounting;
  if (isCounting) {
    for (const Keyed& entry : portion) {
      for (unsigned d = 0; d < kDigits; ++d) ++starts_[d][digitOf(entry.key, d)];
    }
  } else {
    auto& starts = starts_[digit_];
    for (const Keyed& entry : portion) other_[starts[digitOf(entry.key, digit_)]++] = entry;
  }
  if (at_ < entries_.size()) return false;
  if (!isCounting) std::swap(entries_, other_);
  beginPass(isCounting ? 0 : digit_ + 1);
  return digit_ == kSorted;
}

void sortByKey(FlatArray<Keyed>& entries) {
  if (entries.size() <= kFewEntries) return insertionSort(entries);
  FlatArray<Keyed> other(entries.size());
  KeySort sort(entries, other);
  while (!sort.advance(entries.size())) {
  }
  if (sort.sorted().data() == other.data()) entries.swap(other);
}

}  // namespace apollonius::internal
