// Edge conflicts against the oracle. A new site takes parts of Voronoi edges away; how many edges
// between two sites remain is known from the oracle's diagrams without and with it, and the answers
// of the predicates predict that number: none (all of it is taken), one (none of it, or one end, or
// both ends but not all), or two (the interior only).
#include "predicate/edge_conflict.h"

#include <gtest/gtest.h>

#include "predicate/compute_circle.h"
#include "predicate/samples.h"
#include "predicate/stage_counts.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::internal {
namespace {

using namespace test;

/// The two predicates do not depend on the side that the edge is looked at from, nor on whether
/// cached circles are asked first.
void expectSymmetric(const EdgeCorners& e, const Site& q, bool interior) {
  const EdgeCorners mirrored{e.j, e.i, e.l, e.k};
  const VoronoiCircle atK = voronoiCircle(e.i, e.j, e.k), atL = voronoiCircle(e.j, e.i, e.l);
  if (interior) {
    const bool expected = isInteriorInConflict(e, q);
    ASSERT_EQ(isInteriorInConflict(mirrored, q), expected);
    ASSERT_EQ(isInteriorInConflict(e, atK, atL, q), expected);
    ASSERT_EQ(isInteriorInConflict(mirrored, atL, atK, q), expected);
  } else {
    const bool expected = isEntireEdgeInConflict(e, q);
    ASSERT_EQ(isEntireEdgeInConflict(mirrored, q), expected);
    ASSERT_EQ(isEntireEdgeInConflict(e, atK, atL, q), expected);
    ASSERT_EQ(isEntireEdgeInConflict(mirrored, atL, atK, q), expected);
  }
}

/// The number of pieces of the edge that q leaves.
std::size_t piecesLeft(const EdgeCorners& e, const Site& q) {
  const bool atK = isVertexInConflict(e.i, e.j, e.k, q);
  const bool atL = isVertexInConflict(e.j, e.i, e.l, q);
  if (atK != atL) return 1;
  expectSymmetric(e, q, !atK);
  return atK ? (isEntireEdgeInConflict(e, q) ? 0 : 1) : (isInteriorInConflict(e, q) ? 2 : 1);
}

struct Outcomes {
  int untouched = 0, interior = 0, entire = 0, bothEndsOnly = 0;
};

/// Checks all edges of the diagram of `circles` against the query, a circle that none of them
/// covers.
void expectAgreement(const Circles& circles, const Circle& query, Outcomes& outcomes) {
  Circles all = circles;
  all.push_back(query);
  const auto before = facesByEdge(oracleDiagram(circles));
  const auto after = facesByEdge(oracleDiagram(all));
  const std::vector<Site> sites = toSites(circles);
  const Site q = toSite(query);
  for (const auto& [ends, thirds] : before) {
    const auto [a, b] = ends;
    // Where two sites share several edges, the oracle's triples do not say which ends belong
    // together.
    if (thirds.size() != 1) continue;
    const int l = before.at({b, a}).front();
    const EdgeCorners edge{corner(sites, a), corner(sites, b), corner(sites, thirds.front()),
                           corner(sites, l)};
    const auto found = after.find(ends);
    const std::size_t expected = found == after.end() ? 0 : found->second.size();
    ASSERT_EQ(piecesLeft(edge, q), expected)
        << "edge " << a << " " << b << ", faces " << thirds.front() << " and " << l;
    const bool atK = isVertexInConflict(edge.i, edge.j, edge.k, q);
    if (expected == 0) ++outcomes.entire;
    if (expected == 2) ++outcomes.interior;
    if (expected == 1 && !atK) ++outcomes.untouched;
    if (expected == 1 && atK && isVertexInConflict(edge.j, edge.i, edge.l, q))
      ++outcomes.bothEndsOnly;
  }
}

bool coveredByAny(const Circle& q, const Circles& circles) {
  for (const Circle& c : circles) {
    if (oracleCovers(c, q)) return true;
  }
  return false;
}

TEST(EdgeConflict, AgreesWithTheOracleOnTinyGrids) {
  Random random(91);
  Outcomes outcomes;
  const int all = sized(5000, 20000);
  for (int run = 0; run < runs(all); ++run) {
    const int side = static_cast<int>(random.integer(1, 6));
    const int heaviest = static_cast<int>(random.integer(0, 4));
    const std::size_t n = 2 + random.below(std::size_t{4});
    const Circles circles = visibleOnly(tinyGrid(random, n, side, heaviest));
    const Circle query = tinyGrid(random, 1, side, heaviest).front();
    if (circles.size() < 2 || coveredByAny(query, circles)) continue;
    expectAgreement(circles, query, outcomes);
    if (HasFatalFailure())
      FAIL() << "run " << run << "\n" << toText(insertAll(circles)) << toText(insertAll({query}));
  }
  // All kinds of answers must have occurred, often.
  EXPECT_GT(outcomes.untouched, runs(all / 5));
  EXPECT_GT(outcomes.entire, runs(all / 5));
  EXPECT_GT(outcomes.interior, runs(all / 50));
  EXPECT_GT(outcomes.bothEndsOnly, runs(all / 1000));
}

class EdgeConflictOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(EdgeConflictOn, AgreesWithTheOracle) {
  Random random(92);
  Outcomes outcomes;
  const int count = runs(GetParam().large ? 150 : 10);
  for (int run = 0; run < count; ++run) {
    const std::size_t n = 3 + random.below(std::size_t{4});
    Circles circles = GetParam().make(random, n);
    const Circle query = circles.back();
    circles.pop_back();
    circles = visibleOnly(circles);
    if (circles.size() < 2 || coveredByAny(query, circles)) continue;
    expectAgreement(circles, query, outcomes);
    if (HasFatalFailure())
      FAIL() << "run " << run << "\n" << toText(insertAll(circles)) << toText(insertAll({query}));
  }
}

TEST_P(EdgeConflictOn, EarlyStagesNeverContradictTheExactOne) {
  Random random(93);
  const int count = runs(GetParam().large ? 300 : 30);
  for (int run = 0; run < count; ++run) {
    std::vector<Site> s = toSites(visibleOnly(GetParam().make(random, 7)));
    if (s.size() < 5) continue;
    // The reference site is the larger of i and j, or j is infinite.
    if (precedes(s[0], s[1])) std::swap(s[0], s[1]);
    const bool unbounded = run % 3 == 0;
    const Corner j = unbounded ? nullptr : &s[1];
    const Corner k = run % 3 == 1 ? nullptr : &s[2];
    for (const auto probe : {stages::Probe::kMiddle, stages::Probe::kOpposite}) {
      const Sign exact = stages::edgeExact(s[0], j, k, &s[3], s[4], probe);
      for (const MaybeSign early : {stages::edgeFilter(s[0], j, k, &s[3], s[4], probe),
                                    stages::edgeMiddle(s[0], j, k, &s[3], s[4], probe),
                                    stages::edgeFixed(s[0], j, k, &s[3], s[4], probe)}) {
        if (early.known) {
          ASSERT_EQ(early.sign == Sign::kPositive, exact == Sign::kPositive) << "run " << run;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, EdgeConflictOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(EdgeConflict, EasyCasesAreAnsweredByTheFilter) {
  Random random(94);
  Outcomes outcomes;
  const stages::Counts before = stages::counts();
  for (int run = 0; run < 100; ++run) {
    const Circles circles = visibleOnly(randomCircles(random, 6, Hidden::k20Percent));
    const Circle query = randomCircles(random, 1, Hidden::kNone).front();
    if (circles.size() >= 2 && !coveredByAny(query, circles))
      expectAgreement(circles, query, outcomes);
  }
  EXPECT_GT(stages::counts().edgeFilter - before.edgeFilter, 500u);
  EXPECT_EQ(stages::counts().edgeExact, before.edgeExact);
}

}  // namespace
}  // namespace apollonius::internal
