// The circle under a pointer, on the plane and on the sphere.
#pragma once

#include "apollonius/types.h"

namespace apollonius::internal {

/// Finds the site on top of those that contain a point; else the nearest one, or kNoSite. `next()`
/// gives the sites around the point, nearest first, then kNoSite. `isIn(id)` tells whether the one
/// given last contains the point, and `weightOf(id)` its weight.
template <class Next, class IsIn, class WeightOf>
[[nodiscard]] SiteId topmost(Top top, Next&& next, IsIn&& isIn, WeightOf&& weightOf) {
  SiteId best = next();
  if (best == kNoSite || !isIn(best)) return best;
  for (SiteId id = next(); id != kNoSite && isIn(id); id = next()) {
    if (top == Top::kLast ? id > best : weightOf(id) < weightOf(best)) best = id;
  }
  return best;
}

}  // namespace apollonius::internal
