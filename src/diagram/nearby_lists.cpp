#include "diagram/nearby_lists.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>

namespace apollonius::internal {

NearbyListsBuilder::NearbyListsBuilder(std::size_t points, bool withDistances, NearbyLists& lists)
    : lists_(lists), withDistances_(withDistances), begins_(points) {
  lists.starts.assign(points + 1, 0);
}

void NearbyListsBuilder::finish() {
  if (ids_.size() > std::numeric_limits<std::uint32_t>::max()) throw std::bad_alloc();
  lists_.ids.resize(ids_.size());
  lists_.distances.resize(distances_.size());
  std::uint32_t at = 0;
  for (std::size_t k = 0; k < begins_.size(); ++k) {
    const std::uint32_t begin = begins_[k], count = lists_.starts[k + 1];
    std::copy_n(ids_.data() + begin, count, lists_.ids.data() + at);
    if (withDistances_) std::copy_n(distances_.data() + begin, count, lists_.distances.data() + at);
    lists_.starts[k + 1] = at += count;
  }
}

}  // namespace apollonius::internal
