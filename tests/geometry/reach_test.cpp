// Cells that end at a distance from their sites' circles: against sampled points, against closed
// forms, and as polygons.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "geometry/coverage_judge.h"
#include "geometry/curve/moments.h"
#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A window that is a rectangle, or that and a hole in it.
struct Window {
  Bounds bounds;
  Region region;
  bool isRegion = false;
  std::vector<double> hole;

  explicit Window(const Bounds& b) : bounds(b) {}
  Window(const Bounds& b, double share) : bounds(b), isRegion(true) {
    const double w = share * (b.xmax - b.xmin), h = share * (b.ymax - b.ymin);
    hole = {b.xmin + w, b.ymin + 1.1 * h, b.xmax - 1.2 * w,
            b.ymin + h, b.xmax - w,       b.ymax - 1.3 * h};
    std::vector<double> rings = {b.xmin, b.ymin, b.xmax, b.ymin, b.xmax, b.ymax, b.xmin, b.ymax};
    rings.insert(rings.end(), hole.begin(), hole.end());
    const std::uint32_t starts[] = {0, 4, 7};
    EXPECT_EQ(region.assign(rings, starts), Error::kNone);
  }
  [[nodiscard]] Voronoi of(const Diagram& diagram, const Reach* reach) const {
    return isRegion ? Voronoi(diagram, region, reach) : Voronoi(diagram, bounds, reach);
  }
  [[nodiscard]] bool holds(double x, double y) const {
    if (x < bounds.xmin || x > bounds.xmax || y < bounds.ymin || y > bounds.ymax) return false;
    bool isInHole = false;
    for (std::size_t k = 0; k < hole.size(); k += 2) {
      const std::size_t next = (k + 2) % hole.size();
      const double x1 = hole[k], y1 = hole[k + 1], x2 = hole[next], y2 = hole[next + 1];
      if ((y1 > y) != (y2 > y) && x < x1 + (y - y1) / (y2 - y1) * (x2 - x1)) isInHole = !isInHole;
    }
    return !isInHole;
  }
};

/// The area of each cell by a grid of points.
std::vector<double> sampledAreas(const Circles& circles, const std::vector<double>& reach,
                                 const Window& window, int side) {
  std::vector<double> areas(circles.size(), 0);
  const Bounds& b = window.bounds;
  const double w = (b.xmax - b.xmin) / side, h = (b.ymax - b.ymin) / side;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) {
      const double x = b.xmin + (i + 0.5) * w, y = b.ymin + (j + 0.5) * h;
      if (!window.holds(x, y)) continue;
      std::size_t best = 0;
      for (std::size_t k = 1; k < circles.size(); ++k) {
        if (distanceTo(circles[k], x, y) < distanceTo(circles[best], x, y)) best = k;
      }
      if (distanceTo(circles[best], x, y) <= reach[best]) areas[best] += w * h;
    }
  }
  return areas;
}

/// A distance for each site, the same or different ones, some of them 0, below 0 or infinite.
std::vector<double> someReach(Random& random, std::size_t count, double size, bool isSame) {
  std::vector<double> reach(count, size * random.between(0.02, 0.6));
  if (isSame) return reach;
  for (double& distance : reach) {
    const std::size_t kind = random.below(std::size_t{8});
    distance = kind == 0   ? 0
               : kind == 1 ? kInfinity
               : kind == 2 ? -size * random.between(0, 0.05)
                           : size * random.between(0.01, 0.6);
  }
  return reach;
}

