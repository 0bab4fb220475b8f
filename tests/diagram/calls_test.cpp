// Calls of both diagrams keep the same promises, apart from their answers: refusals change nothing,
// an empty diagram gives nothing, sites are listed, a search goes on.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "support/saved.h"
#include "support/surfaces.h"

namespace apollonius::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kAnywhere = std::numeric_limits<double>::infinity();

template <class Surface>
class CallsOn : public ::testing::Test {
 protected:
  using Diagram = typename Surface::Diagram;
  using Circle = typename Surface::Circle;
  using NearestFirst = typename Surface::NearestFirst;

  /// Site 1 is hidden.
  static Triples threeSites() { return {10, 20, 0.5, 10.1, 20, 0.1, -100, 0, 0.1}; }

  /// Lists the sites that a search has left.
  static std::vector<SiteId> rest(NearestFirst& search) {
    std::vector<SiteId> found;
    for (SiteId id = 0;;) {
      EXPECT_EQ(search.next(id), Error::kNone);
      if (id == kNoSite) return found;
      found.push_back(id);
    }
  }
};
TYPED_TEST_SUITE(CallsOn, Surfaces, NamesOfSurfaces);

TYPED_TEST(CallsOn, SitesThatAreNoneAreRefusedAndChangeNothing) {
  auto diagram = madeOf<TypeParam>(this->threeSites());
  const auto before = saved(diagram);
  for (const auto& [site, error] : TypeParam::badSites()) {
    const auto [x, y, r] = site;
    SCOPED_TRACE(::testing::Message() << x << ' ' << y << ' ' << r);
    SiteId id = 77;
    EXPECT_EQ(diagram.insert(x, y, r, id), error);
    EXPECT_EQ(id, 77u);
    EXPECT_EQ(diagram.update(0, x, y, r), error);
    for (std::size_t k = 0; k < 3; ++k) {
      Triples many = {50, 50, 1, 60, 60, 1, 70, 70, 1};
      std::ranges::copy(site, many.begin() + static_cast<std::ptrdiff_t>(3 * k));
      std::vector<SiteId> ids(3, 77);
      EXPECT_EQ(diagram.insertMany(many, ids), error);
      EXPECT_EQ(ids, std::vector<SiteId>(3, 77));
      EXPECT_EQ(diagram.updateMany(std::vector<SiteId>{0, 1, 2}, many), error);
    }
  }
  EXPECT_EQ(saved(diagram), before);
}

TYPED_TEST(CallsOn, PointsThatAreNoneAreRefused) {
  const auto diagram = madeOf<TypeParam>(this->threeSites());
  typename TestFixture::NearestFirst search(diagram);
  for (const auto& [site, error] : TypeParam::badSites()) {
    const auto [x, y, r] = site;
    if (r != 3 && r != 0) continue;  // it is the weight that is bad
    SCOPED_TRACE(::testing::Message() << x << ' ' << y);
    const double points[] = {0, 0, x, y};
    SiteId id = 77;
    double distance = 77;
    std::vector<SiteId> sites = {77}, two = {77, 77};
    NearbyLists lists;
    EXPECT_EQ(diagram.find(x, y, id), error);
    EXPECT_EQ(diagram.find(x, y, id, distance), error);
    EXPECT_EQ(diagram.find(x, y, kAnywhere, id), error);
    EXPECT_EQ(diagram.find(x, y, kAnywhere, id, distance), error);
    EXPECT_EQ(diagram.findMany(points, two, {}), error);
    EXPECT_EQ(diagram.kNearest(x, y, 3, kAnywhere, sites), error);
    EXPECT_EQ(diagram.kNearestMany(points, 3, kAnywhere, false, lists), error);
    EXPECT_EQ(diagram.pick(x, y, kAnywhere, Top::kSmallest, id), error);
    EXPECT_EQ(diagram.farthest(x, y, id, distance), error);
    EXPECT_EQ(search.start(x, y), error);
    EXPECT_EQ(id, 77u);
    EXPECT_EQ(distance, 77);
    EXPECT_EQ(sites, std::vector<SiteId>{77});
    EXPECT_EQ(two, (std::vector<SiteId>{77, 77}));
    EXPECT_TRUE(lists.starts.empty());
  }
}

