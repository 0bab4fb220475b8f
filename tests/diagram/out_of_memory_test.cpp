// Lack of memory: every public operation, made to fail at each of its allocations in turn, must
// report kOutOfMemory, leave the diagram as it was, and leave it in a state from which everything
// works. Shapes: tests/geometry/out_of_memory_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "apollonius/diagram.h"
#include "diagram/named_operations.h"
#include "diagram/seen_state.h"
#include "predicate/shadow_check.h"
#include "support/effort.h"
#include "support/failing_heap.h"
#include "support/generators.h"
#include "support/saved.h"
#include "support/shadow.h"

namespace apollonius::test {
namespace {

/// Circles of which most are visible, some hidden, some of those hidden by each other; in the grid
/// many predicates are zero.
Circles mixed(Random& random, std::size_t n) {
  return n % 2 == 0 ? randomCircles(random, n, Hidden::k20Percent) : tinyGrid(random, n, 12, 4);
}

void build(Diagram& diagram, const Circles& circles) {
  for (const Circle& c : circles) {
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.insert(c.x, c.y, c.r, id), Error::kNone);
  }
}

std::vector<std::uint8_t> snapshotOf(const Circles& circles) {
  Diagram diagram;
  build(diagram, circles);
  return saved(diagram);
}

/// Operations for a diagram of n sites made by mixed(). Their arguments are made beforehand, so
/// that only the library allocates.
std::vector<NamedOperation> changes(Random& random, std::size_t n) {
  const Circles others = mixed(random, n);
  const std::vector<double> xyr = flat(others);
  std::vector<SiteId> all(n), half;
  for (SiteId id = 0; id < n; ++id) {
    all[id] = id;
    if (id % 2 == 0) half.push_back(id);
  }
  const Circle c = others[0];
  const auto some = static_cast<SiteId>(random.below(n)),
             other = static_cast<SiteId>(random.below(n));
  const std::vector<double> halfXyr(xyr.begin(),
                                    xyr.begin() + static_cast<std::ptrdiff_t>(3 * half.size()));
  return {
      {"insert",
       [=](Diagram& d) {
         SiteId id = kNoSite;
         return d.insert(c.x, c.y, c.r, id);
       }},
      {"insert over all",
       [=](Diagram& d) {
         SiteId id = kNoSite;
         return d.insert(0, 0, 1e8, id);
       }},
      {"remove",
       [=](Diagram& d) {
         bool removed = false;
         return d.remove(some, removed);
       }},
      {"update", [=](Diagram& d) { return d.update(other, c.x, c.y, c.r); }},
      {"update over all", [=](Diagram& d) { return d.update(other, 0, 0, 1e8); }},
      {"insertMany",
       [=, ids = std::vector<SiteId>(n)](Diagram& d) mutable { return d.insertMany(xyr, ids); }},
      {"insertMany of one",
       [=](Diagram& d) {
         SiteId id = kNoSite;
         const double one[] = {c.x, c.y, c.r};
         return d.insertMany(one, {&id, 1});
       }},
      {"insertMany of an array that is given up",
       [=](Diagram& d) {
         std::vector<SiteId> ids;
         std::vector<double> given;
         try {
           given = xyr;
         } catch (const std::bad_alloc&) {
           return Error::kOutOfMemory;
         }
         return d.insertMany(std::move(given), ids);
       }},
      {"updateMany", [=](Diagram& d) { return d.updateMany(half, halfXyr); }},
      {"removeMany",
       [=](Diagram& d) {
         std::size_t removed = 0;
         return d.removeMany(half, removed);
       }},
      {"fromBytes", [bytes = snapshotOf(others)](Diagram& d) { return d.fromBytes(bytes); }},
      {"fromBytes, trusted",
       [bytes = snapshotOf(others)](Diagram& d) { return d.fromBytes(bytes, Source::kTrusted); }},
  };
}

enum class Failure { kOnce, kBudget };

/// The origin of a diagram: built, restored from a snapshot, which leaves circles and hierarchy for
/// later, or built without a hierarchy.
enum class Origin { kBuilt, kRestored, kWithoutHierarchy };

Diagram make(const Circles& circles, Origin origin) {
  Diagram diagram(origin == Origin::kWithoutHierarchy ? Location::kWalk : Location::kHierarchy);
  if (origin == Origin::kRestored) {
    EXPECT_EQ(diagram.fromBytes(snapshotOf(circles), Source::kTrusted), Error::kNone);
  } else {
    build(diagram, circles);
  }
  return diagram;
}

/// Says what is wrong with a diagram on which an operation ran while the heap refused something;
/// empty if that is as it should be. `before` and `after` are the states without and with the
/// operation; `grows`: whether it shall grow by many sites afterwards, which takes longer than all
/// the rest.
std::string verdict(Diagram& diagram, const std::function<Error(Diagram&)>& run, Error error,
                    const State& before, const State& after, bool grows) {
  if (error == Error::kOutOfMemory) {
    const State now(diagram);
    if (!now.broken.empty()) return "failed and broke the diagram: " + now.broken;
    if (!(now == before)) return "failed and changed the diagram";
    if (run(diagram) != Error::kNone) return "failed at the second try, with memory";
  } else if (error != Error::kNone) {
    return "gave an error that is not lack of memory";
  }
  // Success at last, or in spite of refusals (the hierarchy can be done without).
  const State now(diagram);
  if (!now.broken.empty()) return "left a broken diagram: " + now.broken;
  if (!(now == after)) return "left another diagram than without any refusal";
  if (!grows) return {};
  for (int k = 0; k < 20; ++k) {
    SiteId id = kNoSite;
    if (diagram.insert(3e8 + k % 9 * 5, k / 9 * 5, 2, id) != Error::kNone)
      return "left a diagram that cannot grow";
  }
  std::vector<double> more;
  for (int k = 0; k < 70; ++k) more.insert(more.end(), {-3e8 + k % 9 * 5, k / 9 * 5.0, 2});
  std::vector<SiteId> ids(70);
  if (diagram.insertMany(more, ids) != Error::kNone) return "left a diagram that cannot grow";
  const State grown(diagram);
  return grown.broken.empty() ? std::string()
                              : "left a diagram that breaks as it grows: " + grown.broken;
}

/// Makes an operation fail at each allocation that it makes on a fresh diagram; stops at the first
/// wrong outcome, with a message. `failed` counts the calls that reported kOutOfMemory.
std::string failEverywhere(const Circles& circles, Origin origin, const NamedOperation& operation,
                           Failure failure, int& failed) {
  Diagram untouched, changed;
  build(untouched, circles);
  build(changed, circles);
  if (std::function<Error(Diagram&)>(operation.run)(changed) != Error::kNone)
    return operation.name + " fails on its own";
  const State before(untouched), after(changed);
  std::size_t at = 0;
  for (std::size_t round = 0;; ++round) {
    Diagram diagram = make(circles, origin);
    const std::function<Error(Diagram&)> run =
        operation.run;  // a fresh copy: no memory of an earlier run
    heap.arm();
    const std::size_t live = heap.live;
    if (failure == Failure::kOnce) {
      heap.failAt = at;
    } else {
      heap.limit = live + at;
    }
    const Error error = run(diagram);
    heap.disarm();
    const Heap seen = heap;
    failed += error == Error::kOutOfMemory;
    const bool grows = isThorough() || round % 4 == 0;
    const std::string wrong = verdict(diagram, run, error, before, after, grows);
    if (!wrong.empty()) {
      return operation.name + " on " + std::to_string(circles.size()) + " sites, " +
             (failure == Failure::kOnce ? "allocation " : "budget of bytes ") + std::to_string(at) +
             ": " + wrong;
    }
    if (seen.failures == 0) return {};
    // The next allocation, or in long sequences one a little later; the smallest budget that gets
    // further. Large sets take longer steps.
    const std::size_t step = circles.size() > 200        ? at / 3
                             : failure == Failure::kOnce ? at / 10
                                                         : at / 40;
    at = failure == Failure::kOnce ? at + 1 + step : std::max(seen.wanted - live, at + 1 + step);
  }
}

class OutOfMemory : public ::testing::TestWithParam<Failure> {
 protected:
  /// Runs each operation with failures of the heap; gives one message for each that goes wrong.
  void failAll(const Circles& circles, const std::vector<NamedOperation>& operations,
               Origin origin = Origin::kBuilt) {
    for (const NamedOperation& operation : operations) {
      if (wrong_.contains(operation.name)) continue;
      const std::string message = failEverywhere(circles, origin, operation, GetParam(), failed_);
      if (message.empty()) continue;
      wrong_.insert(operation.name);
      ADD_FAILURE() << message;
    }
  }