TEST(Reach, OfOneSite) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 1}});
  const auto areaIn = [&](const Bounds& bounds, double distance) {
    const Reach reach(distance);
    CellMeasures measures;
    EXPECT_EQ(Voronoi(diagram, bounds, &reach).cellMeasures(0, measures), Error::kNone);
    return measures.area;
  };
  EXPECT_NEAR(areaIn({-9, -9, 9, 9}, 2), 9 * kPi, 1e-12);
  EXPECT_NEAR(areaIn({0, -9, 9, 9}, 2), 4.5 * kPi, 1e-12);
  EXPECT_NEAR(areaIn({0, 0, 9, 9}, 2), 2.25 * kPi, 1e-12);
  EXPECT_NEAR(areaIn({-3, -3, 3, 3}, 2), 9 * kPi, 1e-12);  // touched by the sides
  EXPECT_NEAR(areaIn({-1, -1, 1, 1}, 2), 4, 1e-12);
  EXPECT_NEAR(areaIn({4, 4, 9, 9}, 2), 0, 1e-12);
  EXPECT_NEAR(areaIn({-9, -9, 9, 9}, kInfinity), 324, 1e-9);
  EXPECT_EQ(areaIn({-9, -9, 9, 9}, -1), 0);
  EXPECT_EQ(areaIn({-9, -9, 9, 9}, -5), 0);
  EXPECT_NEAR(areaIn({-9, -9, 9, 9}, -0.5), kPi / 4, 1e-12);
}

TEST(Reach, OfTwoSitesThatMeet) {
  // Circles of radius 5 about centres 6 apart: each loses the segment beyond the middle.
  Diagram diagram;
  insertInto(diagram, {{-3, 0, 1}, {3, 0, 1}});
  const Reach reach(4);
  const Voronoi voronoi(diagram, {-20, -20, 20, 20}, &reach);
  const double half = std::acos(0.6), expected = 25 * (kPi - half) + 3 * 4;
  std::vector<double> areas, perimeters;
  ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
  EXPECT_NEAR(areas[0], expected, 1e-11);
  EXPECT_NEAR(areas[1], expected, 1e-11);
  ASSERT_EQ(voronoi.cellPerimeters(perimeters), Error::kNone);
  EXPECT_NEAR(perimeters[0], 2 * 5 * (kPi - half) + 8, 1e-11);
  CurveArrays edges;
  ASSERT_EQ(voronoi.edgeCurves(edges), Error::kNone);
  ASSERT_EQ(edges.sites.size(), 2u);
  EXPECT_NEAR(std::abs(edges.curves[1]), 4, 1e-12);
  EXPECT_NEAR(edges.curves[0], 0, 1e-12);
}

TEST(Reach, ADistanceForEachSite) {
  // The second one reaches to the bisector only; the first one's edge goes on without it.
  Diagram diagram;
  insertInto(diagram, {{-3, 0, 0}, {3, 0, 0}});
  const std::vector<double> distances{5, 3.5};
  const Reach reach{std::span<const double>(distances)};
  const Voronoi voronoi(diagram, {-20, -20, 20, 20}, &reach);
  CurveArrays boundary;
  ASSERT_EQ(voronoi.cellCurves(0, boundary), Error::kNone);
  double shared = 0, straight = 0;
  for (std::size_t k = 0; k < boundary.sites.size(); ++k) {
    const double* c = &boundary.curves[7 * k];
    if (c[0] != 0 || c[5] != 0) continue;
    straight += std::abs(c[6] - c[1]);
    if (boundary.sites[k] == 1) shared += std::abs(c[6] - c[1]);
  }
  EXPECT_NEAR(straight, 8, 1e-12);
  EXPECT_NEAR(shared, 2 * std::sqrt(3.5 * 3.5 - 9), 1e-12);
  CurveArrays edges;  // between the two cells
  ASSERT_EQ(voronoi.edgeCurves(edges), Error::kNone);
  EXPECT_NEAR(lengthOfCurves(edges), shared, 1e-12);
}