TYPED_TEST(CallsOn, LimitsThatAreNoneAreRefused) {
  const auto diagram = madeOf<TypeParam>(this->threeSites());
  typename TestFixture::NearestFirst search(diagram);
  for (const auto& [limit, error] : {std::pair{kNaN, Error::kNotFinite},
                                     {-kAnywhere, Error::kNotFinite},
                                     {1e101, Error::kOutOfRange}}) {
    SiteId id = 77;
    double distance = 77;
    std::vector<SiteId> sites = {77};
    NearbyLists lists;
    EXPECT_EQ(diagram.find(0, 0, limit, id), error);
    EXPECT_EQ(diagram.find(0, 0, limit, id, distance), error);
    EXPECT_EQ(diagram.findMany({}, limit, {}, {}), error);
    EXPECT_EQ(diagram.kNearest(0, 0, 3, limit, sites), error);
    EXPECT_EQ(diagram.kNearestMany({}, 3, limit, false, lists), error);
    EXPECT_EQ(diagram.pick(0, 0, limit, Top::kSmallest, id), error);
    EXPECT_EQ(search.start(0, 0, limit), error);
    EXPECT_EQ(id, 77u);
    EXPECT_EQ(distance, 77);
    EXPECT_EQ(sites, std::vector<SiteId>{77});
  }
  SiteId id = 77;
  EXPECT_EQ(diagram.pick(0, 0, -1, Top::kSmallest, id), Error::kOutOfRange);
}

TYPED_TEST(CallsOn, ArraysOfOtherLengthsAreRefused) {
  auto diagram = madeOf<TypeParam>(this->threeSites());
  const auto before = saved(diagram);
  const double numbers[] = {50, 50, 1, 60, 60, 1, 70};
  const std::span<const double> all(numbers);
  std::vector<SiteId> ids = {0, 1, 2};
  std::vector<double> distances(2);
  NearbyLists lists;
  EXPECT_EQ(diagram.insertMany(all, std::span(ids).first(2)), Error::kBadLength);
  EXPECT_EQ(diagram.insertMany(all.first(6), ids), Error::kBadLength);
  EXPECT_EQ(diagram.updateMany(std::span(ids).first(2), all), Error::kBadLength);
  EXPECT_EQ(diagram.updateMany(ids, all.first(6)), Error::kBadLength);
  EXPECT_EQ(diagram.findMany(all.first(5), std::span(ids).first(2), {}), Error::kBadLength);
  EXPECT_EQ(diagram.findMany(all.first(4), ids, {}), Error::kBadLength);
  EXPECT_EQ(diagram.findMany(all.first(6), ids, distances), Error::kBadLength);
  EXPECT_EQ(diagram.kNearestMany(all.first(3), 3, kAnywhere, false, lists), Error::kBadLength);
  EXPECT_EQ(saved(diagram), before);
}

TYPED_TEST(CallsOn, UnknownSitesAreRefused) {
  auto diagram = madeOf<TypeParam>(this->threeSites());
  const auto before = saved(diagram);
  for (const SiteId id : {SiteId{3}, kNoSite, kNoSite - 1, SiteId{1} << 31}) {
    typename TestFixture::Circle circle = {};
    bool is = true;
    SiteId cover = 77;
    std::vector<SiteId> neighbors = {77};
    EXPECT_FALSE(diagram.has(id));
    EXPECT_EQ(diagram.site(id, circle), Error::kUnknownSite);
    EXPECT_EQ(diagram.isHidden(id, is), Error::kUnknownSite);
    EXPECT_EQ(diagram.coverOf(id, cover), Error::kUnknownSite);
    EXPECT_EQ(diagram.neighbors(id, neighbors), Error::kUnknownSite);
    EXPECT_EQ(diagram.update(id, 1, 1, 1), Error::kUnknownSite);
    EXPECT_EQ(diagram.updateMany(std::vector<SiteId>{0, id}, Triples{50, 50, 1, 60, 60, 1}),
              Error::kUnknownSite);
    EXPECT_EQ(cover, 77u);
    EXPECT_EQ(neighbors, std::vector<SiteId>{77});
    ASSERT_EQ(diagram.remove(id, is), Error::kNone);
    EXPECT_FALSE(is) << "of no site: no error, but nothing is removed";
    std::size_t count = 99;
    EXPECT_EQ(diagram.removeMany({&id, 1}, count), Error::kNone);
    EXPECT_EQ(count, 0u);
  }
  EXPECT_EQ(saved(diagram), before);
}

