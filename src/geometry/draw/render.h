// Drawings of a whole diagram, in portions: each call continues at `cursor` (0 at first), adds to
// the path until it has about as many commands as asked for, and says when everything has been
// drawn.
#pragma once

#include <cstddef>

#include "apollonius/path.h"
#include "diagram/diagram_core.h"
#include "geometry/curve/tolerance.h"
#include "geometry/window/polygon_clip.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// Draws each Voronoi edge inside the window once.
void drawEdges(const DiagramCore& core, const Rectangle& window, Tolerance tolerance,
               Portion& portion, Path& path);

/// Draws the part of each Voronoi edge that is inside a region.
void drawEdges(const ClippedDiagram& clippedDiagram, Tolerance tolerance, Portion& portion,
               Path& path);

/// Draws the dual graph; with a window also the rays to infinity, cut where they leave it (none
/// from sites outside).
void drawDual(const DiagramCore& core, const Rectangle* window, Tolerance tolerance,
              Portion& portion, Path& path);

/// Draws the circles of all sites, hidden ones too.
void drawSites(const DiagramCore& core, Tolerance tolerance, Portion& portion, Path& path);

}  // namespace apollonius::internal
