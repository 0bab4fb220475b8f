// The plane and the sphere for tests of what both promise: TYPED_TEST_SUITE(…, Surfaces).
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "apollonius/builder.h"
#include "apollonius/nearest_first.h"
#include "apollonius/spherical_diagram.h"
#include "sphere/sphere_sets.h"
#include "support/corpus.h"
#include "support/generators.h"

namespace apollonius::test {

using Triples = std::vector<double>;
using NamedTriples = std::pair<std::string, Triples>;

/// Three numbers of which one can be none of a site's, and why.
struct BadSite {
  std::array<double, 3> site;
  Error error;
};

struct OnThePlane {
  using Diagram = apollonius::Diagram;
  using Circle = apollonius::Circle;
  using Builder = apollonius::Builder;
  using NearestFirst = apollonius::NearestFirst;
  /// The reach of cells from one of 50 sites().
  static constexpr double kUnit = 2e5;

  /// Spread evenly; some are hidden.
  static Triples sites(Random& random, std::size_t n) {
    return flat(randomCircles(random, n, Hidden::k20Percent));
  }
  static std::vector<NamedTriples> sets(Random& random, std::size_t n) {
    std::vector<NamedTriples> sets;
    for (const NamedGenerator& generator : corpus())
      sets.emplace_back(generator.name, flat(generator.make(random, generator.large ? n : 15)));
    return sets;
  }
  static std::array<double, 2> place(Random& random) {
    return {random.between(-1e6, 1e6), random.between(-1e6, 1e6)};
  }
  static std::vector<BadSite> badSites() {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInf = std::numeric_limits<double>::infinity();
    std::vector<BadSite> bad;
    for (std::size_t place = 0; place < 3; ++place) {
      for (const auto& [value, error] : {std::pair{kNaN, Error::kNotFinite},
                                         {kInf, Error::kNotFinite},
                                         {-kInf, Error::kNotFinite},
                                         {1.01e100, Error::kOutOfRange},
                                         {-1.01e100, Error::kOutOfRange},
                                         {1.7e308, Error::kOutOfRange}}) {
        bad.push_back({{1, 2, 3}, error});
        bad.back().site[place] = value;
      }
    }
    return bad;
  }
};

struct OnTheSphere {
  using Diagram = SphericalDiagram;
  using Circle = SphericalCircle;
  using Builder = SphericalBuilder;
  using NearestFirst = SphericalNearestFirst;
  static constexpr double kUnit = 0.3;

  static Triples sites(Random& random, std::size_t n) { return flat(randomSites(random, n, 0.3)); }
  static std::vector<NamedTriples> sets(Random& random, std::size_t n) {
    std::vector<NamedTriples> sets;
    for (const NamedSites& set : namedSets(random, n)) sets.emplace_back(set.name, flat(set.sites));
    return sets;
  }
  static std::array<double, 2> place(Random& random) {
    const auto [lon, lat] = randomPoint(random);
    return {lon, lat};
  }
  static std::vector<BadSite> badSites() {
    constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInf = std::numeric_limits<double>::infinity();
    return {{{kNaN, 0, 0}, Error::kNotFinite},
            {{0, kNaN, 0}, Error::kNotFinite},
            {{0, 0, kNaN}, Error::kNotFinite},
            {{kInf, 0, 0}, Error::kNotFinite},
            {{0, -kInf, 0}, Error::kNotFinite},
            {{0, 0, kInf}, Error::kNotFinite},
            {{0, 90.0001, 0}, Error::kOutOfRange},
            {{0, -91, 0}, Error::kOutOfRange},
            {{0, 0, std::numbers::pi}, Error::kOutOfRange},
            {{0, 0, -3.15}, Error::kOutOfRange}};
  }
};

struct NamesOfSurfaces {
  template <class Surface>
  static std::string GetName(int) {  // NOLINT: GoogleTest's name
    return std::is_same_v<Surface, OnThePlane> ? "Plane" : "Sphere";
  }
};
using Surfaces = ::testing::Types<OnThePlane, OnTheSphere>;

/// The diagram of triples, whose ids are 0, 1, 2, ….
template <class Surface>
typename Surface::Diagram madeOf(const Triples& triples) {
  typename Surface::Diagram diagram;
  std::vector<SiteId> ids(triples.size() / 3);
  EXPECT_EQ(diagram.insertMany(triples, ids), Error::kNone);
  return diagram;
}

/// Lists the neighbours of each id, ascending; the list of an id without a site is empty.
template <class Diagram>
std::vector<std::vector<SiteId>> allNeighbors(const Diagram& diagram) {
  std::vector<std::vector<SiteId>> all(diagram.idLimit());
  for (SiteId id = 0; id < all.size(); ++id) {
    if (!diagram.has(id)) continue;
    EXPECT_EQ(diagram.neighbors(id, all[id]), Error::kNone);
    std::ranges::sort(all[id]);
  }
  return all;
}

template <class Diagram>
void expectValid(const Diagram& diagram) {
  Violation violation;
  ASSERT_EQ(diagram.validate(violation), Error::kNone);
  ASSERT_EQ(violation.text(), "");
}

}  // namespace apollonius::test
