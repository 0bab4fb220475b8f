// The largest circles inside cells and windows, and empty ones: against closed forms, and against
// trying places all over.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/shapes.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::test {
namespace {

constexpr double kEnough = 0.999;

using Points = std::vector<Point>;

Points turned(Points points, double turn, Point offset = {}) {
  for (Point& p : points)
    p = offset + Point{std::cos(turn) * p.x - std::sin(turn) * p.y,
                       std::sin(turn) * p.x + std::cos(turn) * p.y};
  return points;
}

/// The curves of closed rings.
struct Outline {
  std::vector<double> curves;
  std::vector<std::uint32_t> starts{0};

  explicit Outline(const std::vector<Points>& rings) {
    for (const Points& ring : rings) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Point a = ring[k], b = ring[(k + 1) % ring.size()], m = middle(a, b);
        curves.insert(curves.end(), {a.x, a.y, m.x, m.y, 0, b.x, b.y});
      }
      starts.push_back(static_cast<std::uint32_t>(curves.size() / 7));
    }
  }
};

double radiusIn(const std::vector<Points>& rings, double aspect = 1) {
  const Outline outline(rings);
  Circle circle;
  EXPECT_EQ(innerCircle(outline.curves, outline.starts, aspect, circle), Error::kNone);
  return circle.r;
}

void expectAbout(double r, double expected, double rounding) {
  EXPECT_GT(r, kEnough * expected - rounding);
  EXPECT_LE(r, expected * (1 + 1e-9) + rounding);
}

Points regular(std::size_t sides, double size) {
  Points points;
  for (std::size_t k = 0; k < sides; ++k) {
    const double turn = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(sides);
    points.push_back({size * std::cos(turn), size * std::sin(turn)});
  }
  return points;
}

TEST(InnerCircle, OfShapesThatAreKnown) {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, wide{{0, 0}, {6, 0}, {6, 1}, {0, 1}};
  for (const double turn : {0.0, 0.3, 1.0, 2.5}) {
    for (const Point offset : {Point{}, Point{1e6, -3e5}}) {
      const double rounding = 1e-8 * (offset.x > 0) + 1e-12;
      expectAbout(radiusIn({turned(square, turn, offset)}), 2, rounding);
      expectAbout(radiusIn({turned(wide, turn, offset)}), 0.5, rounding);
      expectAbout(radiusIn({turned({{0, 0}, {1, 0}, {0, 1}}, turn, offset)}),
                  1 / (2 + std::numbers::sqrt2), rounding);
      for (const std::size_t sides : {3u, 8u, 33u, 200u})
        expectAbout(radiusIn({turned(regular(sides, 5), turn, offset)}),
                    5 * std::cos(std::numbers::pi / static_cast<double>(sides)), rounding);
    }
  }
  EXPECT_DOUBLE_EQ(radiusIn({wide}, 3), 0.5);
  EXPECT_DOUBLE_EQ(radiusIn({square}, 2), 1);
  for (const double size : {1e-90, 1e90})
    expectAbout(radiusIn({{{0, 0}, {size, 0}, {size, 3 * size}, {0, 3 * size}}}) / size, 0.5, 0);
}

TEST(InnerCircle, OfThinOutlinesAtAnyAngle) {
  const double lean = std::hypot(1, 0.37);
  for (const double width : {1e-3, 1e-6, 1e-9, 1e-12}) {
    SCOPED_TRACE(width);
    const auto strip = [](double w, double up) {
      return Points{{0, up}, {1, 0.37 + up}, {1, 0.37 + up + w}, {0, up + w}};
    };
    expectAbout(radiusIn({strip(width, 0)}), width / 2 / lean, 1e-15);
    std::vector<Points> many, fan;
    for (int k = 0; k < 6; ++k) many.push_back(strip((1 + k / 10.0) * width, 3 * k * width));
    expectAbout(radiusIn(many), 1.5 * width / 2 / lean, 1e-15);
    for (const int k : {0, 2, 4})
      fan.push_back({{0, 0}, {1, 0.37 + k * width}, {1, 0.37 + (k + 1) * width}});
    EXPECT_GT(radiusIn(fan), 0.46 * width * kEnough - 1e-15);
    // A ring, in which all places are equally good, except those at corners.
    Points inner = regular(60, 1 - width);
    std::reverse(inner.begin(), inner.end());
    const double r = radiusIn({regular(60, 1), inner});
    EXPECT_GT(r, width / 2 * std::cos(std::numbers::pi / 60) * kEnough - 1e-15);
    EXPECT_LT(r, width / 2 * (1 + 1e-9) + 1e-15);
  }
}

