// Measures of all clipped cells at once: each edge is clipped once, for both of its cells.
#pragma once

#include <vector>

#include "diagram/diagram_core.h"
#include "geometry/window/polygon_clip.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// kAreas and kPerimeters: one number for each site id, 0 for ids without a cell. kCentroids: two,
/// NaN where there is no area.
enum class Measure : unsigned char { kAreas, kCentroids, kPerimeters };

/// Replaces the contents of `measures`.
void measureCells(const DiagramCore& core, const Rectangle& window, Measure what,
                  std::vector<double>& measures);
void measureCells(const ClippedDiagram& clippedDiagram, Measure what,
                  std::vector<double>& measures);

class CellSums;
/// Adds the parts of the region's border that bound cells.
void addBorders(const ClippedDiagram& clippedDiagram, CellSums& sums);

}  // namespace apollonius::internal
