// Numbers too small for exact answers are taken as 0, wherever a call takes numbers: a radius that
// decays ends no animation. 0 comes back, and never -0.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/building.h"
#include "support/saved.h"
#include "support/snapshots.h"
#include "support/surfaces.h"

namespace apollonius::test {
namespace {

constexpr double kAnywhere = std::numeric_limits<double>::infinity();
constexpr double kTiny[] = {1e-320, -1e-320, 5e-324, -5e-324, 0.99e-100, -0.99e-100, -0.0};

bool isZero(double value) { return value == 0 && !std::signbit(value); }

template <class Surface>
class TinyNumbersOn : public ::testing::Test {
 protected:
  using Diagram = typename Surface::Diagram;

  /// Has site 0 at the origin, of weight 0.
  static Triples sites() { return {0, 0, 0, 30, 0, 0.1, 0, 30, 0.2, -30, -30, 0}; }

  static void expectZeros(const Diagram& diagram, SiteId id) {
    typename Surface::Circle circle = {7, 7, 7};
    ASSERT_EQ(diagram.site(id, circle), Error::kNone);
    const auto& [x, y, r] = circle;
    EXPECT_TRUE(isZero(x) && isZero(y) && isZero(r)) << x << ' ' << y << ' ' << r;
  }
};
TYPED_TEST_SUITE(TinyNumbersOn, Surfaces, NamesOfSurfaces);

TYPED_TEST(TinyNumbersOn, ARadiusThatDecaysEndsAsZero) {
  auto diagram = madeOf<TypeParam>(this->sites());
  int zeros = 0;
  for (double r = 1; r > 0; r /= 2) {
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.insert(40, 40, r, id), Error::kNone) << r;
    ASSERT_EQ(diagram.update(1, 30, 0, r), Error::kNone) << r;
    ASSERT_EQ(diagram.updateMany(std::vector<SiteId>{2, 3}, Triples{0, 30, r, -30, -30, -r}),
              Error::kNone)
        << r;
    const double expected = r < kSmallestMagnitude ? 0 : r;
    SiteArrays sites;
    ASSERT_EQ(diagram.sites(sites), Error::kNone);
    ASSERT_EQ(sites.xyr.size(), 15u);
    for (const std::size_t k : {1, 2, 4}) ASSERT_EQ(sites.xyr[3 * k + 2], expected);
    ASSERT_EQ(sites.xyr[11], -expected);
    if (expected == 0) {
      ++zeros;
      for (const std::size_t k : {1, 2, 3, 4}) ASSERT_TRUE(isZero(sites.xyr[3 * k + 2]));
    }
    bool removed = false;
    ASSERT_EQ(diagram.remove(id, removed), Error::kNone);
  }
  EXPECT_GT(zeros, 700);
  ASSERT_NO_FATAL_FAILURE(expectValid(diagram));
  auto neighbors = allNeighbors(diagram);
  neighbors.resize(4);  // without the id of the inserted site
  EXPECT_EQ(neighbors, allNeighbors(madeOf<TypeParam>({0, 0, 0, 30, 0, 0, 0, 30, 0, -30, -30, 0})));
}

TYPED_TEST(TinyNumbersOn, SitesAreStoredAndGivenBackAsZero) {
  for (const double tiny : kTiny) {
    SCOPED_TRACE(tiny);
    typename TestFixture::Diagram diagram;
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.insert(tiny, -tiny, tiny, id), Error::kNone);
    this->expectZeros(diagram, id);
    ASSERT_EQ(diagram.insert(20, 20, 0.1, id), Error::kNone);
    ASSERT_EQ(diagram.update(id, tiny, tiny, -tiny), Error::kNone);
    this->expectZeros(diagram, id);
    std::vector<SiteId> ids(2);
    ASSERT_EQ(diagram.insertMany(Triples{9, 9, 0, tiny, tiny, tiny}, ids), Error::kNone);
    this->expectZeros(diagram, ids[1]);
    ASSERT_EQ(diagram.updateMany(std::vector<SiteId>{ids[0]}, Triples{-tiny, tiny, tiny}),
              Error::kNone);
    this->expectZeros(diagram, ids[0]);
    EXPECT_EQ(diagram.visibleSize(), 1u) << "identical sites";
    ASSERT_NO_FATAL_FAILURE(expectValid(diagram));
    typename TestFixture::Diagram built;
    build<typename TypeParam::Builder>(built, Triples{9, 9, 0, tiny, tiny, tiny}, 1, 1000);
    this->expectZeros(built, 1);
    typename TestFixture::Diagram restored;
    ASSERT_EQ(restored.fromBytes(saved(diagram)), Error::kNone);
    this->expectZeros(restored, id);
  }
}

