// The convex hull of the circles: arcs of the sites that have an edge to infinity, and common
// tangents between them.
#pragma once

#include "apollonius/path.h"
#include "diagram/diagram_core.h"
#include "geometry/curve/tolerance.h"
#include "predicate/point.h"

namespace apollonius::internal {

/// The hull as one closed figure. A radius below 0 shrinks the hull of the centres' other circles:
/// meaningful up to a common offset.
void drawHull(const DiagramCore& core, Tolerance tolerance, Path& path);

/// The directions in which the cell of a site of the hull is unbounded, counter-clockwise between
/// two unit vectors. Less than half a turn if `sign` is positive, more if it is negative, as a
/// large site has between two that hardly stick out of it; if it is zero, none at all or half a
/// turn. The sign is exact, since "none" and "all" cannot be told apart by two rounded vectors.
struct HullTurn {
  Point from, to;
  Sign sign;
};
/// REQUIRES: h's target is infinity.
[[nodiscard]] HullTurn hullTurnOf(const DelaunayGraph& delaunay, HalfedgeId h);

/// The circle of a site as a closed figure; nothing for a radius of 0 or less.
void drawCircle(const Site& site, Tolerance tolerance, Path& path);

}  // namespace apollonius::internal
