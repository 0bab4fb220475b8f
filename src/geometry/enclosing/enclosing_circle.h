// The smallest circle around all circles. It asks the sites on the hull only: the others do not
// reach as far in any direction.
#pragma once

#include <vector>

#include "apollonius/types.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

/// The smallest circle around all circles, and the visible sites that touch it from inside,
/// ascending by id; without sites none, and `circle` stays as it is. Which sites these are is
/// decided exactly; the circle is rounded once, with the same bits after any history. Throws
/// std::bad_alloc. Cost: O(h) for each of a few circles on the way, each larger than the one
/// before.
void findEnclosingCircle(const DiagramCore& diagram, Site& circle, std::vector<SiteId>& touching);

}  // namespace apollonius::internal
