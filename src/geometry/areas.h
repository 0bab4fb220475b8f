// The areas of all clipped cells at once: each edge is clipped once and counts for the cells on
// both sides.
#pragma once

#include <vector>

#include "diagram/diagram_core.h"
#include "geometry/window.h"

namespace apollonius::internal {

/// By site id; 0 for ids without a cell.
void cellAreas(const DiagramCore& core, const Window& window, std::vector<double>& areas);

}  // namespace apollonius::internal
