// The polygons of all cells: whatever the sites, the window and the tolerance, they are valid and
// tile the window.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "geometry/coverage_judge.h"
#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::test {
namespace {

std::string faultsIn(const Circles& circles, const Bounds& bounds, double tolerance) {
  Diagram diagram;
  insertInto(diagram, circles);
  CoverageArrays coverage;
  EXPECT_EQ(Voronoi(diagram, bounds).cellPolygons(tolerance, coverage), Error::kNone);
  return faultsOf(coverage, bounds);
}

/// Rings in a box: a star, and a smaller one that is a hole of it.
std::vector<std::vector<Place>> starIn(const Bounds& b, Random& random) {
  std::vector<std::vector<Place>> rings;
  const double x = (b.xmin + b.xmax) / 2, y = (b.ymin + b.ymax) / 2, width = (b.xmax - b.xmin) / 2,
               height = (b.ymax - b.ymin) / 2;
  for (const double scale : {1.0, 0.3}) {
    std::vector<Place> ring;
    const int points = 3 + random.below(6);
    for (int k = 0; k < 2 * points; ++k) {
      const double angle = 3.14159265358979 * k / points, share = scale * (k % 2 == 0 ? 1 : 0.5);
      ring.emplace_back(x + width * share * std::cos(angle), y + height * share * std::sin(angle));
    }
    rings.push_back(ring);
  }
  return rings;
}

std::string faultsIn(const Circles& circles, const std::vector<std::vector<Place>>& rings,
                     double tolerance) {
  std::vector<double> coordinates;
  std::vector<std::uint32_t> starts{0};
  for (const auto& ring : rings) {
    for (const Place& p : ring) coordinates.insert(coordinates.end(), {p.first, p.second});
    starts.push_back(static_cast<std::uint32_t>(coordinates.size() / 2));
  }
  Region region;
  if (region.assign(coordinates, starts) != Error::kNone) return "";
  Diagram diagram;
  insertInto(diagram, circles);
  CoverageArrays coverage;
  EXPECT_EQ(Voronoi(diagram, region).cellPolygons(tolerance, coverage), Error::kNone);
  const double size = sizeOf(region.box());
  CoverageJudge judge(coverage, region.area());
  judge.expectPairs([&](Place p, Place q) {
    for (const auto& ring : rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Place a = ring[k], b = ring[(k + 1) % ring.size()];
        const double dx = b.first - a.first, dy = b.second - a.second, length = std::hypot(dx, dy);
        const auto isOn = [&](Place at) {
          return std::abs((at.first - a.first) * dy - (at.second - a.second) * dx) <=
                 length * kCoverageRounding * size;
        };
        if (isOn(p) && isOn(q)) return true;
      }
    }
    return false;
  });
  judge.expectNoCrossings();
  return judge.complaints();
}

class CoverageOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(CoverageOn, OfARectangle) {
  Random random(641);
  for (int run = 0; run < runs(3); ++run) {
    const auto k = static_cast<std::size_t>(run);
    const Circles circles = GetParam().make(random, GetParam().large ? 8 + 8 * k : 4 + k);
    for (const double share : {0.0, -0.3, 0.4, 30.0}) {
      Bounds bounds;
      if (!windowAround(circles, share, bounds)) continue;
      for (const double tolerance : {1e-5, 0.02, 10.0}) {
        const double width = bounds.xmax - bounds.xmin;
        ASSERT_EQ(faultsIn(circles, bounds, tolerance * width), "")
            << "run " << run << " share " << share << " tolerance " << tolerance << "\n"
            << toText(insertAll(circles));
      }
    }
  }
}

TEST_P(CoverageOn, OfAStarWithAHole) {
  Random random(642);
  for (int run = 0; run < runs(3); ++run) {
    const auto k = static_cast<std::size_t>(run);
    const Circles circles = GetParam().make(random, GetParam().large ? 8 + 8 * k : 4 + k);
    for (const double share : {0.0, 0.4}) {
      Bounds bounds;
      if (!windowAround(circles, share, bounds)) continue;
      const auto rings = starIn(bounds, random);
      for (const double tolerance : {1e-5, 0.02, 10.0}) {
        const double width = bounds.xmax - bounds.xmin;
        ASSERT_EQ(faultsIn(circles, rings, tolerance * width), "")
            << "run " << run << " share " << share << " tolerance " << tolerance << "\n"
            << toText(insertAll(circles));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, CoverageOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Coverage, OfTheCasesThatOtherToolsRefused) {
  const std::vector<std::vector<Place>> slanted{{{15.42, 11.98},
                                                 {12.1, 13.95},
                                                 {7.4, 15.94},
                                                 {7.02, 11.27},
                                                 {1.52, 7.15},
                                                 {5.84, 1.63},
                                                 {10.77, 6.81},
                                                 {15.83, 8.53}}};
  const std::vector<std::vector<Place>> triangle{{{0, 0}, {20, 0}, {20, 20}, {0, 20}},
                                                 {{7, 18}, {9, 2}, {7, 4}}};
  const std::vector<std::vector<Place>> touching{{{0, 0}, {900, 0}, {900, 500}, {0, 500}},
                                                 {{0, 250}, {200, 400}, {600, 400}, {600, 100}}};
  for (const double tolerance : {1e-6, 0.01, 1.0, 100.0}) {
    EXPECT_EQ(faultsIn({{4.93, 9.33, 5.79}, {9.91, 3.51, 2.84}}, slanted, tolerance), "");
    EXPECT_EQ(faultsIn({{7, 19.5, 2}, {8, 2, 1.5}, {10.5, 2, 2}}, triangle, tolerance), "");
    EXPECT_EQ(faultsIn({{450, 50, 10}}, touching, tolerance), "");
    EXPECT_EQ(faultsIn({{8, 11, 39}, {48, 30, 1}, {17, 8, 39}}, Bounds{0, 0, 100, 60}, tolerance),
              "");
  }
}

}  // namespace
}  // namespace apollonius::test
