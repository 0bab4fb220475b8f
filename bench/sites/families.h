// The families of sets that are measured, by name. Each is a seeded set in random order: inserting
// it from the front, and removing it from the back, is random insertion and random removal.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "apollonius/diagram.h"

namespace apollonius::bench {

struct SiteSet {
  std::vector<Circle> circles;
  double nearness = 0;  ///< how far from a site the queries "near sites" go (unit of the
                        ///< coordinates); 0: the mean spacing
};

/// The names that makeSites knows.
std::vector<std::string_view> familyNames();

/// The family's n sites; nothing for an unknown name.
std::optional<SiteSet> makeSites(std::string_view family, std::size_t n);

struct Point {
  double x;
  double y;
};

/// `count` points uniform in the bounding box of the centres.
std::vector<Point> pointsInBox(const SiteSet& sites, std::size_t count);
/// `count` points near random sites.
std::vector<Point> pointsNearSites(const SiteSet& sites, std::size_t count);

}  // namespace apollonius::bench
