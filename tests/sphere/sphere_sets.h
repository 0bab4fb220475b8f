// Sets of sites on the unit sphere for tests, and their diagram by brute force in long double.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "apollonius/spherical_diagram.h"
#include "support/random.h"

namespace apollonius::test {

using SphericalSites = std::vector<SphericalCircle>;

struct NamedSites {
  std::string name;
  SphericalSites sites;
};

/// Spread evenly.
inline SphericalPoint randomPoint(Random& random) {
  return {random.between(-180, 180), std::asin(random.between(-1, 1)) * 180 / std::numbers::pi};
}

inline SphericalSites randomSites(Random& random, std::size_t n, double heaviest) {
  SphericalSites sites;
  for (std::size_t k = 0; k < n; ++k) {
    const auto [lon, lat] = randomPoint(random);
    sites.push_back({lon, lat, random.between(0, heaviest)});
  }
  return sites;
}

/// Sets of sites as people have them, and sets that break programs.
inline std::vector<NamedSites> namedSets(Random& random, std::size_t n) {
  std::vector<NamedSites> sets = {
      {"points", randomSites(random, n, 0)},
      {"caps", randomSites(random, n, 0.3)},
      {"mostly hidden", randomSites(random, n, 2.5)},
      {"one", {{12, 34, 0.5}}},
      {"two", {{12, 34, 0.5}, {-100, 80, 0.1}}},
      {"antipodes", {{12, 34, 0.5}, {-168, -34, 0.1}}},
      {"three", {{12, 34, 0.5}, {-100, 80, 0.1}, {50, -20, 0}}},
      {"three on the equator", {{0, 0, 0}, {120, 0, 0.1}, {-120, 0, 0}}},
      {"octahedron", {{0, 0, 0}, {90, 0, 0}, {180, 0, 0}, {-90, 0, 0}, {0, 90, 0}, {0, -90, 0}}},
      {"a cap larger than a hemisphere", {{0, 0, 2}, {175, 3, 0.1}, {-170, -8, 0.2}, {150, 40, 0}}},
  };
  SphericalSites towns, equator, meridian, grid, ring, twins, giant;
  for (std::size_t k = 0; k < n; ++k) {
    const SphericalPoint town = {10.0 * static_cast<double>(k % 5), 45};
    const double spread = std::pow(10, -static_cast<double>(k % 7));
    towns.push_back({town.lon + spread * random.between(-1, 1),
                     town.lat + spread * random.between(-1, 1), spread * random.between(0, 0.01)});
    equator.push_back({random.between(-180, 180), 0, random.between(0, 0.01)});
    meridian.push_back({k % 2 == 0 ? 180.0 : 0.0, random.between(-90, 90), 0});
    twins.push_back({std::floor(random.between(0, 4)), std::floor(random.between(0, 4)),
                     std::floor(random.between(0, 3)) / 10});
    ring.push_back({static_cast<double>(k) * 360 / static_cast<double>(n), 60, 0.01});
    giant.push_back({random.between(-60, 60), random.between(20, 25), random.between(0, 0.001)});
  }
  for (int lat = -90; lat <= 90; lat += 30) {
    for (int lon = -180; lon < 180; lon += 30) grid.push_back({lon * 1.0, lat * 1.0, 0});
  }
  ring.push_back({0, 90, 0.7});
  giant.push_back({0, -60, 1.1});
  for (auto& [name, sites] : std::vector<NamedSites>{{"towns", towns},
                                                     {"on the equator", equator},
                                                     {"on a meridian", meridian},
                                                     {"twins", twins},
                                                     {"about the pole", ring},
                                                     {"beside a giant", giant},
                                                     {"grid", grid}})
    sets.push_back({name, sites});
  return sets;
}

/// Pi in whole precision; libc++'s std::numbers::pi_v<long double> is a double.
inline constexpr long double kLongPi = 3.141592653589793238462643383279502884L;

struct LongVector {
  long double x, y, z;
};
inline LongVector longDirection(double lon, double lat) {
  constexpr long double kRadian = kLongPi / 180;
  const long double a = lon * kRadian, b = lat * kRadian;
  return {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)};
}
inline long double angleOf(const LongVector& a, const LongVector& b) {
  const long double x = a.y * b.z - a.z * b.y, y = a.z * b.x - a.x * b.z, z = a.x * b.y - a.y * b.x;
  return std::atan2(std::sqrt(x * x + y * y + z * z), a.x * b.x + a.y * b.y + a.z * b.z);
}
inline double angleOf(const SphericalCircle& a, const SphericalCircle& b) {
  return static_cast<double>(angleOf(longDirection(a.lon, a.lat), longDirection(b.lon, b.lat)));
}
/// Distance from a point to a site of the unit sphere.
inline double distanceOf(const SphericalPoint& p, const SphericalCircle& site) {
  return static_cast<double>(
      angleOf(longDirection(p.lon, p.lat), longDirection(site.lon, site.lat)) - site.r);
}

/// Distance to the nearest site.
inline double leastDistance(const SphericalSites& sites, const SphericalPoint& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const SphericalCircle& site : sites) least = std::min(least, distanceOf(p, site));
  return least;
}

inline std::vector<double> flat(const SphericalSites& sites) {
  std::vector<double> numbers;
  for (const SphericalCircle& s : sites) numbers.insert(numbers.end(), {s.lon, s.lat, s.r});
  return numbers;
}

inline SphericalDiagram diagramOf(const SphericalSites& sites) {
  SphericalDiagram diagram;
  std::vector<SiteId> ids(sites.size());
  if (diagram.insertMany(flat(sites), ids) != Error::kNone) std::abort();
  return diagram;
}

}  // namespace apollonius::test
