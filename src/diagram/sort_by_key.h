// One sort for everything that is sorted by a small integer: positions along a curve, slots, ids. A template for each would be
// some kilobytes of code each, which every visitor of a page downloads.
#pragma once

#include <cstdint>
#include <vector>

namespace apollonius {

/// A key, and what it is the key of.
struct Keyed {
  std::uint32_t key;
  std::uint32_t value;
};

/// Sorts by key, stably. Cost: O(n), with a second array of the same size if there are more than a few.
void sortByKey(std::vector<Keyed>& entries);

}  // namespace apollonius
