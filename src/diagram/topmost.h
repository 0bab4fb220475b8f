// The circle under a pointer, on the plane and on the sphere.
#pragma once

#include "apollonius/types.h"

namespace apollonius::internal {

/// The site on top of those that contain the point of a search that begins; else the nearest one,
/// or kNoSite if the search finds none. Throws std::bad_alloc. Cost: one location and O(m log m), m
/// = the neighbours of the sites that contain the point.
template <class Search>
[[nodiscard]] SiteId topmost(Search&& search, Top top) {
  SiteId best = search.nextId();
  if (best == kNoSite || !search.isInside()) return best;
  double weight = search.weight();
  for (SiteId id = search.nextId(); id != kNoSite && search.isInside(); id = search.nextId()) {
    if (!(top == Top::kLast ? id > best : search.weight() < weight)) continue;
    best = id;
    weight = search.weight();
  }
  return best;
}

}  // namespace apollonius::internal
