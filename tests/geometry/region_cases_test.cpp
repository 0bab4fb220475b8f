// Regions made so that one decision counts: a side along an edge, a segment that leaves a cell that
// is not convex between two places within it, rings within rings that begin at one point.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "apollonius/region.h"
#include "geometry/shapes.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

using Ring = std::vector<double>;

Error assignRings(Region& region, const std::vector<Ring>& rings) {
  std::vector<double> coordinates;
  std::vector<std::uint32_t> starts{0};
  for (const Ring& ring : rings) {
    coordinates.insert(coordinates.end(), ring.begin(), ring.end());
    starts.push_back(static_cast<std::uint32_t>(coordinates.size() / 2));
  }
  return region.assign(coordinates, starts);
}

Region regionOf(const std::vector<Ring>& rings) {
  Region region;
  EXPECT_EQ(assignRings(region, rings), Error::kNone);
  return region;
}

/// A side that runs along an edge is the border of the cell inside, and no business of the one
/// beyond.
TEST(RegionCases, ASideAlongAnEdgeBelongsToTheCellInside) {
  for (const double sign : {1.0, -1.0}) {
    for (const bool isTurned : {false, true}) {
      const auto at = [&](double x, double y) {
        return isTurned ? Ring{y, sign * x} : Ring{sign * x, y};
      };
      const auto ringOf = [&](std::initializer_list<Ring> points) {
        Ring ring;
        for (const Ring& p : points) ring.insert(ring.end(), p.begin(), p.end());
        return ring;
      };
      const Ring a = at(0, 0), b = at(2, 0);
      Diagram diagram;
      insertInto(diagram, {{a[0], a[1], 0}, {b[0], b[1], 0}});
      const Region region = regionOf({ringOf({at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)})});
      const Voronoi voronoi(diagram, region);
      CurveArrays inside, beyond;
      ASSERT_EQ(voronoi.cellCurves(0, inside), Error::kNone);
      ASSERT_EQ(voronoi.cellCurves(1, beyond), Error::kNone);
      EXPECT_EQ(inside.sites, std::vector<SiteId>(4, kNoSite));
      EXPECT_TRUE(beyond.sites.empty());
    }
  }
}

/// With decimals the side is next to the edge: nothing is left between them.
TEST(RegionCases, ASideNextToAnEdgeLeavesNoSlivers) {
  for (int a = -7; a < 7; ++a) {
    for (int c = a + 1; c < 9; ++c) {
      const double x = 0.05 * (a + c), y = 0.1 * (c - 3);
      Diagram diagram;
      insertInto(diagram, {{0.1 * a, y, 0}, {0.1 * c, y, 0}});
      const Region region = regionOf({{x - 1, y - 0.7, x, y - 0.7, x, y + 0.9, x - 1, y + 0.9}});
      const Voronoi voronoi(diagram, region);
      CurveArrays inside, beyond;
      ASSERT_EQ(voronoi.cellCurves(0, inside), Error::kNone);
      ASSERT_EQ(voronoi.cellCurves(1, beyond), Error::kNone);
      EXPECT_EQ(inside.starts.size(), 2u) << a << " " << c;
      EXPECT_TRUE(beyond.sites.empty()) << a << " " << c;
    }
  }
}

