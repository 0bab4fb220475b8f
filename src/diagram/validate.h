// The invariants of the whole diagram: graph, hierarchy, ids, hidden sites.
#pragma once

#include "apollonius/types.h"
#include "diagram/diagram_core.h"

namespace apollonius::internal {

/// The first broken invariant, exactly checked. Throws std::bad_alloc. Cost: O(n), slow: for tests.
[[nodiscard]] Violation validate(const DiagramCore& diagram);

}  // namespace apollonius::internal
