// The cost of hidden sites, counted in questions to the predicates: removing the visible one of
// many nested sites, covering and uncovering, and asking around a point. Sizes n and 2n: what grows
// with n in each step would be quadratic in all.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "delaunay/diagram_breaker.h"
#include "diagram/diagram_core.h"
#include "diagram/queries.h"
#include "diagram/validate.h"
#include "support/effort.h"
#include "support/generators.h"
#include "support/questions.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

constexpr double kAnywhere = std::numeric_limits<double>::infinity();

using test::Circles;
using test::questions;
using test::Random;
using test::runs;

/// Counts the questions that a run asks.
double questionsOf(const std::function<void()>& run) {
  const double before = questions();
  run();
  return questions() - before;
}

void insertAll(DiagramCore& core, const Circles& circles) {
  for (const Circle& c : circles) core.insert({c.x, c.y, c.r});
}

SiteId anyVisible(const DiagramCore& core) { return core.siteOf(core.delaunay().anyVisible()); }

/// Most children of a site in the forest.
std::size_t mostChildren(DiagramCore& core) {
  std::size_t most = 0;
  const HiddenForest& forest = DiagramBreaker::hidden(core);
  for (Slot slot = 0; slot < core.ids().slots(); ++slot) {
    std::size_t count = 0;
    for (Slot child = forest.firstChild(slot); child != HiddenForest::kNone;
         child = forest.nextSibling(child))
      ++count;
    most = std::max(most, count);
  }
  return most;
}

Circles shuffled(Circles circles) {
  Random random(circles.size());
  random.shuffle(circles);
  return circles;
}

struct Family {
  const char* name;
  std::function<Circle(std::size_t)> circle;  // the k-th, from the smallest
};

const std::array<Family, 3>& nested() {
  static const std::array<Family, 3> families{{
      {"Duplicates", [](std::size_t) { return Circle{1, 2, 3}; }},
      {"Concentric", [](std::size_t k) { return Circle{1, 2, static_cast<double>(k)}; }},
      {"TangentInside",
       [](std::size_t k) { return Circle{static_cast<double>(k), 0, static_cast<double>(k)}; }},
  }};
  return families;
}

Circles made(const Family& family, std::size_t n) {
  Circles circles;
  for (std::size_t k = 1; k <= n; ++k) circles.push_back(family.circle(k));
  return circles;
}

TEST(HiddenWork, RemovingTheVisibleOneOfNestedSitesUntilNoneIsLeft) {
  for (const Family& family : nested()) {
    for (const bool isShuffled : {false, true}) {
      SCOPED_TRACE(std::string(family.name) + (isShuffled ? " shuffled" : " growing"));
      std::array<double, 2> work{};
      for (const int twice : {0, 1}) {
        const auto n = static_cast<std::size_t>(runs(4000)) << twice;
        const Circles circles = made(family, n);
        DiagramCore core(Location::kHierarchy);
        const double inserting =
            questionsOf([&] { insertAll(core, isShuffled ? shuffled(circles) : circles); });
        EXPECT_LT(inserting, (6 + 2 * std::log2(n)) * static_cast<double>(n));
        EXPECT_LE(mostChildren(core), 2u);
        ASSERT_EQ(validate(core).text(), "");
        work[twice] = questionsOf([&] {
          for (std::size_t left = n; left > 0; --left) {
            ASSERT_EQ(core.visibleCount(), 1u);
            ASSERT_EQ(core.site(core.ids().slotOf(anyVisible(core))).r, circles[left - 1].r)
                << "the largest";
            ASSERT_TRUE(core.remove(anyVisible(core)));
            if (left == n / 2) {
              EXPECT_EQ(validate(core).text(), "");
            }
          }
        });
        EXPECT_EQ(core.ids().size(), 0u);
        EXPECT_LT(work[twice], (4 + 3 * std::log2(n)) * static_cast<double>(n));
      }
      EXPECT_LT(work[1], 2.5 * work[0] + 100);
    }
  }
}