TEST(RegionCases, ASlantedSideNextToAnEdgeLeavesNoSlivers) {
  Random random(222);
  for (int run = 0; run < runs(300); ++run) {
    const double ax = 0.1 * random.below(20), ay = 0.1 * random.below(20),
                 bx = ax + 0.1 * (1 + random.below(9)), by = ay + 0.1 * (random.below(19) - 9);
    Diagram diagram;
    insertInto(diagram, {{ax, ay, 0}, {bx, by, 0}});
    // Along the bisector, and to the side of the first site.
    const double mx = (ax + bx) / 2, my = (ay + by) / 2, dx = bx - ax, dy = by - ay,
                 down = random.between(0.1, 2), up = random.between(0.1, 2);
    const Region region = regionOf(
        {{mx + down * dy, my - down * dx, mx - up * dy, my + up * dx, mx - up * dy - 3 * dx,
          my + up * dx - 3 * dy, mx + down * dy - 3 * dx, my - down * dx - 3 * dy}});
    const Voronoi voronoi(diagram, region);
    CurveArrays inside, beyond;
    ASSERT_EQ(voronoi.cellCurves(0, inside), Error::kNone);
    ASSERT_EQ(voronoi.cellCurves(1, beyond), Error::kNone);
    EXPECT_EQ(inside.starts.size(), 2u) << run;
    EXPECT_TRUE(beyond.sites.empty()) << run;
  }
}

/// Holes between the chords and the curves of two parts of a cell: each is one of its own part.
TEST(RegionCases, HolesBetweenChordAndCurve) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 3}, {5, 0, 0}});
  const Region region = regionOf({{3, 0, 12, 0, 12, 7.25, 3, 7.25},
                                  {3, -7.5, 12, -7.5, 12, -0.25, 3, -0.25},
                                  {4.91, 2.45, 4.94, 2.46, 4.92, 2.48},
                                  {5.05, -2.71, 5.08, -2.7, 5.06, -2.68}});
  RingArrays rings;
  ASSERT_EQ(Voronoi(diagram, region).cellPolygon(1, 1e-4, rings), Error::kNone);
  EXPECT_EQ(rings.parts, (std::vector<std::uint32_t>{0, 2, 4}));
}

/// The large circle's cell goes around the small one's. From the first corner to the second the way
/// is free, and the third is close to the first; the way to it is not free.
TEST(RegionCases, ASegmentCrossesAnotherCellBetweenTwoPlacesOfOne) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 3}, {5, 0, 0}});
  const Region region = regionOf({{3, 4, 4.05, -4.2, 4.15, 4}});
  std::vector<double> areas;
  ASSERT_EQ(Voronoi(diagram, region).cellAreas(areas), Error::kNone);
  EXPECT_NEAR(areas[0] + areas[1], region.area(), 1e-12);
  EXPECT_GT(areas[1], 0.01);
}

/// Where a side begins, the small circle is farther than the large one by more than the side is
/// long, though by less than twice that. The side dips into the small one's cell and comes back.
TEST(RegionCases, ASideDipsIntoACellThatIsFarWhereItBegins) {
  const Circles circles{{-1.3125, 1, 2.14}, {0.6, 0, 0}};
  const auto farther = [&](double x) {
    return distanceTo(circles[1], x, 0) - distanceTo(circles[0], x, 0);
  };
  ASSERT_GT(farther(0), 1);
  ASSERT_LT(farther(0.6), -0.01);
  ASSERT_GT(farther(1), 0.01);
  Diagram diagram;
  insertInto(diagram, circles);
  const Region region = regionOf({{0, 0, 1, 0, 1, 1, 0, 1}});
  std::vector<double> areas;
  ASSERT_EQ(Voronoi(diagram, region).cellAreas(areas), Error::kNone);
  EXPECT_NEAR(areas[0] + areas[1], 1, 1e-12);
  EXPECT_NEAR(areas[1], 0.0023952, 1e-7);  // by the midpoint rule
}

