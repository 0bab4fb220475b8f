// pick(), search() and NearestFirst against the oracle's distances, one by one for all sites: what
// a pointer or a window meets, rims and border included, hidden ones too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "apollonius/nearest_first.h"
#include "apollonius/predicate_counts.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/oracle.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

constexpr double kAnywhere = std::numeric_limits<double>::infinity();

struct Rectangle {
  double xmin, ymin, xmax, ymax;
};

class Picking {
 public:
  explicit Picking(const Circles& circles) : circles_(circles) {
    for (const Circle& c : circles) {
      SiteId id = kNoSite;
      EXPECT_EQ(diagram_.insert(c.x, c.y, c.r, id), Error::kNone);
    }
  }

  [[nodiscard]] const Diagram& diagram() const { return diagram_; }

  [[nodiscard]] bool contains(SiteId id, double x, double y) const {
    // Doubles tell nearly all from afar.
    const Circle& c = circles_[id];
    const double length = std::sqrt((c.x - x) * (c.x - x) + (c.y - y) * (c.y - y));
    if (std::abs(length - c.r) > 1e-12 * (length + std::abs(c.r))) return length < c.r;
    return oracleCompareDistance(x, y, c, {x, y, 0}) <= 0;
  }

  [[nodiscard]] SiteId expectedPick(double x, double y, double farthest, Top top) const {
    SiteId best = kNoSite;
    for (SiteId id = 0; id < circles_.size(); ++id) {
      if (!contains(id, x, y)) continue;
      if (best == kNoSite || top == Top::kLast || isAbove(id, best, x, y)) best = id;
    }
    if (best != kNoSite || circles_.empty()) return best;
    const auto nearest = static_cast<SiteId>(oracleNearest(circles_, x, y));
    const bool isNear = farthest == kAnywhere ||
                        oracleCompareDistance(x, y, circles_[nearest], {x, y, -farthest}) <= 0;
    return isNear ? nearest : kNoSite;
  }

  void checkPick(double x, double y, double farthest) {
    for (const Top top : {Top::kSmallest, Top::kLast}) {
      SiteId id = 77;
      ASSERT_EQ(diagram_.pick(x, y, farthest, top, id), Error::kNone);
      ASSERT_EQ(id, expectedPick(x, y, farthest, top)) << x << ' ' << y << " within " << farthest;
    }
  }

  void checkSearch(const Rectangle& w) {
    std::vector<SiteId> found, expected;
    ASSERT_EQ(diagram_.search(w.xmin, w.ymin, w.xmax, w.ymax, found), Error::kNone);
    for (SiteId id = 0; id < circles_.size(); ++id) {
      const Circle& c = circles_[id];
      if (contains(id, std::clamp(c.x, w.xmin, w.xmax), std::clamp(c.y, w.ymin, w.ymax)))
        expected.push_back(id);
    }
    ASSERT_EQ(found, expected) << w.xmin << ' ' << w.ymin << ' ' << w.xmax << ' ' << w.ymax;
  }

  void checkNearestFirst(double x, double y, double farthest) {
    std::vector<SiteId> expected, found;
    if (farthest == kAnywhere) {
      ASSERT_EQ(diagram_.kNearest(x, y, circles_.size(), expected), Error::kNone);
    } else {
      ASSERT_EQ(diagram_.within(x, y, farthest, expected), Error::kNone);
    }
    NearestFirst walk(diagram_);
    ASSERT_EQ(walk.start(x, y, farthest), Error::kNone);
    SiteId id = kNoSite;
    for (;;) {
      ASSERT_EQ(walk.next(id), Error::kNone);
      if (id == kNoSite) break;
      found.push_back(id);
      // the distance of the call for one nearest site, whose sign is that of the oracle's
      ASSERT_EQ(walk.distance() <= 0, contains(id, x, y)) << id;
      Diagram one;
      SiteId only = kNoSite;
      double distance = 0;
      const Circle& circle = circles_[id];
      ASSERT_EQ(one.insert(circle.x, circle.y, circle.r, only), Error::kNone);
      ASSERT_EQ(one.find(x, y, only, distance), Error::kNone);
      ASSERT_EQ(walk.distance(), distance);
    }
    ASSERT_EQ(found, expected);
    ASSERT_EQ(walk.distance(), kAnywhere);
  }

 private:
  /// Is the first one smaller than the other, or as large and nearer?
  [[nodiscard]] bool isAbove(SiteId a, SiteId b, double x, double y) const {
    const Circle &c = circles_[a], &d = circles_[b];
    if (c.r != d.r) return c.r < d.r;
    const int sign = oracleCompareDistance(x, y, c, d);
    return sign < 0 || (sign == 0 && oracleSmaller(d, c));
  }

  Circles circles_;
  Diagram diagram_;
};

double legal(double value) { return isInRange(value) ? value : 0; }

/// Numbers of the sites, their rims, and sums of them: where it is hard.
double hardNumber(Random& random, const Circles& circles, bool isX) {
  const Circle &a = circles[random.below(circles.size())],
               &b = circles[random.below(circles.size())];
  const double p = isX ? a.x : a.y, q = isX ? b.x : b.y;
  switch (random.below(5)) {
    case 0:
      return p;
    case 1:
      return legal(p + a.r);
    case 2:
      return legal(p - a.r);
    case 3:
      return legal((p + q) / 2);
    default:
      return legal(2 * p - q);
  }
}

