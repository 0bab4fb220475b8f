// The convex hull of the circles: arcs of the sites that have an edge to infinity, and common tangents between them.
#pragma once


#include "diagram/diagram_core.h"
#include "geometry/path.h"
#include "geometry/point.h"

namespace apollonius {

/// The sites that the hull touches, all of them, counter-clockwise; one can occur several times (a large circle with small ones sticking
/// out; points in line, there and back).
void hullSites(const DiagramCore& core, Array<SiteId>& sites);

/// The hull as one closed figure. A radius below 0 shrinks the hull of the centres' other circles: meaningful up to a common offset.
void drawHull(const DiagramCore& core, double tolerance, Path& path);

/// Sine of the turn from the outer normal of one half-plane to that of the other; 0 if it is so within the normals' error bounds (then
/// the normals are the same, or opposite).
[[nodiscard]] inline double turnBetween(const VoronoiCircle& from, const VoronoiCircle& to) {
  const double sine = cross(Point{from.x, from.y}, Point{to.x, to.y});
  const double error = 2 * (static_cast<double>(from.slope) + static_cast<double>(to.slope)) + 4 * kUnitRoundoff;
  return absolute(sine) > error ? sine : 0;
}

/// The circle of a site as a closed figure; nothing for a radius of 0 or less.
void drawCircle(const Site& site, double tolerance, Path& path);

}  // namespace apollonius
