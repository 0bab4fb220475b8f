#include "sphere/nearby.h"

#include <algorithm>

#include "diagram/nearby_lists.h"
#include "diagram/topmost.h"
#include "sphere/nearest.h"

namespace apollonius::internal::sphere {

SphericalSearch::SphericalSearch(const ProjectedDiagram& diagram, const SiteTable& sites,
                                 const Direction& point, double maxDistance)
    : diagram_(diagram), sites_(sites) {
  start(point, maxDistance);
}

void SphericalSearch::start(const Direction& point, double maxDistance) {
  point_ = point;
  maxDistance_ = maxDistance;
  last_ = kNoSite;
  heap_.clear();
  seen_.clear();
  if (diagram_.isEmpty()) return;
  const SiteId first = diagram_.siteOf(nearestNode(diagram_, point));
  seen_.insert(first);
  consider(first);
}

void SphericalSearch::consider(SiteId site) {
  const double distance = distanceTo(sites_, site, point_);
  if (distance > maxDistance_) return;
  heap_.push_back({distance, site});
  std::push_heap(heap_.begin(), heap_.end());
}

void SphericalSearch::follow(SiteId site) {
  const VertexId node = diagram_.nodeOf(site);
  if (node == kNoVertex) return;
  const DiagramCore& plane = diagram_.plane();
  if (node == kInfinity) {
    for (const SiteId hidden : diagram_.belowPole()) consider(hidden);
    // Without edges: the pole and at most one other visible site.
    const VertexId other = plane.delaunay().anyVisible();
    if (diagram_.graph().isEmpty() && other != kNoVertex && seen_.insert(diagram_.siteOf(other)))
      consider(diagram_.siteOf(other));
  } else {
    const HiddenForest& hidden = plane.hidden();
    for (Slot child = hidden.firstChild(slotOf(node)); child != HiddenForest::kNone;
         child = hidden.nextSibling(child))
      consider(diagram_.siteOf(vertexOf(child)));
    if (diagram_.graph().isEmpty() && seen_.insert(diagram_.pole())) consider(diagram_.pole());
  }
  if (!diagram_.graph().hasVertex(node)) return;
  for (const HalfedgeId h : diagram_.graph().star(node)) {
    const SiteId neighbor = diagram_.siteOf(diagram_.graph().target(h));
    if (seen_.insert(neighbor)) consider(neighbor);
  }
}

SiteId SphericalSearch::next() {
  if (last_ != kNoSite) follow(last_);
  last_ = kNoSite;
  if (heap_.empty()) return kNoSite;
  std::pop_heap(heap_.begin(), heap_.end());
  last_ = heap_.back().site;
  heap_.pop_back();
  return last_;
}

SiteId pick(const ProjectedDiagram& diagram, const SiteTable& sites, const Direction& point,
            double maxDistance, Top top) {
  SphericalSearch search(diagram, sites, point, maxDistance);
  return topmost(
      top, [&] { return search.next(); }, [&](SiteId) { return search.distance() <= 0; },
      [&](SiteId id) { return sites[id].r; });
}

void listNearbyMany(const ProjectedDiagram& diagram, const SiteTable& sites,
                    std::span<const double> lonLat, std::size_t most, double maxDistance,
                    bool withDistances, NearbyLists& lists) {
  NearbyListsBuilder builder(lonLat.size() / 2, withDistances, lists);
  if (!diagram.isEmpty()) {
    SphericalSearch search(diagram, sites);
    visitPoints(diagram, lonLat, [&](std::size_t k, const Direction& point) {
      builder.begin(k);
      search.start(point, maxDistance);
      for (std::size_t left = most; left > 0; --left) {
        const SiteId id = search.next();
        if (id == kNoSite) break;
        builder.add(id, [&] { return search.distance(); });
      }
    });
  }
  builder.finish();
}

}  // namespace apollonius::internal::sphere