TEST(HiddenWork, RemovingNestedSitesInAnyOrderAndAllAtOnce) {
  for (const Family& family : nested()) {
    SCOPED_TRACE(family.name);
    const auto n = static_cast<std::size_t>(runs(6000));
    for (const bool atOnce : {false, true}) {
      DiagramCore core(Location::kHierarchy);
      insertAll(core, shuffled(made(family, n)));
      std::vector<SiteId> ids(n);
      std::iota(ids.begin(), ids.end(), SiteId{0});
      Random random(7);
      if (!atOnce) random.shuffle(ids);
      const double work = questionsOf([&] {
        if (atOnce) {
          EXPECT_EQ(core.removeMany(ids), n);
          return;
        }
        for (std::size_t k = 0; k < n; ++k) {
          EXPECT_TRUE(core.remove(ids[k]));
          if (k == n / 2) {
            EXPECT_LE(mostChildren(core), 2u);
          }
        }
      });
      EXPECT_LT(work, (4 + 3 * std::log2(n)) * static_cast<double>(n));
      EXPECT_EQ(core.ids().size(), 0u);
    }
  }
}

// The visible one of many duplicates goes away and comes back, again and again.
TEST(HiddenWork, UpdatesOfTheVisibleDuplicate) {
  const auto n = static_cast<std::size_t>(runs(4000));
  DiagramCore core(Location::kHierarchy);
  insertAll(core, made(nested()[0], n));
  const Site home = core.site(0);
  const double work = questionsOf([&] {
    for (std::size_t k = 0; k < n; ++k) {
      const SiteId id = core.siteOf(vertexOf(core.nearest(home.x, home.y)));
      core.update(id, {home.x + 100, home.y, home.r});
      core.update(id, home);
    }
  });
  EXPECT_LT(work, 40 * static_cast<double>(n));
  EXPECT_EQ(core.visibleCount(), 1u);
  EXPECT_EQ(validate(core).text(), "");
}

// Each family gets a tree of its own when the giant over them goes: all removals together stay
// within n log n.
TEST(HiddenWork, RemovingTheVisibleSitesOfNestedFamiliesUntilNoneIsLeft) {
  std::array<double, 2> work{};
  for (const int twice : {0, 1}) {
    Random random(17);
    const auto each = static_cast<std::size_t>(runs(400)) << twice;
    Circles circles;
    for (std::size_t k = 1; k <= each; ++k) {
      for (std::size_t family = 0; family < 10; ++family) {
        Circle c = nested()[family % 3].circle(k);
        c.x += static_cast<double>(4 * each * family);
        circles.push_back(c);
      }
    }
    random.shuffle(circles);
    circles.insert(circles.begin(), {0, 0, 100.0 * static_cast<double>(each)});
    DiagramCore core(Location::kHierarchy);
    insertAll(core, circles);
    ASSERT_EQ(core.visibleCount(), 1u);
    work[twice] = questionsOf([&] {
      ASSERT_TRUE(core.remove(0));
      EXPECT_EQ(core.visibleCount(), 10u);
      EXPECT_EQ(validate(core).text(), "");
      while (core.visibleCount() > 0) ASSERT_TRUE(core.remove(anyVisible(core)));
    });
    EXPECT_EQ(core.ids().size(), 0u);
  }
  EXPECT_LT(work[1], 2.6 * work[0]);
}

/// Small circles apart from each other.
Circles disjoint(std::size_t m) {
  Circles circles;
  for (std::size_t k = 0; k < m; ++k) {
    circles.push_back(
        {static_cast<double>(k % 50 * 10), static_cast<double>(k / 50 * 10 + k % 7), 1});
  }
  return circles;
}