/// Length of lines and curves, the latter by points on them.
double drawnLength(const Path& path) {
  double sum = 0;
  Place from;
  const double* at = path.coordinates.data();
  for (const std::uint8_t command : path.commands) {
    const bool isCurve = static_cast<Command>(command) == Command::kCurve;
    const Place end{at[isCurve ? 4 : 0], at[isCurve ? 5 : 1]};
    Place before = from;
    for (int k = 1; k <= 32 && static_cast<Command>(command) != Command::kMove; ++k) {
      const double t = k / 32.0, s = 1 - t;
      const auto cubic = [&](double p, double q0, double q1, double q2) {
        return s * s * s * p + 3 * s * s * t * q0 + 3 * s * t * t * q1 + t * t * t * q2;
      };
      const Place place =
          isCurve ? Place{cubic(from.first, at[0], at[2], at[4]),
                          cubic(from.second, at[1], at[3], at[5])}
                  : Place{s * from.first + t * end.first, s * from.second + t * end.second};
      sum += std::hypot(place.first - before.first, place.second - before.second);
      before = place;
    }
    from = end;
    at += isCurve ? 6 : 2;
  }
  return sum;
}

/// Sixty circles of radii up to 6 in a square of side 100.
Diagram sixtyCircles(std::uint64_t seed) {
  Random random(seed);
  Circles circles;
  for (int k = 0; k < 60; ++k)
    circles.push_back({random.between(0, 100), random.between(0, 100), random.between(0, 6)});
  Diagram diagram;
  insertInto(diagram, circles);
  return diagram;
}

TEST(Reach, DrawnEdgesAreWhatCellsShareOnceAndWhereTheyEnd) {
  Diagram diagram = sixtyCircles(673);
  bool isRemoved = false;
  ASSERT_EQ(diagram.remove(7, isRemoved), Error::kNone);
  const Reach reach(5);
  const Voronoi voronoi(diagram, {-50, -50, 150, 150}, &reach);  // no cell comes to the border
  std::vector<double> perimeters;
  CurveArrays edges;
  ASSERT_EQ(voronoi.cellPerimeters(perimeters), Error::kNone);
  ASSERT_EQ(voronoi.edgeCurves(edges), Error::kNone);
  double expected = 0;
  for (const double perimeter : perimeters) expected += perimeter;
  expected -= lengthOfCurves(edges);
  Path whole;
  drawEdgesInPortions(voronoi, 1e-4, 16, whole);
  EXPECT_NEAR(drawnLength(whole), expected, 1e-3 * expected);
}

TEST(Reach, AnEdgeIsSharedAsFarAsBothSitesReach) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 0}, {4, 0, 0}});
  for (const std::vector<double>& distances : {std::vector<double>{10, 3}, {3, 10}}) {
    const Reach reach{std::span<const double>(distances)};
    CurveArrays edges;
    ASSERT_EQ(Voronoi(diagram, {-20, -20, 20, 20}, &reach).edgeCurves(edges), Error::kNone);
    EXPECT_NEAR(lengthOfCurves(edges), 2 * std::sqrt(5), 1e-12);  // x = 2, up to 3 from one site
  }
}

TEST(Reach, PolygonsOfCellsThatEndBeforeTheWindowAreNone) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 1}, {4, 0, 1}});
  const Reach reach(3);
  CoverageArrays coverage;
  ASSERT_EQ(Voronoi(diagram, {20, 20, 30, 30}, &reach).cellPolygons(1, coverage), Error::kNone);
  EXPECT_TRUE(coverage.sites.empty());
  EXPECT_TRUE(coverage.coordinates.empty());
}

