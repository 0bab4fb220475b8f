// Lack of memory where nothing is to change: shapes, measures and drawings in windows and regions,
// the regions themselves, walks, prescribed areas, diagrams in the making. Each call is made to
// fail at each of its allocations in turn. It says kOutOfMemory, and afterwards the same call on
// the same objects answers as if nothing had happened. (What changes a diagram, and what only reads
// it: tests/diagram/out_of_memory_test.cpp.)
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apollonius/area_fit.h"
#include "apollonius/builder.h"
#include "apollonius/nearest_first.h"
#include "apollonius/voronoi.h"
#include "support/effort.h"
#include "support/failing_heap.h"
#include "support/generators.h"
#include "support/hash.h"
#include "support/insert_into.h"
#include "support/saved.h"
#include "support/shadow.h"

namespace apollonius::test {
namespace {

/// The objects that a call needs; made anew for each allocation that fails.
struct Subject {
  Diagram diagram;
  Region region;
  Diagram empty;
};

/// A call by name; its answers go into the hash, which needs no memory.
struct Call {
  std::string name;
  std::function<Error(Subject&, Hash&)> run;
};

void add(Hash& hash, const CurveArrays& curves) {
  hash.addAll(curves.curves);
  hash.addAll(curves.sites);
  hash.addAll(curves.starts);
}
void add(Hash& hash, const RingArrays& rings) {
  hash.addAll(rings.coordinates);
  hash.addAll(rings.starts);
  hash.addAll(rings.parts);
}
void add(Hash& hash, const CellMeasures& m) {
  for (const double number : {m.area, m.centroidX, m.centroidY, m.perimeter}) hash.add(number);
}
void add(Hash& hash, const Path& path) {
  hash.addAll(path.commands);
  hash.addAll(path.coordinates);
}
void add(Hash& hash, const CoverageArrays& polygons) {
  hash.addAll(polygons.coordinates);
  hash.addAll(polygons.starts);
  hash.addAll(polygons.parts);
  hash.addAll(polygons.sites);
  hash.addAll(polygons.cells);
}
void add(Hash& hash, const VertexArrays& vertices) {
  hash.addAll(vertices.coordinates);
  hash.addAll(vertices.clearance);
  hash.addAll(vertices.sites);
}
void add(Hash& hash, const EdgeGraph& graph) {
  add(hash, graph.vertices);
  hash.addAll(graph.edges.sites);
  hash.addAll(graph.edges.vertices);
  add(hash, graph.narrowest);
}
template <class Number>
void add(Hash& hash, const std::vector<Number>& numbers) {
  hash.addAll(numbers);
}

// A square with a hole, a part that overlaps it, and an island in the hole.
const std::vector<double> kRings{0,     0,   1.2e6, 0,     1.2e6, 1e6,   0,   1e6,   2e5,
                                 2e5,   6e5, 2.5e5, 4e5,   7e5,   1.1e6, 4e5, 1.5e6, 5e5,
                                 1.1e6, 6e5, 3.5e5, 3.5e5, 4.5e5, 3.5e5, 4e5, 4.5e5};
const std::vector<std::uint32_t> kStarts{0, 4, 7, 10, 13};
constexpr double kTolerance = 100;

/// All of a Voronoi, in the bounds or in the region.
std::vector<Call> shapes(bool inRegion) {
  const auto view = [=](const Subject& s) {
    return inRegion ? Voronoi(s.diagram, s.region) : Voronoi(s.diagram, {2e5, 1e5, 9e5, 8e5});
  };
  // ask(voronoi, answer), or ask(voronoi, id, answer) for each site.
  const auto one = [=]<class Answer>(Answer, auto ask) {
    return [=](Subject& s, Hash& hash) {
      Answer answer;
      const Error error = ask(view(s), answer);
      add(hash, answer);
      return error;
    };
  };
  const auto each = [=]<class Answer>(Answer, auto ask) {
    return [=](Subject& s, Hash& hash) {
      Error error = Error::kNone;
      for (SiteId id = 0; id < s.diagram.size() && error == Error::kNone; ++id) {
        Answer answer;
        error = ask(view(s), id, answer);
        add(hash, answer);
      }
      return error;
    };
  };
  const auto drawn = [=](auto draw) {
    return [=](Subject& s, Hash& hash) {
      Error error = Error::kNone;
      for (Portion portion{0, 16}; !portion.isDone && error == Error::kNone;) {
        Path path;
        error = draw(view(s), portion, path);
        add(hash, path);
      }
      return error;
    };
  };
  using V = const Voronoi&;
  std::vector<Call> calls{
      {"edgeCurves", one(CurveArrays(), [](V v, auto& out) { return v.edgeCurves(out); })},
      {"edgeGraph", one(EdgeGraph(), [](V v, auto& out) { return v.edgeGraph(out); })},
      {"cellCurves",
       each(CurveArrays(), [](V v, auto id, auto& out) { return v.cellCurves(id, out); })},
      {"cellPolygon",
       each(RingArrays(),
            [](V v, auto id, auto& out) { return v.cellPolygon(id, kTolerance, out); })},
      {"cellPolygons",
       one(CoverageArrays(), [](V v, auto& out) { return v.cellPolygons(kTolerance, out); })},
      {"cellPolygonsBetween",
       one(CoverageArrays(),
           [](V v, auto& out) { return v.cellPolygonsBetween(0, 1000, kTolerance, out); })},
      {"cellMeasures",
       each(CellMeasures(), [](V v, auto id, auto& out) { return v.cellMeasures(id, out); })},
      {"cellAreas", one(std::vector<double>(), [](V v, auto& out) { return v.cellAreas(out); })},
      {"cellCentroids",
       one(std::vector<double>(), [](V v, auto& out) { return v.cellCentroids(out); })},
      {"cellPerimeters",
       one(std::vector<double>(), [](V v, auto& out) { return v.cellPerimeters(out); })},
      {"naturalWeights",
       [=](Subject& s, Hash& hash) {
         NaturalWeights found;
         const Error error = view(s).naturalWeights(5e5, 4.2e5, 10, found);
         for (const double weight : found.weights) hash.add(weight);
         return error;
       }},
      {"interpolate",
       [=](Subject& s, Hash& hash) {
         static const std::vector<double> values(1000, 1.5);
         constexpr std::array xy{5e5, 4.2e5, 2.1e5, 1.1e5, 8e5, 7e5};
         std::array<double, 3> results{};
         const auto known = std::span(values).first(s.diagram.size());
         const Error error = view(s).interpolate(known, xy, 0, results);
         for (const double value : results) hash.add(value);
         return error;
       }},
      {"drawEdges", drawn([](V v, auto& portion, auto& path) {
         return v.drawEdges(kTolerance, portion, path);
       })},
      {"drawSites", drawn([](V v, auto& portion, auto& path) {
         return v.drawSites(kTolerance, portion, path);
       })},
      {"drawDual", drawn([](V v, auto& portion, auto& path) {
         return v.drawDual(kTolerance, true, portion, path);
       })},
      {"drawCell",
       each(Path(), [](V v, auto id, auto& path) { return v.drawCell(id, kTolerance, path); })},
      {"drawHull", one(Path(), [](V v, auto& path) { return v.drawHull(kTolerance, path); })},
  };
  for (Call& call : calls) call.name += inRegion ? ", in a region" : ", in bounds";
  return calls;
}

/// Regions, walks, and a diagram that is built in steps.
std::vector<Call> others(const std::vector<double>& xyr) {
  return {
      {"Diagram::narrowest",
       [](Subject& s, Hash& hash) {
         VertexArrays places;
         const Error error = s.diagram.narrowest(places);
         add(hash, places);
         return error;
       }},
      {"Region::assign",
       [](Subject& s, Hash& hash) {
         const double before = s.region.area();
         const Error error = s.region.assign(kRings, kStarts);
         if (error != Error::kNone) {
           EXPECT_EQ(s.region.area(), before) << "is as it was";
         }
         hash.add(s.region.area());
         return error;
       }},
      {"Region::draw",
       [](Subject& s, Hash& hash) {
         Path path;
         const Error error = s.region.draw(path);
         add(hash, path);
         return error;
       }},
      {"enclosingCircle",
       [](Subject& s, Hash& hash) {
         EnclosingCircle circle;
         const Error error = s.diagram.enclosingCircle(circle);
         hash.addAll(circle.sites);
         return error;
       }},
      {"NearestFirst",
       [](Subject& s, Hash& hash) {
         NearestFirst walk(s.diagram);
         SiteId id = 0;
         Error error = walk.start(5e5, 4e5);
         while (error == Error::kNone && id != kNoSite) {
           error = walk.next(id);
           hash.add(std::uint64_t{id});
         }
         if (error != Error::kNone) {
           EXPECT_EQ(walk.next(id), Error::kNone);
           EXPECT_EQ(id, kNoSite) << "the walk has ended";
         }
         return error;
       }},
      {"Builder",
       [=](Subject& s, Hash& hash) {
         s.empty.clear();
         Error error = Error::kNone;
         try {
           Builder builder(s.empty);
           error = builder.reserve(xyr.size() / 6);
           for (std::size_t half : {0u, 1u}) {
             const std::size_t count = xyr.size() / 6 * 3;
             if (error == Error::kNone)
               error = builder.add(std::span(xyr).subspan(half * count, count));
           }
           for (bool isDone = false; error == Error::kNone && !isDone;)
             error = builder.advance(3, isDone);
           hash.add(builder.progress());
         } catch (const std::bad_alloc&) {  // from the constructor
           error = Error::kOutOfMemory;
         }
         if (error != Error::kNone) {
           EXPECT_EQ(s.empty.size(), 0u);
           return error;
         }
         std::vector<std::uint8_t> bytes;
         error = s.empty.toBytes(bytes);
         add(hash, bytes);
         return error;
       }},
  };
}

constexpr std::size_t kFitted = 8;

Circles centres(Random& random) {
  Circles circles;
  for (std::size_t k = 0; k < kFitted; ++k)
    circles.push_back({random.between(0, 2e5), random.between(0, 1e6), random.between(0, 100)});
  return circles;
}

/// Makes some steps of a fit to unequal areas, and gives the weights to the diagram.
Error fit(Subject& s, const std::vector<double>& start) {
  constexpr double kTargets[kFitted] = {1, 2, 3, 4, 4, 3, 2, 1};
  AreaFit fit;
  Error error = fit.begin(s.diagram, s.region, kTargets, start);
  for (int k = 0; k < 3 && error == Error::kNone; ++k) error = fit.step();
  std::vector<double> weights;
  if (error == Error::kNone) error = fit.weights(weights);
  return error == Error::kNone ? fit.finish(s.diagram) : error;
}

class GeometryOutOfMemory : public ::testing::Test {
 protected:
  Subject make(bool isRestored) const {
    Subject subject;
    insertInto(subject.diagram, circles_);
    EXPECT_EQ(subject.region.assign(kRings, kStarts), Error::kNone);
    if (isRestored) {  // circles of faces and the hierarchy are left for later
      const std::vector<std::uint8_t> bytes = saved(subject.diagram);
      EXPECT_EQ(subject.diagram.fromBytes(bytes, Source::kTrusted), Error::kNone);
    }
    return subject;
  }