TEST(InnerCircle, OfStarsAndCombsOfManySides) {
  Random random(93);
  for (const std::size_t sides : {10u, 33u, 100u, 3000u}) {
    Points star = regular(sides, 1);
    for (std::size_t k = 0; k < sides; k += 2) star[k] = 0.5 * star[k];
    const double r = radiusIn({star});
    EXPECT_GT(r, 0.5 * std::cos(2 * std::numbers::pi / static_cast<double>(sides)) * kEnough);
    EXPECT_LE(r, 0.5);
  }
}

// The middle of a box can be on a side: of ten teeth, 20 wide, that was taken for no room at all.
TEST(InnerCircle, OfCombs) {
  for (const int teeth : {2, 3, 10, 21}) {
    for (const double turn : {0.0, 0.3, std::numbers::pi / 2}) {
      Points comb{{0, -1}, {2.0 * teeth, -1}, {2.0 * teeth, 0}};
      for (int k = teeth - 1; k >= 0; --k)
        for (const auto& [dx, y] : {std::pair{1.0, 0.0}, {1.0, 50.0}, {0.0, 50.0}, {0.0, 0.0}})
          comb.push_back({2.0 * k + dx, y});
      const double r = radiusIn({turned(comb, turn)});  // below a tooth: x = 1/2, y = r - 1
      EXPECT_GT(r, 0.625 * kEnough) << teeth << ' ' << turn;
      EXPECT_LT(r, 0.625 + 1e-9);
    }
  }
}

TEST(InnerCircle, ErrorsAndNothing) {
  Circle circle;
  const Outline square({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}});
  const auto of = [&](const std::vector<double>& curves, const std::vector<std::uint32_t>& starts,
                      double aspect) { return innerCircle(curves, starts, aspect, circle); };
  EXPECT_EQ(of({}, {0}, 1), Error::kNone);
  EXPECT_TRUE(std::isnan(circle.r));
  EXPECT_EQ(of(square.curves, {0, 3}, 1), Error::kBadLength);
  EXPECT_EQ(of(square.curves, {0, 0, 4}, 1), Error::kBadLength);
  EXPECT_EQ(of(square.curves, {}, 1), Error::kBadLength);
  EXPECT_EQ(of({1, 2}, {0, 1}, 1), Error::kBadLength);
  EXPECT_EQ(of(square.curves, {0, 4}, 0), Error::kOutOfRange);
  EXPECT_EQ(of(square.curves, {0, 4}, NAN), Error::kNotFinite);
  std::vector<double> bad = square.curves;
  bad[3] = NAN;
  EXPECT_EQ(of(bad, {0, 4}, 1), Error::kNotFinite);
  EXPECT_TRUE(std::isnan(circle.r));
}

// --- In diagrams

struct Scene {
  Circles circles;
  Diagram diagram;
  Bounds bounds{0, 0, 100, 60};
  Region region;  // bounds with a hole
  Points border;  // corners of the region; the first four are those of the bounds

  explicit Scene(Circles sites) : circles(std::move(sites)) {
    std::vector<SiteId> ids(circles.size());
    EXPECT_EQ(diagram.insertMany(flat(circles), ids), Error::kNone);
    border = {{0, 0}, {100, 0}, {100, 60}, {0, 60}, {40, 20}, {45, 42}, {70, 35}};
    std::vector<double> coordinates;
    for (const Point p : border) coordinates.insert(coordinates.end(), {p.x, p.y});
    const std::uint32_t starts[] = {0, 4, 7};
    EXPECT_EQ(region.assign(coordinates, starts), Error::kNone);
  }
  [[nodiscard]] Voronoi view(bool hasHole) const {
    return hasHole ? Voronoi(diagram, region) : Voronoi(diagram, bounds);
  }
  [[nodiscard]] bool holds(bool hasHole, Point p) const {
    return hasHole ? region.contains(p.x, p.y) : p.x >= 0 && p.x <= 100 && p.y >= 0 && p.y <= 60;
  }
  [[nodiscard]] double toBorder(bool hasHole, Point p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < (hasHole ? 7u : 4u); ++k) {
      const std::size_t next = k < 4 ? (k + 1) % 4 : 4 + (k - 3) % 3;
      const Point a = border[k], way = border[next] - a;
      const double t = std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0);
      least = std::min(least, length(p - (a + t * way)));
    }
    return least;
  }
  [[nodiscard]] double toSites(Point p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Circle& c : circles) least = std::min(least, distanceTo(c, p.x, p.y));
    return least;
  }
};

