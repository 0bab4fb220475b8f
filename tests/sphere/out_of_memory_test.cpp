// Lack of memory on the sphere: every operation, made to fail at each of its allocations in turn,
// reports kOutOfMemory and leaves the diagram as it was.
#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <string>
#include <utility>

#include "apollonius/builder.h"
#include "apollonius/nearest_first.h"
#include "sphere/sphere_sets.h"
#include "support/failing_heap.h"
#include "support/saved.h"
#include "support/shadow.h"

namespace apollonius::test {
namespace {

using Operation = std::function<Error(SphericalDiagram&)>;

/// Operations whose arguments are made beforehand, so that only the library allocates.
std::vector<std::pair<std::string, Operation>> operations(const std::vector<std::uint8_t>& bytes) {
  Random random(21);
  const std::vector<double> more = flat(randomSites(random, 30, 0.2));
  const std::vector<double> heavy = {10, 20, 2.5};  // hides most of the others
  const std::vector<double> two = {1, 2, 0, 100, 3, 0};
  static const std::vector<double> all(1000, 1), tenth = {0.1};
  static std::vector<SiteId> ids(30), one(1), removed = {3, 4, 5, 6}, moved = {7, 8};
  return {
      {"insert", [](SphericalDiagram& d) { return d.insert(1, 2, 0.01, one[0]); }},
      {"insertMany", [=](SphericalDiagram& d) { return d.insertMany(more, ids); }},
      {"a cover", [=](SphericalDiagram& d) { return d.insertMany(heavy, one); }},
      {"remove",
       [](SphericalDiagram& d) {
         bool is = false;
         return d.remove(5, is);
       }},
      {"removeMany",
       [](SphericalDiagram& d) {
         std::size_t n = 0;
         return d.removeMany(removed, n);
       }},
      {"update", [](SphericalDiagram& d) { return d.update(9, 50, 60, 0.1); }},
      {"updateMany", [=](SphericalDiagram& d) { return d.updateMany(moved, two); }},
      {"kNearest",
       [](SphericalDiagram& d) {
         std::vector<SiteId> found;
         return d.kNearest(1, 2, 20, 1, found);
       }},
      {"kNearestMany",
       [](SphericalDiagram& d) {
         const double points[] = {1, 2, 30, 40};
         NearbyLists lists;
         return d.kNearestMany(points, 20, 1, true, lists);
       }},
      {"nearest first",
       [](SphericalDiagram& d) {
         SphericalNearestFirst search(d);
         Error error = search.start(1, 2);
         for (SiteId id = 0; error == Error::kNone && id != kNoSite;) error = search.next(id);
         return error;
       }},
      {"sites",
       [](SphericalDiagram& d) {
         SiteArrays sites;
         return d.sites(sites);
       }},
      {"cellAreas",
       [](SphericalDiagram& d) {
         std::vector<double> a;
         return d.cellAreas({}, a);
       }},
      {"cellPolygons",
       [](SphericalDiagram& d) {
         CoverageArrays polygons;
         return d.cellPolygons(0.01, true, {}, polygons);
       }},
      {"cellPolygons within a distance",
       [](SphericalDiagram& d) {
         CoverageArrays polygons;
         return d.cellPolygons(0.01, true, tenth, polygons);
       }},
      {"cellPerimeters",
       [](SphericalDiagram& d) {
         std::vector<double> perimeters;
         return d.cellPerimeters(tenth, perimeters);
       }},
      {"naturalWeights",
       [](SphericalDiagram& d) {
         NaturalWeights found;
         return d.naturalWeights(1, 2, 0, found);
       }},
      {"interpolate",
       [](SphericalDiagram& d) {
         const std::span<const double> values(all.data(), d.idLimit());
         const double points[] = {1, 2, 30, 40};
         double results[2];
         return d.interpolate(values, points, 0, results);
       }},
      {"vertices",
       [](SphericalDiagram& d) {
         VertexArrays v;
         return d.vertices(v);
       }},
      {"edges",
       [](SphericalDiagram& d) {
         EdgeArrays e;
         return d.edges(e);
       }},
      {"narrowest",
       [](SphericalDiagram& d) {
         VertexArrays v;
         return d.narrowest(v);
       }},
      {"toBytes",
       [](SphericalDiagram& d) {
         std::vector<std::uint8_t> b;
         return d.toBytes(b);
       }},
      {"fromBytes", [&](SphericalDiagram& d) { return d.fromBytes(bytes); }},
  };
}

TEST(SphericalOutOfMemory, EveryFailureLeavesTheDiagramAsItWas) {
  const ShadowCheckOf none(0);
  Random random(20);
  const SphericalSites sites = randomSites(random, 40, 0.3);
  const std::vector<std::uint8_t> bytes = saved(diagramOf(sites));
  for (const auto& [name, operation] : operations(bytes)) {
    SCOPED_TRACE(name);
    std::size_t failures = 0;
    for (std::size_t k = 0;; ++k) {
      SphericalDiagram diagram;
      ASSERT_EQ(diagram.fromBytes(bytes), Error::kNone);
      heap.arm();
      heap.failAt = k;
      const Error error = operation(diagram);
      const bool hasFailed = heap.failures > 0;
      heap.disarm();
      Violation violation;
      ASSERT_EQ(diagram.validate(violation), Error::kNone);
      ASSERT_EQ(violation.text(), "") << k;
      if (!hasFailed) {
        ASSERT_EQ(error, Error::kNone);
        break;
      }
      // Some room is optional: then the operation succeeds all the same.
      if (error == Error::kNone) continue;
      ASSERT_EQ(error, Error::kOutOfMemory);
      ++failures;
      SphericalCircle circle = {};
      ASSERT_EQ(diagram.size(), sites.size());
      for (SiteId id = 0; id < sites.size(); ++id) {
        ASSERT_EQ(diagram.site(id, circle), Error::kNone);
        ASSERT_EQ(circle.lon, sites[id].lon);
        ASSERT_EQ(circle.r, sites[id].r);
      }
      ASSERT_EQ(saved(diagram).size(), bytes.size());  // as many ids as before
      ASSERT_EQ(operation(diagram), Error::kNone);
      if (k > 60) k += k / 4;
    }
    EXPECT_GT(failures, 0u);
  }
}

TEST(SphericalOutOfMemory, AnIdThatWasFreeIsFreeAgain) {
  const ShadowCheckOf none(0);
  Random random(22);
  const std::vector<double> more = flat(randomSites(random, 30, 0.2));
  const SphericalSites sites = randomSites(random, 40, 0.3);
  std::vector<SiteId> ids(30);
  for (std::size_t k = 0; k < 8; ++k) {
    SphericalDiagram diagram = diagramOf(sites);
    bool isRemoved = false;
    ASSERT_EQ(diagram.remove(7, isRemoved), Error::kNone);
    heap.arm();
    heap.failAt = k;
    const Error error = diagram.insertMany(more, ids);
    heap.disarm();
    ASSERT_EQ(error, Error::kOutOfMemory) << k;
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.insert(1, 2, 0, id), Error::kNone);
    EXPECT_EQ(id, 7u) << k;
  }
}

/// A builder that failed once fails again, and the diagram stays empty.
TEST(SphericalOutOfMemory, EndsABuilderAndTheDiagramStaysEmpty) {
  Random random(475);
  const std::vector<double> sites = flat(randomSites(random, 40, 0.3));
  SphericalDiagram diagram;
  int failed = 0;
  for (std::size_t k = 0;; ++k) {
    heap.arm();
    heap.failAt = k;
    Error error = Error::kNone, again = Error::kNone;
    try {
      SphericalBuilder builder(diagram);
      error = builder.reserve(20);
      if (error == Error::kNone) error = builder.add(sites);
      for (bool isDone = false; error == Error::kNone && !isDone;) {
        error = builder.advance(3, isDone);
        if (error != Error::kNone) again = builder.advance(3, isDone);
      }
    } catch (const std::bad_alloc&) {  // from the constructor
      error = Error::kOutOfMemory;
    }
    heap.disarm();
    if (error == Error::kNone) break;
    ASSERT_EQ(error, Error::kOutOfMemory) << k;
    ASSERT_TRUE(again == Error::kNone || again == error) << k;
    ASSERT_EQ(diagram.size(), 0u) << k;
    ++failed;
  }
  EXPECT_GT(failed, 15);
  EXPECT_EQ(diagram.size(), 40u);
}

}  // namespace
}  // namespace apollonius::test
