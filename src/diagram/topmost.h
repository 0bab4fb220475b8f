// The circle under a pointer, on the plane and on the sphere.
#pragma once

#include "apollonius/types.h"

namespace apollonius::internal {

/// Of the sites that contain a point, the one on top; else the nearest one, or kNoSite. `next()`
/// gives the sites around the point, nearest first, then kNoSite; `isIn(id)` tells whether the one
/// given last contains the point, and `weightOf(id)` its weight.
template <class Next, class IsIn, class WeightOf>
[[nodiscard]] SiteId topmost(Top top, Next&& next, IsIn&& isIn, WeightOf&& weightOf) {
  SiteId best = next();
  if (best == kNoSite || !isIn(best)) return best;
  for (SiteId id = next(); id != kNoSite && isIn(id); id = next()) {
    const double r = weightOf(id), smallest = weightOf(best);
    if (top == Top::kSmallest && r != smallest ? r < smallest : id > best) best = id;
  }
  return best;
}

}  // namespace apollonius::internal
