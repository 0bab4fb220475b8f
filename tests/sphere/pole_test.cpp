// The site from which all are projected (src/sphere/pole_choice.h), when another one is chosen, and
// the state that is kept beside the plane's diagram when that is rebuilt.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "sphere/pole_choice.h"
#include "sphere/projection.h"
#include "sphere/sphere_sets.h"
#include "sphere/spherical_core.h"

namespace apollonius::test {
namespace {

namespace sphere = internal::sphere;

sphere::SphericalCore coreOf(const SphericalSites& sites) {
  sphere::SphericalCore core(1);
  std::vector<SiteId> ids(sites.size());
  core.insertMany(flat(sites), ids);
  return core;
}

SiteId poleOf(const sphere::SiteTable& sites, std::uint64_t& seed) {
  const internal::FlatArray<sphere::Cap> caps = sites.caps();
  sphere::PoleChoice choice(sites, caps, seed);
  while (!choice.advance(7)) {
  }
  return choice.pole();
}

/// Seen from the giant, or from the site that it nearly covers, a circle is inaccurate. All but one
/// of the others lead to the giant.
TEST(SphericalPole, ASiteWithoutLossIsFoundAmongManyThatLeadToAGiant) {
  Random random(61);
  SphericalSites sites = {{0, 0, 1}, {30, 0, 1 - std::numbers::pi / 6 + 1e-9}, {180, 0, 0}};
  for (int k = 0; k < 200; ++k)
    sites.push_back({random.between(-30, 30), random.between(-30, 30), 0});
  sphere::SiteTable table(1);
  table.reserve(sites.size());
  for (const SphericalCircle& site : sites) (void)table.take({{site.lon, site.lat}, site.r});
  for (std::uint64_t first = 1; first <= 20; ++first) {
    std::uint64_t seed = first;
    EXPECT_EQ(poleOf(table, seed), 2u);
  }
}

/// Does no other site hide it, as far as the projection from it can tell?
bool isVisible(const sphere::SiteTable& sites, SiteId id) {
  const sphere::Projection projection(sites.cap(id));
  for (SiteId other = 0; other < sites.idLimit(); ++other) {
    if (sites.has(other) && other != id &&
        projection.image(sites.cap(other)).kind == sphere::Projection::Kind::kCoversPole)
      return false;
  }
  return true;
}

/// Any two weights are less than a full turn apart, and distances from a site's centre, too.
TEST(SphericalPole, IsVisibleAmongWeightsOfAnySize) {
  Random random(62);
  for (int round = 0; round < 300; ++round) {
    sphere::SiteTable table(1);
    const std::size_t n = 2 + random.below(std::size_t{8});
    table.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
      const auto [lon, lat] = randomPoint(random);
      const double r = random.between(-1, 1);
      (void)table.take({{lon, lat}, (random.below(3) == 0 ? r : r < 0 ? -1 : 1) * 3.14159});
    }
    std::uint64_t seed = 1;
    EXPECT_TRUE(isVisible(table, poleOf(table, seed)));
  }
}

/// A site that the pole covers up to 10^-9 radians would have a circle that is hardly known.
class ASiteThatThePoleNearlyCovers : public testing::Test {
 protected:
  ASiteThatThePoleNearlyCovers() : core_(coreOf(sites())), pole_(core_.projected().pole()) {}

  static SphericalSites sites() {
    Random random(63);
    return randomSites(random, 20, 0.1);
  }
  [[nodiscard]] SphericalCircle covered(double latitudes) const {
    const auto& [centre, r] = core_.sites()[pole_];
    const SphericalCircle there = {centre.lon, centre.lat + (centre.lat > 0 ? -1 : 1) * latitudes,
                                   0};
    return {there.lon, there.lat, r - angleOf(there, {centre.lon, centre.lat, 0}) + 1e-9};
  }
  void expectAnotherPole() const {
    EXPECT_NE(core_.projected().pole(), pole_);
    EXPECT_LE(core_.projected().loss(), sphere::kUsualLoss);
    EXPECT_EQ(core_.validate().what, nullptr);
  }

  sphere::SphericalCore core_;
  SiteId pole_;
};

TEST_F(ASiteThatThePoleNearlyCovers, IsInserted) {
  const auto [lon, lat, r] = covered(5);
  (void)core_.insert({{lon, lat}, r});
  expectAnotherPole();
}

TEST_F(ASiteThatThePoleNearlyCovers, IsInsertedWithAnother) {
  std::vector<SiteId> ids(2);
  core_.insertMany(flat({covered(5), covered(10)}), ids);
  expectAnotherPole();
}

TEST_F(ASiteThatThePoleNearlyCovers, HasBeenMovedThere) {
  const auto [lon, lat, r] = covered(5);
  core_.update(pole_ == 0 ? 1 : 0, {{lon, lat}, r});
  expectAnotherPole();
}

TEST_F(ASiteThatThePoleNearlyCovers, HasBeenMovedThereWithAnother) {
  std::vector<SiteId> ids;
  for (SiteId id = 0; ids.size() < 2; ++id) {
    if (id != pole_) ids.push_back(id);
  }
  core_.updateMany(ids, flat({covered(5), covered(10)}));
  expectAnotherPole();
}

TEST(SphericalPole, AnotherIsTakenWhereOneSiteHasBeenMovedOverIt) {
  Random random(65);
  sphere::SphericalCore core = coreOf(randomSites(random, 30, 0));
  const SiteId pole = core.projected().pole();
  core.update(pole == 0 ? 1 : 0, {core.sites()[pole].centre, 0.5});
  EXPECT_NE(core.projected().pole(), pole);
  EXPECT_TRUE(core.projected().isHidden(pole));
  EXPECT_EQ(core.validate().what, nullptr);
}

TEST(SphericalPole, CapsFollowTheirSitesWhereThePlaneIsBuiltAnew) {
  Random random(64);
  sphere::SphericalCore core = coreOf(randomSites(random, 400, 0.05));
  const SiteId pole = core.projected().pole();
  std::vector<SiteId> ids;
  for (SiteId id = 0; id < 400; id += 2) {
    if (id != pole) ids.push_back(id);
  }
  // One that the pole covers has none, nor has one that is no more.
  (void)core.insert({core.sites()[pole].centre, -1});
  const SiteId removed = pole == 1 ? 3 : 1;
  ASSERT_EQ(core.removeMany({&removed, 1}), 1u);
  ASSERT_EQ(core.projected().pole(), pole);
  ASSERT_EQ(core.projected().belowPole().size(), 1u);
  const std::uint32_t layout = core.projected().plane().layout();
  core.updateMany(ids, flat(randomSites(random, ids.size(), 0.05)));
  ASSERT_EQ(core.projected().pole(), pole);
  ASSERT_NE(core.projected().plane().layout(), layout);
  EXPECT_EQ(core.validate().what, nullptr);
}

}  // namespace
}  // namespace apollonius::test
