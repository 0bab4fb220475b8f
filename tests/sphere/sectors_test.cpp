// The edges of a cell as sectors (src/sphere/cell.h): which of those whose ends are in one
// direction go all the way round a site, and which have no length.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sphere/cell.h"
#include "sphere/sphere_sets.h"
#include "sphere/spherical_core.h"

namespace apollonius::test {
namespace {

namespace sphere = internal::sphere;

constexpr double kPi = std::numbers::pi;

void expectWholeTurns(const SphericalSites& sites) {
  sphere::SphericalCore core(1);
  std::vector<SiteId> ids(sites.size());
  core.insertMany(flat(sites), ids);
  const sphere::ProjectedDiagram& diagram = core.projected();
  if (diagram.visibleCount() < 2) return;
  sphere::SphericalVertices vertices(diagram, sphere::SphericalVertices::Of::kAll);
  internal::FlatArray<sphere::Sector> sectors;
  for (const SiteId id : ids) {
    if (diagram.isHidden(id)) continue;
    listSectors(diagram, diagram.nodeOf(id), vertices, sectors);
    double turn = 0;
    for (const sphere::Sector& sector : sectors) {
      EXPECT_GE(sector.width, 0) << id;
      turn += sector.width;
    }
    EXPECT_NEAR(turn, 2 * kPi, 1e-9) << id;
  }
}

double sumOfAreas(const SphericalSites& sites) {
  std::vector<double> areas;
  EXPECT_EQ(diagramOf(sites).cellAreas({}, areas), Error::kNone);
  double sum = 0;
  for (const double area : areas) sum += area;
  return sum;
}

TEST(SphericalSectors, AreATurnAboutEachSite) {
  Random random(81);
  for (int round = 0; round < 4; ++round) {
    for (const NamedSites& set : namedSets(random, 10 + 20 * static_cast<std::size_t>(round))) {
      SCOPED_TRACE(set.name + ", round " + std::to_string(round));
      expectWholeTurns(set.sites);
    }
  }
}

TEST(SphericalSectors, AreATurnWhereManySitesTouchOneCap) {
  Random random(82);
  for (int round = 0; round < 200; ++round) {
    SCOPED_TRACE(round);
    SphericalSites sites;
    for (std::size_t k = 4 + random.below(std::size_t{14}); k > 0; --k) {
      const double x = std::floor(random.between(-12, 12)) * 15,
                   y = std::floor(random.between(-6, 7)) * 15;
      sites.push_back({x, std::min(y, 90.0), 0});
    }
    expectWholeTurns(sites);
  }
}

/// The third site's cell is a dot on the edge of two others, which goes all round except there.
TEST(SphericalSectors, OfAnEdgeThatADotInterruptsGoesRound) {
  for (const double dot : {1e-4, 1e-6, 1e-8}) {
    const SphericalSites sites = {{-90, 0, 0}, {90, 0, 0}, {0, 20, -kPi / 2 + dot}};
    std::vector<double> areas;
    ASSERT_EQ(diagramOf(sites).cellAreas({}, areas), Error::kNone);
    EXPECT_NEAR(areas[0], 2 * kPi, 2 * dot * dot + 1e-12);
    EXPECT_NEAR(areas[1], 2 * kPi, 2 * dot * dot + 1e-12);
    EXPECT_NEAR(sumOfAreas(sites), 4 * kPi, 1e-12);
    expectWholeTurns(sites);
  }
}

/// The turns of dots as small as rounding do not tell which sector goes round.
TEST(SphericalSectors, OfDotsAsSmallAsRoundingAddUp) {
  Random random(84);
  for (const double dot : {1e-13, 1e-14, 1e-15, 3e-16}) {
    for (int round = 0; round < 300; ++round) {
      SphericalSites sites = randomSites(random, 2, 0);
      if (round % 2 == 0) sites.push_back(randomSites(random, 1, 0.1)[0]);
      const SphericalPoint p = randomPoint(random);
      sites.push_back({p.lon, p.lat, dot - leastDistance(sites, p)});
      ASSERT_NEAR(sumOfAreas(sites), 4 * kPi, 1e-6) << dot << ", round " << round;
    }
  }
}

/// Found by search. Among sectors that are equally near up to rounding, the one with the least turn
/// goes round.
TEST(SphericalSectors, OfACrossOfDotsAddUp) {
  const SphericalSites sites = {{2.2957411708756297, -17.994067706249389, 0},
                                {62.222695953823603, 7.6341230832567932, 0},
                                {-41.390407476129042, 4.5787373322318672, -0.84876701120191178},
                                {44.187231769910454, 4.0427416215198733, -0.31929196313710095},
                                {44.187231770293636, 4.0427416215198733, -0.31929196313057817},
                                {44.187231769910454, 4.0427416213282816, -0.31929196313781577},
                                {44.187231769527273, 4.0427416209450984, -0.31929196314569369}};
  EXPECT_NEAR(sumOfAreas(sites), 4 * kPi, 5e-5);
}

/// Found by search. Sites that are some 10^-12 radians apart and on a lattice have edges without
/// length, on whose bisectors all sites of the cluster are nearest as far as rounding tells; or to
/// one side only.
TEST(SphericalSectors, OfEdgesWithoutLengthInATinyLatticeHaveNoWidth) {
  const SphericalSites sets[] = {
      {{46.201990812355739, 44.308099214233899, 0},
       {46.201990812400133, 44.308099214233899, 0},
       {46.201990812400133, 44.308099214145116, 0},
       {46.201990812311351, 44.308099214145116, 0},
       {46.201990812355739, 44.308099214189504, 0},
       {46.201990812311351, 44.308099214145116, 0},
       {46.201990812311351, 44.308099214233899, 0},
       {46.201990812400133, 44.308099214145116, 0},
       {46.201990812400133, 44.308099214233899, 0},
       {68.748684929245542, 4.7541035874439688, 0.031906877302334873}},
      {{-6.7817044817217402, 6.0511761898638543, 0},
       {-6.7817044817217402, 6.0511761898835612, 0},
       {-6.7817044817414471, 6.0511761898638543, 0},
       {-6.7817044817217402, 6.0511761898441483, 0},
       {-6.7817044817414471, 6.0511761898638543, 0},
       {-6.7817044817217402, 6.0511761898441483, 0},
       {-6.7817044817414471, 6.0511761898441483, 0},
       {-6.7817044817217402, 6.0511761898638543, 0},
       {115.04428890556858, -35.283403503502747, 0.0121208493494263}},
  };
  for (const SphericalSites& sites : sets) EXPECT_NEAR(sumOfAreas(sites), 4 * kPi, 1e-9);
}

/// Found by search. The bearing where two bisectors meet, and a vertex, are known the less the more
/// of a site is covered; the curves themselves tell more.
TEST(SphericalSectors, OfSitesThatAreNearlyCoveredAreAccurate) {
  const SphericalSites sets[] = {{{4.5535012171918368, 21.751652396360168, 0.45387949852076798},
                                  {163.97722916949476, 13.721679373721027, 0.59636229046116096},
                                  {-13.176343758213164, 30.590124105560019, 0.13679909832895013},
                                  {-2.869921749445183, 45.71222096511783, 0.022515761532779836},
                                  {-94.486089510386833, 36.189350905685806, -0.99117878689014671}},
                                 {{62.607654792316737, 59.096907364775781, 0.33477339792168426},
                                  {154.42760385650718, -4.5222784878557372, 0.92771633716383328},
                                  {101.43357454986869, -44.60951030754677, -0.13953351744221584},
                                  {62.595181732308674, -20.510351770338012, -0.645310035888226},
                                  {140.89633775995776, 43.557875669280165, 0.061924959841501516},
                                  {-120.00415665189081, 21.770624492147029, -0.60077398690990769},
                                  {98.630316433742735, -18.186394918189084, -0.043593140326287146},
                                  {115.75952783387237, 50.870901761872553, -0.19854784804928768}}};
  for (const SphericalSites& sites : sets) EXPECT_NEAR(sumOfAreas(sites), 4 * kPi, 1e-12);
}

/// Where a vertex is close to a site, its bearing is known the less, but not that of the meeting of
/// two bisectors.
TEST(SphericalSectors, OfSitesThatAreCloseToTheirVerticesAreAccurate) {
  Random random(83);
  for (int round = 0; round < 200; ++round) {
    const auto [lon, lat] = randomPoint(random);
    const double spread = std::pow(10, -random.between(6, 9));
    SphericalSites sites;
    for (int k = 0; k < 5; ++k)
      sites.push_back({lon + spread * random.between(-1, 1),
                       std::clamp(lat + spread * random.between(-1, 1), -90.0, 90.0), 0});
    EXPECT_NEAR(sumOfAreas(sites), 4 * kPi, 1e-11) << round;
  }
}

}  // namespace
}  // namespace apollonius::test
