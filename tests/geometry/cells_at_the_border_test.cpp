// Cells at the window's border: they do not depend on the history, and fill the window together,
// also where it is many times as large as the set of sites.
#include <gtest/gtest.h>

#include "geometry/shapes.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

/// Compares the cells of circles inserted one by one in their order and in the opposite one.
void expectSameCells(const Circles& circles, const Bounds& bounds, int run) {
  Diagram forwards, backwards;
  SiteId ignored = kNoSite;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    const Circle &c = circles[k], &last = circles[circles.size() - 1 - k];
    ASSERT_EQ(forwards.insert(c.x, c.y, c.r, ignored), Error::kNone);
    ASSERT_EQ(backwards.insert(last.x, last.y, last.r, ignored), Error::kNone);
  }
  for (SiteId id = 0; id < circles.size(); ++id) {
    const auto there = static_cast<SiteId>(circles.size() - 1 - id);
    bool isHidden = false, isHiddenThere = false;
    ASSERT_EQ(forwards.isHidden(id, isHidden), Error::kNone);
    ASSERT_EQ(backwards.isHidden(there, isHiddenThere), Error::kNone);
    if (isHidden != isHiddenThere) continue;  // identical ones
    CurveArrays cell, cellThere;
    ASSERT_EQ(Voronoi(forwards, bounds).cellCurves(id, cell), Error::kNone);
    ASSERT_EQ(Voronoi(backwards, bounds).cellCurves(there, cellThere), Error::kNone);
    ASSERT_EQ(cell.starts, cellThere.starts) << "run " << run << " site " << id;
    ASSERT_EQ(cell.curves, cellThere.curves) << "run " << run << " site " << id;
  }
}

TEST(Cells, AtACornerOfAnImmenseWindowAreTheSameAfterAnyHistory) {
  // Found by geometry_fuzz: contacts near a corner are at one place there, seen from the other end
  // of the side. Their order, and whether the corner is between them, were left to where the
  // boundary of the cell was begun.
  Random random(527);
  for (int run = 0; run < runs(2000); ++run) {
    const Circles circles = tinyGrid(random, 7, 6, 2);
    const double size = std::ldexp(1.0, static_cast<int>(random.integer(0, 300)));
    const auto x = static_cast<double>(random.integer(0, 5)),
               y = static_cast<double>(random.integer(0, 5));
    const Bounds corners[] = {{x, y, size + 6, size + 6},
                              {-size, y, x, size + 6},
                              {-size, -size, x, y},
                              {x, -size, size + 6, y}};
    const Bounds bounds = corners[run % 4];
    if (!(bounds.xmin < bounds.xmax && bounds.ymin < bounds.ymax)) continue;
    expectSameCells(circles, bounds, run);
    if (HasFatalFailure()) return;
  }
}

TEST(Cells, ThatMeetTheBorderTwiceInOnePointAreTheSameAfterAnyHistory) {
  // Found by geometry_fuzz: seen from as far away as these sites are, vertices between the small
  // ones are one point of the border. Which of the pieces that start there follows one that ends
  // there was left to where the boundary of the cell was begun.
  Random random(528);
  for (int run = 0; run < runs(2000); ++run) {
    Circles circles = tinyGrid(random, 5, 4, 1);
    const double far = std::ldexp(1.0, static_cast<int>(random.integer(50, 300)));
    for (int k = 0; k < 3; ++k)
      circles.push_back({far * random.between(0.5, 1), far * random.between(0.5, 1),
                         far * random.between(0, 0.2)});
    const auto x = static_cast<double>(random.integer(0, 4)),
               y = static_cast<double>(random.integer(0, 4));
    expectSameCells(circles, {x, y, far, far}, run);
    if (HasFatalFailure()) return;
  }
}

/// Found by geometry_fuzz: of a circle so large that its vertices are 256 apart, two pairs of edges
/// leave and enter the window in one point, all with the same other end.
TEST(Cells, ThatMeetTheBorderTwiceWithTheSamePieceAreTheSameAfterAnyHistory) {
  const Circles circles{{-66, 0, 0},
                        {-0x1.eb74e2647dc7ep+60, -0x1.1366287107727p+62, 0x1.2d902028a833fp+62},
                        {-128, -40, 9},
                        {-0x1.98014p+6, -37, 9},
                        {0, 0, 8}};
  expectSameCells(circles, {-0x1p285, -0x1p285, 256, 256}, 0);
}

/// Also if the neighbour that comes first has two edges, on both sides of a small cell before it.
TEST(Cells, BeginAtTheSameEdgeAfterAnyHistory) {
  Random random(529);
  for (int run = 0; run < runs(100); ++run) {
    Circles circles{{0, 0, 10}, {0, 11.1, 0.5}, {0, 18, 0.6}};
    for (int k = 0; k < 12; ++k) {
      const double x = random.between(-40, 40);
      circles.push_back({x, k % 2 == 0 ? -std::sqrt(2500 - x * x) : 70, 0});
    }
    for (int k = 0; k < 8; ++k) circles.push_back({k % 2 == 0 ? -60.0 : 60.0, 10.0 * k - 30, 0});
    random.shuffle(circles);
    expectSameCells(circles, {-400, -400, 400, 400}, run);
    if (HasFatalFailure()) return;
  }
}

