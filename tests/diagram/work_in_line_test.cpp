// Sites in line on the hull, in sorted order and not: what an insertion or a removal changes, and
// the questions that it asks, must not grow with the number of sites. Work is counted, not timed:
// the faces that change (an insertion makes as many as the new site has neighbours, a removal takes
// as many away) and the predicates' answers (stage_counts.h).
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <ostream>

#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"
#include "predicate/shadow_check.h"
#include "predicate/stage_counts.h"
#include "support/degree.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using namespace test;

/// The factor by which the shadow check may ask more on its own account.
constexpr std::size_t kSlack = kShadowCheck ? 3 : 1;

/// Answers of all stages since the last reset. Those of the filters that are settled on the way are
/// not among them, but where sites are in line these know nothing.
std::size_t answers() {
  const stages::Counts& c = stages::counts();
  const unsigned long long all =
      c.lorentzFilter + c.lorentzMiddle + c.lorentzExact + c.distanceFilter + c.distanceMiddle +
      c.distanceFixed + c.distanceExact + c.vertexOfPoints + c.vertexTwofold + c.vertexFilter +
      c.vertexMiddle + c.vertexFixed + c.vertexExact + c.edgeCached + c.edgeFilter + c.edgeMiddle +
      c.edgeFixed + c.edgeExact;
  return static_cast<std::size_t>(all);
}

struct Work {
  std::size_t faces = 0, answers = 0;
};

Work workOfInsertion(const std::vector<Site>& sites) {
  DiagramCore core(Location::kHierarchy);
  Work work;
  stages::counts() = {};
  for (const Site& site : sites) work.faces += degree(core, core.insert(site));
  work.answers = answers();
  return work;
}

struct Row {
  const char* name;
  std::function<Site(std::size_t)> at;  ///< in the order of the row
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }

const std::vector<Row>& rows() {
  static const std::vector<Row> all{
      {"PointsAlongX", [](std::size_t k) { return Site{static_cast<double>(k), 0, 0}; }},
      {"PointsAlongY", [](std::size_t k) { return Site{5, static_cast<double>(k), 1}; }},
      {"PointsAlongASlope",
       [](std::size_t k) {
         return Site{3.0 * static_cast<double>(k), -2.0 * static_cast<double>(k), 0};
       }},
      {"TwoParallelLines",
       [](std::size_t k) {
         return Site{static_cast<double>(k / 2), k % 2 == 0 ? 0.0 : 1000.0, 0};
       }},
      // Circles of several sizes on a line that they all touch from above.
      {"TangentRow",
       [](std::size_t k) {
         const double r = static_cast<double>(1 + k * 7 % 3);
         return Site{8.0 * static_cast<double>(k), r, r};
       }},
  };
  return all;
}

class WorkInLine : public ::testing::TestWithParam<Row> {};

TEST_P(WorkInLine, OfInsertionsGrowsLikeTheirNumber) {
  const auto n = static_cast<std::size_t>(runs(1000));
  for (const char* order : {"ascending", "descending", "random"}) {
    SCOPED_TRACE(order);
    Work work[2];
    for (const std::size_t times : {1u, 2u}) {
      std::vector<Site> sites;
      for (std::size_t k = 0; k < times * n; ++k) sites.push_back(GetParam().at(k));
      if (*order == 'd') std::reverse(sites.begin(), sites.end());
      Random random(341);
      if (*order == 'r') random.shuffle(sites);
      work[times - 1] = workOfInsertion(sites);
      EXPECT_LE(work[times - 1].faces, 6 * sites.size());
      EXPECT_LE(work[times - 1].answers, kSlack * 18 * sites.size());
    }
    EXPECT_LE(work[1].faces, 2.2 * static_cast<double>(work[0].faces));
    EXPECT_LE(work[1].answers, 2.2 * static_cast<double>(work[0].answers));
  }
}

/// A row of many, put in at once; then some of them go, in any order.
TEST_P(WorkInLine, OfARemovalIsThatOfAFewFaces) {
  const auto n = static_cast<std::size_t>(runs(kShadowCheck ? 20000 : 100000));
  std::vector<double> xyr;
  for (std::size_t k = 0; k < n; ++k) {
    const Site site = GetParam().at(k);
    xyr.insert(xyr.end(), {site.x, site.y, site.r});
  }
  DiagramCore core(Location::kHierarchy);
  std::vector<SiteId> ids(n);
  insertAll(core, xyr, ids);
  Random random(342);
  for (int k = 0; k < 1000; ++k) {
    const SiteId id = ids[random.below(n)];
    if (core.ids().slotOf(id) == kNoSlot) continue;
    ASSERT_LE(degree(core, id), 12u);
    stages::counts() = {};
    ASSERT_TRUE(core.remove(id));
    ASSERT_LE(answers(), kSlack * 150);
  }
}

TEST(WorkInLine, PointsHaveDegreeFour) {
  DiagramCore core(Location::kHierarchy);
  std::vector<SiteId> ids;
  for (int k = 0; k < 100; ++k)
    ids.push_back(core.insert({k * 37 % 100 * 1.0, k * 37 % 100 * 2.0, 0}));
  for (int k = 0; k < 100; ++k) {
    // The two beside and infinity on both sides; the ends have one neighbour and one side.
    EXPECT_EQ(degree(core, ids[static_cast<std::size_t>(k)]),
              k * 37 % 100 == 0 || k * 37 % 100 == 99 ? 2u : 4u);
  }
}

/// Row by row, each row from the left: the first site of a row sees all of the row below, and the
/// next ones take most of that over. Those faces do change, but their circles are in conflict
/// beyond doubt: hardly more questions are asked than in random order.
TEST(WorkInLine, OfALatticeRowByRow) {
  if (kShadowCheck) GTEST_SKIP() << "the shadow check asks about every face";
  const int side = runs(60);
  std::vector<Site> sites;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) sites.push_back({1.0 * x, 1.0 * y, 0});
  }
  const Work rowByRow = workOfInsertion(sites);
  EXPECT_LE(rowByRow.answers, 12 * sites.size());
  Random random(343);
  random.shuffle(sites);
  EXPECT_LE(rowByRow.answers, 4 * workOfInsertion(sites).answers);
}

INSTANTIATE_TEST_SUITE_P(Rows, WorkInLine, ::testing::ValuesIn(rows()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::internal
