// The cell of a site of the sphere as sectors about it, one for each edge.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "base/flat_array.h"
#include "sphere/bisector.h"
#include "sphere/projected_diagram.h"
#include "sphere/vertices.h"

namespace apollonius::internal::sphere {

inline constexpr double kTurn = 2 * std::numbers::pi;

/// The part of a cell that is bounded by one edge.
struct Sector {
  SphericalBisector bisector;
  double from = 0;   ///< bearing of its first point about the site
  double width = 0;  ///< angle to its last one, counter-clockwise, 0 to 2 pi
};

/// The sector of an edge about the site where `h` starts. Calls throw std::bad_alloc.
[[nodiscard]] Sector sectorOf(const ProjectedDiagram& diagram, HalfedgeId h,
                              SphericalVertices& vertices);

/// The other one of two visible sites. REQUIRES: there are just two.
[[nodiscard]] inline VertexId otherOfTwo(const ProjectedDiagram& diagram, VertexId node) {
  return node == kInfinity ? diagram.plane().delaunay().anyVisible() : kInfinity;
}

/// How far cells reach, in radians.
class AngularReach {
 public:
  /// `distances` are measured from the circles of the sites, on a sphere of this radius: one for
  /// each id, or one for all, or none for an unlimited reach. REQUIRES: `distances` live as long.
  AngularReach(std::span<const double> distances, double radius)
      : distances_(distances), radius_(radius) {}

  /// Do all cells end at other cells only?
  [[nodiscard]] bool isUnlimited() const {
    return distances_.empty() ||
           (distances_.size() == 1 && distances_[0] == std::numeric_limits<double>::infinity());
  }
  /// The reach from the circle of a site.
  [[nodiscard]] double beyondCircle(SiteId site) const {
    if (distances_.empty()) return std::numeric_limits<double>::infinity();
    return taken(distances_[distances_.size() == 1 ? 0 : site]) / radius_;
  }
  /// The reach from the site's centre: up to 0 there is no cell, from pi on the cell ends at other
  /// cells only.
  [[nodiscard]] double of(const ProjectedDiagram& diagram, VertexId node) const {
    return diagram.cap(node).weight + beyondCircle(diagram.siteOf(node));
  }

 private:
  std::span<const double> distances_;
  double radius_;
};

/// Calls visit(from, to) for each part of a sector, counted from its beginning, that is closer than
/// `aside`, at most half a turn, to a bearing, counter-clockwise.
template <class Visit>
void visitAbout(const Sector& sector, double bearing, double aside, Visit&& visit) {
  const double begin = std::remainder(bearing - sector.from, kTurn) - aside;
  double done = 0;
  for (const double turn : {-kTurn, 0.0, kTurn}) {
    const double from = std::clamp(begin + turn, done, sector.width);
    const double to = std::clamp(begin + turn + 2 * aside, done, sector.width);
    if (!(from < to)) continue;
    visit(from, to);
    done = to;
  }
}

/// Calls visit(from, to) for each part of a sector, counted from its beginning, in which its curve
/// is nearer to the site than the angle `reach`, which is above 0; counter-clockwise.
template <class Visit>
void visitWithin(const Sector& sector, double reach, Visit&& visit) {
  if (reach < std::numbers::pi) {
    visitAbout(sector, sector.bisector.middle(), sector.bisector.asideWithin(reach), visit);
  } else {
    visit(0.0, sector.width);
  }
}

/// Lists the sectors of a visible site, counter-clockwise; none if it is the only one. The sector
/// of the closed edge of two visible sites begins where the edge is farthest. Cost: O(d).
void listSectors(const ProjectedDiagram& diagram, VertexId node, SphericalVertices& vertices,
                 FlatArray<Sector>& sectors);

}  // namespace apollonius::internal::sphere
