// Lack of memory: every public operation, made to fail at each of its allocations in turn, must report kOutOfMemory, leave the
// diagram as it was, and leave it in a state from which everything works.
//
// operator new is replaced for the whole test program. Two ways to fail: the k-th allocation only, as if others had freed
// memory in between; and a budget of bytes, as on a heap that is full (what the operation itself frees, it may use again).
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <new>
#include <optional>

#include "apollonius.h"
#include "support/effort.h"
#include "support/generators.h"

namespace {

constexpr std::size_t kHeader = alignof(std::max_align_t);  // holds the size of the block behind it

struct Heap {
  std::size_t live = 0;       // bytes
  std::size_t count = 0;      // allocations since the last arming
  std::size_t failures = 0;
  std::size_t wanted = 0;     // bytes that would have been live if the first failure had not been one
  std::optional<std::size_t> failAt;  // the allocation that fails, counted from 0
  std::optional<std::size_t> limit;   // bytes

  bool refuses(std::size_t size) {
    const bool refused = (failAt && count == *failAt) || (limit && live + size > *limit);
    ++count;
    if (refused && failures++ == 0) wanted = live + size;
    return refused;
  }
  void disarm() {
    failAt.reset();
    limit.reset();
  }
  void arm() {
    count = failures = wanted = 0;
    disarm();
  }
};

Heap heap;

}  // namespace

// Not inlined, or g++ takes malloc and free for a mismatch. Array and nothrow forms end here, too.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (heap.refuses(size)) throw std::bad_alloc();
  void* block = std::malloc(kHeader + size);
  if (block == nullptr) throw std::bad_alloc();
  *static_cast<std::size_t*>(block) = size;
  heap.live += size;
  return static_cast<std::byte*>(block) + kHeader;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  if (memory == nullptr) return;
  void* block = static_cast<std::byte*>(memory) - kHeader;
  heap.live -= *static_cast<std::size_t*>(block);
  std::free(block);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace apollonius::test {
namespace {

/// What a user can see of a diagram.
struct State {
  std::vector<SiteId> ids;
  Circles circles;
  std::vector<bool> hidden;
  std::vector<std::array<SiteId, 3>> faces;  // each from its smallest id on, sorted
  std::string broken;

  explicit State(const Diagram& diagram) {
    EXPECT_EQ(diagram.ids(ids), Error::kNone);
    for (const SiteId id : ids) {
      Circle circle{};
      bool isHidden = false;
      EXPECT_EQ(diagram.site(id, circle), Error::kNone);
      EXPECT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
      circles.push_back(circle);
      hidden.push_back(isHidden);
    }
    std::vector<SiteId> corners;
    EXPECT_EQ(diagram.faces(corners), Error::kNone);
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      std::array<SiteId, 3> face{corners[k], corners[k + 1], corners[k + 2]};
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      faces.push_back(face);
    }
    std::sort(faces.begin(), faces.end());
    EXPECT_EQ(diagram.validate(broken), Error::kNone);
  }

  bool operator==(const State& other) const {
    const auto same = [](const Circle& a, const Circle& b) { return a.x == b.x && a.y == b.y && a.r == b.r; };
    return ids == other.ids && hidden == other.hidden && faces == other.faces && broken == other.broken &&
           std::equal(circles.begin(), circles.end(), other.circles.begin(), other.circles.end(), same);
  }
};

/// Circles of which most are visible, some hidden, some of those hidden by each other; in the grid many predicates are zero.
Circles mixed(Random& random, std::size_t n) {
  Circles circles = n % 2 == 0 ? randomCircles(random, n, Hidden::k20Percent) : tinyGrid(random, n, 12, 4);
  return circles;
}

void build(Diagram& diagram, const Circles& circles) {
  for (const Circle& c : circles) {
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.insert(c.x, c.y, c.r, id), Error::kNone);
  }
}

/// An operation on a diagram; results that it returns live as long as the object.
struct Operation {
  std::string name;
  std::function<Error(Diagram&)> run;
};

std::vector<double> flat(const Circles& circles) {
  std::vector<double> xyr;
  for (const Circle& c : circles) xyr.insert(xyr.end(), {c.x, c.y, c.r});
  return xyr;
}

/// Operations for a diagram of n sites made by mixed(). What they need is made beforehand, so that only the library allocates.
std::vector<Operation> changes(Random& random, std::size_t n) {
  const Circles others = mixed(random, n);
  const std::vector<double> xyr = flat(others);
  std::vector<SiteId> all(n), half;
  for (SiteId id = 0; id < n; ++id) {
    all[id] = id;
    if (id % 2 == 0) half.push_back(id);
  }
  const Circle c = others[0];
  const auto some = static_cast<SiteId>(random.below(n)), other = static_cast<SiteId>(random.below(n));
  const std::vector<double> halfXyr(xyr.begin(), xyr.begin() + static_cast<std::ptrdiff_t>(3 * half.size()));
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
      {"insertMany", [=, ids = std::vector<SiteId>(n)](Diagram& d) mutable { return d.insertMany(xyr, ids); }},
      {"updateMany", [=](Diagram& d) { return d.updateMany(half, halfXyr); }},
      {"removeMany",
       [=](Diagram& d) {
         std::size_t removed = 0;
         return d.removeMany(half, removed);
       }},
  };
}