TEST(Cells, OfClustersSeenFromFarAwayFillTheWindow) {
  // Vertices at 1e163 times the distance of their sites: the square of that is no double.
  const Circles circles{{6.6935695045504091e-76, -8.0265294509859347e-76, 2.83230295111918e-76},
                        {2.9843267206500499e+75, -3.0241321295159993e+75, 4.8575612909689714e+74},
                        {6.6935695045504091e-76, -8.0265294505698252e-76, 2.83230295111918e-76},
                        {2.9843267206500499e+75, -3.0241321295159993e+75, 4.8575612909689714e+74},
                        {6.6935695045503588e-76, -8.0265294509848228e-76, 2.8323029511200127e-76},
                        {2.9865148506127249e+75, -3.0241321294748356e+75, 4.8575675083845455e+74}};
  Bounds bounds;
  ASSERT_TRUE(windowAround(circles, 3, bounds));
  EXPECT_NEAR(sumOfAreas(circles, bounds), 1, 1e-12);
}

/// A cell whose contacts with the border are all in pairs, at corners: between them, along two
/// whole sides, are cells that are thinner than the spacing of doubles at the window's size.
TEST(Cells, BehindCellsMuchThinnerThanTheWindowDoNotTakeItAll) {
  const auto expectWhole = [](const Bounds& bounds, const Circles& circles) {
    Diagram diagram;
    insertInto(diagram, circles);
    std::vector<double> areas;
    ASSERT_EQ(Voronoi(diagram, bounds).cellAreas(areas), Error::kNone);
    double sum = 0;
    for (const double area : areas) {
      EXPECT_LE(area / areaOf(bounds), 0.5 + 1e-12);
      sum += area;
    }
    EXPECT_NEAR(sum / areaOf(bounds), 1, 1e-12);
  };
  const double far = 0x1.3c3c3c3c3c3c3p+61, near = 0x1.9303338383331p-156;
  expectWhole({-far, -far, near, near}, {{-far, -far, 0},
                                         {0x1.030305a5adafcp-252, 0x1.030303030303p-252, 0},
                                         {0x1.030303030303p-252, 0x1.030303030303p-252, 0},
                                         {0x1.030303030303p-252, near, 0}});
  const double most = 0x1.e7e7e7e7e7e81p+275, less = 0x1.e7e7e7e7e7e7ep+275,
               least = 0x1.e7e7e7e7e7e7dp+275;
  expectWhole({7, 0, most, most}, {{less, less, 0},
                                   {most, most, 0x1.f800000000003p+25},
                                   {least, less, -0x1.5cp+27},
                                   {most, most, -0x1.dc00000000006p+25},
                                   {least, most, 0x1.f7fffffffffffp+25},
                                   {0, 0, 0},
                                   {7, 21, 4},
                                   {0x1.c2p+2, 0x1.4fffffffffffcp+4, 0x1.fcp+1},
                                   {0x1.7fffffffffffcp+1, 0, -0x1.0000000000004p+1}});
  // Two circles a double apart in all their numbers: one is along two sides, and no double is
  // between its edge and them.
  const double low = 0x1.f8p+55;
  const Bounds bounds{low, 0, 0x1.f800001400001p+55, 0x1.f800000400001p+55};
  const Circles circles{{low, low, low},
                        {0x1.f8000014p+55, 0x1.f8000004p+55, 0x1.f8000014p+55},
                        {bounds.xmax, bounds.ymax, bounds.xmax}};
  EXPECT_NEAR(sumOfAreas(circles, bounds), 1, 1e-9);
}

/// Sides of the window are edges of the diagram, up to three of the same cell.
TEST(Cells, WhoseEdgesAreTheBorder) {
  Random random(530);
  Circles circles;
  for (int k = 0; k < 25; ++k) circles.push_back({2.0 * (k % 5 - 2), 2.0 * (k / 5 - 2), 0});
  const double past = 1 + 0x1p-30;
  for (const Bounds& bounds :
       {Bounds{-1, -1, 1, 1.5}, Bounds{-1, -1, 1, past}, Bounds{-1, -1, past, 1},
        Bounds{-past, -1, 1, 1}, Bounds{-1, -past, 1, 1}, Bounds{-1, -1, past, past}}) {
    random.shuffle(circles);
    EXPECT_NEAR(sumOfAreas(circles, bounds), 1, 1e-12);
  }
}