Rectangle hardWindow(Random& random, const Circles& circles) {
  const double a = hardNumber(random, circles, true), b = hardNumber(random, circles, true);
  const double c = hardNumber(random, circles, false), d = hardNumber(random, circles, false);
  const bool isSegment = random.below(4) == 0;
  return {std::min(a, b), std::min(c, d), isSegment ? std::min(a, b) : std::max(a, b),
          std::max(c, d)};
}

void checkAtHardPlaces(Random& random, const Circles& circles, int places) {
  Picking picking(circles);
  for (int k = 0; k < places; ++k) {
    const double x = hardNumber(random, circles, true), y = hardNumber(random, circles, false);
    const double farthest = legal(std::abs(x - circles[random.below(circles.size())].x));
    picking.checkPick(x, y, k % 3 == 0 ? kAnywhere : k % 3 == 1 ? 0 : farthest);
    picking.checkSearch(hardWindow(random, circles));
    picking.checkNearestFirst(x, y, k % 2 == 0 ? kAnywhere : farthest);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

TEST(Pick, AgreesWithTheOracleOnTinyGrids) {
  Random random(451);
  for (int run = 0; run < runs(1500); ++run) {
    const int side = static_cast<int>(random.integer(1, 6));
    const int heaviest = random.below(5);
    Circles circles = tinyGrid(random, 1 + random.below(std::size_t{14}), side, heaviest);
    if (run % 3 == 0) {
      for (Circle& c : circles) c.r -= 2;  // negative ones, which contain nothing
    }
    checkAtHardPlaces(random, circles, 8);
    if (HasFatalFailure()) FAIL() << "run " << run;
  }
}

class PickOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(PickOn, AgreesWithTheOracle) {
  Random random(452);
  const Circles circles = GetParam().make(random, GetParam().large ? 100 : 15);
  checkAtHardPlaces(random, circles, runs(GetParam().large ? 20 : 10));
}

INSTANTIATE_TEST_SUITE_P(Corpus, PickOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Pick, TheSmallestOrTheLast) {
  Picking picking({{0, 0, 5}, {1, 0, 2}, {0, 1, 2}, {0, 0, 9}, {20, 0, 1}});
  const auto at = [&](double x, double y, double farthest, Top top) {
    SiteId id = kNoSite;
    EXPECT_EQ(picking.diagram().pick(x, y, farthest, top, id), Error::kNone);
    return id;
  };
  EXPECT_EQ(at(0.25, 0.75, 0, Top::kSmallest), 2u) << "of two small ones the nearest";
  EXPECT_EQ(at(0.75, 0.25, 0, Top::kSmallest), 1u) << "of two small ones the nearest";
  EXPECT_EQ(at(0.5, 0.5, 0, Top::kLast), 3u);
  EXPECT_EQ(at(-4, 0, 0, Top::kSmallest), 0u);
  EXPECT_EQ(at(18, 0, 1, Top::kSmallest), 4u) << "outside, at that very distance";
  EXPECT_EQ(at(18, 0, 0.5, Top::kSmallest), kNoSite);
  EXPECT_EQ(at(1000, 0, kAnywhere, Top::kSmallest), 4u);
}

TEST(Search, LongAndLargeWindowsOfManySites) {
  Random random(453);
  for (const Hidden hidden : {Hidden::kNone, Hidden::k20Percent, Hidden::k95Percent}) {
    const Circles circles = randomCircles(random, sized(800u, 2000u), hidden);
    Picking picking(circles);
    for (int k = 0; k < runs(3); ++k) {
      const double x = random.between(-1e6, 1e6), y = random.between(-1e6, 1e6);
      for (const Rectangle& w :
           {Rectangle{-1e6, y, 1e6, y}, Rectangle{x, -1e100, x, 1e100},
            Rectangle{x, y, x + 3e5, y + 2e5}, Rectangle{x, y, x + 1e6, y + 10},
            Rectangle{-1e100, -1e100, 1e100, 1e100}, Rectangle{1e7, y, 1e9, 1e9}}) {
        picking.checkSearch(w);
        if (HasFatalFailure()) return;
      }
    }
  }
}

/// Circles that nearly touch a segment, for which cutting it never helps.
TEST(Search, EndsWhereManyAreNextToTheWindowEverywhere) {
  Circles circles;
  for (int k = 0; k < 200; ++k) circles.push_back({0.5, 1 + k * 0x1p-44, 1 - 0x1p-50});
  Picking picking(circles);
  picking.checkSearch({0, 0, 1, 0});
  picking.checkSearch({0, 0x1p-50, 1, 0x1p-50});
  picking.checkSearch({0.5, -1, 0.5, 0});
  picking.checkSearch({-1e-100, -1e-100, 1e-100, 1e-100});
}

// (From the middle of a half-plane all sites seemed to be at one distance: 400 times as slow.)
TEST(Search, WithoutLimitsNeedsNoExactArithmetic) {
  Random random(147);
  Circles circles = randomCircles(random, 600, Hidden::k20Percent);
  for (const double r : {-1.0, -1e6, 0.0, 3e5}) circles.push_back({5e5 + r, 2e5, r});
  Picking picking(circles);
  const double far = kLargestMagnitude;
  const PredicateCounts before = predicateCounts();
  std::vector<SiteId> sites;
  std::vector<std::array<double, 4>> windows;
  for (const double at : {-3e5, 0.0, 12345.0})
    for (const std::array<double, 4>& window : {std::array<double, 4>{-far, -far, far, far},
                                                {-far, -far, at, far},
                                                {at, -far, far, far},
                                                {-far, -far, far, at},
                                                {-far, at, far, far},
                                                {-far, at, at, far},
                                                {at, at, far, far}})
      windows.push_back(window);
  for (const auto& [xmin, ymin, xmax, ymax] : windows)
    ASSERT_EQ(picking.diagram().search(xmin, ymin, xmax, ymax, sites), Error::kNone);
  EXPECT_EQ(predicateCounts().distance.exact, before.distance.exact);
  for (const auto& [xmin, ymin, xmax, ymax] : windows)
    picking.checkSearch({xmin, ymin, xmax, ymax});
  picking.checkSearch({5e7, -far, far, far});  // nothing
  Picking one(Circles{{3, 4, 5}});
  for (const auto& [xmin, ymin, xmax, ymax] : windows) one.checkSearch({xmin, ymin, xmax, ymax});
  Picking none(Circles{});
  none.checkSearch({-far, -far, far, far});
}

/// Windows that have no middle, as there is no double between their sides, or none in the range.
TEST(Search, InWindowsThatCannotBeCut) {
  const double ulp = 0x1p-52;
  Circles circles;
  // Many next to the window, at the same place, and as near as its middle is to its corners.
  for (int k = 0; k < 50; ++k) circles.push_back({1 - ulp / 2, 1, 0});
  for (int k = 0; k < 50; ++k) circles.push_back({1, 1 - ulp / 2, 0});
  for (const double x : {1.0, 1 + ulp, 1 + 2 * ulp, 1e-100, -1e-100, 1.5e-100})
    for (const double y : {1.0, 1 + ulp, 1 + 2 * ulp, 1e-100, -1e-100, 1.5e-100})
      circles.push_back({x, y, 0});
  Picking picking(circles);
  for (const double low : {1.0, 1 + ulp}) {
    picking.checkSearch({low, 1, low + ulp, 1});
    picking.checkSearch({1, low, 1, low + ulp});
    picking.checkSearch({low, low, low + ulp, low + ulp});
  }
  picking.checkSearch({-1e-100, -1e-100, 1.2e-100, 1.2e-100});
  picking.checkSearch({-1e-100, 0, 1.2e-100, 1e-100});
}

TEST(Pick, BadNumbersAreErrors) {
  Diagram diagram;
  SiteId id = kNoSite;
  std::vector<SiteId> sites;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(diagram.pick(nan, 0, 1, Top::kSmallest, id), Error::kNotFinite);
  EXPECT_EQ(diagram.pick(0, 1e101, 1, Top::kSmallest, id), Error::kOutOfRange);
  EXPECT_EQ(diagram.pick(0, 0, nan, Top::kSmallest, id), Error::kNotFinite);
  EXPECT_EQ(diagram.pick(0, 0, -1, Top::kSmallest, id), Error::kOutOfRange);
  EXPECT_EQ(diagram.search(0, 0, nan, 1, sites), Error::kBadBounds);
  EXPECT_EQ(diagram.search(-kAnywhere, 0, 1, 1, sites), Error::kBadBounds);
  EXPECT_EQ(diagram.search(0, 2, 1, 1, sites), Error::kBadBounds);
  EXPECT_EQ(diagram.search(2, 0, 1, 1, sites), Error::kBadBounds);
  EXPECT_EQ(diagram.search(0, 0, 1, 1e101, sites), Error::kBadBounds);
  NearestFirst walk(diagram);
  EXPECT_EQ(walk.start(nan, 0), Error::kNotFinite);
  EXPECT_EQ(walk.start(0, 0, 1e101), Error::kOutOfRange);
}

TEST(Pick, EmptyDiagram) {
  Diagram diagram;
  SiteId id = 5;
  EXPECT_EQ(diagram.pick(0, 0, kAnywhere, Top::kSmallest, id), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  std::vector<SiteId> sites{7};
  EXPECT_EQ(diagram.search(0, 0, 1, 1, sites), Error::kNone);
  EXPECT_TRUE(sites.empty());
  NearestFirst walk(diagram);
  EXPECT_EQ(walk.next(id), Error::kNone) << "before start()";
  EXPECT_EQ(id, kNoSite);
  EXPECT_EQ(walk.distance(), kAnywhere);
  EXPECT_EQ(walk.start(0, 0), Error::kNone);
  EXPECT_EQ(walk.next(id), Error::kNone);
  EXPECT_EQ(id, kNoSite);
}

}  // namespace
}  // namespace apollonius::test