  /// Makes a call fail at each allocation, one by one.
  void fail(const Call& call, bool isRestored) {
    SCOPED_TRACE(call.name + ", sites: " + std::to_string(circles_.size()));
    Hash expected;
    Subject calm = make(isRestored);
    ASSERT_EQ(call.run(calm, expected), Error::kNone);
    for (std::size_t at = 0;; ++at) {
      SCOPED_TRACE("allocation " + std::to_string(at));
      Subject subject = make(isRestored);
      Hash answer, again;
      heap.arm();
      heap.failAt = at;
      const Error error = call.run(subject, answer);
      heap.disarm();
      if (error == Error::kOutOfMemory) {
        ++failed_;
        ASSERT_EQ(call.run(subject, again), Error::kNone) << "with memory";
        ASSERT_EQ(again.value(), expected.value()) << "another answer than without the failure";
      } else {  // the hierarchy can be done without
        ASSERT_EQ(error, Error::kNone);
        ASSERT_EQ(answer.value(), expected.value());
      }
      std::string broken;
      ASSERT_EQ(subject.diagram.validate(broken), Error::kNone);
      ASSERT_EQ(broken, "");
      if (heap.failures == 0) return;
    }
  }

  static void expectWeights(const Diagram& diagram, const Diagram& expected, double tolerance) {
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
    for (SiteId id = 0; id < expected.size(); ++id) {
      Circle one{}, other{};
      ASSERT_EQ(diagram.site(id, one), Error::kNone);
      ASSERT_EQ(expected.site(id, other), Error::kNone);
      ASSERT_NEAR(one.r, other.r, tolerance) << "site " << id;
    }
  }

