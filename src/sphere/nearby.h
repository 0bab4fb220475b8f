// The sites around a point of the sphere one by one, in the order of their distance.
#pragma once

#include <cstddef>
#include <span>

#include "apollonius/types.h"
#include "base/flat_array.h"
#include "diagram/nearby_search.h"
#include "sphere/spherical_core.h"

namespace apollonius::internal::sphere {

/// Distance of a point to a site, in the unit of the sphere's radius, rounded.
[[nodiscard]] inline double distanceTo(const SiteTable& sites, SiteId id, const Direction& point) {
  const double angle = angleBetween(point, directionOf(sites[id].centre)).angle();
  return angle * sites.radius() - sites[id].r;
}

/// The sphere as the surface of a search around a point, in the unit of its radius
/// (nearby_search.h). Of sites that are equally far up to rounding, any may come first.
class Sphere {
 public:
  using Point = Direction;
  using Site = SiteId;
  static constexpr SiteId kNone = kNoSite;

  struct Entry {
    double distance;
    SiteId site;
  };

  explicit Sphere(const SphericalCore& core) : diagram_(&core.projected()), sites_(&core.sites()) {}

  [[nodiscard]] SiteId nearest(const Direction& point) const;
  [[nodiscard]] Entry entry(const Direction& point, SiteId site) const {
    return {distance(point, site), site};
  }
  [[nodiscard]] static bool isBeyond(const Direction&, const Entry& entry, double limit) {
    return entry.distance > limit;
  }
  [[nodiscard]] static bool isAfter(const Direction&, const Entry& a, const Entry& b) {
    return a.distance != b.distance ? a.distance > b.distance : a.site > b.site;
  }
  template <class Visit>
  void visitBelow(SiteId site, Visit visit) const;
  template <class Visit>
  void visitNeighbors(SiteId site, Visit visit) const;
  [[nodiscard]] double distance(const Direction& point, SiteId site) const {
    return distanceTo(*sites_, site, point);
  }
  [[nodiscard]] bool contains(const Direction& point, SiteId site) const {
    return distance(point, site) <= 0;
  }
  [[nodiscard]] double weight(SiteId site) const { return (*sites_)[site].r; }
  [[nodiscard]] static SiteId idOf(SiteId site) { return site; }

 private:
  const ProjectedDiagram* diagram_;
  const SiteTable* sites_;
};

/// The first `most` sites of a search from each of the points longitude, latitude in degrees.
/// Replaces the contents of `lists`, with distances or without. Throws std::bad_alloc.
void listNearbyMany(const SphericalCore& core, std::span<const double> lonLat, std::size_t most,
                    double maxDistance, bool withDistances, NearbyLists& lists);

}  // namespace apollonius::internal::sphere

namespace apollonius::internal {
extern template class NearbySearch<sphere::Sphere>;  // sphere/nearby.cpp
}
