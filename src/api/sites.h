// The sites of a diagram in arrays, on the plane and on the sphere.
#pragma once

#include <cstddef>
#include <vector>

#include "apollonius/types.h"

namespace apollonius::internal {

/// All ids, ascending. Replaces the contents. Throws std::bad_alloc.
template <class AnyDiagram>
void listIds(const AnyDiagram& diagram, std::vector<SiteId>& ids) {
  ids.clear();
  ids.reserve(diagram.size());
  for (SiteId id = 0; id < diagram.idLimit(); ++id) {
    if (diagram.has(id)) ids.push_back(id);
  }
}

/// Lists ids, circles and hidden flags of all sites; `AnyCircle` is the diagram's type of a circle.
/// Replaces the contents. Throws std::bad_alloc.
template <class AnyCircle, class AnyDiagram>
void listSites(const AnyDiagram& diagram, SiteArrays& sites) {
  listIds(diagram, sites.ids);
  sites.xyr.resize(3 * sites.ids.size());
  sites.hidden.resize(sites.ids.size());
  for (std::size_t k = 0; k < sites.ids.size(); ++k) {
    AnyCircle circle{};
    bool isHidden = false;
    (void)diagram.site(sites.ids[k], circle);
    (void)diagram.isHidden(sites.ids[k], isHidden);
    const auto& [x, y, r] = circle;
    sites.xyr[3 * k] = x;
    sites.xyr[3 * k + 1] = y;
    sites.xyr[3 * k + 2] = r;
    sites.hidden[k] = isHidden ? 1 : 0;
  }
}

}  // namespace apollonius::internal
