// Histories of the sphere: whatever has happened, the diagram is that of the sites that are there.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <span>

#include "sphere/sphere_sets.h"
#include "support/effort.h"
#include "support/saved.h"

namespace apollonius::test {
namespace {

/// Compares sites by id, and areas up to rounding, with a fresh diagram; sites that are so close
/// that rounding tells which of them is visible are left out. Checks that of identical sites the
/// one with the least id is visible.
void expectLike(const SphericalDiagram& diagram, const std::map<SiteId, SphericalCircle>& sites) {
  Violation violation;
  ASSERT_EQ(diagram.validate(violation), Error::kNone);
  ASSERT_EQ(violation.text(), "");
  ASSERT_EQ(diagram.size(), sites.size());
  SphericalSites inOrder;
  for (const auto& [id, site] : sites) inOrder.push_back(site);
  const SphericalDiagram fresh = diagramOf(inOrder);
  ASSERT_EQ(diagram.visibleSize(), fresh.visibleSize());
  std::vector<double> areas, freshAreas;
  ASSERT_EQ(diagram.cellAreas({}, areas), Error::kNone);
  ASSERT_EQ(fresh.cellAreas({}, freshAreas), Error::kNone);
  std::size_t k = 0;
  for (const auto& [id, site] : sites) {
    SphericalCircle found = {};
    ASSERT_EQ(diagram.site(id, found), Error::kNone);
    EXPECT_EQ(found.lon, site.lon);
    EXPECT_EQ(found.r, site.r);
    const SphericalCircle& own = site;
    const auto isIdentical = [&](const SphericalCircle& other) {
      return other.lon == own.lon && other.lat == own.lat && other.r == own.r;
    };
    const bool isClose = std::ranges::any_of(inOrder, [&](const SphericalCircle& other) {
      return angleOf(other, own) < 1e-12 && other.r == own.r && !isIdentical(other);
    });
    if (!isClose) {
      EXPECT_NEAR(areas[id], freshAreas[k], 1e-10) << id;
    }
    const auto first = std::ranges::find_if(inOrder, isIdentical) - inOrder.begin();
    bool isHidden = false;
    ASSERT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
    EXPECT_TRUE(isHidden || first == static_cast<std::ptrdiff_t>(k)) << id;
    ++k;
  }
}

TEST(SphericalHistories, OfAllOperations) {
  Random random(7);
  for (const NamedSites& set : namedSets(random, sized(std::size_t{20}, std::size_t{40}))) {
    SCOPED_TRACE(set.name);
    SphericalDiagram diagram;
    std::map<SiteId, SphericalCircle> sites;
    const auto someId = [&] {
      return std::next(sites.begin(), static_cast<std::ptrdiff_t>(random.below(sites.size())))
          ->first;
    };
    const auto someSite = [&] { return set.sites[random.below(set.sites.size())]; };
    for (int step = 0; step < 200; ++step) {
      const std::size_t what = sites.empty() ? 0 : random.below(10);
      if (what < 4) {
        const SphericalCircle site = someSite();
        SiteId id = kNoSite;
        ASSERT_EQ(diagram.insert(site.lon, site.lat, site.r, id), Error::kNone);
        ASSERT_FALSE(sites.contains(id));
        sites[id] = site;
      } else if (what == 4) {
        SphericalSites more;
        for (int k = 0; k < 5; ++k) more.push_back(someSite());
        std::vector<SiteId> ids(more.size());
        ASSERT_EQ(diagram.insertMany(flat(more), ids), Error::kNone);
        for (std::size_t k = 0; k < ids.size(); ++k) sites[ids[k]] = more[k];
      } else if (what < 7) {
        // One at random, or the heaviest.
        const auto isLighter = [](const auto& a, const auto& b) { return a.second.r < b.second.r; };
        const SiteId id = what == 5 ? someId() : std::ranges::max_element(sites, isLighter)->first;
        bool removed = false;
        ASSERT_EQ(diagram.remove(id, removed), Error::kNone);
        ASSERT_TRUE(removed);
        sites.erase(id);
      } else if (what == 7) {
        std::vector<SiteId> ids = {someId(), someId(), 1234567, someId()};
        ids.push_back(ids[0]);
        std::size_t removed = 0, expected = 0;
        for (const SiteId id : ids) expected += sites.erase(id);
        ASSERT_EQ(diagram.removeMany(ids, removed), Error::kNone);
        ASSERT_EQ(removed, expected);
      } else if (what == 8) {
        const SiteId id = someId();
        sites[id] = someSite();
        ASSERT_EQ(diagram.update(id, sites[id].lon, sites[id].lat, sites[id].r), Error::kNone);
      } else {
        std::vector<SiteId> ids;
        SphericalSites moved;
        for (int k = 0; k < 4; ++k) {
          ids.push_back(someId());
          moved.push_back(someSite());
          sites[ids.back()] = moved.back();
        }
        ASSERT_EQ(diagram.updateMany(ids, flat(moved)), Error::kNone);
      }
      if (step % 20 == 0 || step > 190) expectLike(diagram, sites);
    }
    diagram.clear();
    EXPECT_EQ(diagram.size(), 0u);
    expectLike(diagram, {});
  }
}

TEST(SphericalHistories, TheHeaviestIsRemovedAgainAndAgain) {
  Random random(8);
  SphericalSites sites = randomSites(random, 300, 1.5);
  SphericalDiagram diagram = diagramOf(sites);
  std::map<SiteId, SphericalCircle> left;
  for (SiteId id = 0; id < sites.size(); ++id) left[id] = sites[id];
  while (!left.empty()) {
    const auto heaviest = std::ranges::max_element(
        left, [](const auto& a, const auto& b) { return a.second.r < b.second.r; });
    bool removed = false;
    ASSERT_EQ(diagram.remove(heaviest->first, removed), Error::kNone);
    left.erase(heaviest);
    if (left.size() % 23 == 0) expectLike(diagram, left);
  }
}

TEST(SphericalHistories, ManyMovesAtOnceBuildThePlaneAnew) {
  Random random(9);
  SphericalSites sites = randomSites(random, sized(std::size_t{1000}, std::size_t{3000}), 0.01);
  SphericalDiagram diagram = diagramOf(sites);
  for (int round = 0; round < 4; ++round) {
    std::vector<SiteId> ids;
    SphericalSites moved;
    for (SiteId id = 0; id < sites.size(); ++id) {
      if (random.below(10) < 9) ids.push_back(id);
    }
    for (const SiteId id : ids) moved.push_back(sites[id] = randomSites(random, 1, 0.01)[0]);
    ASSERT_EQ(diagram.updateMany(ids, flat(moved)), Error::kNone);
    Violation violation;
    ASSERT_EQ(diagram.validate(violation), Error::kNone);
    ASSERT_EQ(violation.text(), "");
    for (int k = 0; k < 100; ++k) {
      const SphericalPoint p = randomPoint(random);
      SiteId id = kNoSite;
      ASSERT_EQ(diagram.find(p.lon, p.lat, id), Error::kNone);
      EXPECT_LE(distanceOf(p, sites[id]), leastDistance(sites, p) + 2e-15);
    }
  }
}

TEST(SphericalHistories, LongitudesAreWrapped) {
  const SphericalDiagram diagram =
      diagramOf({{370, 5, 0}, {-170, 0, 0}, {100000 * 360.0 + 45, 0, 0}});
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.find(10, 5, id), Error::kNone);
  EXPECT_EQ(id, 0u);
  ASSERT_EQ(diagram.find(190 + 720, 0, id), Error::kNone);
  EXPECT_EQ(id, 1u);
  double distance = 1;
  ASSERT_EQ(diagram.find(45, 0, id, distance), Error::kNone);
  EXPECT_EQ(id, 2u);
  EXPECT_EQ(distance, 0);
}

TEST(SphericalHistories, LongitudesAreReducedWithoutRounding) {
  for (const double lon : {370.1, -533.3, 360 * 1000 + 0.1, -360 * 12345.0 - 77.7, 1e12 + 0.3}) {
    const SphericalDiagram diagram = diagramOf({{std::remainder(lon, 360), 5, 0}, {0, -60, 0}});
    SiteId id = kNoSite;
    double distance = 1;
    ASSERT_EQ(diagram.find(lon, 5, id, distance), Error::kNone);
    EXPECT_EQ(id, 0u);
    EXPECT_EQ(distance, 0) << lon;
  }
}

/// Expects equal hidden sites.
void expectSameHidden(const SphericalDiagram& diagram, const SphericalDiagram& other) {
  std::vector<SiteId> ids;
  ASSERT_EQ(diagram.ids(ids), Error::kNone);
  for (const SiteId id : ids) {
    bool isHidden = false, isOtherHidden = false;
    ASSERT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
    ASSERT_EQ(other.isHidden(id, isOtherHidden), Error::kNone);
    ASSERT_EQ(isHidden, isOtherHidden) << id;
  }
}

TEST(SphericalHistories, SnapshotsKeepWhichOfIdenticalSitesIsVisible) {
  // Duplicates, among them poles with different longitudes. Sites that become visible later are the
  // same, too.
  Random random(11);
  for (int history = 0; history < 200; ++history) {
    SCOPED_TRACE(history);
    SphericalDiagram diagram, restored;
    const auto change = [&](SphericalDiagram& changed, Random same) {
      if (same.below(3) == 0 && changed.size() > 0) {
        std::vector<SiteId> ids;
        ASSERT_EQ(changed.ids(ids), Error::kNone);
        bool removed = false;
        ASSERT_EQ(changed.remove(ids[same.below(ids.size())], removed), Error::kNone);
      } else {
        const double lon = 60.0 * static_cast<double>(same.below(6)) - 180;
        const double lat = 45.0 * static_cast<double>(same.below(5)) - 90;
        const double r = 0.4 * static_cast<double>(same.below(4));
        SiteId id = kNoSite;
        ASSERT_EQ(changed.insert(lon, lat, r, id), Error::kNone);
      }
    };
    for (int step = 0; step < 60; ++step) change(diagram, Random(random.next()));
    ASSERT_EQ(restored.fromBytes(saved(diagram)), Error::kNone);
    EXPECT_EQ(saved(restored), saved(diagram));
    expectSameHidden(diagram, restored);
    for (int step = 0; step < 20; ++step) {
      const std::uint64_t seed = random.next();
      change(diagram, Random(seed));
      change(restored, Random(seed));
      expectSameHidden(diagram, restored);
    }
  }
}

TEST(SphericalHistories, SnapshotsGiveTheSameDiagram) {
  Random random(10);
  for (const NamedSites& set : namedSets(random, 50)) {
    SCOPED_TRACE(set.name);
    SphericalDiagram diagram = diagramOf(set.sites), restored;
    for (SiteId id = 1; id < set.sites.size(); id += 3) {
      bool removed = false;
      ASSERT_EQ(diagram.remove(id, removed), Error::kNone);
    }
    const std::vector<std::uint8_t> bytes = saved(diagram);
    ASSERT_EQ(restored.fromBytes(bytes), Error::kNone);
    EXPECT_EQ(saved(restored), bytes);
    expectSameHidden(diagram, restored);
    for (int k = 0; k < 10; ++k) {
      const auto [lon, lat] = randomPoint(random);
      SiteId id = kNoSite, other = kNoSite;
      ASSERT_EQ(diagram.insert(lon, lat, 0, id), Error::kNone);
      ASSERT_EQ(restored.insert(lon, lat, 0, other), Error::kNone);
      EXPECT_EQ(id, other);
    }
    // Every damage is seen, as is a false length.
    for (int k = 0; k < 200; ++k) {
      std::vector<std::uint8_t> damaged = bytes;
      damaged[random.below(damaged.size())] ^= static_cast<std::uint8_t>(1 + random.below(255));
      EXPECT_EQ(restored.fromBytes(damaged), Error::kCorruptSnapshot);
    }
    for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 8)
      EXPECT_EQ(restored.fromBytes(std::span(bytes).first(size)), Error::kCorruptSnapshot);
  }
}

}  // namespace
}  // namespace apollonius::test
