// levels() describes the hierarchy, after any history; and predicateCounts().
#include <gtest/gtest.h>

#include <algorithm>

#include "apollonius/predicate_counts.h"
#include "predicate/stage_counts.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/replay.h"
#include "support/saved.h"

namespace apollonius::test {
namespace {

std::vector<std::uint8_t> levelsOf(const Diagram& diagram) {
  std::vector<std::uint8_t> levels{99};  // to be replaced
  EXPECT_EQ(diagram.levels(levels), Error::kNone);
  return levels;
}

Circles randomCircles(std::size_t n) {
  for (const NamedGenerator& generator : corpus()) {
    Random random(1901);
    if (generator.name == std::string("Hidden20Percent")) return generator.make(random, n);
  }
  ADD_FAILURE();
  return {};
}

/// 0 for hidden sites and free ids, else at least 1.
void expectVisibleOnesOnly(const Diagram& diagram, const std::vector<std::uint8_t>& levels) {
  std::size_t visible = 0;
  for (SiteId id = 0; id < levels.size(); ++id) {
    bool hidden = true;
    if (diagram.has(id)) {
      ASSERT_EQ(diagram.isHidden(id, hidden), Error::kNone);
    }
    ASSERT_EQ(levels[id] > 0, !hidden) << id;
    visible += hidden ? 0 : 1;
  }
  EXPECT_EQ(visible, diagram.visibleSize());
}

TEST(Levels, OneInThirtyTwoGoesUp) {
  Diagram diagram;
  const std::vector<SiteId> ids = insertInto(diagram, randomCircles(20'000));
  const std::vector<std::uint8_t> levels = levelsOf(diagram);
  ASSERT_EQ(levels.size(), ids.size());
  expectVisibleOnesOnly(diagram, levels);
  const auto above = [&](int level) {
    return std::count_if(levels.begin(), levels.end(), [=](int k) { return k > level; });
  };
  EXPECT_EQ(above(0), static_cast<std::ptrdiff_t>(diagram.visibleSize()));
  EXPECT_NEAR(static_cast<double>(above(1)), static_cast<double>(above(0)) / 32, 40);
  EXPECT_NEAR(static_cast<double>(above(2)), static_cast<double>(above(0)) / 1024, 8);
  EXPECT_GT(above(2), 0);
}

TEST(Levels, FollowRemovalsMovesAndSnapshots) {
  Diagram diagram;
  const std::vector<SiteId> ids = insertInto(diagram, randomCircles(1500));
  Random random(1902);
  for (int run = 0; run < runs(200); ++run) {
    const SiteId id = ids[random.below(ids.size())];
    bool removed = false;
    if (run % 2 == 0) {
      ASSERT_EQ(diagram.remove(id, removed), Error::kNone);
    } else if (diagram.has(id)) {
      ASSERT_EQ(diagram.update(id, random.between(0, 1), random.between(0, 1), 0), Error::kNone);
    }
  }
  expectVisibleOnesOnly(diagram, levelsOf(diagram));

  // A diagram that was read makes its levels when it is asked: that is now.
  Diagram restored;
  ASSERT_EQ(restored.fromBytes(saved(diagram)), Error::kNone);
  EXPECT_EQ(levelsOf(restored), levelsOf(diagram));
  Diagram walking(Location::kWalk);
  ASSERT_EQ(walking.fromBytes(saved(diagram)), Error::kNone);
  const std::vector<std::uint8_t> plain = levelsOf(walking);
  EXPECT_EQ(*std::max_element(plain.begin(), plain.end()), 1);
  expectVisibleOnesOnly(walking, plain);
}

TEST(Levels, OfFewSites) {
  Diagram diagram;
  EXPECT_TRUE(levelsOf(diagram).empty());
  insertInto(diagram, {{0, 0, 5}, {0, 0, 1}});
  EXPECT_EQ(levelsOf(diagram)[1], 0);
  EXPECT_GE(levelsOf(diagram)[0], 1);
}

double sum(const StageCounts& stages) { return stages.filter + stages.middle + stages.exact; }

TEST(PredicateCounts, CountWhatWasAskedByStage) {
  const PredicateCounts before = predicateCounts();
  Diagram diagram;
  insertInto(diagram, randomCircles(500));
  const PredicateCounts random = predicateCounts();
  EXPECT_GT(sum(random.edgeConflict), sum(before.edgeConflict));
  EXPECT_GT(random.covers.filter, before.covers.filter);
  EXPECT_EQ(random.vertexConflict.exact, before.vertexConflict.exact) << "doubles suffice";
  EXPECT_EQ(random.ties, before.ties);

  Circles grid;
  for (int k = 0; k < 64; ++k) grid.push_back({k % 8 * 1.0, k / 8 * 1.0, 0});
  Diagram lattice;
  insertInto(lattice, grid);
  const PredicateCounts ties = predicateCounts();
  EXPECT_GT(ties.vertexConflict.middle, random.vertexConflict.middle) << "exact in doubles";
  EXPECT_GT(ties.ties, random.ties) << "four points on one circle, again and again";
}

TEST(PredicateCounts, HoldEachStageOnce) {
  const PredicateCounts before = predicateCounts();
  const internal::stages::Counts raw = internal::stages::counts();
  Diagram diagram;
  insertInto(diagram, randomCircles(1500));
  SiteId id = kNoSite;
  double distance = 0;
  for (int k = 0; k < 100; ++k)
    ASSERT_EQ(diagram.find(0.3 * k, 100 - 0.7 * k, id, distance), Error::kNone);
  const PredicateCounts after = predicateCounts();
  const internal::stages::Counts& now = internal::stages::counts();
  ASSERT_GT(now.edgeAtOnce, raw.edgeAtOnce);
  ASSERT_GT(now.vertexAtOnce, raw.vertexAtOnce);
  ASSERT_GT(now.distanceAtOnce, raw.distanceAtOnce);
  const auto total = [](const PredicateCounts& c) {
    return sum(c.covers) + sum(c.distance) + sum(c.bearing) + sum(c.vertexConflict) +
           sum(c.edgeConflict);
  };
  const auto totalOf = [](const internal::stages::Counts& c) {
    return static_cast<double>(
        c.lorentzFilter + c.lorentzMiddle + c.lorentzExact + c.distanceAtOnce + c.distanceFilter +
        c.distanceMiddle + c.distanceFixed + c.distanceExact + c.vertexAtOnce + c.vertexOfPoints +
        c.vertexTwofold + c.vertexFilter + c.vertexMiddle + c.vertexFixed + c.vertexExact +
        c.edgeAtOnce + c.edgeCached + c.edgeFilter + c.edgeMiddle + c.edgeFixed + c.edgeExact +
        c.rayCached + c.rayFilter + c.rayMiddle + c.rayFixed + c.rayExact);
  };
  EXPECT_EQ(total(after) - total(before), totalOf(now) - totalOf(raw));
}

}  // namespace
}  // namespace apollonius::test
