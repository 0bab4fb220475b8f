// One sort for everything that is sorted by a small integer: positions along a curve, slots, ids. A
// template for each would be some kilobytes of code each, which every visitor of a page downloads.
#pragma once

#include <cstdint>
#include <span>

#include "memory/flat_array.h"

namespace apollonius::internal {

/// A key, and what it is the key of.
struct Keyed {
  std::uint32_t key;
  std::uint32_t value;
};

/// Sorts by key, stably. Returns where the entries are then: in one of the two arrays of equal
/// size. Cost: O(n).
[[nodiscard]] std::span<Keyed> sortByKey(std::span<Keyed> entries, std::span<Keyed> other);

/// The same in place, with a second array of its own.
void sortByKey(FlatArray<Keyed>& entries);

}  // namespace apollonius::internal
