// Which site the others are projected from.
#pragma once

#include <cstdint>

#include "sphere/site_table.h"

namespace apollonius::internal::sphere {

/// A visible site from which circles lose little accuracy: of a few that are drawn at random, the
/// first from which the loss (Projection::Image) is usual, else the best. `caps` are the sites' by
/// id. Advances `seed`. REQUIRES: at least one site. Throws std::bad_alloc. Cost: O(n).
[[nodiscard]] SiteId choosePole(const SiteTable& sites, const FlatArray<Cap>& caps,
                                std::uint64_t& seed);

/// Is a site visible, as far as the projection from it can tell: does no other one hide it? Cost:
/// O(n).
[[nodiscard]] bool isVisible(const SiteTable& sites, SiteId id);

}  // namespace apollonius::internal::sphere