/// The circles of both cells, and the edge between them, are symmetric about a line across the side
/// that the first circle touches: at any of the four, at the origin and elsewhere, and in windows
/// of both kinds. With `isInscribed` it touches the two sides beside that one as well.
TEST(Reach, ACircleThatTouchesASideIsCutAsIfItWereElsewhere) {
  for (const double place : {0.0, -1000.0, 0.1}) {
    for (const std::size_t side : {0, 1, 2, 3}) {
      const auto circle = [&](double away, double weight) -> Circle {
        const double x[] = {1, 0, -1, 0}, y[] = {0, 1, 0, -1};
        return {place + x[side] * away, place + y[side] * away, weight};
      };
      for (const bool isInscribed : {false, true}) {
        for (double radius = 8; radius <= 12; radius += 0.5) {
          for (const double r : {0.0, 1.0, 2.0}) {
            const double half = isInscribed ? radius : 30;
            const double across = place + half, under = place - half;
            Bounds bounds{under, under, across, across},
                wider{place - 40, place - 40, place + 40, place + 40};
            double* const sides[] = {&bounds.xmax, &bounds.ymax, &bounds.xmin, &bounds.ymin};
            double* const behind[] = {&bounds.xmin, &bounds.ymin, &bounds.xmax, &bounds.ymax};
            *sides[side] = place;
            *behind[side] = side < 2 ? place - 30 : place + 30;
            Diagram diagram;
            insertInto(diagram, {circle(-radius, r), circle(-25, 1)});
            const Reach reach(radius - r);
            CellMoments expected;
            ASSERT_EQ(Voronoi(diagram, wider, &reach).cellMoments(0, expected), Error::kNone);
            ASSERT_GT(expected.area, 2 * radius * radius);
            Region region;
            const double ring[] = {bounds.xmin, bounds.ymin, bounds.xmax, bounds.ymin,
                                   bounds.xmax, bounds.ymax, bounds.xmin, bounds.ymax};
            const std::uint32_t starts[] = {0, 4};
            ASSERT_EQ(region.assign(ring, starts), Error::kNone);
            for (const Voronoi& voronoi :
                 {Voronoi(diagram, bounds, &reach), Voronoi(diagram, region, &reach)}) {
              CellMoments moments;
              std::vector<double> areas;
              RingArrays polygon;
              ASSERT_EQ(voronoi.cellMoments(0, moments), Error::kNone);
              ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
              ASSERT_EQ(voronoi.cellPolygon(0, 1e-3, polygon), Error::kNone);
              EXPECT_NEAR(moments.area, expected.area, 1e-6 * expected.area) << radius << " " << r;
              EXPECT_NEAR(areas[0], expected.area, 1e-6 * expected.area) << radius << " " << r;
              EXPECT_NEAR(areaOf(polygon), expected.area, 1e-2 * expected.area);
            }
          }
        }
      }
    }
  }
}

/// Cells of a lattice are rectangles of 6 by 8: circles of radius 3 and 4 touch their sides, one of
/// radius 5 passes their corners.
TEST(Reach, CirclesThatTouchEdgesOrEndInVerticesAreCutAsOthersAre) {
  const double discWithin3 = 2 * (3 * std::sqrt(7.0) + 16 * std::asin(0.75));
  for (const double scale : {1.0, 0.1, 1e6}) {
    for (const double place : {0.0, 0.3, -1000.0}) {
      for (const double r : {0.0, 1.0}) {
        Circles circles;
        for (int i = 0; i < 4; ++i) {
          for (int j = 0; j < 4; ++j)
            circles.push_back({scale * (place + 6 * i), scale * (place + 8 * j), scale * r});
        }
        Diagram diagram;
        insertInto(diagram, circles);
        const double low = scale * (place - 3), bottom = scale * (place - 4);
        const Bounds bounds{low, bottom, low + scale * 24, bottom + scale * 32};
        for (const auto& [radius, area] :
             {std::pair{3.0, 9 * kPi}, {4.0, discWithin3}, {5.0, 48.0}, {6.0, 48.0}}) {
          SCOPED_TRACE(testing::Message() << scale << ' ' << place << ' ' << r << ' ' << radius);
          const Reach reach(scale * (radius - r));
          const Voronoi voronoi(diagram, bounds, &reach);
          std::vector<double> areas;
          CoverageArrays coverage;
          ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
          ASSERT_EQ(voronoi.cellPolygons(scale * 1e-4, coverage), Error::kNone);
          EXPECT_EQ(coverage.sites.size(), circles.size());
          for (SiteId id = 0; id < areas.size(); ++id) {
            RingArrays polygon;
            ASSERT_EQ(voronoi.cellPolygon(id, scale * 1e-4, polygon), Error::kNone);
            EXPECT_NEAR(areas[id], scale * scale * area, 1e-7 * scale * scale * area);
            EXPECT_NEAR(areaOf(polygon), scale * scale * area, 1e-3 * scale * scale * area);
          }
        }
      }
    }
  }
}

