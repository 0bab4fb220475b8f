// Windows, reaches, points and weights of views: numbers too small for exact answers are taken as
// 0.
#include <gtest/gtest.h>

#include <vector>

#include "apollonius/area_fit.h"
#include "apollonius/spherical_diagram.h"
#include "apollonius/voronoi.h"
#include "support/insert_into.h"

namespace apollonius::test {
namespace {

constexpr double kTiny[] = {1e-320, -1e-320, 5e-324, 0.99e-100, -0.99e-100, -0.0};
constexpr std::uint32_t kStarts[] = {0, 3};

template <class View>
std::vector<double> areasOf(const View& view) {
  std::vector<double> areas;
  EXPECT_EQ(view.cellAreas(areas), Error::kNone);
  return areas;
}

TEST(TinyNumbers, InWindowsReachesAndPointsOfViews) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 1}, {5, 1, 2}, {2, 6, 0.5}});
  const double ring[] = {0, 0, 8, 0, 0, 8}, values[] = {1, 2, 3};
  Region region;
  ASSERT_EQ(region.assign(ring, kStarts), Error::kNone);
  const Reach zero(0.0);
  const auto inRectangle = areasOf(Voronoi(diagram, {0, 0, 8, 8}));
  const auto inRegion = areasOf(Voronoi(diagram, region));
  const auto reached = areasOf(Voronoi(diagram, {0, 0, 8, 8}, &zero));
  for (const double tiny : kTiny) {
    SCOPED_TRACE(tiny);
    const Voronoi view(diagram, {tiny, -tiny, 8, 8});
    EXPECT_EQ(areasOf(view), inRectangle);
    Region other;
    ASSERT_EQ(other.assign(std::vector<double>{tiny, -tiny, 8, tiny, tiny, 8}, kStarts),
              Error::kNone);
    EXPECT_EQ(areasOf(Voronoi(diagram, other)), inRegion);
    EXPECT_EQ(other.box().xmin, 0);
    EXPECT_TRUE(other.contains(-1e-320, tiny)) << "on the border";
    const Reach all(tiny), each(std::vector<double>(3, tiny));
    EXPECT_EQ(areasOf(Voronoi(diagram, {0, 0, 8, 8}, &all)), reached);
    EXPECT_EQ(areasOf(Voronoi(diagram, {0, 0, 8, 8}, &each)), reached);
    NaturalWeights found, expected;
    ASSERT_EQ(view.naturalWeights(3, tiny, tiny, found), Error::kNone);
    ASSERT_EQ(view.naturalWeights(3, 0, 0, expected), Error::kNone);
    EXPECT_EQ(found.ids, expected.ids);
    EXPECT_EQ(found.weights, expected.weights);
    double result = 0, wanted = 0;
    ASSERT_EQ(view.interpolate(values, std::vector<double>{3, tiny}, tiny, {&result, 1}),
              Error::kNone);
    ASSERT_EQ(view.interpolate(values, std::vector<double>{3, 0}, 0, {&wanted, 1}), Error::kNone);
    EXPECT_EQ(result, wanted);
    AreaFit fitting;
    ASSERT_EQ(fitting.begin(diagram, region, std::vector<double>{1, 1, 1},
                            std::vector<double>{tiny, 0, tiny}),
              Error::kNone);
    EXPECT_EQ(fitting.begin(diagram, region, std::vector<double>{1, tiny, 1}), Error::kBadTarget);
    EXPECT_EQ(fitting.badSite(), 1u);
  }
}

TEST(TinyNumbers, InCellsOfTheSphere) {
  SphericalDiagram diagram;
  SiteId id = kNoSite;
  for (const double lon : {0.0, 90.0}) ASSERT_EQ(diagram.insert(lon, 0, 0, id), Error::kNone);
  for (const double tiny : kTiny) {
    SCOPED_TRACE(tiny);
    SphericalPoint centroid{};
    ASSERT_EQ(diagram.cellCentroid(0, tiny, centroid), Error::kNone);
    EXPECT_NE(centroid.lon, centroid.lon) << "it does not reach beyond its centre: NaN";
    bool isInside = false;
    ASSERT_EQ(diagram.contains(0, tiny, tiny, tiny, isInside), Error::kNone);
    EXPECT_TRUE(isInside);
    std::vector<double> areas;
    ASSERT_EQ(diagram.cellAreas({&tiny, 1}, areas), Error::kNone);
    EXPECT_EQ(areas, std::vector<double>(2, 0));
  }
}

}  // namespace
}  // namespace apollonius::test
