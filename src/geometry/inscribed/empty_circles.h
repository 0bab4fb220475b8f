// Empty circles with their centres in a window: the points farthest from all sites.
#pragma once

#include <cstddef>

#include "apollonius/types.h"
#include "geometry/clipping/clipping.h"

namespace apollonius::internal {

/// Lists the `most` largest empty circles with their centres in a window, none with its centre in a
/// larger one: x, y, the distance to the nearest site, and that site. With `inside` they do not
/// cross the window's border either, and r is at least 0.999 of what is possible. Cells have no
/// reach here. Replaces the contents. False as WidestPlace::find(). Throws std::bad_alloc. Cost:
/// O(n (log n + most)); with `inside` also that of finding the largest circle in each cell at the
/// border that is examined.
[[nodiscard]] bool listEmptyCircles(const DiagramCore& core, const Clipping& window,
                                    std::size_t most, bool inside, VertexArrays& circles);

}  // namespace apollonius::internal