/// Expects polygons of all cells that fit together and have the areas of the cells, up to a share.
void expectPolygons(const Voronoi& voronoi, double tolerance, double share) {
  std::vector<double> areas;
  CoverageArrays coverage;
  ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
  ASSERT_EQ(voronoi.cellPolygons(tolerance, coverage), Error::kNone);
  CoverageJudge judge(coverage, 0);
  judge.expectNoCrossings();
  EXPECT_EQ(judge.complaints(), "");
  for (SiteId id = 0; id < areas.size(); ++id) {
    RingArrays polygon;
    ASSERT_EQ(voronoi.cellPolygon(id, tolerance, polygon), Error::kNone);
    EXPECT_NEAR(areaOf(polygon), areas[id], share * areas[id]) << "site " << id;
  }
}

/// The smaller circle's reach ends where it touches the edge, which bends around it and goes on:
/// all chords there enter the circle, and a corner of its polygon can be beyond one.
TEST(Reach, PolygonsFitWhereAReachTouchesAnEdgeThatGoesOn) {
  for (const double scale : {1.0, 0x1p-19, 0x1p20}) {
    for (const double place : {0.0, 1000.0}) {
      for (const auto& [dx, dy] : {std::pair{2, 0}, {0, -3}, {3, 4}, {-1, 3}, {-2, -2}, {-4, 1}}) {
        for (const double weight : {0.0, 0.5, 1.0}) {
          const double distance = std::sqrt(1.0 * dx * dx + dy * dy);
          for (const double off : {0.0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-9, 1e-6, -1e-6}) {
            for (const double farther : {kInfinity, 1.5 * scale}) {
              SCOPED_TRACE(testing::Message() << scale << ' ' << place << ' ' << dx << ' ' << dy
                                              << ' ' << weight << ' ' << off << ' ' << farther);
              const double x = scale * place, half = (distance - weight) / 2 * (1 + off);
              Diagram diagram;
              insertInto(diagram,
                         {{x, scale, scale * weight}, {x + scale * dx, scale + scale * dy, 0}});
              const std::vector<double> distances{farther, scale * half};
              const Reach reach{std::span<const double>(distances)};
              const Window rectangle({x - 50 * scale, -50 * scale, x + 50 * scale, 50 * scale});
              Region triangle;
              const double ring[] = {x + 40 * scale, -40 * scale,    x + 40 * scale,
                                     40 * scale,     x - 40 * scale, 40 * scale};
              const std::uint32_t starts[] = {0, 3};
              ASSERT_EQ(triangle.assign(ring, starts), Error::kNone);
              for (const double tolerance : {0.0, 0.1 * scale}) {
                const double share = tolerance == 0 ? 0.01 : 1;
                expectPolygons(rectangle.of(diagram, &reach), tolerance, share);
                expectPolygons(Voronoi(diagram, triangle, &reach), tolerance, share);
              }
            }
          }
        }
      }
    }
  }
}

/// A corner of the window that points inwards is on the circle in which the cell ends.
TEST(Reach, PolygonsFitWhereACircleTouchesACornerOfTheWindow) {
  for (const double scale : {1.0, 0x1p-19, 0x1p20}) {
    for (const double x : {4.0, 5.0, 6.0, 7.0, 8.0}) {
      for (const double y : {2.0, 5.0, 7.0}) {
        Region notched;
        std::vector<double> ring{-50, -50, 50, -50, 50, 50, 6, 0, -50, 50};
        for (double& coordinate : ring) coordinate *= scale;
        const std::uint32_t starts[] = {0, 5};
        ASSERT_EQ(notched.assign(ring, starts), Error::kNone);
        Diagram diagram;
        insertInto(diagram, {{scale * x, scale * y, scale}, {scale * -2, scale * 7, scale}});
        const std::vector<double> distances{scale * (std::sqrt((x - 6) * (x - 6) + y * y) - 1),
                                            scale};
        const Reach reach{std::span<const double>(distances)};
        for (const double tolerance : {0.0, 1e-3 * scale, scale}) {
          SCOPED_TRACE(testing::Message() << scale << ' ' << x << ' ' << y << ' ' << tolerance);
          expectPolygons(Voronoi(diagram, notched, &reach), tolerance, tolerance == 0 ? 0.01 : 1);
        }
      }
    }
  }
}

