// insertMany, updateMany and removeMany on diagrams that already hold sites: the same graph as a
// fresh build of what remains.
#include <gtest/gtest.h>

#include <map>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

/// A diagram changed in batches, and the sites that it should contain.
class Batches {
 public:
  explicit Batches(Location location) : diagram_(location) {}

  void insert(const Circles& circles) {
    std::vector<SiteId> ids(circles.size());
    ASSERT_EQ(diagram_.insertMany(flat(circles), ids), Error::kNone);
    for (std::size_t k = 0; k < ids.size(); ++k)
      ASSERT_TRUE(table_.insert({ids[k], circles[k]}).second) << "an id given twice";
  }

  void update(const std::vector<SiteId>& ids, const Circles& circles) {
    ASSERT_EQ(diagram_.updateMany(ids, flat(circles)), Error::kNone);
    for (std::size_t k = 0; k < ids.size(); ++k) table_[ids[k]] = circles[k];
  }

  void remove(const std::vector<SiteId>& ids) {
    std::size_t removed = 0;
    ASSERT_EQ(diagram_.removeMany(ids, removed), Error::kNone);
    ASSERT_EQ(removed, ids.size());
    for (const SiteId id : ids) table_.erase(id);
  }

  /// Some of the ids, in random order.
  std::vector<SiteId> some(Random& random, std::size_t count) const {
    std::vector<SiteId> ids;
    for (const auto& [id, circle] : table_) ids.push_back(id);
    random.shuffle(ids);
    ids.resize(std::min(count, ids.size()));
    return ids;
  }

  void expectFreshBuild() const {
    std::string broken;
    ASSERT_EQ(diagram_.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
    Circles circles;
    for (const auto& [id, circle] : table_) {
      Circle got{};
      ASSERT_EQ(diagram_.site(id, got), Error::kNone);
      ASSERT_TRUE(got.x == circle.x && got.y == circle.y && got.r == circle.r);
      circles.push_back(circle);
    }
    const Canonical got = canonicalForm(diagram_, broken);
    ASSERT_EQ(broken, "");
    const Canonical expected = freshBuild(circles, Build::kOneByOne, Location::kHierarchy, broken);
    ASSERT_EQ(broken, "");
    ASSERT_TRUE(got == expected) << difference(expected, got);
  }

 private:
  Diagram diagram_;
  std::map<SiteId, Circle> table_;
};

class BatchesOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(BatchesOn, EndInAFreshBuild) {
  Random random(301);
  for (int run = 0; run < runs(sized(2, 4)); ++run) {
    const std::size_t size = GetParam().large ? 30 : 5;
    const Circles pool = GetParam().make(random, 6 * size);
    const auto draw = [&](std::size_t count) {
      Circles circles;
      for (std::size_t k = 0; k < count; ++k) circles.push_back(pool[random.below(pool.size())]);
      return circles;
    };
    Batches batches(run % 2 == 0 ? Location::kHierarchy : Location::kWalk);
    for (int step = 0; step < 8; ++step) {
      batches.insert(draw(random.below(2 * size)));
      if (step % 2 == 0) {
        const std::vector<SiteId> ids = batches.some(random, random.below(size));
        batches.update(ids, draw(ids.size()));
      } else {
        batches.remove(batches.some(random, random.below(2 * size)));
      }
      batches.expectFreshBuild();
      if (HasFatalFailure()) FAIL() << "run " << run << " step " << step;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, BatchesOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::test