TEST(HiddenWork, UncoveringAGiantBelowAGiantDoesNotAskWhatThatOneHides) {
  const auto m = static_cast<std::size_t>(runs(3000));
  DiagramCore core(Location::kHierarchy);
  insertAll(core, disjoint(m));
  const std::size_t visible = core.visibleCount();
  std::vector<SiteId> giants;
  for (int k = 0; k < 200; ++k) giants.push_back(core.insert({0, 0, 1e5 + k}));
  EXPECT_EQ(core.visibleCount(), 1u);
  for (std::size_t k = giants.size(); k-- > 1;) {
    EXPECT_LT(questionsOf([&] { ASSERT_TRUE(core.remove(giants[k])); }), 10);
    EXPECT_EQ(core.visibleCount(), 1u);
  }
  const double work = questionsOf([&] {
    for (int k = 0; k < 1000; ++k) ASSERT_TRUE(core.remove(core.insert({0, 0, 2e5})));
  });
  EXPECT_LT(work, 10000);
  EXPECT_EQ(validate(core).text(), "");
  ASSERT_TRUE(core.remove(giants[0]));
  EXPECT_EQ(core.visibleCount(), visible);
  EXPECT_EQ(validate(core).text(), "");
}

TEST(HiddenWork, AGiantThatManyWereHungOnUncoversThem) {
  const auto m = static_cast<std::size_t>(runs(3000));
  DiagramCore core(Location::kHierarchy);
  const SiteId giant = core.insert({0, 0, 1e5});
  insertAll(core, shuffled(disjoint(m)));
  EXPECT_EQ(core.visibleCount(), 1u);
  ASSERT_TRUE(core.remove(giant));
  EXPECT_EQ(core.visibleCount(), m);
  EXPECT_EQ(validate(core).text(), "");
}

TEST(HiddenWork, AroundAPointInNestedSites) {
  constexpr std::size_t kAnswer = 10;
  for (const Family& family : nested()) {
    SCOPED_TRACE(family.name);
    std::array<double, 2> nearest{}, within{};
    for (const int twice : {0, 1}) {
      const auto n = static_cast<std::size_t>(runs(4000)) << twice;
      DiagramCore core(Location::kHierarchy);
      insertAll(core, shuffled(made(family, n)));
      std::vector<SiteId> sites;
      // Left of where all touch, so that circles differ in their distance.
      nearest[twice] = questionsOf([&] { listNearby(core, -7, 40, kAnswer, kAnywhere, sites); });
      EXPECT_EQ(sites.size(), kAnswer);
      const Site& last = core.site(core.ids().slotOf(sites.back()));
      const double distance =
          std::sqrt((last.x + 7) * (last.x + 7) + (last.y - 40) * (last.y - 40)) - last.r;
      // In `within` each site that is looked at is a question: at most two for each in the answer.
      if (family.circle(1).r == family.circle(2).r) continue;  // all are as far
      within[twice] = questionsOf([&] { listNearby(core, -7, 40, n, distance, sites); });
      EXPECT_GE(sites.size() + 1, kAnswer);
      EXPECT_LE(sites.size(), kAnswer + 2);
      EXPECT_LT(within[twice], 20 * kAnswer);
    }
    EXPECT_LT(nearest[1], 20 * kAnswer);
    EXPECT_LT(within[1], 20 * kAnswer);
  }
}

// Among sites that are equally far a parent comes before its children, as it should: all circles
// touch on this line.
TEST(HiddenWork, EquallyFarNestedSitesComeLargestFirst) {
  const std::size_t n = 300;
  DiagramCore core(Location::kHierarchy);
  insertAll(core, shuffled(made(nested()[2], n)));
  for (const double x : {0.0, -5.0}) {
    std::vector<SiteId> sites;
    listNearby(core, x, 0, n, kAnywhere, sites);
    ASSERT_EQ(sites.size(), n);
    for (std::size_t k = 0; k < n; ++k)
      EXPECT_EQ(core.site(core.ids().slotOf(sites[k])).r, static_cast<double>(n - k));
  }
}

}  // namespace
}  // namespace apollonius::internal