/// A hole is cut out of the smallest part around it, whichever ring is found first.
TEST(RegionCases, AHoleOfAnIslandInAHole) {
  Diagram diagram;
  insertInto(diagram, {{3, 1, 0}});
  const Region region = regionOf({{0, 0, 10, -10, 20, 0, 10, 10},
                                  {0, 0, 6, -4, 12, 0, 6, 4},
                                  {0, 0, 3, -1.5, 6, 0, 3, 1.5},
                                  {2.5, 0, 3, -0.5, 3.5, 0, 3, 0.5}});
  RingArrays rings;
  ASSERT_EQ(Voronoi(diagram, region).cellPolygon(0, 1e-3, rings), Error::kNone);
  std::vector<double> areas;
  for (std::size_t part = 0; part + 1 < rings.parts.size(); ++part) {
    RingArrays one;
    one.coordinates = rings.coordinates;
    one.starts.assign(rings.starts.begin() + rings.parts[part],
                      rings.starts.begin() + rings.parts[part + 1] + 1);
    areas.push_back(areaOf(one));
  }
  std::sort(areas.begin(), areas.end());
  ASSERT_EQ(areas.size(), 2u);
  EXPECT_NEAR(areas[0], 9 - 0.5, 1e-12);
  EXPECT_NEAR(areas[1], 200 - 48, 1e-12);
}

/// The last piece of a cell's drawing is a straight line only where the cell's border is one: the
/// last point of a curve is there.
TEST(RegionCases, DrawnCellsEndWithTheirLastCurve) {
  Random random(221);
  for (int run = 0; run < runs(60); ++run) {
    Circles circles;
    for (int k = 0; k < 12; ++k)
      circles.push_back({random.between(0, 10), random.between(0, 10), random.between(0, 2)});
    Diagram diagram;
    insertInto(diagram, circles);
    const Voronoi voronoi(diagram, Bounds{-5, -5, 15, 15});
    for (SiteId id = 0; id < circles.size(); ++id) {
      CurveArrays cell;
      Path path;
      ASSERT_EQ(voronoi.cellCurves(id, cell), Error::kNone);
      ASSERT_EQ(voronoi.drawCell(id, 1e-3, path), Error::kNone);
      if (cell.sites.size() < 2 || cell.starts.size() != 2) continue;
      const double* const last = &cell.curves[7 * (cell.sites.size() - 1)];
      if (last[4] <= 1.0001) continue;  // straight, or nearly
      ASSERT_GE(path.coordinates.size(), 4u);
      EXPECT_EQ(path.coordinates[path.coordinates.size() - 2], path.coordinates[0]) << run;
      EXPECT_EQ(path.coordinates.back(), path.coordinates[1]) << run;
    }
  }
}

/// Between the curve and where its tangents meet is inside, if the part is on the curve's outer
/// side.
TEST(RegionCases, AHoleBeforeTheApexOfACurve) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 3}, {5, 0, 0}});
  const Region region = regionOf(
      {{-9, -7, 9, -7, 9, 7, -9, 7}, {3.9, 0, 3.95, 0.02, 3.9, 0.04}, {8, 0, 8.5, 0, 8, 1}});
  RingArrays rings;
  for (const SiteId id : {0u, 1u}) {
    ASSERT_EQ(Voronoi(diagram, region).cellPolygon(id, 1e-4, rings), Error::kNone);
    EXPECT_EQ(rings.parts, (std::vector<std::uint32_t>{0, 2})) << id;
  }
}

/// Sides that cross although their directions are parallel for doubles: integers of 31 bits.
TEST(RegionCases, SidesThatCrossAtOnePartInTwoToTheSixtieth) {
  const double b = 0x1p30, a = b + 1;
  const Region region = regionOf({{0, 0, a, b, a, -a}, {1, 1, b, b - 1, 0, 2 * a}});
  const double below = (a * a + a * b) / 2;
  const double above = std::abs(cross(Point{b - 1, b - 2}, Point{-1, 2 * a - 1})) / 2;
  EXPECT_NEAR(region.area() / (below + above), 1, 1e-9);
}