TYPED_TEST(CallsOn, EmptyBatchesChangeNothing) {
  auto diagram = madeOf<TypeParam>(this->threeSites());
  const auto before = saved(diagram);
  std::size_t removed = 77;
  EXPECT_EQ(diagram.insertMany({}, std::span<SiteId>()), Error::kNone);
  EXPECT_EQ(diagram.updateMany({}, {}), Error::kNone);
  EXPECT_EQ(diagram.removeMany({}, removed), Error::kNone);
  EXPECT_EQ(removed, 0u);
  EXPECT_EQ(diagram.findMany({}, {}, {}), Error::kNone);
  EXPECT_EQ(saved(diagram), before);
}

TYPED_TEST(CallsOn, AnEmptyDiagramHasNothing) {
  const typename TestFixture::Diagram diagram;
  SiteId id = 77;
  double distance = 0;
  ASSERT_EQ(diagram.find(1, 2, id, distance), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  EXPECT_EQ(distance, kAnywhere);
  ASSERT_EQ(diagram.find(1, 2, 5, id, distance), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  EXPECT_EQ(distance, kAnywhere);
  ASSERT_EQ(diagram.farthest(1, 2, id, distance), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  EXPECT_EQ(distance, -kAnywhere);
  id = 77;
  ASSERT_EQ(diagram.pick(1, 2, kAnywhere, Top::kSmallest, id), Error::kNone);
  EXPECT_EQ(id, kNoSite);
  const double points[] = {1, 2, 3, 4};
  std::vector<SiteId> found(2, 5), sites = {77};
  std::vector<double> distances(2, 0);
  ASSERT_EQ(diagram.findMany(points, found, distances), Error::kNone);
  EXPECT_EQ(found, std::vector<SiteId>(2, kNoSite));
  EXPECT_EQ(distances, std::vector<double>(2, kAnywhere));
  ASSERT_EQ(diagram.kNearest(1, 2, 5, kAnywhere, sites), Error::kNone);
  EXPECT_TRUE(sites.empty());
  NearbyLists lists;
  ASSERT_EQ(diagram.kNearestMany(points, 5, kAnywhere, true, lists), Error::kNone);
  EXPECT_EQ(lists.starts, std::vector<std::uint32_t>(3, 0));
  VertexArrays vertices;
  EdgeArrays edges;
  ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
  ASSERT_EQ(diagram.edges(edges), Error::kNone);
  EXPECT_TRUE(vertices.coordinates.empty());
  EXPECT_TRUE(edges.sites.empty());
  typename TestFixture::NearestFirst search(diagram);
  ASSERT_EQ(search.start(1, 2), Error::kNone);
  EXPECT_TRUE(this->rest(search).empty());
  EXPECT_EQ(search.distance(), kAnywhere);
}

TYPED_TEST(CallsOn, SitesAreListedInTheOrderOfTheirIds) {
  auto diagram = madeOf<TypeParam>(this->threeSites());
  bool removed = false;
  SiteId id = kNoSite;
  ASSERT_EQ(diagram.insert(50, 60, -0.2, id), Error::kNone);
  ASSERT_EQ(diagram.remove(2, removed), Error::kNone);
  const Triples expected = {10, 20, 0.5, 10.1, 20, 0.1, 50, 60, -0.2};
  SiteArrays sites{{7}, {7, 7, 7, 7}, {7}};
  ASSERT_EQ(diagram.sites(sites), Error::kNone);
  EXPECT_EQ(sites.ids, (std::vector<SiteId>{0, 1, 3}));
  EXPECT_EQ(sites.xyr, expected);
  EXPECT_EQ(std::vector<int>(sites.hidden.begin(), sites.hidden.end()), (std::vector{0, 1, 0}));
  std::vector<SiteId> ids{7};
  ASSERT_EQ(diagram.ids(ids), Error::kNone);
  EXPECT_EQ(ids, sites.ids);
  diagram.clear();
  ASSERT_EQ(diagram.insert(9, 9, 1, id), Error::kNone);
  EXPECT_EQ(id, 0u);
}

TYPED_TEST(CallsOn, HiddenSitesHaveACoverAndNoNeighbors) {
  const auto diagram = madeOf<TypeParam>(this->threeSites());
  bool isHidden = false;
  SiteId cover = kNoSite;
  ASSERT_EQ(diagram.isHidden(1, isHidden), Error::kNone);
  EXPECT_TRUE(isHidden);
  ASSERT_EQ(diagram.coverOf(1, cover), Error::kNone);
  EXPECT_EQ(cover, 0u);
  ASSERT_EQ(diagram.coverOf(0, cover), Error::kNone);
  EXPECT_EQ(cover, kNoSite);
  std::vector<SiteId> neighbors = {77};
  ASSERT_EQ(diagram.neighbors(1, neighbors), Error::kNone);
  EXPECT_TRUE(neighbors.empty());
}

TYPED_TEST(CallsOn, MovedDiagramsAreWhatTheyWere) {
  auto diagram = madeOf<TypeParam>(this->threeSites());
  const auto before = saved(diagram);
  auto moved = std::move(diagram);
  EXPECT_EQ(saved(moved), before);
  typename TestFixture::Diagram assigned;
  assigned = std::move(moved);
  EXPECT_EQ(saved(assigned), before);
}

TYPED_TEST(CallsOn, RevisionsChangeWithTheDiagram) {
  typename TestFixture::Diagram diagram;
  std::uint64_t last = diagram.revision();
  const auto expectChange = [&] {
    EXPECT_NE(diagram.revision(), last);
    last = diagram.revision();
  };
  SiteId id = 0;
  bool removed = false;
  for (const double x : {10, 30}) {
    ASSERT_EQ(diagram.insert(x, 12, 1, id), Error::kNone);
    expectChange();
  }
  ASSERT_EQ(diagram.remove(0, removed), Error::kNone);
  expectChange();
  ASSERT_EQ(diagram.update(1, 3, 4, 1), Error::kNone);
  expectChange();
  ASSERT_EQ(diagram.find(1, 2, id), Error::kNone);
  EXPECT_EQ(diagram.revision(), last);
  // Nor does a snapshot bring back a number that there was.
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(diagram.fromBytes(saved(diagram)), Error::kNone);
    expectChange();
  }
  diagram.clear();
  expectChange();
}

TYPED_TEST(CallsOn, TheNearestOfManyPointsAreThoseOfEach) {
  Random random(354);
  const auto diagram = madeOf<TypeParam>(TypeParam::sites(random, 500));
  std::vector<double> points;
  for (int k = 0; k < 300; ++k) {
    for (const double number : TypeParam::place(random)) points.push_back(number);
  }
  for (const double limit : {kAnywhere, TypeParam::kUnit / 4, -TypeParam::kUnit / 20}) {
    NearbyLists lists, bare;
    ASSERT_EQ(diagram.kNearestMany(points, 6, limit, true, lists), Error::kNone);
    ASSERT_EQ(diagram.kNearestMany(points, 6, limit, false, bare), Error::kNone);
    EXPECT_EQ(bare.ids, lists.ids);
    EXPECT_EQ(bare.starts, lists.starts);
    EXPECT_TRUE(bare.distances.empty());
    ASSERT_EQ(lists.starts.size(), points.size() / 2 + 1);
    ASSERT_EQ(lists.distances.size(), lists.ids.size());
    EXPECT_GT(lists.ids.size(), 10u);
    std::vector<SiteId> nearest(points.size() / 2);
    std::vector<double> distances(nearest.size());
    ASSERT_EQ(diagram.findMany(points, limit, nearest, distances), Error::kNone);
    for (std::size_t k = 0; k < nearest.size(); ++k) {
      const double x = points[2 * k], y = points[2 * k + 1];
      std::vector<SiteId> expected;
      ASSERT_EQ(diagram.kNearest(x, y, 6, limit, expected), Error::kNone);
      const auto begin = lists.ids.begin() + lists.starts[k];
      ASSERT_EQ(std::vector<SiteId>(begin, lists.ids.begin() + lists.starts[k + 1]), expected);
      SiteId id = 77;
      double distance = 77;
      ASSERT_EQ(diagram.find(x, y, limit, id, distance), Error::kNone);
      ASSERT_EQ(id, expected.empty() ? kNoSite : expected.front());
      ASSERT_EQ(distance, expected.empty() ? kAnywhere : lists.distances[lists.starts[k]]);
      ASSERT_EQ(nearest[k], id);
      ASSERT_EQ(distances[k], distance);
    }
  }
}

TYPED_TEST(CallsOn, NoNearestSitesAreAskedFor) {
  std::vector<SiteId> sites = {77};
  const auto diagram = madeOf<TypeParam>(this->threeSites());
  ASSERT_EQ(diagram.kNearest(1, 2, 0, kAnywhere, sites), Error::kNone);
  EXPECT_TRUE(sites.empty());
}

TYPED_TEST(CallsOn, UnderAPointIsTheSmallestOrTheLastElseTheNearest) {
  Random random(72);
  const Triples triples = TypeParam::sites(random, 60);
  const auto diagram = madeOf<TypeParam>(triples);
  int inNone = 0, inSeveral = 0;
  for (int k = 0; k < 400; ++k) {
    const auto [x, y] = TypeParam::place(random);
    std::vector<SiteId> containing, nearest;
    ASSERT_EQ(diagram.kNearest(x, y, 60, 0, containing), Error::kNone);
    ASSERT_EQ(diagram.kNearest(x, y, 1, kAnywhere, nearest), Error::kNone);
    inNone += containing.empty() ? 1 : 0;
    inSeveral += containing.size() > 1 ? 1 : 0;
    const auto isSmaller = [&](SiteId a, SiteId b) {
      return triples[3 * a + 2] < triples[3 * b + 2];
    };
    const SiteId smallest =
        containing.empty() ? nearest[0] : *std::ranges::min_element(containing, isSmaller);
    const SiteId last = containing.empty() ? nearest[0] : *std::ranges::max_element(containing);
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.pick(x, y, kAnywhere, Top::kSmallest, id), Error::kNone);
    EXPECT_EQ(id, smallest);
    ASSERT_EQ(diagram.pick(x, y, kAnywhere, Top::kLast, id), Error::kNone);
    EXPECT_EQ(id, last);
    ASSERT_EQ(diagram.pick(x, y, 0, Top::kLast, id), Error::kNone);
    EXPECT_EQ(id, containing.empty() ? kNoSite : last);
  }
  EXPECT_GT(inNone, 10);
  EXPECT_GT(inSeveral, 10);
}

TYPED_TEST(CallsOn, NearestFirstGivesOneSiteAfterAnotherUpToADistance) {
  Random random(71);
  const auto diagram = madeOf<TypeParam>(TypeParam::sites(random, 50));
  const auto [x, y] = TypeParam::place(random);
  const double limit = 3 * TypeParam::kUnit;
  typename TestFixture::NearestFirst begun(diagram);
  SiteId id = 77;
  ASSERT_EQ(begun.next(id), Error::kNone);
  EXPECT_EQ(id, kNoSite) << "before start()";
  EXPECT_EQ(begun.distance(), kAnywhere);
  ASSERT_EQ(begun.start(x, y, limit), Error::kNone);
  ASSERT_EQ(begun.next(id), Error::kNone);
  SiteId nearest = kNoSite;
  double distance = 0;
  ASSERT_EQ(diagram.find(x, y, nearest, distance), Error::kNone);
  EXPECT_EQ(id, nearest);
  EXPECT_EQ(begun.distance(), distance);
  typename TestFixture::NearestFirst search = std::move(begun);
  std::vector<SiteId> expected, found = this->rest(search);
  ASSERT_EQ(diagram.kNearest(x, y, 50, limit, expected), Error::kNone);
  found.insert(found.begin(), id);
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), 5u);
  EXPECT_LT(found.size(), 50u);
}

}  // namespace
}  // namespace apollonius::test
