// Lists of sites near points, made in the order in which the points are visited.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "apollonius/types.h"

namespace apollonius::internal {

class NearbyListsBuilder {
 public:
  /// Replaces the contents of `lists`. Throws std::bad_alloc, as all calls do.
  NearbyListsBuilder(std::size_t points, bool withDistances, NearbyLists& lists);

  /// The next sites are near this point. Each point is begun once.
  void begin(std::size_t point);
  /// `distance()` is called if distances are wanted.
  template <class Distance>
  void add(SiteId id, Distance&& distance) {
    ids_.push_back(id);
    if (withDistances_) distances_.push_back(distance());
    ++lists_.starts[point_ + 1];
  }

  /// Puts the lists into the order of the points. The last call.
  void finish();

 private:
  NearbyLists& lists_;  // its `starts` are counts up to finish()
  bool withDistances_;
  std::size_t point_ = 0;
  std::vector<std::uint32_t> begins_;  // of each point's list, in ids_
  std::vector<SiteId> ids_;
  std::vector<double> distances_;
};

}  // namespace apollonius::internal