/// The needle of a point on a circle, as far as doubles can tell, meets the window's border in two
/// pairs of contacts, each in one double: they do not say whose the border is but there.
TEST(Cells, AroundANeedleTakeAllButIt) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 0}, {0x1p-119, 1, 1}});
  std::vector<double> areas;
  const Bounds bounds{-31, -31, 31, 0};
  ASSERT_EQ(Voronoi(diagram, bounds).cellAreas(areas), Error::kNone);
  EXPECT_LT(areas[0], 1e-30);
  EXPECT_NEAR(areas[1] / areaOf(bounds), 1, 1e-12);
}

/// A strip as thin as 10^-100 of the window ends at its bottom, beside the right side. Rounding
/// lets the one of its two edges that is on the inner side end at the right side, and so a whole
/// side after the other.
TEST(Cells, WhoseContactsRoundingMovesAlongASideDoNotTakeItAll) {
  const Bounds bounds{-1e100, -1e100, 0x1.544444444444p+1, 0x1.544444444444p+1};
  Diagram diagram;
  insertInto(diagram, {{0x1.111111111110dp-1, 0x1.544444444444p+1, 0x1.544444444444p+1},
                       {0x1.1111111111109p-1, 0x1.544444444443cp+1, 0x1.544444444443cp+1},
                       {0, 0, 0}});
  const Voronoi voronoi(diagram, bounds);
  std::vector<double> areas;
  ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
  EXPECT_NEAR((areas[0] + areas[1] + areas[2]) / areaOf(bounds), 1, 1e-12);
  for (SiteId id = 0; id < 3; ++id) {
    CellMeasures measures;
    ASSERT_EQ(voronoi.cellMeasures(id, measures), Error::kNone);
    EXPECT_NEAR(measures.area / areaOf(bounds), areas[id] / areaOf(bounds), 1e-12);
  }
}

TEST(Cells, WithoutAreaHaveNoPerimeter) {
  const Bounds bounds{0, 0, 96, 64};
  Random random(529);
  for (int run = 0; run < runs(300); ++run) {
    // A side of the window is the edge between two sites that are mirrored at it.
    Circles circles{{17, 25, 4}, {-17, 25, 4}, {-17, -25, 4}};
    if (run > 0) circles.clear();
    for (int k = run == 0 ? 0 : 1 + random.below(5); k-- > 0;) {
      const double x = 1 + random.below(40), y = 1 + random.below(30), r = random.below(6);
      for (const double a : {x, -x}) {
        circles.push_back({a, y, r});
        circles.push_back({a, -y, r});
      }
    }
    Diagram diagram;
    insertInto(diagram, circles);
    const Voronoi view(diagram, bounds);
    std::vector<double> areas, perimeters;
    ASSERT_EQ(view.cellAreas(areas), Error::kNone);
    ASSERT_EQ(view.cellPerimeters(perimeters), Error::kNone);
    for (SiteId id = 0; id < circles.size(); ++id) {
      CellMeasures measures;
      ASSERT_EQ(view.cellMeasures(id, measures), Error::kNone);
      ASSERT_NEAR(perimeters[id], measures.perimeter, 1e-9) << "run " << run << " site " << id;
      if (areas[id] >= 1e-9) continue;
      ASSERT_EQ(perimeters[id], 0) << "run " << run << " site " << id;
    }
  }
}

/// Rings of a window whose points are in line up to their last digits, in one cell and across
/// several: windows have no such rings.
TEST(Cells, HaveNoPerimeterAlongFlatRings) {
  Random random(530);
  for (int run = 0; run < runs(200); ++run) {
    std::vector<double> corners{2, -2, 2, 2, -2, 2, 1.2, 0.9, 1.4, 1, 0.2, 0.4};
    if (run > 0) {  // others that are on one line up to rounding
      const double x = random.between(-1, 1), dx = random.between(-1, 1);
      corners.resize(6);
      for (const double step : {1.0, 1.2, 0.0})
        corners.insert(corners.end(), {x + step * dx, 1.5 + step * 0.3});
    }
    Region window, plain;
    ASSERT_EQ(window.assign(corners, std::vector<std::uint32_t>{0, 3, 6}), Error::kNone);
    corners.resize(6);
    ASSERT_EQ(plain.assign(corners, std::vector<std::uint32_t>{0, 3}), Error::kNone);
    EXPECT_EQ(window.area(), plain.area());
    Diagram diagram;
    insertInto(diagram, {{-1, 1, 0}, {2, 1, 0}});
    for (SiteId id = 0; id < 2; ++id) {
      CellMeasures own, expected;
      ASSERT_EQ(Voronoi(diagram, window).cellMeasures(id, own), Error::kNone);
      ASSERT_EQ(Voronoi(diagram, plain).cellMeasures(id, expected), Error::kNone);
      EXPECT_NEAR(own.perimeter, expected.perimeter, 1e-9) << "run " << run;
      EXPECT_NEAR(own.area, expected.area, 1e-9) << "run " << run;
    }
  }
}

}  // namespace
}  // namespace apollonius::test
