// The proof that rings tile the window (src/geometry/polygons/tiling_proof.h): it holds for what
// people have; where it holds, no two segments meet; and rings that do not tile have none.
#include "geometry/polygons/tiling_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagram/bulk_insertion.h"
#include "geometry/clipping/rectangle_clipping.h"
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
    PolygonFinder finder(core, *cells, clipping.border(), 0.1);
    raw = listRawRings(core, finder);
  }

  [[nodiscard]] bool isProved() const { return TilingProof(core, kWindow, raw).holds(); }

  DiagramCore core;
  RawRings raw;
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
    const RawRings before = scene.raw;
    Mesh mesh(scene.core, kWindow, scene.raw);
    ASSERT_TRUE(mesh.mend());
    for (std::size_t k = 0; k < before.rings.size(); ++k) {
      const auto points = before.pointsOf(before.rings[k]),
                 mended = scene.raw.pointsOf(scene.raw.rings[k]);
      ASSERT_TRUE(std::equal(points.begin(), points.end(), mended.begin(), mended.end())) << round;
    }
  }
  EXPECT_GE(proved, 300);
}

TEST(TilingProof, FailsForRingsThatDoNotTile) {
  Random random(63);
  for (int round = 0; round < 60; ++round) {
    Scene scene(randomCircles(random, 20, round % 2 * 4.0, 0));
    if (!scene.isProved()) continue;
    const RawRings good = scene.raw;
    const auto expectNone = [&](const char* what) {
      EXPECT_FALSE(scene.isProved()) << what << ", round " << round;
      scene.raw = good;
    };
    RawRings& raw = scene.raw;
    const auto distrust = [&] {
      for (RawRings::Cell& cell : raw.cells) cell.isTraced = true;
    };
    const RawRings::Ring ring = raw.rings[random.below(raw.rings.size())];
    const auto begin = raw.points.begin() + ring.first;
    std::size_t inner = random.below(raw.points.size());
    while (!kWindow.holds(raw.points[inner])) inner = random.below(raw.points.size());

    distrust();
    EXPECT_TRUE(scene.isProved()) << round;
    raw.points[inner].x = std::nextafter(raw.points[inner].x, 1000);
    expectNone("a point of one ring is off by its last place");
    distrust();
    const Point moved = raw.points[inner];
    for (Point& p : raw.points) {
      if (p == moved) p = p + Point{50, 30};
    }
    expectNone("a point of all rings is far away");
    std::reverse(begin, begin + ring.count);
    expectNone("a ring is turned");
    distrust();
    std::reverse(begin, begin + ring.count);
    expectNone("a ring is turned, and none is known to turn around its site");
    std::swap(begin[0], begin[1]);
    expectNone("two points are exchanged");
    raw.cells.pop_back();
    expectNone("a cell is missing");
    raw.cells.push_back(raw.cells[0]);
    expectNone("a cell is there twice");
  }
}

}  // namespace
}  // namespace apollonius::test
