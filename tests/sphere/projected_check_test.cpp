// ProjectedDiagram::check() finds sites that are not those of the table: each message, and the site
// that it names.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "sphere/projected_diagram.h"
#include "sphere/sphere_sets.h"

namespace apollonius::test {
namespace {

namespace sphere = internal::sphere;

constexpr SiteId kPole = 0, kBelowPole = 1, kAlsoBelowPole = 2, kVisible = 3, kBelowVisible = 5;

class ProjectedDiagramCheck : public testing::Test {
 protected:
  ProjectedDiagramCheck() : table_(1) {
    const SphericalSites sites = {{0, 0, 0.5},    {5, 0, 0.1},   {0, 5, 0.1},
                                  {90, 10, 0.25}, {-90, 20, 0.}, {92, 10, 0.1}};
    table_.reserve(sites.size() + 1);
    for (const auto& [lon, lat, r] : sites) (void)table_.take({{lon, lat}, r});
    project();
  }

  /// All sites from one of them.
  void project(SiteId pole = kPole) {
    const internal::FlatArray<sphere::Cap> caps = table_.caps();
    internal::FlatArray<SiteId> others;
    for (SiteId id = 0; id < table_.idLimit(); ++id) {
      if (table_.has(id) && id != pole) others.push_back(id);
    }
    diagram_ = sphere::ProjectedDiagram(caps[pole], pole);
    sphere::ProjectedDiagram::Filling filling(diagram_, table_, caps, std::move(others));
    while (!filling.advance(1)) {
    }
  }
  [[nodiscard]] Violation found() const {
    Violation violation;
    violation.what = diagram_.check(table_, violation.where);
    return violation;
  }
  void move(SiteId id, double lon, double lat, double r) { table_.set(id, {{lon, lat}, r}); }

  sphere::SiteTable table_;
  sphere::ProjectedDiagram diagram_;
};

TEST_F(ProjectedDiagramCheck, FindsNothing) {
  EXPECT_EQ(found().what, nullptr);
  EXPECT_EQ(diagram_.visibleCount(), 3u);
  EXPECT_EQ(diagram_.belowPole().size(), 2u);
}

TEST_F(ProjectedDiagramCheck, FindsNothingWhereASiteHasBeenTakenFromBelowThePole) {
  move(kBelowPole, 0, 60, 0.1);
  ASSERT_TRUE(diagram_.update(table_, {{kBelowPole}}));
  EXPECT_EQ(found().what, nullptr);
  EXPECT_EQ(diagram_.belowPole().size(), 1u);
}

TEST_F(ProjectedDiagramCheck, SeveralMovesOfWhichOneIsFromBelowThePoleAreNotMade) {
  move(kBelowPole, 0, 60, 0.1);
  move(kVisible, 91, 10, 0.25);
  EXPECT_FALSE(diagram_.update(table_, {{kBelowPole, kVisible}}));
  EXPECT_FALSE(diagram_.update(table_, {{kVisible, kBelowPole}}));
  move(kBelowPole, 5, 0, 0.1);
  move(kVisible, 90, 10, 0.25);
  EXPECT_EQ(found().what, nullptr);
}

TEST_F(ProjectedDiagramCheck, FindsASiteThatHasLeftThePole) {
  move(kAlsoBelowPole, 0, 60, 0.1);
  EXPECT_EQ(found().text(), "is not covered by the pole: site 2");
}

TEST_F(ProjectedDiagramCheck, FindsASiteThatIsNoLongerListedBelowThePole) {
  // Another one has the place of the first, and the last place is no more.
  ASSERT_TRUE(diagram_.remove({{kBelowPole}}));
  EXPECT_EQ(found().text(), "is not in the list of sites that the pole covers: site 1");
  ASSERT_TRUE(diagram_.remove({{kAlsoBelowPole}}));
  EXPECT_EQ(found().text(), "is not in the list of sites that the pole covers: site 1");
}

TEST_F(ProjectedDiagramCheck, FindsASiteWithoutACircle) {
  ASSERT_TRUE(diagram_.remove({{kBelowVisible}}));
  EXPECT_EQ(found().text(), "is not in the list of sites that the pole covers: site 5");
}

TEST_F(ProjectedDiagramCheck, FindsASiteThatIsIdenticalToThePoleAndHasALesserId) {
  move(kBelowPole, 90, 10, 0.1);
  project(kVisible);
  ASSERT_EQ(found().what, nullptr);
  move(kBelowPole, 90, 10, 0.25);
  EXPECT_EQ(found().text(), "is identical to the pole and has a lesser id: site 1");
  project(kVisible);
  EXPECT_EQ(found().what, nullptr);
  EXPECT_EQ(diagram_.pole(), kBelowPole);
}

TEST_F(ProjectedDiagramCheck, FindsASiteThatHasMovedWithoutItsCircle) {
  for (const SphericalCircle& there :
       {SphericalCircle{91, 10, 0.25}, {90, 11, 0.25}, {90, 10, 0.26}, {1, 0, 0.1}, {9, 0, 3}}) {
    SCOPED_TRACE(there.lon);
    move(kVisible, there.lon, there.lat, there.r);
    EXPECT_EQ(found().text(), "has another circle than its image: site 3");
  }
}

TEST_F(ProjectedDiagramCheck, FindsASiteWhoseCapHasMovedByLessThanItsCircleTells) {
  // Where rounding gives neighbouring caps the same circle. It is x that changes, and then y.
  for (const double pole : {0.0, 90.0}) {
    move(kPole, pole, 0, 0.5);
    std::size_t sameCircles = 0;
    for (int k = 0; k < 1000; ++k) {
      const double lon = 90 - pole + k * 0x1p-10, next = std::nextafter(lon, 360);
      move(kVisible, lon, 10, 0.25);
      project();
      ASSERT_EQ(found().what, nullptr);
      move(kVisible, next, 10, 0.25);
      const std::string text = found().text();
      if (text == "has another cap in the graph: site 3") {
        ++sameCircles;
      } else if (!text.empty()) {  // the angle may round to the same direction
        ASSERT_EQ(text, "has another circle than its image: site 3");
      }
    }
    EXPECT_GT(sameCircles, 0u);
  }
}

TEST_F(ProjectedDiagramCheck, FindsASiteWhoseLatitudeOrWeightHasChangedByLessThanItsCircleTells) {
  std::size_t latitudes = 0, weights = 0;
  for (int k = 0; k < 1000; ++k) {
    const double lat = 10 + k * 0x1p-10, r = 0x1p-20 * (1 + k * 0x1p-10);
    move(kVisible, 90, lat, r);
    project();
    ASSERT_EQ(found().what, nullptr);
    move(kVisible, 90, std::nextafter(lat, 90), r);
    latitudes += found().text() == "has another cap in the graph: site 3";
    move(kVisible, 90, lat, std::nextafter(r, 1));
    weights += found().text() == "has another cap in the graph: site 3";
  }
  EXPECT_GT(latitudes, 0u);
  EXPECT_GT(weights, 0u);
}

TEST_F(ProjectedDiagramCheck, CountsSites) {
  table_.release(kBelowVisible);
  EXPECT_EQ(found().text(), "sites are not counted right: 5");
}

}  // namespace
}  // namespace apollonius::test
