#include "sphere/nearby.h"

#include "diagram/nearby_lists.h"
#include "sphere/nearest.h"

namespace apollonius::internal::sphere {

SiteId Sphere::nearest(const Direction& point) const {
  return diagram_->isEmpty() ? kNoSite : diagram_->siteOf(nearestNode(*diagram_, point));
}

template <class Visit>
void Sphere::visitBelow(SiteId site, Visit visit) const {
  const VertexId node = diagram_->nodeOf(site);
  if (node == kNoVertex) return;
  if (node == kInfinity) {
    for (const SiteId hidden : diagram_->belowPole()) visit(hidden);
    return;
  }
  const HiddenForest& hidden = diagram_->plane().hidden();
  for (Slot child = hidden.firstChild(slotOf(node)); child != HiddenForest::kNone;
       child = hidden.nextSibling(child))
    visit(diagram_->siteOf(vertexOf(child)));
}

template <class Visit>
void Sphere::visitNeighbors(SiteId site, Visit visit) const {
  const VertexId node = diagram_->nodeOf(site);
  if (node == kNoVertex) return;
  const Graph& graph = diagram_->graph();
  if (graph.isEmpty()) {  // the pole and at most one other visible site
    const VertexId other =
        node == kInfinity ? diagram_->plane().delaunay().anyVisible() : kInfinity;
    if (other != kNoVertex) visit(diagram_->siteOf(other));
    return;
  }
  if (!graph.hasVertex(node)) return;  // hidden
  for (const HalfedgeId h : graph.star(node)) visit(diagram_->siteOf(graph.target(h)));
}

}  // namespace apollonius::internal::sphere

template class apollonius::internal::NearbySearch<apollonius::internal::sphere::Sphere>;

namespace apollonius::internal::sphere {

void listNearbyMany(const SphericalCore& core, std::span<const double> lonLat, std::size_t most,
                    double maxDistance, bool withDistances, NearbyLists& lists) {
  NearbyListsBuilder builder(lonLat.size() / 2, withDistances, lists);
  if (core.sites().size() > 0) {
    const Sphere sphere(core);
    NearbySearch search(sphere);
    visitPoints(core.projected(), lonLat, [&](std::size_t k, const Direction& point) {
      search.start(point, maxDistance, sphere.nearest(point));
      builder.list(k, search, most);
    });
  }
  builder.finish();
}

}  // namespace apollonius::internal::sphere
