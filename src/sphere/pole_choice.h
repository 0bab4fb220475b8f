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

}  // namespace apollonius::internal::sphere
