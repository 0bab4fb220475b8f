// Two faces with their surroundings, proved right at once in doubles: for diagrams whose faces are known beforehand (snapshots).
#pragma once

#include <array>

#include "predicate/site.h"
#include "predicate/voronoi_circle.h"

namespace apollonius {

/// A bounded face, counter-clockwise, and the corners beyond its edges; all of them finite.
struct FaceWithSurroundings {
  std::array<Corner, 3> corners, beyond;
};

/// Do doubles show of both faces that no corner covers another, that there is a circle, and that no corner beyond is in conflict with it?
/// Then these are the circles; else they say nothing.
[[nodiscard]] bool areCertainFaces(const std::array<FaceWithSurroundings, 2>& faces, std::array<VoronoiCircle, 2>& circles) noexcept;

}  // namespace apollonius