Circles sitesIn(Random& random, std::size_t n, double heaviest) {
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const double u = random.unit();
    circles.push_back({140 * random.unit() - 20, 100 * random.unit() - 20, heaviest * u * u});
  }
  return circles;
}

TEST(CellCircles, AreInsideAndNoPlaceHasMoreRoom) {
  Random random(94);
  for (const std::size_t n : {1u, 2u, 5u, 30u, 200u}) {
    for (const double heaviest : {0.0, 2.0, 8.0}) {
      const Scene scene(sitesIn(random, n, heaviest));
      for (const bool hasHole : {false, true}) {
        const Voronoi view = scene.view(hasHole);
        std::vector<double> all;
        ASSERT_EQ(view.cellCirclesBetween(0, static_cast<SiteId>(n), 1, all), Error::kNone);
        ASSERT_EQ(all.size(), 3 * n);
        for (SiteId id = 0; id < n; ++id) {
          Circle circle;
          ASSERT_EQ(view.cellCircle(id, 1, circle), Error::kNone);
          CellMoments moments;
          ASSERT_EQ(view.cellMoments(id, moments), Error::kNone);
          EXPECT_EQ(std::isnan(circle.r), moments.isEmpty);
          if (std::isnan(circle.r)) {
            EXPECT_TRUE(std::isnan(all[3 * id]));
            continue;
          }
          EXPECT_EQ(circle.x, all[3 * id]);
          EXPECT_EQ(circle.y, all[3 * id + 1]);
          EXPECT_EQ(circle.r, all[3 * id + 2]);
          for (int k = 0; k < 24; ++k) {
            const double turn = std::numbers::pi * k / 12, r = circle.r * (1 - 1e-9);
            const Point p{circle.x + r * std::cos(turn), circle.y + r * std::sin(turn)};
            EXPECT_TRUE(scene.holds(hasHole, p));
            EXPECT_LE(distanceTo(scene.circles[id], p.x, p.y), scene.toSites(p) + 1e-9);
          }
        }
        // Half of how much farther the next cell is: less than the way to a place's border
        for (int k = 0; k < sized(300, 3000); ++k) {
          const Point p{100 * random.unit(), 60 * random.unit()};
          if (!scene.holds(hasHole, p)) continue;
          SiteId id = kNoSite;
          ASSERT_EQ(scene.diagram.find(p.x, p.y, id), Error::kNone);
          double room = scene.toBorder(hasHole, p);
          for (SiteId other = 0; other < n; ++other) {
            if (other == id) continue;
            const double more = distanceTo(scene.circles[other], p.x, p.y) - scene.toSites(p);
            room = std::min(room, more / 2);
          }
          EXPECT_GT(all[3 * id + 2], kEnough * room - 1e-12);
        }
      }
    }
  }
}

TEST(CellCircles, ArePartsOfCellsWithinAReach) {
  const Scene scene({{30, 10, 2}, {80, 40, 1}});
  const Reach reach(5);
  for (const Voronoi& view : {Voronoi(scene.diagram, scene.bounds, &reach),
                              Voronoi(scene.diagram, scene.region, &reach)}) {
    Circle circle;
    ASSERT_EQ(view.cellCircle(0, 1, circle), Error::kNone);
    EXPECT_GT(circle.r, 7 * kEnough);
    EXPECT_LE(circle.r, 7);
    EXPECT_NEAR(circle.x, 30, 0.01);
    EXPECT_NEAR(circle.y, 10, 0.01);
  }
}

TEST(CellCircles, OfEllipsesOfAllAspects) {
  Random random(95);
  const Scene scene(sitesIn(random, 60, 4));
  for (const double aspect : {1e-3, 0.02, 0.25, 3.0, 30.0, 300.0, 1e3}) {
    SCOPED_TRACE(aspect);
    std::vector<double> all;
    ASSERT_EQ(scene.view(true).cellCirclesBetween(0, 60, aspect, all), Error::kNone);
    for (SiteId id = 0; id < 60; ++id) {
      if (std::isnan(all[3 * id])) continue;
      for (int k = 0; k < 24; ++k) {
        const double turn = std::numbers::pi * k / 12, r = all[3 * id + 2] * (1 - 1e-9);
        const Point p{all[3 * id] + aspect * r * std::cos(turn),
                      all[3 * id + 1] + r * std::sin(turn)};
        EXPECT_TRUE(scene.holds(true, p));
        EXPECT_LE(distanceTo(scene.circles[id], p.x, p.y), scene.toSites(p) + 1e-9);
      }
    }
  }
}