/// Circles that pass corners of the window, end in vertices or touch edges, by small numbers.
TEST(Reach, BoundariesHaveNoPiecesWithoutLength) {
  Random random(675);
  const auto tick = [&](std::size_t count) { return static_cast<double>(random.below(count)) / 2; };
  for (int run = 0; run < runs(1000); ++run) {
    Circles circles;
    std::vector<double> distances;
    for (int k = 0; k < 5; ++k) {
      circles.push_back({tick(20), tick(20), tick(3)});
      const double toSomePlace = std::hypot(tick(20) - circles[k].x, tick(20) - circles[k].y);
      distances.push_back(run % 4 == 0 ? tick(8) : toSomePlace - circles[k].r);
    }
    Diagram diagram;
    insertInto(diagram, circles);
    const Reach reach{std::span<const double>(distances)};
    const Bounds bounds{2, 3, 8 + tick(20), 9 + tick(20)};
    for (const Window& window : {Window(bounds), Window(bounds, 0.25)}) {
      for (SiteId id = 0; id < circles.size(); ++id) {
        CurveArrays boundary;
        ASSERT_EQ(window.of(diagram, &reach).cellCurves(id, boundary), Error::kNone);
        for (std::size_t k = 0; k < boundary.curves.size(); k += 7) {
          const double* const curve = &boundary.curves[k];
          EXPECT_FALSE(curve[0] == curve[5] && curve[1] == curve[6])
              << "run " << run << " site " << id << ": " << curve[0] << ' ' << curve[1];
        }
      }
    }
  }
}

TEST(Reach, WithoutADistanceACellIsNotLimited) {
  Diagram diagram;
  insertInto(diagram, {{-3, 0, 0}, {3, 0, 0}, {100, 0, 0}});
  const double distance[] = {2};
  const SiteId id[] = {1};
  std::vector<double> areas;
  const double disc = 4 * std::acos(-1.0);
  const Reach first{std::span<const double>(distance)}, second(id, distance);
  ASSERT_EQ(Voronoi(diagram, {-9, -9, 9, 9}, &first).cellAreas(areas), Error::kNone);
  EXPECT_NEAR(areas[0], disc, 1e-12);
  EXPECT_NEAR(areas[1], 162, 1e-12);
  ASSERT_EQ(Voronoi(diagram, {-9, -9, 9, 9}, &second).cellAreas(areas), Error::kNone);
  EXPECT_NEAR(areas[0], 162, 1e-12);
  EXPECT_NEAR(areas[1], disc, 1e-12);
  EXPECT_FALSE(second.isUnlimited());
  EXPECT_EQ(second.of(2), kInfinity);
}

TEST(Reach, DistancesOfSomeSitesAreThoseOfAllForTheirCells) {
  Random random(907);
  const Circles circles = randomCircles(random, 40, Hidden::kNone);
  Diagram diagram;
  insertInto(diagram, circles);
  Bounds bounds;
  ASSERT_TRUE(windowAround(circles, 0.2, bounds));
  const std::vector<double> distances =
      someReach(random, circles.size(), (bounds.xmax - bounds.xmin) / 8, false);
  const Reach all{std::span<const double>(distances)};
  for (SiteId id = 0; id < circles.size(); ++id) {
    std::vector<SiteId> ids, near;
    ASSERT_EQ(diagram.neighbors(id, ids), Error::kNone);
    ids.push_back(id);
    std::sort(ids.begin(), ids.end());
    std::vector<double> some;
    for (const SiteId one : ids) some.push_back(distances[one]);
    const Reach about(ids, some);
    CurveArrays expected, curves;
    ASSERT_EQ(Voronoi(diagram, bounds, &all).cellCurves(id, expected), Error::kNone);
    ASSERT_EQ(Voronoi(diagram, bounds, &about).cellCurves(id, curves), Error::kNone);
    EXPECT_EQ(curves.curves, expected.curves);
    EXPECT_EQ(curves.sites, expected.sites);
    std::vector<SiteId> expectedNear;
    ASSERT_EQ(Voronoi(diagram, bounds, &all).neighbors(id, expectedNear), Error::kNone);
    ASSERT_EQ(Voronoi(diagram, bounds, &about).neighbors(id, near), Error::kNone);
    EXPECT_EQ(near, expectedNear);
  }
}

