// The proof that rings tile the window (src/geometry/polygons/tiling_proof.h): it holds for what
// people have; where it holds, no two segments meet; and rings that do not tile have none.
#include "geometry/polygons/tiling_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagram/bulk_insertion.h"
#include "geometry/clipping/rectangle_clipping.h"
#include "geometry/polygons/coverage.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

using namespace internal;

constexpr Rectangle kWindow{0, 0, 100, 60};

struct Scene {
  explicit Scene(const std::vector<double>& circles) : core(Location::kHierarchy) {
    std::vector<SiteId> ids(circles.size() / 3);
    insertAll(core, circles, ids);
    const RectangleClipping clipping(core, kWindow);
    const auto cells = clipping.cells(Parts::kThinToo);
    PolygonFinder finder(core, *cells, clipping.border(), Tolerance{0.1});
    raw = listCells(core, finder, RingsAre::kRaw, 0, core.ids().idLimit());
  }

  [[nodiscard]] bool isProved() const { return TilingProof(core, kWindow, raw).holds(); }

  DiagramCore core;
  CellList raw;
};

std::vector<double> randomCircles(Random& random, int n, double largest, double grid) {
  std::vector<double> circles;
  const auto onGrid = [&](double x) { return grid > 0 ? std::round(x / grid) * grid : x; };
  for (int k = 0; k < n; ++k) {
    for (const double most : {100.0, 60.0, largest})
      circles.push_back(onGrid(random.between(0, most)));
  }
  return circles;
}

TEST(TilingProof, HoldsForSitesInGeneralPosition) {
  Random random(61);
  int proved = 0;
  for (int round = 0; round < 100; ++round) {
    const double largest = round % 3 * 4.0;
    proved += static_cast<int>(Scene(randomCircles(random, 5 + round, largest, 0)).isProved());
  }
  EXPECT_GE(proved, 95);
}

TEST(TilingProof, HoldsOnlyWhereNoSegmentsMeet) {
  Random random(62);
  int proved = 0;
  for (int round = 0; round < 400; ++round) {
    const double grid = std::array{0.0, 0.1, 1.0, 5.0}[static_cast<std::size_t>(round % 4)];
    Scene scene(randomCircles(random, 3 + round / 5, round % 3 * 5.0, grid));
    if (!scene.isProved()) continue;
    ++proved;
    const CellList before = scene.raw;
    Mesh mesh(scene.core, kWindow, scene.raw);
    ASSERT_TRUE(mesh.mend());
    Coverage asGiven, mended;
    assemble(before, asGiven);
    assemble(scene.raw, mended);
    ASSERT_TRUE(std::equal(asGiven.rings.coordinates.begin(), asGiven.rings.coordinates.end(),
                           mended.rings.coordinates.begin(), mended.rings.coordinates.end()))
        << round;
  }
  EXPECT_GE(proved, 300);
}

TEST(TilingProof, FailsForRingsThatDoNotTile) {
  Random random(63);
  for (int round = 0; round < 60; ++round) {
    Scene scene(randomCircles(random, 20, round % 2 * 4.0, 0));
    if (!scene.isProved()) continue;
    const CellList good = scene.raw;
    const auto expectNone = [&](const char* what) {
      EXPECT_FALSE(scene.isProved()) << what << ", round " << round;
      scene.raw = good;
    };
    CellList& raw = scene.raw;
    const auto distrust = [&] {
      for (CellList::Cell& cell : raw.cells) cell.isTraced = true;
    };
    const auto at = [&](std::size_t point) {
      return Point{raw.rings.coordinates[2 * point], raw.rings.coordinates[2 * point + 1]};
    };
    const auto set = [&](std::size_t point, Point p) {
      raw.rings.coordinates[2 * point] = p.x;
      raw.rings.coordinates[2 * point + 1] = p.y;
    };
    const std::size_t ring = random.below(raw.rings.ringCount());
    const auto reverse = [&] {
      FlatArray<Point> points;
      for (std::size_t k = raw.rings.starts[ring]; k < raw.rings.starts[ring + 1]; ++k)
        points.push_back(at(k));
      for (std::size_t k = 0; k < points.size(); ++k)
        set(raw.rings.starts[ring] + k, points[points.size() - 1 - k]);
    };
    std::size_t inner = 0;  // a point inside of the window, and not at an end of a ring's array
    const auto isEnd = [&](std::size_t point) {
      return std::any_of(raw.rings.starts.begin(), raw.rings.starts.end(),
                         [&](std::uint32_t start) { return start == point || start == point + 1; });
    };
    while (isEnd(inner) || !kWindow.holds(at(inner))) inner = random.below(raw.isBorder.size());

    distrust();
    EXPECT_TRUE(scene.isProved()) << round;
    const Point p = at(inner);
    set(inner, {std::nextafter(p.x, 1000), p.y});
    expectNone("a point of one ring is off by its last place");
    distrust();
    for (std::size_t k = 0; k < raw.isBorder.size(); ++k) {
      if (at(k) == p) set(k, p + Point{50, 30});
    }
    expectNone("a point of all rings is far away");
    reverse();
    expectNone("a ring is turned");
    distrust();
    reverse();
    expectNone("a ring is turned, and none is known to turn around its site");
    const Point next = at(inner + 1);
    if (!isEnd(inner + 1)) {
      set(inner + 1, p);
      set(inner, next);
      expectNone("two points are exchanged");
    }
    raw.cells.pop_back();
    expectNone("a cell is missing");
    raw.cells.push_back(raw.cells[0]);
    expectNone("a cell is there twice");
  }
}

TEST(TilingProof, FailsForARingThatGoesRoundTwice) {
  Scene scene({50, 30, 0});
  ASSERT_TRUE(scene.isProved());
  ASSERT_EQ(scene.raw.rings.ringCount(), 1u);
  const Rings once = scene.raw.rings;
  scene.raw.rings.clear();
  const Corners corners = once.corners(0);
  for (std::size_t k = 0; k <= 2 * corners.size(); ++k)
    scene.raw.rings.add(corners[k % corners.size()]);
  scene.raw.rings.endRing();
  scene.raw.rings.endPart();
  scene.raw.isBorder.assign(2 * corners.size() + 1, 1);
  EXPECT_FALSE(scene.isProved());
}

}  // namespace
}  // namespace apollonius::test