TEST(CellCircles, OfACircleThatALargerOneCoversButForALittle) {
  for (const double rest : {1e-1, 1e-3, 1e-6, 1e-9}) {
    for (const double turn : {0.0, 1.0, 2.2}) {
      const double away = 9 + rest;
      const Scene scene(
          {{50, 30, 10}, {50 + away * std::cos(turn), 30 + away * std::sin(turn), 1}});
      Circle circle;
      ASSERT_EQ(scene.view(false).cellCircle(1, 1, circle), Error::kNone);
      EXPECT_GT(circle.r, 0);
      EXPECT_LT(circle.r, 25 * std::sqrt(rest));  // as wide as the cell grows in the window
    }
  }
}

VertexArrays emptyCirclesIn(const Voronoi& view, std::size_t most, bool inside) {
  VertexArrays circles;
  EXPECT_EQ(view.emptyCircles(most, inside, circles), Error::kNone);
  EXPECT_EQ(circles.coordinates.size(), 2 * circles.sites.size());
  EXPECT_EQ(circles.clearance.size(), circles.sites.size());
  return circles;
}

TEST(EmptyCircles, AreEmptyApartAndTheLargest) {
  Random random(96);
  for (const std::size_t n : {1u, 2u, 3u, 12u, 80u}) {
    for (const double heaviest : {0.0, 8.0}) {
      const Scene scene(sitesIn(random, n, heaviest));
      for (const bool hasHole : {false, true}) {
        for (const bool inside : {false, true}) {
          const VertexArrays circles = emptyCirclesIn(scene.view(hasHole), 12, inside);
          ASSERT_FALSE(circles.sites.empty());
          for (std::size_t k = 0; k < circles.sites.size(); ++k) {
            const Point at{circles.coordinates[2 * k], circles.coordinates[2 * k + 1]};
            const double r = circles.clearance[k];
            EXPECT_TRUE(scene.holds(hasHole, at));
            EXPECT_LE(r, circles.clearance[k > 0 ? k - 1 : 0]);
            EXPECT_NEAR(distanceTo(scene.circles[circles.sites[k]], at.x, at.y), scene.toSites(at),
                        1e-9);
            const double room = inside ? std::min(scene.toSites(at), scene.toBorder(hasHole, at))
                                       : scene.toSites(at);
            EXPECT_NEAR(r, room, 1e-9);
            for (std::size_t before = 0; before < k; ++before) {
              const Point other{circles.coordinates[2 * before],
                                circles.coordinates[2 * before + 1]};
              EXPECT_GE(length(at - other), circles.clearance[before] - 1e-12);
            }
          }
          for (int k = 0; k < sized(500, 5000); ++k) {
            const Point p{100 * random.unit(), 60 * random.unit()};
            if (!scene.holds(hasHole, p)) continue;
            const double room =
                inside ? std::min(scene.toSites(p), scene.toBorder(hasHole, p)) : scene.toSites(p);
            EXPECT_GE(circles.clearance[0], (inside ? kEnough : 1) * room - 1e-9);
          }
        }
      }
    }
  }
}

TEST(EmptyCircles, OfTwoPointsInARectangle) {
  const Scene scene({{30, 30, 0}, {70, 30, 0}});
  const VertexArrays circles = emptyCirclesIn(scene.view(false), 5, true);
  ASSERT_FALSE(circles.sites.empty());
  EXPECT_GT(circles.clearance[0], 19);
  EXPECT_TRUE(std::is_sorted(circles.clearance.rbegin(), circles.clearance.rend()));
}

