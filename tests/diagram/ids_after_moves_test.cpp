// Moves of many sites at once: ids that are free stay so in their order, and of an id that is given
// several times the last place counts, wherever the others are.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

std::vector<double> randomPoints(Random& random, std::size_t count) {
  std::vector<double> xyr;
  for (std::size_t k = 0; k < count; ++k)
    xyr.insert(xyr.end(), {random.between(0, 100), random.between(0, 100), 0});
  return xyr;
}

void expectValid(const Diagram& diagram) {
  std::string broken;
  ASSERT_EQ(diagram.validate(broken), Error::kNone);
  ASSERT_EQ(broken, "");
}

TEST(IdsAfterMoves, FreeOnesAreUsedAgainLastFirst) {
  Random random(231);
  constexpr std::size_t kSites = 400;
  Diagram diagram;
  std::vector<SiteId> ids(kSites);
  ASSERT_EQ(diagram.insertMany(randomPoints(random, kSites), ids), Error::kNone);
  bool removed = false;
  for (const SiteId id : {3u, 7u, 9u}) ASSERT_EQ(diagram.remove(id, removed), Error::kNone);
  std::vector<SiteId> rest;
  for (const SiteId id : ids) {
    if (id != 3 && id != 7 && id != 9) rest.push_back(id);
  }
  // Nearly all sites move far, so the diagram is rebuilt.
  ASSERT_EQ(diagram.updateMany(rest, randomPoints(random, rest.size())), Error::kNone);
  for (const SiteId expected : {9u, 7u, 3u, 400u}) {
    SiteId id = kNoSite;
    ASSERT_EQ(diagram.insert(random.between(0, 100), 50, 0, id), Error::kNone);
    EXPECT_EQ(id, expected);
  }
  expectValid(diagram);
}

TEST(IdsAfterMoves, OfOneGivenTwiceTheLastPlaceCounts) {
  Random random(232);
  constexpr std::size_t kSites = 300;
  Diagram diagram;
  std::vector<SiteId> ids(kSites);
  ASSERT_EQ(diagram.insertMany(randomPoints(random, kSites), ids), Error::kNone);
  for (int run = 0; run < runs(100); ++run) {
    std::vector<SiteId> moved;
    std::vector<double> xyr;
    for (int k = 0; k < 3; ++k) {
      const SiteId id = random.below(SiteId{kSites});
      for (int time = 0; time < 2; ++time) {
        moved.push_back(id);
        xyr.insert(xyr.end(), {random.between(0, 100), random.between(0, 100), 0});
      }
    }
    ASSERT_EQ(diagram.updateMany(moved, xyr), Error::kNone);
    expectValid(diagram);
    if (HasFatalFailure()) return;
    for (std::size_t k = 0; k < moved.size(); ++k) {
      std::size_t last = k;
      for (std::size_t m = k; m < moved.size(); ++m) last = moved[m] == moved[k] ? m : last;
      Circle now{};
      ASSERT_EQ(diagram.site(moved[k], now), Error::kNone);
      ASSERT_EQ(now.x, xyr[3 * last]) << "run " << run;
      ASSERT_EQ(now.y, xyr[3 * last + 1]) << "run " << run;
    }
  }
}

}  // namespace
}  // namespace apollonius::test
