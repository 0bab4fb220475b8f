// Natural neighbours on the sphere against the diagram with the new site in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sphere/sphere_sets.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

/// The area that an inserted site takes from each cell, as a share of its own; empty if it has
/// none.
std::vector<double> takenFrom(const SphericalSites& sites, const SphericalCircle& site) {
  SphericalSites more = sites;
  more.push_back(site);
  std::vector<double> before, after;
  EXPECT_EQ(diagramOf(sites).cellAreas({}, before), Error::kNone);
  EXPECT_EQ(diagramOf(more).cellAreas({}, after), Error::kNone);
  if (after.back() == 0) return {};
  for (std::size_t k = 0; k < sites.size(); ++k) before[k] = (before[k] - after[k]) / after.back();
  return before;
}

std::vector<double> weightsById(const SphericalDiagram& diagram, const SphericalCircle& site) {
  NaturalWeights found;
  EXPECT_EQ(diagram.naturalWeights(site.lon, site.lat, site.r, found), Error::kNone);
  std::vector<double> weights(diagram.idLimit(), 0);
  for (std::size_t k = 0; k < found.ids.size(); ++k) {
    EXPECT_EQ(weights[found.ids[k]], 0) << "twice";
    weights[found.ids[k]] = found.weights[k];
  }
  return weights;
}

TEST(SphericalNaturalNeighbors, AreWhatANewSiteTakes) {
  Random random(31);
  for (int round = 0; round < sized(2, 20); ++round) {
    for (const NamedSites& set : namedSets(random, 6 + 14 * static_cast<std::size_t>(round % 3))) {
      // Which of two equal sites is hidden depends on what else comes.
      if (set.name == "grid" || set.name == "twins") continue;
      const SphericalDiagram diagram = diagramOf(set.sites);
      for (int k = 0; k < 12; ++k) {
        const SphericalPoint p = randomPoint(random);
        SphericalCircle site = {p.lon, p.lat, k % 3 == 0 ? 0 : random.between(-0.2, 0.8)};
        if (k == 5) site.lon = 180;
        if (k == 6) site.lat = -90;
        SCOPED_TRACE(set.name + ": " + std::to_string(site.lon) + ", " + std::to_string(site.lat) +
                     ", " + std::to_string(site.r));
        const std::vector<double> weights = weightsById(diagram, site);
        double sum = 0;
        for (const double weight : weights) sum += weight;
        EXPECT_NEAR(sum, 1, 1e-14);
        const std::vector<double> taken = takenFrom(set.sites, site);
        if (taken.empty()) {
          EXPECT_EQ(*std::ranges::max_element(weights), 1);
          continue;
        }
        for (std::size_t id = 0; id < taken.size(); ++id)
          EXPECT_NEAR(weights[id], taken[id], 1e-7) << id;
      }
    }
  }
}

TEST(SphericalNaturalNeighbors, BesideASiteAreThoseOfAPlaceThere) {
  // Bisectors with a site as close as rounding are of caps alone.
  Random random(34);
  for (int round = 0; round < sized(40, 1000); ++round) {
    const SphericalSites sites = randomSites(random, 30, round % 2 == 0 ? 0 : 0.05);
    const double apart = std::pow(10, -1 - round % 13);
    const SphericalCircle& beside = sites[0];
    SphericalCircle site = {beside.lon + apart * random.between(-1, 1),
                            beside.lat + apart * random.between(-1, 1), beside.r};
    site.lat = std::clamp(site.lat, -90.0, 90.0);
    SCOPED_TRACE(std::to_string(round));
    const std::vector<double> taken = takenFrom(sites, site);
    const std::vector<double> weights = weightsById(diagramOf(sites), site);
    // Rounding of directions, 2^-53, turns a bisector by this.
    const double rounding = 1e-7 + 1e-13 / apart;
    for (std::size_t id = 0; id < taken.size(); ++id)
      EXPECT_NEAR(weights[id], taken[id], rounding) << id;
  }
}

TEST(SphericalNaturalNeighbors, AtASiteThatSiteAlone) {
  Random random(32);
  const SphericalSites sites = randomSites(random, 100, 0);
  const SphericalDiagram diagram = diagramOf(sites);
  for (SiteId id = 0; id < sites.size(); ++id) EXPECT_EQ(weightsById(diagram, sites[id])[id], 1);
}

TEST(SphericalNaturalNeighbors, OfEqualSitesAboutAPoleAreEqual) {
  SphericalSites sites;
  constexpr int kSites = 400;
  for (int k = 0; k < kSites; ++k) sites.push_back({k * 360.0 / kSites - 180, 60, 0});
  for (const double weight : weightsById(diagramOf(sites), {0, 90, 0}))
    EXPECT_NEAR(weight, 1.0 / kSites, 1e-12);
}

TEST(SphericalNaturalNeighbors, InterpolateIsTheSumOfWeightsTimesValues) {
  Random random(33);
  const SphericalSites sites = randomSites(random, 200, 0.05);
  SphericalDiagram diagram = diagramOf(sites);
  bool removed = false;
  ASSERT_EQ(diagram.remove(17, removed), Error::kNone);
  std::vector<double> values, points;
  for (std::size_t k = 0; k < sites.size(); ++k) values.push_back(random.between(-1, 1));
  values[17] = std::nan("");
  for (int k = 0; k < 500; ++k) {
    const SphericalPoint p = randomPoint(random);
    points.insert(points.end(), {p.lon, p.lat});
  }
  std::vector<double> results(points.size() / 2);
  ASSERT_EQ(diagram.interpolate(values, points, 0.01, results), Error::kNone);
  for (std::size_t k = 0; k < results.size(); ++k) {
    NaturalWeights found;
    ASSERT_EQ(diagram.naturalWeights(points[2 * k], points[2 * k + 1], 0.01, found), Error::kNone);
    double sum = 0;
    for (std::size_t n = 0; n < found.ids.size(); ++n)
      sum += found.weights[n] * values[found.ids[n]];
    EXPECT_NEAR(results[k], sum, 1e-13);
  }
}

TEST(SphericalNaturalNeighbors, OfTheOnlySiteIsThatSiteAlsoIfItWouldBeCovered) {
  const SphericalDiagram diagram = diagramOf({{10, 20, 0.1}});
  for (const double r : {0.0, 1.0}) {
    NaturalWeights found;
    ASSERT_EQ(diagram.naturalWeights(12, 20, r, found), Error::kNone);
    EXPECT_EQ(found.ids, std::vector<SiteId>{0});
    EXPECT_EQ(found.weights, std::vector<double>{1});
  }
}

TEST(SphericalNaturalNeighbors, NoneWithoutSites) {
  const SphericalDiagram diagram;
  NaturalWeights found;
  ASSERT_EQ(diagram.naturalWeights(1, 2, 0, found), Error::kNone);
  EXPECT_TRUE(found.ids.empty());
  std::vector<double> results = {7};
  ASSERT_EQ(diagram.interpolate({}, std::vector<double>{1, 2}, 0, results), Error::kNone);
  EXPECT_TRUE(std::isnan(results[0]));
  EXPECT_EQ(diagram.naturalWeights(1, 91, 0, found), Error::kOutOfRange);
  EXPECT_EQ(diagram.interpolate({}, std::vector<double>{1}, 0, results), Error::kBadLength);
  EXPECT_EQ(diagram.interpolate({}, std::vector<double>{1, 2}, 4, results), Error::kOutOfRange);
}

}  // namespace
}  // namespace apollonius::test