TEST(Reach, BadDistancesAreRefused) {
  Diagram diagram;
  insertInto(diagram, {{-3, 0, 0}});
  std::vector<double> areas;
  const auto answer = [&](double distance) {
    const Reach reach(distance);
    return Voronoi(diagram, {-9, -9, 9, 9}, &reach).cellAreas(areas);
  };
  EXPECT_EQ(answer(std::numeric_limits<double>::quiet_NaN()), Error::kNotFinite);
  EXPECT_EQ(answer(-kInfinity), Error::kOutOfRange);
  EXPECT_EQ(answer(1e200), Error::kOutOfRange);
  EXPECT_EQ(answer(kInfinity), Error::kNone);
  const auto first = [&](double distance) {
    const Reach reach(std::vector<double>{distance, 1});
    return Voronoi(diagram, {-9, -9, 9, 9}, &reach).cellAreas(areas);
  };
  EXPECT_EQ(first(std::numeric_limits<double>::quiet_NaN()), Error::kNotFinite);
  EXPECT_EQ(first(-kInfinity), Error::kOutOfRange);
  EXPECT_EQ(first(kInfinity), Error::kNone);
}

TEST(Reach, WithoutLimitCellsMakeUpTheWindow) {
  Diagram diagram;
  insertInto(diagram, {{-3, 0, 0}, {3, 1, 1}, {0, 5, 2}, {1, -4, 0}});
  const Reach unlimited(kInfinity);
  CoverageArrays whole, polygons;
  ASSERT_EQ(Voronoi(diagram, {-9, -9, 9, 9}).cellPolygons(0.01, whole), Error::kNone);
  ASSERT_EQ(Voronoi(diagram, {-9, -9, 9, 9}, &unlimited).cellPolygons(0.01, polygons),
            Error::kNone);
  EXPECT_EQ(polygons.sites, whole.sites);
  EXPECT_EQ(polygons.coordinates, whole.coordinates);
}

TEST(Reach, PathsOfCellsInPortionsMakeUpTheWhole) {
  const Diagram diagram = sixtyCircles(674);
  const Reach reach(5);
  for (const Window& window : {Window({-10, 10, 90, 120}), Window({-10, 10, 90, 120}, 0.3)}) {
    for (const Reach* limit : {static_cast<const Reach*>(nullptr), &reach}) {
      const Voronoi voronoi = window.of(diagram, limit);
      CellPaths whole, part;
      Portion all, portion{0, 20};
      ASSERT_EQ(voronoi.cellPaths(0.01, 3, all, whole), Error::kNone);
      EXPECT_TRUE(all.isDone);
      EXPECT_FALSE(whole.content.empty());
      std::vector<std::uint8_t> joined;
      while (!portion.isDone) {
        ASSERT_EQ(voronoi.cellPaths(0.01, 3, portion, part), Error::kNone);
        joined.insert(joined.end(), part.content.begin(), part.content.end());
      }
      EXPECT_EQ(joined, whole.content);
    }
  }
}

