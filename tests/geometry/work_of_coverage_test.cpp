// The work of making polygons that tile the window, counted: where thousands of edges come to one
// place, rounding makes most of them meet, and mending that must not take long.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"
#include "geometry/clipping/rectangle_clipping.h"
#include "geometry/polygons/coverage.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

using namespace internal;

struct Family {
  const char* name;
  /// Site k of n, x, y, r, in a window of side 1000.
  Site (*site)(Random& random, double k, double n);
};

void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

constexpr double kTurn = 2 * 3.14159265358979323846;

Site around(double angle, double distance, double r) {
  return {500 + distance * std::cos(angle), 500 + distance * std::sin(angle), r};
}

const Family kFamilies[] = {
    {"Random",
     [](Random& random, double, double) {
       const double x = random.between(0, 1000), y = random.between(0, 1000);
       return Site{x, y, random.between(0, 5)};
     }},
    {"OnACircle", [](Random&, double k, double n) { return around(kTurn * k / n, 480, 0); }},
    {"TangentToACircle",
     [](Random& random, double, double) {
       const double angle = random.between(0, kTurn), r = random.between(1, 20);
       return around(angle, 100 + r, r);
     }},
    {"Wheel", [](Random&, double k,
                 double n) { return k == 0 ? Site{500, 500, 50} : around(kTurn * k / n, 300, 0); }},
    {"OnALine", [](Random&, double k, double n) { return Site{1000 * (k + 0.5) / n, 500, 0}; }},
    {"Lattice",
     [](Random&, double k, double n) {
       const double side = std::ceil(std::sqrt(n)), row = std::floor(k / side);
       return Site{1000 * (k - side * row + 0.5) / side, 1000 * (row + 0.5) / side, 0};
     }},
};

std::size_t workOf(const Family& family, std::size_t n) {
  Random random(91);
  std::vector<double> circles;
  for (std::size_t k = 0; k < n; ++k) {
    const Site site = family.site(random, static_cast<double>(k), static_cast<double>(n));
    circles.insert(circles.end(), {site.x, site.y, site.r});
  }
  DiagramCore core(Location::kHierarchy);
  std::vector<SiteId> ids(n);
  insertAll(core, circles, ids);
  const RectangleClipping clipping(core, {0, 0, 1000, 1000});
  const auto cells = clipping.cells(Parts::kThinToo);
  PolygonFinder finder(core, *cells, clipping.border(), Tolerance{0.1});
  Coverage coverage;
  EXPECT_TRUE(coverWindow(core, finder, clipping.box(), 1e6, {}, coverage));
  return coverage.work;
}

class WorkOfCoverage : public ::testing::TestWithParam<Family> {};

TEST_P(WorkOfCoverage, IsNLogN) {
  // 3 segments a site, and about as many again in each further round: of which random sites need
  // one or two, those of which all edges come to one place 13 to 16.
  for (const std::size_t n : {std::size_t{500}, sized(std::size_t{1000}, std::size_t{8000})}) {
    const auto sites = static_cast<double>(n);
    EXPECT_LE(static_cast<double>(workOf(GetParam(), n)), 32 * sites * std::log2(sites)) << n;
  }
}

INSTANTIATE_TEST_SUITE_P(Families, WorkOfCoverage, ::testing::ValuesIn(kFamilies),
                         [](const auto& family) { return std::string(family.param.name); });

}  // namespace
}  // namespace apollonius::test