  Circles circles_;
  int failed_ = 0;
  const ShadowCheckOf none_{0};
};

TEST_F(GeometryOutOfMemory, ShapesSaySoAndAnswerAfterwards) {
  for (const std::size_t n : {0u, 1u, 2u, 7u, 20u}) {
    if (!isThorough() && n > 7) break;
    Random random(n);
    circles_ = randomCircles(random, n, Hidden::k20Percent);
    for (const bool inRegion : {false, true}) {
      for (const Call& call : shapes(inRegion)) {
        for (const bool isRestored : {false, true}) fail(call, isRestored);
      }
    }
  }
  EXPECT_GT(failed_, 500);
}

TEST_F(GeometryOutOfMemory, RegionsWalksAndBuildersSaySoAndAnswerAfterwards) {
  for (const std::size_t n : {1u, 2u, 40u}) {
    Random random(n);
    circles_ = randomCircles(random, n, Hidden::k20Percent);
    const std::vector<double> xyr = flat(circles_);
    for (const Call& call : others(xyr)) fail(call, false);
  }
  EXPECT_GT(failed_, 50);
}

// Up to rounding: where the hierarchy was done without, sums were made in another order.
TEST_F(GeometryOutOfMemory, FitsLeaveTheDiagramAsItWasAndCanBeBegunAgain) {
  Random random(8);
  circles_ = centres(random);
  for (const std::vector<double>& start :
       {std::vector<double>(), std::vector<double>{0, 1e4, 2e4, 0, 0, 1e4, 5, 100}}) {
    Subject calm = make(false);
    ASSERT_EQ(fit(calm, start), Error::kNone);
    for (std::size_t at = 0;; ++at) {
      SCOPED_TRACE("allocation " + std::to_string(at));
      Subject subject = make(false);
      heap.arm();
      heap.failAt = at;
      const Error error = fit(subject, start);
      heap.disarm();
      if (error == Error::kOutOfMemory) {
        ++failed_;
        expectWeights(subject.diagram, make(false).diagram, 0);
        ASSERT_EQ(fit(subject, start), Error::kNone) << "with memory";
      } else {
        ASSERT_EQ(error, Error::kNone);
      }
      expectWeights(subject.diagram, calm.diagram, 1e-6);
      if (HasFailure() || heap.failures == 0) break;
    }
  }
  EXPECT_GT(failed_, 100);
}

// A step that runs out of memory is taken again by the next one. (One that ran out where the ground
// becomes less went on from areas that were none.) So is finish(), which said that the diagram had
// changed.
TEST_F(GeometryOutOfMemory, FitsGoOnAfterwards) {
  Random random(8);
  circles_ = centres(random);
  constexpr double kTargets[kFitted] = {1, 2, 3, 4, 4, 3, 2, 1};
  constexpr double kEnough = 1e-9;
  constexpr int kMost = 40;
  // With lack of memory at one allocation, should there be so many.
  const auto fitAll = [&](Subject& s, std::optional<std::size_t> failAt) {
    AreaFit fit;
    EXPECT_EQ(fit.begin(s.diagram, s.region, kTargets), Error::kNone);
    const auto expectOnlyLackOf = [&](Error error) {
      failed_ += error == Error::kOutOfMemory;
      EXPECT_TRUE(error == Error::kNone || error == Error::kOutOfMemory);
    };
    heap.arm();
    heap.failAt = failAt;
    int steps = 0;
    while (fit.error() > kEnough && steps < kMost) {
      const double before = fit.error();
      const Error error = fit.step();
      expectOnlyLackOf(error);
      if (error == Error::kNone) ++steps;
      if (error != Error::kNone) {
        EXPECT_EQ(fit.error(), before);
      }
    }
    Error error = fit.finish(s.diagram);
    expectOnlyLackOf(error);
    if (error != Error::kNone) error = fit.finish(s.diagram);
    EXPECT_EQ(error, Error::kNone);
    heap.disarm();
    return steps;
  };
  Subject calm = make(false);
  const int expected = fitAll(calm, std::nullopt);
  EXPECT_LT(expected, kMost);
  for (std::size_t at = 0;; ++at) {
    SCOPED_TRACE("allocation " + std::to_string(at));
    Subject subject = make(false);
    ASSERT_EQ(fitAll(subject, at), expected) << "steps";
    const bool isRefused = heap.failures > 0;
    expectWeights(subject.diagram, calm.diagram, 1e-3);
    if (HasFailure() || !isRefused) break;
  }
  EXPECT_GT(failed_, 100);
}

// Memory for a call about one cell does not grow with the window far away from the cell. (An array
// of all crossings was filled for each call.)
TEST_F(GeometryOutOfMemory, CallsAboutOneCellTakeNoMoreWithAWindowThatIsLargerElsewhere) {
  // Cells in a row; teeth of a comb go across the border between the last two.
  circles_ = {{0, 0, 0}, {100, 0, 0}, {200, 0, 0}, {200, 100, 0}};
  for (const int teeth : {10, 20'000}) {
    SCOPED_TRACE(teeth);
    std::vector<double> comb{300, -50, 300, 80};
    for (int k = 0; k < teeth; ++k) {
      const double x = 300 - 100.0 * (k + 1) / teeth;
      comb.insert(comb.end(), {x + 50.0 / teeth, 20, x, 80});
    }
    comb.insert(comb.end(), {200, 20, -50, 20, -50, -50});
    Subject subject = make(false);
    const std::vector<std::uint32_t> starts{0, static_cast<std::uint32_t>(comb.size() / 2)};
    ASSERT_EQ(subject.region.assign(comb, starts), Error::kNone);
    const Voronoi view(subject.diagram, subject.region);
    for (const SiteId id : {0u, 1u}) {
      CellMeasures measures;
      CurveArrays curves;
      RingArrays rings;
      Path path;
      NaturalWeights weights;
      const auto all = {
          std::function([&] { return view.cellMeasures(id, measures); }),
          std::function([&] { return view.cellCurves(id, curves); }),
          std::function([&] { return view.cellPolygon(id, kTolerance, rings); }),
          std::function([&] { return view.drawCell(id, kTolerance, path); }),
          std::function([&] { return view.naturalWeights(1, 1, 0, weights); }),
      };
      for (const auto& call : all) {
        ASSERT_EQ(call(), Error::kNone);  // which lays the window over the diagram
        heap.arm();
        heap.limit = heap.live + 16'384;
        EXPECT_EQ(call(), Error::kNone);
        heap.disarm();
      }
    }
  }
}

// A builder that ran out of memory says so again, and changes nothing. (Places were filled that it
// did not have any more.)
TEST_F(GeometryOutOfMemory, BuildersSaySoAgain) {
  Random random(9);
  const std::vector<double> xyr = flat(randomCircles(random, 60, Hidden::k20Percent));
  for (std::size_t at = 0;; ++at) {
    SCOPED_TRACE("allocation " + std::to_string(at));
    Diagram diagram;
    Builder builder(diagram);
    ASSERT_EQ(builder.add(xyr), Error::kNone);
    bool isDone = false;
    Error error = Error::kNone;
    heap.arm();
    heap.failAt = at;
    while (error == Error::kNone && !isDone) error = builder.advance(3, isDone);
    heap.disarm();
    if (heap.failures == 0) break;
    if (error == Error::kNone) continue;  // the hierarchy can be done without
    ++failed_;
    for (int again = 0; again < 3; ++again) {
      ASSERT_EQ(builder.advance(30, isDone), Error::kOutOfMemory);
      ASSERT_FALSE(isDone);
    }
    ASSERT_EQ(diagram.size(), 0u);
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
  }
  EXPECT_GT(failed_, 5);
}

}  // namespace
}  // namespace apollonius::test