TEST(Reach, AreasAreThoseOfSampledPoints) {
  Random random(671);
  for (int run = 0; run < runs(25) && !::testing::Test::HasFailure(); ++run) {
    const Circles circles =
        randomCircles(random, 2 + random.below(std::size_t{12}), Hidden::k20Percent);
    Bounds bounds;
    if (!windowAround(circles, random.between(-0.2, 0.5), bounds)) continue;
    const double size = bounds.xmax - bounds.xmin;
    const std::vector<double> distances = someReach(random, circles.size(), size, run % 3 == 0);
    const Reach reach{std::span<const double>(distances)};
    const Window rectangle(bounds), withHole(bounds, 0.2);
    for (const Window* window : {&rectangle, &withHole}) {
      Diagram diagram;
      insertInto(diagram, circles);
      const Voronoi voronoi = window->of(diagram, &reach);
      constexpr int kSide = 300;
      const std::vector<double> expected = sampledAreas(circles, distances, *window, kSide);
      std::vector<double> areas;
      ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
      for (SiteId id = 0; id < circles.size(); ++id) {
        EXPECT_NEAR(areas[id], expected[id], 12 * areaOf(bounds) / kSide)
            << "run " << run << " site " << id << "\n"
            << toText(insertAll(circles));
        CellMoments moments;
        ASSERT_EQ(voronoi.cellMoments(id, moments), Error::kNone);
        EXPECT_NEAR(moments.area, areas[id], 1e-9 * areaOf(bounds));
      }
    }
  }
}

/// Says what is wrong with the polygons; empty if nothing is.
std::string faultsIn(const Circles& circles, const std::vector<double>& distances,
                     const Window& window, double tolerance) {
  Diagram diagram;
  insertInto(diagram, circles);
  const Reach reach{std::span<const double>(distances)};
  CoverageArrays coverage;
  EXPECT_EQ(window.of(diagram, &reach).cellPolygons(tolerance, coverage), Error::kNone);
  CoverageJudge judge(coverage, 0);
  const double size = sizeOf(window.bounds), rounding = 1e-9 * size;
  judge.expectPairs([&](Place p, Place q) {
    // On the window's border; or both where some site's reach ends, or on an edge beyond that.
    for (const double share : {0.3, 0.5, 0.7}) {
      const double x = p.first + share * (q.first - p.first),
                   y = p.second + share * (q.second - p.second);
      const double nx = q.second - p.second, ny = p.first - q.first, length = std::hypot(nx, ny);
      if (length == 0) return true;
      if (!window.holds(x + nx / length * rounding, y + ny / length * rounding)) return true;
    }
    const auto isAtReach = [&](Place at) {
      std::vector<double> own;
      for (std::size_t k = 0; k < circles.size(); ++k)
        own.push_back(distanceTo(circles[k], at.first, at.second));
      const auto nearest =
          static_cast<std::size_t>(std::min_element(own.begin(), own.end()) - own.begin());
      for (std::size_t k = 0; k < own.size(); ++k) {
        if (own[k] <= own[nearest] + rounding && own[k] >= distances[k] - rounding) return true;
      }
      return false;
    };
    return isAtReach(p) && isAtReach(q);
  });
  judge.expectNoCrossings();
  return judge.complaints();
}

class ReachOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(ReachOn, PolygonsFitTogether) {
  // Distances as small as those of doubles, and places far beyond all that is in the window: a
  // vertex can be within reach for one cell and not for the next one.
  const std::string name = GetParam().name;
  if (name == "OneUlpApart" || name == "MixedMagnitudes") GTEST_SKIP();
  Random random(672);
  for (int run = 0; run < runs(2); ++run) {
    const auto k = static_cast<std::size_t>(run);
    const Circles circles = GetParam().make(random, GetParam().large ? 8 + 6 * k : 4 + k);
    for (const double share : {0.0, 0.4}) {
      Bounds bounds;
      if (!windowAround(circles, share, bounds)) continue;
      const double size = bounds.xmax - bounds.xmin;
      const std::vector<double> distances = someReach(random, circles.size(), size, run % 2 == 0);
      const Window rectangle(bounds), withHole(bounds, 0.2);
      for (const double tolerance : {1e-5, 0.02, 10.0}) {
        for (const Window* window : {&rectangle, &withHole}) {
          ASSERT_EQ(faultsIn(circles, distances, *window, tolerance * size), "")
              << "run " << run << " share " << share << " tolerance " << tolerance << " region "
              << window->isRegion << "\n"
              << toText(insertAll(circles));
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, ReachOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::test
