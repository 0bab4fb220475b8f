// Nearest sites where distances differ by less than their rounding.
#include <gtest/gtest.h>

#include <cmath>

#include "support/effort.h"
#include "support/insert_into.h"
#include "support/oracle.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

void expectNearest(const Diagram& diagram, const Circles& circles, double x, double y) {
  SiteId id = kNoSite;
  double distance = 0;
  ASSERT_EQ(diagram.find(x, y, id, distance), Error::kNone);
  ASSERT_EQ(static_cast<int>(id), oracleNearest(circles, x, y)) << x << " " << y;
}

/// Circles that all but touch one about a point: their distances to it differ in the last places,
/// those of large circles by more.
TEST(CloseDistances, AreComparedExactly) {
  Random random(191);
  for (int run = 0; run < runs(200); ++run) {
    const double x = random.between(-1, 1), y = random.between(-1, 1);
    Circles circles;
    const double rim = random.between(0.1, 0.4);
    for (int k = 0; k < 12; ++k) {
      const double t = random.between(-3, 3), norm = 1 + t * t,
                   way = std::ldexp(random.between(1, 2), run % 2 == 0 ? 0 : random.below(20));
      const double cx = x + way * (1 - t * t) / norm, cy = y + way * 2 * t / norm;
      circles.push_back({cx, cy, std::sqrt((cx - x) * (cx - x) + (cy - y) * (cy - y)) - rim});
    }
    for (const Location location : {Location::kHierarchy, Location::kWalk}) {
      Diagram diagram(location);
      insertInto(diagram, circles);
      expectNearest(diagram, circles, x, y);
      if (HasFatalFailure()) return;
      std::vector<SiteId> order;
      ASSERT_EQ(diagram.kNearest(x, y, circles.size(), order), Error::kNone);
      ASSERT_EQ(order.size(), circles.size());
      for (std::size_t k = 0; k + 1 < order.size(); ++k) {
        ASSERT_LE(oracleCompareDistance(x, y, circles[order[k]], circles[order[k + 1]]), 0)
            << "run " << run;
      }
    }
  }
}

}  // namespace
}  // namespace apollonius::test