// Found by such windows: cells with an edge beside a side of the window, where r is the same all
// along it; two sides that cut off two corners of a box, which were taken for a strip; circles out
// of order; clusters of sites some doubles apart.
TEST(EmptyCircles, InsidePolygonsOfAllShapesAroundAllKindsOfSites) {
  Random random(98);
  for (int run = 0; run < sized(240, 6000); ++run) {
    SCOPED_TRACE(run);
    const int kind = run % 4;
    const std::size_t n = 1 + random.below(std::size_t{30});
    Circles circles;
    for (std::size_t k = 0; k < n; ++k) {
      const double u = random.unit(), v = random.unit(), share = static_cast<double>(k) / 30;
      if (kind == 0) circles.push_back({u, v, 0});
      if (kind == 1) circles.push_back({u, v, 0.2 * share * share * share});
      if (kind == 2) circles.push_back({share, 0.5, 0.01 * u});
      if (kind == 3) circles.push_back({0.3 + 1e-7 * u * u, 0.3 + 1e-7 * v * v, 0});
    }
    const double squash = random.oneIn(3) ? 0.15 : 1;
    const std::size_t sides = 3 + random.below(std::size_t{30});
    Points ring;
    for (std::size_t k = 0; k < sides; ++k) {
      const double turn =
                       2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(sides),
                   r = 0.45 + 0.05 * random.unit();
      ring.push_back({0.5 + r * std::cos(turn), 0.5 + squash * r * std::sin(turn)});
    }
    Diagram diagram;
    std::vector<SiteId> ids(n);
    ASSERT_EQ(diagram.insertMany(flat(circles), ids), Error::kNone);
    std::vector<double> coordinates;
    for (const Point p : ring) coordinates.insert(coordinates.end(), {p.x, p.y});
    const std::uint32_t starts[] = {0, static_cast<std::uint32_t>(sides)};
    Region region;
    ASSERT_EQ(region.assign(coordinates, starts), Error::kNone);
    const auto roomAt = [&](Point p) {
      double room = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < sides; ++k) {
        const Point a = ring[k], way = ring[(k + 1) % sides] - a;
        const double t = std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0);
        room = std::min(room, length(p - (a + t * way)));
      }
      for (const Circle& c : circles) room = std::min(room, distanceTo(c, p.x, p.y));
      return room;
    };
    const Voronoi view(diagram, region);
    const VertexArrays found = emptyCirclesIn(view, 5, true);
    ASSERT_FALSE(found.sites.empty());
    for (std::size_t k = 0; k < found.sites.size(); ++k) {
      const double r = found.clearance[k];
      EXPECT_NEAR(r, roomAt({found.coordinates[2 * k], found.coordinates[2 * k + 1]}),
                  3e-4 * std::abs(r) + 1e-12);
      EXPECT_LE(r, found.clearance[k > 0 ? k - 1 : 0]);
    }
    for (int k = 0; k < 300; ++k) {
      const Point p{random.unit(), random.unit()};
      if (region.contains(p.x, p.y)) {
        EXPECT_GE(found.clearance[0], kEnough * roomAt(p) - 1e-12);
      }
    }
    std::vector<double> cells;
    EXPECT_EQ(view.cellCirclesBetween(0, static_cast<SiteId>(n), 1, cells), Error::kNone);
  }
}

TEST(EmptyCircles, OfNoSitesACoveredWindowAndAReach) {
  EXPECT_TRUE(emptyCirclesIn(Scene({}).view(true), 3, true).sites.empty());
  const Scene covered({{50, 30, 99}});
  for (const bool inside : {false, true})
    EXPECT_LT(emptyCirclesIn(covered.view(true), 1, inside).clearance[0], 0);
  Random random(97);
  const Scene scene(sitesIn(random, 20, 3));
  const Reach reach(1);
  for (const bool inside : {false, true}) {
    EXPECT_EQ(emptyCirclesIn(Voronoi(scene.diagram, scene.region, &reach), 4, inside).clearance,
              emptyCirclesIn(scene.view(true), 4, inside).clearance);
    EXPECT_TRUE(emptyCirclesIn(scene.view(true), 0, inside).sites.empty());
  }
}

TEST(Region, HasItsCentroid) {
  Region region;
  const double rings[] = {1e6,     0, 1e6 + 4, 0, 1e6 + 4, 4, 1e6,     4,
                          1e6 + 2, 2, 1e6 + 2, 4, 1e6 + 4, 4, 1e6 + 4, 2};
  const std::uint32_t starts[] = {0, 4, 8};  // a square without its upper right quarter
  EXPECT_EQ(region.centroidX(), 0);
  ASSERT_EQ(region.assign(rings, starts), Error::kNone);
  EXPECT_DOUBLE_EQ(region.area(), 12);
  EXPECT_NEAR(region.centroidX(), 1e6 + 5.0 / 3, 1e-9);
  EXPECT_NEAR(region.centroidY(), 5.0 / 3, 1e-9);
}

}  // namespace
}  // namespace apollonius::test
