// Lists of sites near points, made in the order in which the points are visited.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "apollonius/types.h"

namespace apollonius::internal {

/// The first `most` sites of a search. Replaces the contents of `sites`. Throws std::bad_alloc.
template <class Search>
void listNearby(Search&& search, std::size_t most, std::vector<SiteId>& sites) {
  sites.clear();
  while (sites.size() < most) {
    const SiteId id = search.nextId();
    if (id == kNoSite) return;
    sites.push_back(id);
  }
}

class NearbyListsBuilder {
 public:
  /// Replaces the contents of `lists`. Throws std::bad_alloc, as all calls do.
  NearbyListsBuilder(std::size_t points, bool withDistances, NearbyLists& lists);

  /// Lists the first `most` sites of a search from a point. Each point comes once.
  template <class Search>
  void list(std::size_t point, Search& search, std::size_t most) {
    begins_[point] = static_cast<std::uint32_t>(ids_.size());
    for (; most > 0; --most) {
      const SiteId id = search.nextId();
      if (id == kNoSite) break;
      ids_.push_back(id);
      if (withDistances_) distances_.push_back(search.distance());
      ++lists_.starts[point + 1];
    }
  }

  /// Puts the lists into the order of the points. Must be the last call.
  void finish();

 private:
  NearbyLists& lists_;  // its `starts` are counts up to finish()
  bool withDistances_;
  std::vector<std::uint32_t> begins_;  // by point: where its list begins in ids_
  std::vector<SiteId> ids_;
  std::vector<double> distances_;
};

}  // namespace apollonius::internal
