#include "delaunay/sort_by_key.h"

#include <array>
#include <cstddef>
#include <utility>

#include "memory/flat_array.h"

namespace apollonius::internal {

namespace {

constexpr std::size_t kFew =
    32;  // of which inserting is cheaper than summing up the counters of a radix sort
constexpr unsigned kDigitBits = 8, kDigits = 32 / kDigitBits;

void insertionSort(std::span<Keyed> entries) {
  for (std::size_t k = 1; k < entries.size(); ++k) {
    const Keyed entry = entries[k];
    std::size_t hole = k;
    for (; hole > 0 && entries[hole - 1].key > entry.key; --hole) entries[hole] = entries[hole - 1];
    entries[hole] = entry;
  }
}

unsigned digitOf(std::uint32_t key, unsigned digit) {
  return key >> (digit * kDigitBits) & ((1u << kDigitBits) - 1);
}

}  // namespace

std::span<Keyed> sortByKey(std::span<Keyed> entries, std::span<Keyed> other) {
  if (entries.size() <= kFew) {
    insertionSort(entries);
    return entries;
  }
  std::array<std::array<std::uint32_t, 1u << kDigitBits>, kDigits> starts{};
  for (const Keyed& entry : entries) {
    for (unsigned d = 0; d < kDigits; ++d) ++starts[d][digitOf(entry.key, d)];
  }
  for (unsigned d = 0; d < kDigits; ++d) {  // the least significant digit first
    if (starts[d][digitOf(entries[0].key, d)] == entries.size()) continue;  // the same in all
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts[d]) {
      const std::uint32_t count = start;
      start = sum;
      sum += count;
    }
    for (const Keyed& entry : entries) other[starts[d][digitOf(entry.key, d)]++] = entry;
    std::swap(entries, other);
  }
  return entries;
}

void sortByKey(FlatArray<Keyed>& entries) {
  if (entries.size() <= kFew) return insertionSort(entries);
  FlatArray<Keyed> other(entries.size());
  if (sortByKey(entries, other).data() == other.data()) entries.swap(other);
}

}  // namespace apollonius::internal