TYPED_TEST(TinyNumbersOn, QueriesAreThoseOfZero) {
  const auto diagram = madeOf<TypeParam>(this->sites());
  typename TypeParam::NearestFirst search(diagram);
  for (const double tiny : kTiny) {
    SCOPED_TRACE(tiny);
    SiteId id = kNoSite;
    double distance = 7;
    ASSERT_EQ(diagram.find(tiny, -tiny, id), Error::kNone);
    EXPECT_EQ(id, 0u);
    ASSERT_EQ(diagram.find(tiny, tiny, tiny, id, distance), Error::kNone);
    EXPECT_EQ(id, 0u) << "at a distance of 0, which is the limit";
    EXPECT_EQ(distance, 0);
    double far = 0, expected = 0;
    SiteId farthest = kNoSite;
    ASSERT_EQ(diagram.farthest(0, 0, farthest, expected), Error::kNone);
    ASSERT_EQ(diagram.farthest(tiny, tiny, id, far), Error::kNone);
    EXPECT_EQ(id, farthest);
    EXPECT_EQ(far, expected);
    const double points[] = {tiny, tiny, 30, -tiny};
    std::vector<SiteId> ids(2);
    std::vector<double> distances(2);
    ASSERT_EQ(diagram.findMany(points, tiny, ids, distances), Error::kNone);
    EXPECT_EQ(ids, (std::vector<SiteId>{0, 1}));
    EXPECT_EQ(distances, (std::vector<double>{0, -0.1}));
    ASSERT_EQ(diagram.kNearest(tiny, tiny, 4, tiny, ids), Error::kNone);
    EXPECT_EQ(ids, std::vector<SiteId>{0});
    NearbyLists lists;
    ASSERT_EQ(diagram.kNearestMany(points, 4, tiny, true, lists), Error::kNone);
    EXPECT_EQ(lists.ids, (std::vector<SiteId>{0, 1}));
    EXPECT_EQ(lists.distances, (std::vector<double>{0, -0.1}));
    ASSERT_EQ(diagram.pick(tiny, tiny, tiny, Top::kLast, id), Error::kNone);
    EXPECT_EQ(id, 0u);
    ASSERT_EQ(search.start(tiny, tiny, tiny), Error::kNone);
    ASSERT_EQ(search.next(id), Error::kNone);
    EXPECT_EQ(id, 0u);
    EXPECT_EQ(search.distance(), 0);
    ASSERT_EQ(search.next(id), Error::kNone);
    EXPECT_EQ(id, kNoSite);
  }
}

/// They cannot have been written.
TYPED_TEST(TinyNumbersOn, SnapshotsWithThemAreForged) {
  const auto bytes = saved(madeOf<TypeParam>({1, 2, 0.5, 10, 20, 0.25}));
  int numbers = 0;
  for (std::size_t k = 0; 4 * (k + 2) <= bytes.size(); ++k) {
    const double number = numberAt(bytes, k);
    if (number != 2 && number != 10 && number != 0.5) continue;
    ++numbers;
    for (const double tiny : {1e-320, -1e-200, 0.99e-100}) {
      auto forged = bytes;
      setNumber(forged, k, tiny);
      typename TestFixture::Diagram restored;
      EXPECT_EQ(restored.fromBytes(withChecksum(forged)), Error::kCorruptSnapshot)
          << number << ' ' << tiny;
    }
  }
  EXPECT_EQ(numbers, 3);
}

TEST(TinyNumbers, BoundsOfASearchAndCirclesOfAConflict) {
  const Diagram diagram = madeOf<OnThePlane>({0, 0, 0, 30, 0, 0.1, 0, 30, 0.2, -30, -30, 0});
  for (const double tiny : kTiny) {
    std::vector<SiteId> found, expected;
    ASSERT_EQ(diagram.search(tiny, tiny, -tiny, -tiny, found), Error::kNone) << "a point";
    EXPECT_EQ(found, std::vector<SiteId>{0});
    bool isCovered = false, expectedCovered = false;
    ASSERT_EQ(diagram.conflict(tiny, tiny, tiny, found, isCovered), Error::kNone);
    ASSERT_EQ(diagram.conflict(0, 0, 0, expected, expectedCovered), Error::kNone);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(isCovered, expectedCovered);
  }
}

}  // namespace
}  // namespace apollonius::test