std::vector<Operation> queries(std::size_t n) {
  std::vector<double> xy;
  for (std::size_t k = 0; k < 2 * n; ++k) xy.push_back(static_cast<double>(k * 7 % 13));
  return {
      {"find",
       [](Diagram& d) {
         SiteId id = kNoSite;
         double distance = 0;
         return d.find(3.5, 2.25, id, distance);
       }},
      {"findMany", [=, ids = std::vector<SiteId>(n), distances = std::vector<double>(n)](Diagram& d) mutable { return d.findMany(xy, ids, distances); }},
      {"neighbors",
       [=](Diagram& d) {
         std::vector<SiteId> sites;
         Error error = Error::kNone;
         for (SiteId id = 0; id < n && error == Error::kNone; ++id) error = d.neighbors(id, sites);
         return error;
       }},
      {"coverOf",
       [=](Diagram& d) {
         SiteId cover = kNoSite;
         Error error = Error::kNone;
         for (SiteId id = 0; id < n && error == Error::kNone; ++id) error = d.coverOf(id, cover);
         return error;
       }},
      {"ids",
       [](Diagram& d) {
         std::vector<SiteId> ids;
         return d.ids(ids);
       }},
      {"vertices",
       [](Diagram& d) {
         VertexArrays vertices;
         return d.vertices(vertices);
       }},
      {"edges",
       [](Diagram& d) {
         EdgeArrays edges;
         return d.edges(edges);
       }},
      {"faces",
       [](Diagram& d) {
         std::vector<SiteId> sites;
         return d.faces(sites);
       }},
      {"validate",
       [](Diagram& d) {
         std::string broken;
         return d.validate(broken);
       }},
  };
}

enum class Failure { kOnce, kBudget };

/// Makes an operation fail at each allocation that it makes on a fresh diagram. Returns how many times it failed.
int failEverywhere(const Circles& circles, const Operation& operation, Failure failure) {
  std::optional<State> before, after;
  int failed = 0;
  std::size_t at = 0;
  for (;;) {
    Diagram diagram;
    build(diagram, circles);
    if (!before) before.emplace(diagram);
    EXPECT_EQ(before->broken, "");
    const std::function<Error(Diagram&)> run = operation.run;  // a fresh copy: no memory of an earlier run
    heap.arm();
    const std::size_t live = heap.live;
    if (failure == Failure::kOnce) {
      heap.failAt = at;
    } else {
      heap.limit = live + at;
    }
    const Error error = run(diagram);
    heap.disarm();
    const std::size_t failures = heap.failures, wanted = heap.wanted, count = heap.count;

    if (error == Error::kOutOfMemory) {
      ++failed;
      const State now(diagram);
      EXPECT_EQ(now.broken, "");
      EXPECT_TRUE(now == *before) << "the diagram changed";
      // And it still works.
      EXPECT_EQ(run(diagram), Error::kNone);
      if (!after) {
        Diagram another;
        build(another, circles);
        EXPECT_EQ(run(another), Error::kNone);
        after.emplace(another);
      }
      EXPECT_TRUE(State(diagram) == *after) << "the second try went otherwise than a first one: " << State(diagram).broken;
    } else {
      // Success: nothing had failed, or only what can be done without (the hierarchy).
      EXPECT_EQ(error, Error::kNone);
      EXPECT_EQ(State(diagram).broken, "") << "after a success in spite of " << failures << " failed allocations";
    }
    // Whatever happened: the diagram can grow.
    for (std::size_t k = 0; k < 40; ++k) {
      SiteId id = kNoSite;
      EXPECT_EQ(diagram.insert(static_cast<double>(k % 7) * 5 + 100, static_cast<double>(k / 7) * 5, 2, id), Error::kNone);
    }
    const std::string broken = State(diagram).broken;
    EXPECT_EQ(broken, "") << "after further insertions";
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << operation.name << ", " << circles.size() << " sites, "
                    << (failure == Failure::kOnce ? "allocation " : "budget of bytes ") << at;
      return failed;
    }
    if (failures == 0) return failed;
    // The next allocation, or in long sequences one a little later; the smallest budget that gets further.
    at = failure == Failure::kOnce ? at + 1 + count / 40 : std::max(wanted - live, at + 1 + at / 40);
  }
}

class OutOfMemory : public ::testing::TestWithParam<Failure> {};

TEST_P(OutOfMemory, ChangesLeaveTheDiagramAsItWas) {
  int failed = 0;
  const std::vector<std::size_t> sizes{1, 2, 3, 4, 5, 7, 8, 9, 16, 17, 33, 64, 65, 150};
  for (const std::size_t n : sizes) {
    if (kEffortDivisor > 1 && n > 65) break;
    Random random(n);
    const Circles circles = mixed(random, n);
    for (const Operation& operation : changes(random, n)) {
      failed += failEverywhere(circles, operation, GetParam());
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(failed, 500);
}

TEST_P(OutOfMemory, ChangesThatNeedLongNumbersLeaveTheDiagramAsItWas) {
  // Exact arithmetic beyond the 512 bits that are kept inline: exponents far apart.
  int failed = 0;
  for (const std::size_t n : {3u, 6u, 9u}) {
    Random random(n);
    const Circles circles = rangeEnds(random, n, Range::kMixed);
    for (const Operation& operation : changes(random, n)) {
      failed += failEverywhere(circles, operation, GetParam());
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(failed, 100);
}

TEST_P(OutOfMemory, QueriesSaySo) {
  for (const std::size_t n : {1u, 2u, 5u, 40u, 41u}) {
    Random random(n);
    const Circles circles = mixed(random, n);
    for (const Operation& operation : queries(n)) {
      (void)failEverywhere(circles, operation, GetParam());
      if (HasFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(By, OutOfMemory, ::testing::Values(Failure::kOnce, Failure::kBudget),
                         [](const auto& info) { return info.param == Failure::kOnce ? "OneAllocation" : "Budget"; });

}  // namespace
}  // namespace apollonius::test
