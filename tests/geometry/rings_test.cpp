// Rings of cells: closed, of three different points or more, and not crossing themselves, exactly;
// and the vertices that they go through.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::test {
namespace {

/// Checks the rings of all cells; returns how many there are.
int checkRings(const Circles& circles, const Bounds& bounds, double tolerance,
               const Reach* reach = nullptr) {
  Diagram diagram;
  insertInto(diagram, circles);
  const Voronoi voronoi(diagram, bounds, reach);
  int count = 0;
  for (SiteId id = 0; id < circles.size(); ++id) {
    RingArrays rings;
    EXPECT_EQ(voronoi.cellPolygon(id, tolerance, rings), Error::kNone);
    CellMeasures measures;
    EXPECT_EQ(voronoi.cellMeasures(id, measures), Error::kNone);
    for (const double x : rings.coordinates) EXPECT_FALSE(x == 0 && std::signbit(x)) << "-0";
    if (rings.starts.size() < 2) {
      EXPECT_LT(measures.area, 1e-12 * areaOf(bounds)) << "site " << id << " has no ring";
    }
    for (std::size_t r = 0; r + 1 < rings.starts.size(); ++r) {
      std::vector<Point> ring;
      for (std::uint32_t k = rings.starts[r]; k < rings.starts[r + 1]; ++k) {
        ring.push_back({rings.coordinates[2 * k], rings.coordinates[2 * k + 1]});
      }
      std::vector<std::pair<double, double>> different;
      for (const Point p : ring) different.emplace_back(p.x, p.y);
      std::sort(different.begin(), different.end());
      different.erase(std::unique(different.begin(), different.end()), different.end());
      EXPECT_GE(ring.size(), 4u) << "site " << id;
      EXPECT_GE(different.size(), 3u) << "site " << id;
      EXPECT_TRUE(ring.front() == ring.back()) << "site " << id;
      if (crossesItself(ring)) {
        std::ostringstream text;
        text.precision(17);
        for (const Point p : ring) text << p.x << " " << p.y << "\n";
        ADD_FAILURE() << "site " << id << " region " << r << " of " << toText(insertAll(circles))
                      << "crosses itself:\n"
                      << text.str();
      }
      ++count;
    }
  }
  return count;
}

class RingsOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(RingsOn, DoNotCrossThemselves) {
  Random random(601);
  for (int run = 0; run < runs(6); ++run) {
    const auto k = static_cast<std::size_t>(run);
    const Circles circles = GetParam().make(random, GetParam().large ? 8 + 8 * k : 4 + k);
    for (const double share : {0.0, -0.3, 0.4, 30.0}) {
      Bounds bounds;
      if (!windowAround(circles, share, bounds)) continue;
      for (const double tolerance : {1e-4, 0.1}) {
        checkRings(circles, bounds, tolerance * (bounds.xmax - bounds.xmin));
        if (HasFailure())
          FAIL() << "run " << run << " share " << share << " tolerance " << tolerance;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, RingsOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

/// Subsets of lattices: integers, decimal fractions as they are written, multiples of a decimal
/// step (off by rounding), moved far away.
Circles latticeSubset(Random& random, int kind) {
  const int side = 2 + random.below(6);
  const double steps[] = {1, 0.1, 0.3, 8.53e-9, 48, 1e-3};
  const double step = steps[random.below(std::size_t{6})];
  const double x0 = kind == 2 ? 1000.1 * step : 0, y0 = kind == 2 ? -333.3 * step : 0;
  const double weights = random.oneIn(2) ? 0 : step;
  Circles circles;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      if (random.oneIn(3)) continue;
      const double r = random.oneIn(4) ? weights : 0;
      if (kind == 1) {
        circles.push_back({i / (1 / step), j / (1 / step), r});
      } else {
        circles.push_back({x0 + i * step, y0 + j * step, r});
      }
    }
  }
  return circles;
}

TEST(Rings, OfLatticeSubsetsDoNotCrossThemselves) {
  Random random(602);
  int rings = 0;
  for (int run = 0; run < runs(300); ++run) {
    const Circles circles = latticeSubset(random, run % 3);
    Bounds bounds;
    if (!windowAround(circles, run % 2 == 0 ? 0.1 : 0.0, bounds)) continue;
    rings += checkRings(circles, bounds, defaultTolerance(bounds));
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(rings, runs(1500));
}

TEST(Rings, OfSmallCirclesNearlyTouchingLargeOnes) {
  // Cells smaller than the tolerance, with two or three neighbours, between circles that touch or
  // nearly do.
  Random random(603);
  for (int run = 0; run < runs(3000); ++run) {
    Circles circles;
    const int count = 2 + random.below(4);
    const double unit = random.oneIn(2) ? 1 : 0.1;
    for (int k = 0; k < count; ++k) {
      const auto x = static_cast<double>(random.integer(0, 9)),
                 y = static_cast<double>(random.integer(0, 9));
      circles.push_back({unit * x, unit * y, unit * static_cast<double>(random.integer(0, 4))});
    }
    const Bounds bounds{-600, -600, 600, 600};
    checkRings(circles, bounds, defaultTolerance(bounds));
    if (HasFailure()) FAIL() << "run " << run;
  }
}

TEST(Rings, ThroughTheirOwnCentre) {
  // Circles that touch from within, up to rounding: their cells begin within a double of their
  // centre, so that points of the ring are on it.
  int needles = 0;
  for (int x = -70; x <= 70; x += 5) {
    for (int r = 1; r <= 15; ++r) {
      for (int way = 1; way <= 6; ++way) {
        const double left = x / 10.0, right = (x + way) / 10.0;
        const Circles circles{{left, -2.6, (r + way) / 10.0}, {right, -2.6, r / 10.0}};
        const Bounds bounds{-11, -11, 12.1, 12.1};
        needles += checkRings(circles, bounds, defaultTolerance(bounds)) == 2 ? 1 : 0;
        if (HasFailure()) FAIL() << "x " << x << " r " << r << " way " << way;
      }
    }
  }
  EXPECT_GT(needles, 100);
}

TEST(Rings, OfACellSmallerThanTheTolerance) {
  const Circles circles{{6, 2, 2}, {8, 0, 2}, {7, 1, 1}};
  const Bounds bounds{-600, -600, 600, 600};
  EXPECT_EQ(checkRings(circles, bounds, defaultTolerance(bounds)), 3);
}

TEST(Rings, ThroughAVertexOnACornerOfTheWindow) {
  // Found by geometry_fuzz: the two edges that end at (0, 0) were cut off by one side each, in the
  // wrong order.
  EXPECT_EQ(checkRings({{-63, -60, 67}, {-9, -12, -5}, {0, -108, 88}}, {-24, -2, 0, 0}, 0.001), 3);
}

TEST(Rings, InAWindowThatBeginsAtMinusZeroHaveNone) {
  EXPECT_EQ(checkRings({{2, 2, 1}, {1, -2, 2}, {-1, -2, 2}}, {-0.0, -0.0, 5, 5}, 0.01), 2);
}

TEST(Rings, ThroughOneVertexOfFourSites) {
  const Circles circles{{768, 200, 10}, {672, 150, 10}, {768, 0, 10}, {672, 50, 10}};
  EXPECT_EQ(checkRings(circles, {}, 0.1), 4);
}

/// The ends of edges that have length zero exactly: all faces of one vertex have one place.
TEST(Vertices, OfManySitesOnOneCircleAreOne) {
  Random random(604);
  int multiple = 0;
  for (int run = 0; run < runs(400); ++run) {
    Circles circles;
    switch (run % 4) {
      case 0:
        circles = cocircularPoints(random, 4 + random.below(std::size_t{12}));
        break;
      case 1:
        circles = commonTangent(random, 4 + random.below(std::size_t{12}), 20);
        break;
      case 2:
        circles = tinyGrid(random, 12, 6, 3);
        break;
      default:
        circles = lattice(random, 5, 4, 3, 1);
        break;
    }
    if (run % 8 >= 4) {  // in another unit, off the integers, and not about the origin
      for (Circle& c : circles) c = {c.x * 0x1p-7 + 5, c.y * 0x1p-7 - 11, c.r * 0x1p-7};
    }
    Diagram diagram;
    insertInto(diagram, circles);
    VertexArrays vertices;
    ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
    std::map<std::vector<double>, int> places;
    const std::size_t count = vertices.clearance.size();
    for (std::size_t v = 0; v < count; ++v) {
      const double x = vertices.coordinates[2 * v], y = vertices.coordinates[2 * v + 1],
                   s = vertices.clearance[v];
      ++places[{x, y, s}];
      // No other place is as near as rounding could have moved this one. (Vertices of such small
      // integers are far apart or the same.)
      for (std::size_t w = 0; w < v; ++w) {
        const double dx = vertices.coordinates[2 * w] - x, dy = vertices.coordinates[2 * w + 1] - y;
        const double size = 1e-12 * (std::abs(x) + std::abs(y) + std::abs(s));
        if (std::abs(dx) + std::abs(dy) > size || std::abs(vertices.clearance[w] - s) > size)
          continue;
        ASSERT_TRUE(dx == 0 && dy == 0 && vertices.clearance[w] == s)
            << "run " << run << " at " << x << " " << y;
      }
    }
    for (const auto& [place, faces] : places) multiple += faces > 1;
  }
  EXPECT_GT(multiple, runs(400)) << "there are such vertices";
}

TEST(Vertices, OnGridsAreRight) {
  Diagram diagram;
  insertInto(diagram, {{100, 100, 3}, {200, 100, 3}, {100, 200, 3}, {200, 200, 3}, {260, 150, 3}});
  VertexArrays vertices;
  ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
  int found = 0;
  for (std::size_t v = 0; v < vertices.clearance.size(); ++v) {
    found += vertices.coordinates[2 * v] == 150 && vertices.coordinates[2 * v + 1] == 150;
  }
  EXPECT_EQ(found, 2);
}

/// A window of which one side goes through a place, and circles beside that on a line across it.
struct AtASide {
  std::size_t side;
  double place;  // both coordinates

  /// A circle at this distance from the place, outwards.
  [[nodiscard]] Circle circle(double away, double weight) const {
    const double x[] = {1, 0, -1, 0}, y[] = {0, 1, 0, -1};
    return {place + x[side] * away, place + y[side] * away, weight};
  }
  [[nodiscard]] Bounds bounds() const {
    Bounds bounds{place - 30, place - 30, place + 30, place + 30};
    double* const sides[] = {&bounds.xmax, &bounds.ymax, &bounds.xmin, &bounds.ymin};
    *sides[side] = place;
    return bounds;
  }
};

/// Rounding puts the point that is computed where they touch beyond the side, on it, or before it.
TEST(Rings, WhereAnEdgeTouchesASideDoNotCross) {
  int count = 0;
  for (const double place : {0.0, -1000.0, 1048576.0}) {
    for (const std::size_t side : {0, 1, 2, 3}) {
      const AtASide scene{side, place};
      for (double left = 1; left <= 12; left += 2) {
        for (double r = 0; r < left; ++r) {
          for (double q = 0; q <= 6; ++q) {
            const Circles circles{scene.circle(-left, r), scene.circle(left - r + q, q)};
            for (const double tolerance : {1e-2, 1e2})
              count += checkRings(circles, scene.bounds(), tolerance);
          }
        }
      }
    }
  }
  EXPECT_GT(count, 2000);
}

TEST(Rings, WhereCellsEndAtADistanceThatTouchesASideDoNotCross) {
  int count = 0;
  for (const double place : {0.0, -1000.0, 1048576.0}) {
    for (const std::size_t side : {0, 1, 2, 3}) {
      const AtASide scene{side, place};
      for (double away = 1; away <= 12; ++away) {
        for (double r = 0; r < away; ++r) {
          const Reach reach(away - r);
          for (const double tolerance : {1e-2, 1e2})
            count += checkRings({scene.circle(-away, r), scene.circle(-25, 1)}, scene.bounds(),
                                tolerance, &reach);
        }
      }
    }
  }
  EXPECT_GT(count, 1000);
}

}  // namespace
}  // namespace apollonius::test
