// Natural neighbours: against the areas that an insertion takes, and as an interpolation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/random.h"
#include "support/saved.h"

namespace apollonius::test {
namespace {

/// A rectangle, or the same with a hole in its middle.
struct Window {
  Bounds bounds;
  Region region;
  bool isRegion;

  Window(const Bounds& b, bool hasHole) : bounds(b), isRegion(hasHole) {
    if (!hasHole) return;
    const double w = (b.xmax - b.xmin) / 3, h = (b.ymax - b.ymin) / 3;
    const double rings[] = {b.xmin,     b.ymin,     b.xmax,         b.ymin,
                            b.xmax,     b.ymax,     b.xmin,         b.ymax,
                            b.xmin + w, b.ymin + h, b.xmin + w,     b.ymin + 2 * h,
                            b.xmax - w, b.ymax - h, b.xmax - w / 2, b.ymin + h};
    const std::uint32_t starts[] = {0, 4, 8};
    EXPECT_EQ(region.assign(rings, starts), Error::kNone);
  }
  [[nodiscard]] Voronoi of(const Diagram& diagram) const {
    return isRegion ? Voronoi(diagram, region) : Voronoi(diagram, bounds);
  }
  [[nodiscard]] double area() const {
    return isRegion ? region.area() : (bounds.xmax - bounds.xmin) * (bounds.ymax - bounds.ymin);
  }
};

std::map<SiteId, double> weightsOf(const Voronoi& voronoi, const Circle& q) {
  NaturalWeights found;
  EXPECT_EQ(voronoi.naturalWeights(q.x, q.y, q.r, found), Error::kNone);
  std::map<SiteId, double> weights;
  double sum = 0;
  for (std::size_t k = 0; k < found.ids.size(); ++k) {
    EXPECT_TRUE(weights.emplace(found.ids[k], found.weights[k]).second) << "each once";
    EXPECT_GE(found.weights[k], 0);
    sum += found.weights[k];
  }
  if (!weights.empty()) {
    EXPECT_NEAR(sum, 1, 1e-12);
  }
  return weights;
}

/// Empty, or where the weights differ from what insertion takes.
std::string difference(Diagram& diagram, const Window& window, const Circle& q) {
  const std::map<SiteId, double> weights = weightsOf(window.of(diagram), q);
  std::vector<double> before, after;
  EXPECT_EQ(window.of(diagram).cellAreas(before), Error::kNone);
  SiteId own = kNoSite;
  EXPECT_EQ(diagram.insert(q.x, q.y, q.r, own), Error::kNone);
  bool isCovered = false, isRemoved = false;
  EXPECT_EQ(diagram.isHidden(own, isCovered), Error::kNone);
  EXPECT_EQ(window.of(diagram).cellAreas(after), Error::kNone);
  EXPECT_EQ(diagram.remove(own, isRemoved), Error::kNone);
  if (isCovered) {
    SiteId nearest = kNoSite;
    EXPECT_EQ(diagram.find(q.x, q.y, nearest), Error::kNone);
    return weights == std::map<SiteId, double>{{nearest, 1.0}} ? "" : "not the one that covers it";
  }
  // Areas are good to the last places of the window's, and its coordinates.
  const Bounds& b = window.bounds;
  const double size =
      std::max({std::abs(b.xmin), std::abs(b.xmax), std::abs(b.ymin), std::abs(b.ymax)});
  const double rounding = 1e-12 * (window.area() + size * (b.xmax - b.xmin + b.ymax - b.ymin));
  if (!(after[own] > 1e3 * rounding)) return "";
  for (SiteId id = 0; id < before.size(); ++id) {
    if (id == own) continue;  // used before, and by none now
    const auto at = weights.find(id);
    const double weight = at == weights.end() ? 0 : at->second;
    const double expected = (before[id] - after[id]) / after[own];
    if (!(std::abs(weight - expected) <= rounding / after[own]))
      return "weight of " + std::to_string(id) + " is " + std::to_string(weight) + ", expected " +
             std::to_string(expected);
  }
  return "";
}

/// The box of the centres, larger or smaller by a factor.
Bounds boxAround(const Circles& circles, double factor) {
  Bounds b{circles[0].x, circles[0].y, circles[0].x, circles[0].y};
  for (const Circle& c : circles)
    b = {std::min(b.xmin, c.x), std::min(b.ymin, c.y), std::max(b.xmax, c.x),
         std::max(b.ymax, c.y)};
  const double x = (b.xmin + b.xmax) / 2, y = (b.ymin + b.ymax) / 2;
  const double half = factor * std::max({b.xmax - b.xmin, b.ymax - b.ymin, 1e-3}) / 2;
  return {x - half, y - 0.7 * half, x + half, y + 0.7 * half};
}

class NaturalNeighbors : public testing::TestWithParam<NamedGenerator> {};

TEST_P(NaturalNeighbors, AreWhatInsertionTakes) {
  Random random(77);
  for (const std::size_t n : {1, 2, 3, 12, 40}) {
    const Circles circles = GetParam().make(random, n);
    if (circles.empty()) continue;
    Diagram diagram;
    insertInto(diagram, circles);
    for (const double factor : {0.4, 1.0, 2.5, 300.0}) {
      for (const bool hasHole : {false, true}) {
        const Bounds b = boxAround(circles, factor);
        if (!(b.xmin < b.xmax && b.ymin < b.ymax) || !isInRange(b.xmin) || !isInRange(b.xmax) ||
            !isInRange(b.ymin) || !isInRange(b.ymax))
          continue;
        const Window window(b, hasHole);
        std::vector<Circle> places;
        for (int k = 0; k < sized(6, 100); ++k) {
          const double r = k % 3 == 0 ? (b.xmax - b.xmin) * random.unit() / 10 : 0;
          places.push_back({b.xmin + (b.xmax - b.xmin) * random.unit(),
                            b.ymin + (b.ymax - b.ymin) * random.unit(), r});
        }
        const Circle& site = circles[random.below(circles.size())];
        places.push_back({site.x, site.y, site.r});
        for (int k = 0; k < sized(3, 30); ++k) {  // on the rim, or just beside it
          const double angle = 6.28 * random.unit();
          const double away =
              site.r * (1 + std::ldexp(1.0, -static_cast<int>(30 + random.below(24))));
          places.push_back({site.x + away * std::cos(angle), site.y + away * std::sin(angle), 0});
        }
        places.push_back({site.x, b.ymin, 0});
        places.push_back({b.xmin, b.ymax, 0});
        places.push_back({b.xmax + b.xmax - b.xmin, (b.ymin + b.ymax) / 2, 0});
        VertexArrays vertices;
        ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
        if (vertices.coordinates.size() > 1)
          places.push_back({vertices.coordinates[0], vertices.coordinates[1], 0});
        for (const Circle& q : places) {
          if (!isInRange(q.x) || !isInRange(q.y)) continue;
          const bool isInside =
              window.isRegion ? window.region.contains(q.x, q.y)
                              : q.x >= b.xmin && q.x <= b.xmax && q.y >= b.ymin && q.y <= b.ymax;
          if (isInside) {
            EXPECT_FALSE(weightsOf(window.of(diagram), q).empty())
                << n << " sites, window " << factor << ", at " << q.x << " " << q.y << " " << q.r;
          }
          EXPECT_EQ(difference(diagram, window, q), "")
              << n << " sites, window " << factor << (hasHole ? " with a hole" : "") << ", at "
              << testing::PrintToString(q.x) << " " << q.y << " " << q.r;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, NaturalNeighbors, testing::ValuesIn(corpus()),
                         [](const auto& tested) { return tested.param.name; });

TEST(NaturalWeights, OfCirclesThatCoverOthersOrAll) {
  Diagram diagram;
  insertInto(diagram, {{10, 10, 1}, {30, 12, 2}, {22, 30, 0}, {50, 25, 3}, {25, 18, 0}});
  for (const Bounds& bounds : {Bounds{0, 0, 60, 40}, Bounds{20, 5, 26, 20}}) {
    for (const bool hasHole : {false, true}) {
      const Window window(bounds, hasHole);
      for (const Circle& q : {Circle{25, 18, 5}, Circle{24, 17, 9}, Circle{25, 17, 15},
                              Circle{25, 17, 100}, Circle{200, 17, 100}, Circle{26, 18, 0}})
        EXPECT_EQ(difference(diagram, window, q), "") << q.x << " " << q.y << " " << q.r;
    }
  }
}

TEST(NaturalWeights, OfACellInAHoleAreNone) {
  Diagram diagram;
  insertInto(diagram, {{18, 20, 0}, {24, 20, 0}, {21, 17, 0}, {21, 23, 0}});
  for (const bool hasHole : {false, true}) {
    const Window window({0, 0, 42, 40}, hasHole);
    EXPECT_EQ(weightsOf(window.of(diagram), {21, 20, 0}).size(), hasHole ? 0u : 4u);
  }
}

/// Trusted bytes are not proved, so that searches look again at what they find.
TEST(NaturalWeights, OfACircleThatCoversAllInATrustedSnapshot) {
  Diagram diagram;
  insertInto(diagram, {{10, 10, 1}, {30, 12, 2}, {22, 30, 0}, {50, 25, 3}});
  ASSERT_EQ(diagram.fromBytes(saved(diagram), Source::kTrusted), Error::kNone);
  const Window window({0, 0, 60, 40}, false);
  EXPECT_EQ(difference(diagram, window, {25, 17, 100}), "");
  EXPECT_EQ(difference(diagram, window, {25, 17, 1}), "");
}

/// Beside the rim of a circle a new cell is a needle; at a corner of the window, or on a side,
/// little of it is inside. There is a value nevertheless, among those of the sites.
TEST(Interpolation, HasAValueEverywhereInTheWindow) {
  Random random(79);
  for (const double offset : {0.0, 1e3, -1e6, 1e9}) {
    for (const bool hasHole : {false, true}) {
      const Window window({offset, offset, offset + 60, offset + 40}, hasHole);
      const Circles circles{{offset + 10, offset + 10, 3},
                            {offset + 30, offset + 12, 2},
                            {offset + 14, offset + 13, 2},
                            {offset + 22, offset + 30, 0},
                            {offset - 20, offset - 20, 25}};
      Diagram diagram;
      insertInto(diagram, circles);
      const std::vector<double> values{5, 7, 11, 13, 17};
      std::vector<double> xy{offset,      offset, offset + 60, offset + 40,
                             offset + 60, offset, offset + 60, offset + 7};
      for (int k = 0; k < 2000; ++k) {
        const Circle& c = circles[random.below(circles.size())];
        const double angle = 2 * 3.14159265358979323846 * random.unit();
        const double away = c.r + std::ldexp(1.0, -static_cast<int>(random.below(60)));
        xy.push_back(c.x + away * std::cos(angle));
        xy.push_back(c.y + away * std::sin(angle));
      }
      std::vector<double> results(xy.size() / 2);
      ASSERT_EQ(window.of(diagram).interpolate(values, xy, 0, results), Error::kNone);
      for (std::size_t k = 0; k < results.size(); ++k) {
        const double x = xy[2 * k], y = xy[2 * k + 1];
        const Bounds& b = window.bounds;
        const bool isInside = hasHole ? window.region.contains(x, y)
                                      : x >= b.xmin && x <= b.xmax && y >= b.ymin && y <= b.ymax;
        EXPECT_EQ(std::isnan(results[k]), !isInside) << offset << ": " << k;
        if (!isInside) continue;
        EXPECT_GE(results[k], 5 - 1e-9) << offset << ": " << k;
        EXPECT_LE(results[k], 17 + 1e-9) << offset << ": " << k;
      }
    }
  }
}

/// Sibson: where new cells end before the window does.
TEST(Interpolation, OfPointsMeetsLinearFields) {
  Random random(78);
  for (const double offset : {0.0, 1000.0, -4096.0, 1e6}) {
    Circles points;
    for (int k = 0; k < 500; ++k)
      points.push_back({offset + 100 * random.unit(), offset + 60 * random.unit(), 0});
    Diagram diagram;
    insertInto(diagram, points);
    const Voronoi voronoi(diagram, {offset - 500, offset - 500, offset + 600, offset + 560});
    std::vector<double> values, xy, results;
    for (const Circle& p : points) values.push_back(3 + 2 * (p.x - offset) - (p.y - offset));
    for (int k = 0; k < 2000; ++k) {
      xy.push_back(offset + 25 + 50 * random.unit());
      xy.push_back(offset + 15 + 30 * random.unit());
    }
    results.resize(xy.size() / 2);
    ASSERT_EQ(voronoi.interpolate(values, xy, 0, results), Error::kNone);
    for (std::size_t k = 0; k < results.size(); ++k) {
      const double x = xy[2 * k] - offset, y = xy[2 * k + 1] - offset;
      EXPECT_NEAR(results[k], 3 + 2 * x - y, offset == 1e6 ? 1e-7 : 1e-9);
      NaturalWeights found;
      ASSERT_EQ(voronoi.naturalWeights(xy[2 * k], xy[2 * k + 1], 0, found), Error::kNone);
      double sum = 0;
      for (std::size_t m = 0; m < found.ids.size(); ++m)
        sum += found.weights[m] * values[found.ids[m]];
      EXPECT_NEAR(results[k], sum, 1e-9);
    }
  }
}

TEST(Interpolation, IsExactAtSitesAndInCirclesAndNothingOutside) {
  Diagram diagram;
  insertInto(diagram, {{10, 10, 3}, {30, 12, 2}, {22, 30, 0}, {10, 11, 1}});
  for (const bool hasHole : {false, true}) {
    const Window window({0, 0, 42, 40}, hasHole);
    const double values[] = {5, 7, 11, 13};
    const double xy[] = {22, 30, 10, 8, 30, 12, -1, 5, 42, 40, 20, 20, 30, 13.7};
    double results[7];
    ASSERT_EQ(window.of(diagram).interpolate(values, xy, 0, results), Error::kNone);
    EXPECT_EQ(results[0], 11);
    EXPECT_EQ(results[1], 5);
    EXPECT_EQ(results[2], 7);
    EXPECT_TRUE(std::isnan(results[3]));
    EXPECT_FALSE(std::isnan(results[4])) << "on the border";
    EXPECT_EQ(std::isnan(results[5]), hasHole);
    EXPECT_EQ(std::isnan(results[6]), hasHole) << "in a circle";
  }
}

/// Each of many sites on a circle or a line is a neighbour then.
TEST(Interpolation, OfManyNaturalNeighbors) {
  for (const bool isCircle : {false, true}) {
    constexpr int kSites = 1000;
    Circles points;
    std::vector<double> values;
    for (int k = 0; k < kSites; ++k) {
      const double angle = 2 * 3.14159265358979323846 * k / kSites;
      points.push_back(isCircle ? Circle{100 * std::cos(angle), 100 * std::sin(angle), 0}
                                : Circle{k / 10.0 - 50, 0, 0});
      values.push_back(points.back().x);
    }
    Diagram diagram;
    insertInto(diagram, points);
    const Voronoi voronoi(diagram, {-200, -150, 200, 150});
    const double xy[] = {0.5, 60, -20, -30, 3, 4};
    double results[3];
    ASSERT_EQ(voronoi.interpolate(values, xy, 0, results), Error::kNone);
    NaturalWeights found;
    ASSERT_EQ(voronoi.naturalWeights(3, 4, 0, found), Error::kNone);
    EXPECT_GT(found.ids.size(), 50U);
    if (!isCircle) continue;
    EXPECT_NEAR(results[0], 0.5, 1e-9);
    EXPECT_NEAR(results[1], -20, 1e-9);
    EXPECT_NEAR(results[2], 3, 1e-9);
  }
}

TEST(Interpolation, RefusesAndLeavesResultsAsTheyAre) {
  Diagram diagram;
  insertInto(diagram, {{10, 10, 3}, {30, 12, 2}});
  const Voronoi voronoi(diagram, {0, 0, 40, 40});
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const double values[] = {1, 2}, one[] = {1}, xy[] = {1, 2}, bad[] = {1, kNan}, far[] = {1e200, 0};
  double result[] = {17};
  EXPECT_EQ(voronoi.interpolate(one, xy, 0, result), Error::kBadLength);
  EXPECT_EQ(voronoi.interpolate(values, xy, 0, {}), Error::kBadLength);
  EXPECT_EQ(voronoi.interpolate(values, bad, 0, result), Error::kNotFinite);
  EXPECT_EQ(voronoi.interpolate(values, far, 0, result), Error::kOutOfRange);
  EXPECT_EQ(voronoi.interpolate(values, xy, kNan, result), Error::kNotFinite);
  EXPECT_EQ(Voronoi(diagram, {0, 0, 0, 1}).interpolate(values, xy, 0, result), Error::kBadBounds);
  EXPECT_EQ(result[0], 17);
  NaturalWeights found;
  EXPECT_EQ(voronoi.naturalWeights(1, kNan, 0, found), Error::kNotFinite);
  EXPECT_EQ(voronoi.naturalWeights(1, 1, 1e200, found), Error::kOutOfRange);
  const Diagram empty;
  ASSERT_EQ(Voronoi(empty, {0, 0, 1, 1}).interpolate({}, xy, 0, result), Error::kNone);
  EXPECT_TRUE(std::isnan(result[0]));
  EXPECT_TRUE(weightsOf(Voronoi(empty, {0, 0, 1, 1}), {0.5, 0.5, 0}).empty());
}

TEST(NaturalWeights, DoNotDependOnTheDistanceOfTheView) {
  Diagram diagram;
  insertInto(diagram, {{10, 10, 3}, {30, 12, 2}, {20, 30, 1}});
  const Bounds bounds{0, 0, 40, 40};
  const Reach reach(1);
  EXPECT_EQ(weightsOf(Voronoi(diagram, bounds, &reach), {20, 20, 1}),
            weightsOf(Voronoi(diagram, bounds), {20, 20, 1}));
}

}  // namespace
}  // namespace apollonius::test