  int failed_ = 0;

 private:
  std::set<std::string> wrong_;
  const ShadowCheckOf none_{0};
};

TEST_P(OutOfMemory, ChangesLeaveTheDiagramAsItWas) {
  // Arrays grow at powers of two; 64 sites and more are rebuilt where most of them change.
  const std::vector<std::size_t> usual{1, 2, 3, 4, 5, 8, 17, 65},
      thorough{1, 2, 3, 4, 5, 7, 8, 9, 16, 17, 33, 64, 65, 150};
  for (const std::size_t n : sized(usual, thorough)) {
    if (kEffortDivisor > 1 && n > 33) break;
    Random random(n);
    const Circles circles = mixed(random, n);
    failAll(circles, changes(random, n));
  }
  EXPECT_GT(failed_, 200);
}

TEST_P(OutOfMemory, ChangesThatNeedLongNumbersLeaveTheDiagramAsItWas) {
  // Exponents far apart. Long numbers allocate nothing themselves (number/dyadic.h); what uses them
  // does.
  for (const std::size_t n : {3u, 6u}) {
    Random random(n);
    const Circles circles = rangeEnds(random, n, Range::kMixed);
    failAll(circles, changes(random, n));
  }
  EXPECT_GT(failed_, 50);
}

/// Changes of most of a set, with a giant that comes in the middle of it.
std::vector<NamedOperation> changesOfAll(const Circles& circles, const Circle& giant) {
  const std::size_t n = circles.size();
  std::vector<SiteId> ids(n);
  std::iota(ids.begin(), ids.end(), SiteId{0});
  const auto updateTo = [=](auto change) {
    std::vector<double> xyr;
    for (std::size_t k = 0; k < n; ++k) {
      Circle c = circles[k];
      change(k, c);
      xyr.insert(xyr.end(), {c.x, c.y, c.r});
    }
    return [=](Diagram& d) { return d.updateMany(ids, xyr); };
  };
  const auto giantAt = [=](std::size_t at) {
    return
        [=](std::size_t k, Circle& c) { c = k == at ? giant : Circle{c.x + 2e4, c.y - 1e4, c.r}; };
  };
  std::vector<double> more;
  for (const Circle& c : circles) more.insert(more.end(), {c.x + 1e4, c.y + 2e4, c.r});
  more.insert(more.end(), {giant.x, giant.y, giant.r});
  std::vector<SiteId> odd;
  for (SiteId id = 1; id < n; id += 2) odd.push_back(id);
  // In the order of their slots, which is not known.
  const auto giantAndOneOverAll = [=](SiteId first, SiteId second) {
    const std::vector<double> xyr{giant.x, giant.y, giant.r, 0, 0, 4e6};
    return [=, both = std::vector<SiteId>{first, second}](Diagram& d) {
      return d.updateMany(both, xyr);
    };
  };
  const std::vector<SiteId> allButOne(ids.begin() + 1, ids.end());
  const auto removal = [](const std::vector<SiteId>& which) {
    return [=](Diagram& d) {
      std::size_t removed = 0;
      return d.removeMany(which, removed);
    };
  };
  // A hundredth of a spacing, which flips edges; then one that is to be hidden, which has no
  // memory.
  const auto jittered = [=](std::size_t hiddenOne) {
    return [=](std::size_t k, Circle& c) {
      const auto share = [k](double step) {
        return step * static_cast<double>(k) - std::floor(step * static_cast<double>(k)) - 0.5;
      };
      c = {c.x + 3e3 * share(0.618), c.y + 3e3 * share(0.414), c.r};
      if (k == hiddenOne) c = {circles[0].x, circles[0].y, circles[0].r / 2};
    };
  };
  return {
      {"updateMany, flips", updateTo(jittered(n))},
      {"updateMany, flips and an early one elsewhere", updateTo(jittered(3))},
      {"updateMany, flips and a late one elsewhere", updateTo(jittered(n - 3))},
      {"updateMany, all a little",
       updateTo([](std::size_t k, Circle& c) { c.x += static_cast<double>(k % 7); })},
      {"updateMany, all a little upwards",
       updateTo([](std::size_t k, Circle& c) { c.y += static_cast<double>(k % 7); })},
      {"updateMany, all grow",
       updateTo([](std::size_t k, Circle& c) { c.r += k % 3 == 0 ? 3e5 : 1e5; })},
      {"updateMany, all elsewhere",
       updateTo([](std::size_t k, Circle& c) { c = {c.y, -c.x, c.r + static_cast<double>(k)}; })},
      {"updateMany, an early giant", updateTo(giantAt(3))},
      {"updateMany, a late giant", updateTo(giantAt(n - 3))},
      {"updateMany, a giant and one over all", giantAndOneOverAll(5, 6)},
      {"updateMany, one over all and a giant", giantAndOneOverAll(6, 5)},
      {"update to a giant", [=](Diagram& d) { return d.update(5, giant.x, giant.y, giant.r); }},
      {"insertMany with a giant", [=, moreIds = std::vector<SiteId>(n + 1)](
                                      Diagram& d) mutable { return d.insertMany(more, moreIds); }},
      {"removeMany of half", removal(odd)},
      {"removeMany of all but one", removal(allButOne)},
  };
}

TEST_P(OutOfMemory, ChangesOfWholeSetsLeaveThemAsTheyWere) {
  Random random(7);
  // One level of the hierarchy over 230, two over 2200.
  const std::size_t n = kEffortDivisor > 1 ? 120 : sized(230u, 2200u);
  const Circle overAQuarter{5e5, 5e5, 7e5};
  Circles circles = randomCircles(random, n, Hidden::kNone);
  failAll(circles, changesOfAll(circles, overAQuarter));
  for (Circle& c : circles) c.r = random.between(0, 2e4);  // some hidden
  circles[1] = {-5e5, 5e5, 6e5};                           // a giant that leaves
  failAll(circles, changesOfAll(circles, overAQuarter));
  EXPECT_GT(failed_, 50);
}

/// The first goes away, which lets the second move in place to where it was not possible before,
/// and the third has no memory: going back, the second must be first.
TEST_P(OutOfMemory, MovesInPlaceGoBackInTheirOrder) {
  Random random(9);
  const std::size_t n = 60;
  const Circles circles = randomCircles(random, n, Hidden::kNone);
  std::vector<NamedOperation> operations;
  for (int run = 0; run < 6; ++run) {
    const auto first = static_cast<SiteId>(random.below(n - 2));
    const auto apart = [&](SiteId id) {
      return std::hypot(circles[id].x - circles[first].x, circles[id].y - circles[first].y);
    };
    SiteId second = first + 1;
    for (SiteId id = second; id + 1 < n; ++id) second = apart(id) < apart(second) ? id : second;
    const Circle &from = circles[second], &towards = circles[first];
    const double way = random.between(0, 0.7);
    const Circle nearer{from.x + way * (towards.x - from.x), from.y + way * (towards.y - from.y),
                        from.r};
    operations.push_back({"updateMany, run " + std::to_string(run),
                          [ids = std::vector<SiteId>{first, second, n - 1},
                           xyr = flat({{9e6, 9e6, 0}, nearer, {0, 0, 1e8}})](Diagram& d) {
                            return d.updateMany(ids, xyr);
                          }});
  }
  failAll(circles, operations);
  EXPECT_GT(failed_, 6);
}

/// A call that flips edges, then one that has no room to rebuild the diagram: undoing it leaves the
/// flips of the first.
TEST_P(OutOfMemory, FlipsOfAnEarlierCallStay) {
  Random random(10);
  const Circles circles = randomCircles(random, kEffortDivisor > 1 ? 60 : 200, Hidden::k20Percent);
  std::vector<SiteId> ids(circles.size());
  std::iota(ids.begin(), ids.end(), SiteId{0});
  Circles little = circles, far = circles;
  for (Circle& c : little) {
    c.x += random.between(-3e3, 3e3);
    c.y += random.between(-3e3, 3e3);
  }
  std::reverse(far.begin(), far.end());
  const std::vector<double> littleXyr = flat(little), farXyr = flat(far);
  Diagram expected, other;
  build(expected, circles);
  build(other, far);
  ASSERT_EQ(expected.updateMany(ids, littleXyr), Error::kNone);
  const State before(expected), after(other);
  for (std::size_t at = 0;; at += 1 + at / 10) {
    Diagram diagram;
    build(diagram, circles);
    ASSERT_EQ(diagram.updateMany(ids, littleXyr), Error::kNone);
    heap.arm();
    if (GetParam() == Failure::kOnce) {
      heap.failAt = at;
    } else {
      heap.limit = heap.live + 64 * at;
    }
    const Error error = diagram.updateMany(ids, farXyr);
    heap.disarm();
    const bool isDone = heap.failures == 0;
    failed_ += error == Error::kOutOfMemory;
    const State now(diagram);
    ASSERT_EQ(now.broken, "") << "at " << at;
    ASSERT_TRUE(now == (error == Error::kNone ? after : before)) << "at " << at;
    if (isDone) break;
  }
  EXPECT_GT(failed_, 1);
}

TEST_P(OutOfMemory, HiddenSitesThatMovedBelowTheirParentGoBack) {
  const Circles circles{{0, 0, 10}, {1, 0, 1},   {2, 0, 1},  {40, 0, 1},
                        {0, 40, 1}, {-40, 0, 2}, {0, -40, 1}};
  failAll(circles,
          {{"updateMany of two hidden sites and a visible one",
            [ids = std::vector<SiteId>{1, 2, 6}, xyr = flat({{3, 1, 2}, {-2, 0, 0.5}, {0, 0, 90}})](
                Diagram& d) { return d.updateMany(ids, xyr); }}});
  EXPECT_GT(failed_, 1);
}

/// A giant leaves more room free among the faces than memory is held back; taking it out again has
/// to find that.
TEST_P(OutOfMemory, GiantsOverManySitesAreTakenOutAgain) {
  if (kEffortDivisor > 1) GTEST_SKIP() << "two thousand sites";
  Random random(7);
  const Circles circles = randomCircles(random, 2200, Hidden::kNone);
  std::vector<NamedOperation> operations = changesOfAll(circles, {5e5, 5e5, 7e5});
  std::erase_if(operations, [](const NamedOperation& operation) {
    return operation.name.find("one over all") == std::string::npos;
  });
  ASSERT_EQ(operations.size(), 2u);
  failAll(circles, operations);
  EXPECT_GT(failed_, 10);
}

/// Hundreds of neighbours: undoing takes more than the reserve.
TEST_P(OutOfMemory, GiantsWithManyNeighborsLeaveTheDiagramAsItWas) {
  Random random(8);
  Circles circles = giantDisk(random, kEffortDivisor > 1 ? 100 : sized(230u, 3000u));
  const auto larger = [](const Circle& a, const Circle& b) { return a.r > b.r; };
  std::sort(circles.begin(), circles.end(), larger);
  const Circle giant = circles[0];
  failAll(circles, changesOfAll(circles, {1e4, 0, giant.r}));
  circles[0].r = 0;
  failAll(circles, changesOfAll(circles, giant));
  EXPECT_GT(failed_, 50);
}

TEST_P(OutOfMemory, QueriesSaySo) {
  for (const std::size_t n : {1u, 2u, 5u, 40u, 41u}) {
    Random random(n);
    const Circles circles = mixed(random, n);
    failAll(circles, queries(n));
  }
  EXPECT_GT(failed_, 10);
}

TEST_P(OutOfMemory, RestoredDiagramsAreNoExceptions) {
  for (const std::size_t n : {2u, 9u, 16u}) {
    Random random(n);
    const Circles circles = mixed(random, n);
    failAll(circles, changes(random, n), Origin::kRestored);
    failAll(circles, queries(n), Origin::kRestored);
  }
  EXPECT_GT(failed_, 100);
}

TEST_P(OutOfMemory, DiagramsWithoutAHierarchyAreNoExceptions) {
  for (const std::size_t n : {2u, 9u, 16u}) {
    Random random(n);
    const Circles circles = mixed(random, n);
    failAll(circles, changes(random, n), Origin::kWithoutHierarchy);
  }
  EXPECT_GT(failed_, 100);
}

/// Levels, too, are made room for, which can be done without.
TEST_P(OutOfMemory, AThousandSitesAtOnce) {
  if (kEffortDivisor > 1) GTEST_SKIP() << "two thousand sites";
  Random random(9);
  const Circles circles = randomCircles(random, 1100, Hidden::kNone);
  const std::vector<double> xyr = flat(randomCircles(random, 1100, Hidden::kNone));
  failAll(circles, {{"insertMany of as many as there are",
                     [=, ids = std::vector<SiteId>(1100)](Diagram& d) mutable {
                       return d.insertMany(xyr, ids);
                     }}});
  EXPECT_GT(failed_, 5);
}

/// On a broken diagram validate() needs memory only for the text of its answer.
TEST_P(OutOfMemory, WordsForWhatIsBroken) {
  if (internal::kShadowCheck)
    GTEST_SKIP() << "a filter may contradict the exact stage on an invalid graph";
  std::ifstream file(APOLLONIUS_TEST_DATA "/snapshots/forged_find_out_of_bounds.bin",
                     std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  Diagram diagram;
  ASSERT_EQ(diagram.fromBytes(bytes, Source::kTrusted), Error::kNone);
  std::string expected;
  ASSERT_EQ(diagram.validate(expected), Error::kNone);
  ASSERT_NE(expected, "");
  for (std::size_t at = 0;; ++at) {
    std::string broken;
    heap.arm();
    heap.failAt = at;
    const Error error = diagram.validate(broken);
    heap.disarm();
    if (heap.failures == 0) break;
    ++failed_;
    EXPECT_EQ(error, Error::kOutOfMemory);
    EXPECT_EQ(diagram.validate(broken), Error::kNone);
    EXPECT_EQ(broken, expected);
  }
  EXPECT_GT(failed_, 0);
}

INSTANTIATE_TEST_SUITE_P(By, OutOfMemory, ::testing::Values(Failure::kOnce, Failure::kBudget),
                         [](const auto& test) {
                           return test.param == Failure::kOnce ? "OneAllocation" : "Budget";
                         });

}  // namespace
}  // namespace apollonius::test