/// The ring becomes a region, and cells' areas add up to its own; that of each is that of one.
void expectRegion(const Ring& ring, const Circles& circles, const std::string& where) {
  SCOPED_TRACE(where);
  const Region region = regionOf({ring});
  Diagram diagram;
  insertInto(diagram, circles);
  std::vector<double> areas;
  ASSERT_EQ(Voronoi(diagram, region).cellAreas(areas), Error::kNone);
  double sum = 0;
  for (const double area : areas) sum += area;
  const double whole = areaOf(region.box());
  EXPECT_NEAR(sum / whole, region.area() / whole, 1e-9);
  for (SiteId id = 0; id < areas.size(); ++id) {
    CellMeasures measures;
    ASSERT_EQ(Voronoi(diagram, region).cellMeasures(id, measures), Error::kNone);
    EXPECT_NEAR(measures.area / whole, areas[id] / whole, 1e-9) << "site " << id;
  }
}

/// Needles 6 · 10^11 long, with one end in a square and the other at places a double apart:
/// crossings, once rounded, are crossed again and again, and 16 segments became 90 000.
/// The lengths of a cell's polygons.
double lengthOfRings(const Voronoi& view, SiteId id) {
  RingArrays rings;
  EXPECT_EQ(view.cellPolygon(id, 1e-6, rings), Error::kNone);
  double sum = 0;
  for (std::size_t k = 0; k + 1 < rings.starts.size(); ++k) {
    for (std::size_t m = rings.starts[k]; m + 1 < rings.starts[k + 1]; ++m) {
      const double* const p = &rings.coordinates[2 * m];
      sum += std::hypot(p[2] - p[0], p[3] - p[1]);
    }
  }
  return sum;
}

/// A ring that goes along a line and back has no boundary, where others cross it, too. (Its sides
/// were cut at crossings that were rounded in two ways, before they could cancel.)
TEST(RegionCases, RingsWithoutAreaHaveNoBoundary) {
  Random random(3501);
  std::vector<std::vector<Ring>> cases{
      {{10.5, 14, 12, 16, 111, 148}, {11, 14, 128, 100, -13, 148}}};
  for (int run = 0; run < runs(200); ++run) {
    const double x = random.below(64), y = random.below(64), u = 1 + random.below(9),
                 v = 1 + random.below(9);
    Ring line;
    for (int k = 0; k < 3 + static_cast<int>(random.below(4)); ++k) {
      const double at = random.below(60) - 20.0;
      line.insert(line.end(), {x + at * u / 2, y + at * v / 2});
    }
    Ring other;
    for (int k = 0; k < 3 + static_cast<int>(random.below(3)); ++k)
      other.insert(other.end(), {random.below(200) - 40.0, random.below(200) - 40.0});
    cases.push_back({line, other});
    cases.push_back({other, line, line, line});
  }
  for (const std::vector<Ring>& rings : cases) {
    Region region;
    if (assignRings(region, rings) != Error::kNone) continue;  // the other one has no area
    Diagram diagram;
    insertInto(diagram, {{45, 60, 0}, {111, 148, 0}, {30, 90, 7}});
    const Voronoi view(diagram, region);
    std::vector<double> perimeters;
    ASSERT_EQ(view.cellPerimeters(perimeters), Error::kNone);
    for (SiteId id = 0; id < 3; ++id) {
      CellMeasures measures;
      ASSERT_EQ(view.cellMeasures(id, measures), Error::kNone);
      EXPECT_NEAR(measures.perimeter, lengthOfRings(view, id), 1e-3) << "cell " << id;
      EXPECT_NEAR(measures.perimeter, perimeters[id], 1e-9) << "cell " << id;
    }
    if (HasFailure()) return;
  }
}

/// The cell that has all of a window has its area, if the window is thinner than rounding is where
/// edges meet a border, too.
TEST(RegionCases, ThinWindows) {
  for (const double height : {0x1p-46, 0x1p-44, 0x1p-40, 0x1p-38, 0x1p-30}) {
    for (const double far : {0.0, 1e4}) {
      SCOPED_TRACE(testing::Message() << height << " " << far);
      Diagram diagram;
      insertInto(diagram, {{45 - far, 60, 0}, {200 + far, 148, 0}});
      const Region region = regionOf({{0, 60, 100, 60, 100, 60 + height, 0, 60 + height}});
      const Voronoi view(diagram, region);
      std::vector<double> areas;
      ASSERT_EQ(view.cellAreas(areas), Error::kNone);
      CellMeasures measures;
      ASSERT_EQ(view.cellMeasures(0, measures), Error::kNone);
      EXPECT_NEAR(measures.area, region.area(), 1e-9 * region.area());
      EXPECT_NEAR(areas[0], region.area(), 1e-9 * region.area());
      EXPECT_NEAR(measures.perimeter, 200, 1e-6);
    }
  }
}

