#include "diagram/diagram_core.h"

#include <algorithm>
#include <new>

#include "diagram/spatial_order.h"

namespace apollonius {

void DiagramCore::reserve(std::size_t sites) {
  ids_.reserve(sites);
  hidden_.reserve(sites);
  base_.reserve(sites + 1);  // last: who looks at its size finds room for all
}

VertexId DiagramCore::startFor(double x, double y) const {
  const SiteId close = grid_.near(x, y);
  if (close != kNoSite && ids_.state(close) == SiteState::kVisible) return vertexOf(close);
  const SiteId start = hierarchy_.locate(x, y);
  return start == kNoSite ? base_.anyVisible() : vertexOf(start);
}

SiteId DiagramCore::nearest(double x, double y, SiteId hint) const {
  const VertexId start = hint != kNoSite ? vertexOf(hint) : startFor(x, y);
  return siteOf(base_.locate(x, y, start, walk_).nearest);
}

SiteId DiagramCore::insert(const Site& site) { return insertNear(site, kNoVertex); }

SiteId DiagramCore::insertNear(const Site& site, VertexId start) {
  const SiteId id = ids_.next();
  if (id + std::size_t{2} > base_.graph().vertexSlots()) {
    hidden_.reserve(id + std::size_t{1});
    base_.reserve(id + std::size_t{2});  // last: see reserve
  }
  ids_.take(id, place(id, site, start));
  return id;
}

SiteState DiagramCore::place(SiteId id, const Site& site, VertexId start) {
  const VertexId v = vertexOf(id);
  // -0 + 0 is 0: one number, one pattern of bits.
  base_.setSite(v, {site.x + 0.0, site.y + 0.0, site.r + 0.0});
  if (start == kNoVertex) start = startFor(site.x, site.y);
  const DelaunayGraph::Insertion insertion = base_.insert(v, start, walk_);
  // From here on nothing throws.
  if (insertion.cover != kNoVertex) {
    hidden_.attach(id, siteOf(insertion.cover));
    return SiteState::kHidden;
  }
  for (const VertexId covered : insertion.covered) {
    hidden_.attach(siteOf(covered), id);
    ids_.setState(siteOf(covered), SiteState::kHidden);
    leaveLocation(siteOf(covered));
  }
  enterLocation(id);
  return SiteState::kVisible;
}

bool DiagramCore::remove(SiteId id) {
  if (ids_.state(id) == SiteState::kFree) return false;
  displace(id);
  ids_.release(id);
  return true;
}

std::size_t DiagramCore::removeMany(std::span<const SiteId> ids) {
  ballast_.load();
  std::vector<SiteId> gone;
  gone.reserve(ids.size());
  try {
    for (const SiteId id : ids) {
      if (ids_.state(id) == SiteState::kFree || ids_.state(id) == SiteState::kPending) continue;  // pending: repeated
      displace(id);
      gone.push_back(id);
    }
  } catch (const std::bad_alloc&) {
    ballast_.drop();
    for (const SiteId id : gone) restore(id, site(id));
    throw;
  }
  for (const SiteId id : gone) ids_.release(id);
  return gone.size();
}

void DiagramCore::displace(SiteId id) {
  if (ids_.state(id) == SiteState::kHidden) {
    hidden_.dissolve(id);  // what it covered is covered by its parent, too
  } else {
    displaceVisible(id);
  }
  ids_.setState(id, SiteState::kPending);
}

void DiagramCore::displaceVisible(SiteId id) {
  children_.clear();
  for (SiteId child = hidden_.firstChild(id); child != HiddenForest::kNone; child = hidden_.nextSibling(child)) {
    children_.push_back(vertexOf(child));
  }
  const std::span<const Remover::Fate> fates = remover_.remove(base_, vertexOf(id), children_);
  // From here on nothing throws.
  for (const Remover::Fate& fate : fates) {
    const SiteId child = siteOf(fate.vertex);
    hidden_.detach(child);
    if (fate.cover == kNoVertex) {
      ids_.setState(child, SiteState::kVisible);
    } else {
      hidden_.attach(child, siteOf(fate.cover));
    }
  }
  leaveLocation(id);
  // The fates were the remover's scratch, which the line above may have used.
  for (const VertexId child : children_) {
    if (ids_.state(siteOf(child)) == SiteState::kVisible) enterLocation(siteOf(child));
  }
}

void DiagramCore::enterLocation(SiteId id) noexcept {
  if (!usesHierarchy_) return;
  hierarchy_.insert(id, site(id));
  if (walk_ != Walk::kSectors) return;
  grid_.insert(id, site(id));
  if (grid_.isOutgrown()) rebuildGrid();
}

void DiagramCore::leaveLocation(SiteId id) noexcept {
  hierarchy_.remove(id, remover_);
  grid_.remove(site(id));
}

void DiagramCore::rebuildGrid() noexcept {
  Site low = site(siteOf(base_.anyVisible())), high = low;
  const auto forEachVisible = [&](auto&& visit) {
    for (SiteId id = 0; id < ids_.slots(); ++id) {
      if (base_.graph().hasVertex(vertexOf(id))) visit(id);
    }
  };
  forEachVisible([&](SiteId id) {
    const Site& s = site(id);
    low = {std::min(low.x, s.x), std::min(low.y, s.y), 0};
    high = {std::max(high.x, s.x), std::max(high.y, s.y), 0};
  });
  grid_.rebuild(base_.visibleCount(), low, high);
  forEachVisible([&](SiteId id) { grid_.insert(id, site(id)); });
}

void DiagramCore::update(SiteId id, const Site& site) {
  ballast_.load();
  move(id, site);
}

void DiagramCore::move(SiteId id, const Site& site) {
  const Site old = this->site(id);
  if (old.x == site.x && old.y == site.y && old.r == site.r) return;
  displace(id);
  try {
    ids_.setState(id, place(id, site, kNoVertex));
  } catch (const std::bad_alloc&) {
    ballast_.drop();
    restore(id, old);
    throw;
  }
}

void DiagramCore::insertMany(std::span<const double> xyr, std::span<SiteId> ids) {
  const std::size_t n = ids.size();
  ballast_.load();
  const std::size_t sites = ids_.size() + n;
  reserve(sites > ids_.slots() ? sites : ids_.slots());
  std::vector<std::uint32_t> order = insertionOrder({xyr, 3});
  // Ids are given in the order of the input, sites inserted along the curve.
  for (SiteId& id : ids) {
    id = ids_.next();
    ids_.take(id, SiteState::kPending);
  }
  std::size_t done = 0;
  try {
    VertexId start = kNoVertex;
    for (; done < n; ++done) {
      const double* circle = &xyr[3 * std::size_t{order[done]}];
      const SiteId id = ids[order[done]];
      ids_.setState(id, place(id, {circle[0], circle[1], circle[2]}, start));
      start = base_.anyVisible();
    }
  } catch (const std::bad_alloc&) {
    ballast_.drop();
    for (std::size_t k = 0; k < done; ++k) displace(ids[order[k]]);
    for (std::size_t k = n; k-- > 0;) ids_.release(ids[k]);  // so that the next ones are given in the same order again
    throw;
  }
}

void DiagramCore::updateMany(std::span<const SiteId> ids, std::span<const double> xyr) {
  ballast_.load();
  std::vector<Site> old(ids.size());
  std::size_t done = 0;
  try {
    for (; done < ids.size(); ++done) {
      old[done] = site(ids[done]);
      move(ids[done], {xyr[3 * done], xyr[3 * done + 1], xyr[3 * done + 2]});
    }
  } catch (const std::bad_alloc&) {
    ballast_.drop();
    while (done-- > 0) {
      displace(ids[done]);
      restore(ids[done], old[done]);
    }
    throw;
  }
}

void DiagramCore::clear() noexcept {
  base_.clear();
  hidden_.clear();
  hierarchy_.clear();
  grid_.clear();
  ids_.clear();
}

}  // namespace apollonius
