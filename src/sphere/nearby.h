// The sites around a point of the sphere one by one, in the order of their distance.
#pragma once

#include <cstddef>
#include <limits>
#include <span>

#include "apollonius/types.h"
#include "base/flat_array.h"
#include "diagram/nearby_search.h"
#include "sphere/projected_diagram.h"

namespace apollonius::internal::sphere {

/// From a point to a site in the unit of the sphere's radius, rounded.
[[nodiscard]] inline double distanceTo(const SiteTable& sites, SiteId id, const Direction& point) {
  const double angle = angleBetween(point, directionOf(sites[id].centre)).angle();
  return angle * sites.radius() - sites[id].r;
}

/// All sites, hidden ones too, in the order of their distance to a point, or those that are not
/// farther than a limit, in the unit of the sphere's radius. The diagram must stay as it is. Cost:
/// one location and O(m log m), m = the neighbours of the sites found. Calls throw std::bad_alloc,
/// and are not to be repeated then.
///
/// Works as NearbySearch does in the plane, and for the same reasons, which are the triangle
/// inequality and straight ways.
class SphericalSearch {
 public:
  SphericalSearch(const ProjectedDiagram& diagram, const SiteTable& sites, const Direction& point,
                  double maxDistance = std::numeric_limits<double>::infinity());

  /// For several points in turn: nothing is found before start().
  SphericalSearch(const ProjectedDiagram& diagram, const SiteTable& sites)
      : diagram_(diagram), sites_(sites) {}

  /// Begins at a point, in the memory of the search before.
  void start(const Direction& point, double maxDistance);

  /// The next site, kNoSite after the last.
  [[nodiscard]] SiteId next();

  /// To the site that next() gave last, in the unit of the sphere's radius; infinite if there is
  /// none.
  [[nodiscard]] double distance() const {
    return last_ == kNoSite ? std::numeric_limits<double>::infinity()
                            : distanceTo(sites_, last_, point_);
  }

 private:
  struct Entry {
    double distance;
    SiteId site;
    bool operator<(const Entry& other) const {  // the nearest on top of a heap
      return distance != other.distance ? distance > other.distance : site > other.site;
    }
  };

  void consider(SiteId site);
  /// Considers those that may come directly after a site.
  void follow(SiteId site);

  const ProjectedDiagram& diagram_;
  const SiteTable& sites_;
  Direction point_{};
  double maxDistance_ = 0;
  SiteId last_ = kNoSite;  // returned last, not followed yet
  FlatArray<Entry> heap_;
  SlotSet seen_;  // visible sites: a hidden one has one parent
};

/// Of the sites that contain the point, at a rounded distance of at most 0, the one on top; else
/// the nearest one if it is not farther than `maxDistance`; else kNoSite. Throws std::bad_alloc.
[[nodiscard]] SiteId pick(const ProjectedDiagram& diagram, const SiteTable& sites,
                          const Direction& point, double maxDistance, Top top);

/// The first `most` sites of a search from each of the points longitude, latitude in degrees.
/// Replaces the contents of `lists`, with distances or without. Throws std::bad_alloc.
void listNearbyMany(const ProjectedDiagram& diagram, const SiteTable& sites,
                    std::span<const double> lonLat, std::size_t most, double maxDistance,
                    bool withDistances, NearbyLists& lists);

}  // namespace apollonius::internal::sphere