TEST(RegionCases, NeedlesWhoseRoundedCrossingsCrossAgain) {
  Random random(1123);
  for (int run = 0; run < runs(40); ++run) {
    Ring ring;
    for (int k = 0; k < 30; ++k) {
      double x = random.between(-200, 200), y = random.between(-200, 200);
      if (k % 2 != 0) {
        const auto aside = static_cast<double>(random.integer(0, 3));
        x = -410706247680.99976 - aside * 0x1p-14;
        y = -470600908800.99976 + aside * 0x1p-14;
      }
      ring.insert(ring.end(), {x, y});
    }
    expectRegion(ring, {{0, 0, 1}, {-3, 200, 0}, {50, -60, 20}}, std::to_string(run));
  }
}

/// All of a ring's sides within some doubles of one line.
TEST(RegionCases, SidesThatDoublesHardlyTellApart) {
  Random random(1124);
  for (int run = 0; run < runs(40); ++run) {
    Ring ring;
    for (int k = 0; k < 24; ++k) {
      const double x = random.between(0.5, 1);
      const auto aside = static_cast<double>(random.integer(-20, 20));
      ring.insert(ring.end(), {x, 1.1 * x + aside * 0x1p-52});
    }
    expectRegion(ring, {{0.6, 0.7, 0.1}, {0.9, 1, 0}}, std::to_string(run));
  }
}

/// Two sides 10^97 long that are 10^80 apart at most: whether a vertex 10^152 away is between them
/// is rounding, and areas are within the region's box nevertheless.
TEST(RegionCases, VerticesOutsideThatRoundingTakesForInside) {
  const double x = -5.8638425437254018e-48, top = 8.8601677203229403e+79;
  expectRegion({-8.2733791088789846e+96, -6.1316084347919886e+96, x, top, 3059.2000000000016,
                -2370.3999999999996},
               {{-5.8638425437254005e-48, top, 0},
                {-5.863842543725403e-48, 8.8601677203229351e+79, 0},
                {7471104, -1441792, 0}},
               "");
}

/// A needle 10^98 long and 10^-66 wide, and circles 10^76 apart: the vertex put into the box keeps
/// its place on the edge's curve, whose tangents meet 10^124 away.
TEST(RegionCases, CurvesOfVerticesThatRoundingTakesForInside) {
  expectRegion({0, 0, 0, 9e-67, 6.1000000000000022e+98, -4.9000000000000004e+98},
               {{-3.3e76, 0, 9.5999999999999992e28},
                {-7.8e76, 0, 2.3000000000000001e29},
                {3.0000000000000002e65, 0, 0},
                {0, 0, 0}},
               "");
}

/// 10^97 away the circle at 10^78 is as near to the walk as rounding, and takes it in. Behind,
/// where the line would leave its cell, there is an edge's bisector, but not the edge.
TEST(RegionCases, EdgesBehindAreCrossedOnlyWhereTheyAre) {
  Circles circles(17, {0, 0, 0});  // many, for the order in which they are inserted
  circles[1] = {3e78, 0, 0};
  circles[6] = {0, 0, 4e-5};
  circles[12] = {0, -3e97, 0};
  circles[13] = {-12, 4, 0};
  circles[16] = {-10, 0, 0};
  expectRegion({0, -3e97, -2e97, 0, 0, 0}, circles, "");
}

}  // namespace
}  // namespace apollonius::test
