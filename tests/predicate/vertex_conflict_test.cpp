// isVertexInConflict() and hasVoronoiCircle() against the oracle, which solves for the circles;
// their laws; the filter and the cached circle against the exact stage.
#include "predicate/vertex_conflict.h"

#include <gtest/gtest.h>

#include <cmath>

#include "number/dyadic.h"
#include "predicate/compute_circle.h"
#include "predicate/reference_site.h"
#include "predicate/samples.h"
#include "predicate/stage_counts.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::internal {
namespace {

using namespace test;

bool covered(const Circle& q, const Circles& by) {
  for (const Circle& c : by) {
    if (oracleCovers(c, q)) return true;
  }
  return false;
}

/// Expects of each face: equal answers after rotation, and through the cached circle.
void expectConflict(const std::vector<Site>& sites, int i, int j, int k, const Site& q,
                    bool expected) {
  const Corner a = corner(sites, i), b = corner(sites, j), c = corner(sites, k);
  ASSERT_EQ(isVertexInConflict(a, b, c, q), expected);
  ASSERT_EQ(isVertexInConflict(b, c, a, q), expected) << "rotated once";
  ASSERT_EQ(isVertexInConflict(c, a, b, q), expected) << "rotated twice";
  ASSERT_EQ(isVertexInConflict(voronoiCircle(a, b, c), a, b, c, q), expected)
      << "through the cached circle";
}

/// The oracle's answer is about a q that covers nothing and is not covered; otherwise q beats every
/// site that it covers.
void expectAgreement(const Circles& circles, int i, int j, int k, int q) {
  const std::vector<Site> sites = toSites(circles);
  const CircleAnswer answer = oracleCircle(circles, i, j, k, q);
  if (answer == CircleAnswer::kNoCircle) return;
  bool beatsSite = false;
  for (const int t : {i, j, k})
    beatsSite = beatsSite || (t != kInfinity && oracleCovers(circles[q], circles[t]));
  expectConflict(sites, i, j, k, sites[q], beatsSite || answer == CircleAnswer::kInConflict);
}

/// All quadruples (face i, j, k and query q) of circles of a tiny grid; j, k and q take every role,
/// so every permutation is in.
TEST(VertexConflict, AgreesWithTheOracleOnAllQuadruplesOfATinyGrid) {
  Circles grid;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      for (int r = 0; r < 2; ++r) grid.push_back({x * 1.0, y * 1.0, r * 1.0});
    }
  }
  const int n = static_cast<int>(grid.size());
  for (int i = 0; i < n; ++i) {
    for (int j = i + 1; j < n; ++j) {
      for (int k = i + 1; k <= n; ++k) {  // k == n: infinity
        Circles face{grid[i], grid[j]};
        if (k < n) face.push_back(grid[k]);
        if (k == j || visibleOnly(face).size() != face.size()) continue;
        if (k < n) {
          const std::vector<Site> s = toSites(face);
          const bool exists = oracleCircle(face, 0, 1, 2, kInfinity) != CircleAnswer::kNoCircle;
          ASSERT_EQ(hasVoronoiCircle(s[0], s[1], s[2]), exists) << toText(insertAll(face));
          ASSERT_EQ(hasVoronoiCircle(s[1], s[2], s[0]), exists) << toText(insertAll(face));
          if (!exists) continue;
        }
        for (int q = 0; q < n; q += 1 + (kEffortDivisor > 1)) {
          if (covered(grid[q], face)) continue;
          Circles all = face;
          all.push_back(grid[q]);
          const int query = static_cast<int>(face.size());
          expectAgreement(all, 0, 1, k < n ? 2 : kInfinity, query);
          if (k == n) expectAgreement(all, 1, 0, kInfinity, query);
          if (HasFatalFailure())
            FAIL() << toText(insertAll(all)) << (k == n ? "with infinity" : "");
        }
      }
    }
  }
}

class VertexConflictOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(VertexConflictOn, AgreesWithTheOracle) {
  Random random(81);
  const int count = runs(GetParam().large ? 400 : 40);
  for (int run = 0; run < count; ++run) {
    const Circles circles = GetParam().make(random, 4);
    if (circles.size() < 4) continue;
    const Circles face(circles.begin(), circles.begin() + 3);
    if (visibleOnly(face).size() != 3 || covered(circles[3], face)) continue;
    const Circles four(circles.begin(), circles.begin() + 4);
    expectAgreement(four, 0, 1, 2, 3);
    expectAgreement(four, 0, 2, 1, 3);
    expectAgreement(four, 0, 1, kInfinity, 3);
    expectAgreement(four, 1, 0, kInfinity, 3);
    if (HasFatalFailure()) FAIL() << "run " << run << "\n" << toText(insertAll(four));
  }
}

TEST_P(VertexConflictOn, StagesAgreeAndScalingChangesNothing) {
  Random random(82);
  const int count = runs(GetParam().large ? 400 : 60);
  for (int run = 0; run < count; ++run) {
    const std::vector<Site> s = toSites(visibleOnly(GetParam().make(random, 6)));
    if (s.size() < 4) continue;
    Corner i = &s[0], j = &s[1], k = run % 4 == 0 ? nullptr : &s[2];
    const Site& q = s[3];
    rotateToReference(i, j, k);
    const Sign exact = stages::vertexExact(*i, j, k, &q);
    for (const MaybeSign early :
         {stages::vertexOfPoints(*i, j, k, &q), stages::vertexTwofold(*i, j, k, &q),
          stages::vertexFilter(*i, j, k, &q), stages::vertexMiddle(*i, j, k, &q),
          stages::vertexFixed(*i, j, k, &q)}) {
      if (early.known) {
        ASSERT_EQ(early.sign, exact) << "run " << run;
      }
    }
    // The exact stage is homogeneous: by powers of two nothing changes, not even the range's ends
    // matter.
    for (const double scale : {0x1p-40, 0x1p+60}) {
      const auto scaled = [&](Corner c) {
        return c == nullptr ? Site{} : Site{c->x * scale, c->y * scale, c->r * scale};
      };
      const Site si = scaled(i), sj = scaled(j), sk = scaled(k), sq = scaled(&q);
      const MaybeSign again =
          stages::vertexFilter(si, j == nullptr ? nullptr : &sj, k == nullptr ? nullptr : &sk, &sq);
      ASSERT_EQ(
          stages::vertexExact(si, j == nullptr ? nullptr : &sj, k == nullptr ? nullptr : &sk, &sq),
          exact);
      if (again.known) {
        ASSERT_EQ(again.sign, exact) << "run " << run;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, VertexConflictOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(VertexConflict, TranslationAndCommonWeightChangeNothing) {
  Random random(83);
  for (int run = 0; run < runs(2000); ++run) {
    const Circles circles = visibleOnly(tinyGrid(random, 6, 5, 3));
    if (circles.size() < 4) continue;
    const std::vector<Site> s = toSites(circles);
    if (!hasVoronoiCircle(s[0], s[1], s[2])) continue;
    const bool expected = isVertexInConflict(&s[0], &s[1], &s[2], s[3]);
    std::vector<Site> moved = s;  // small integers plus these offsets are exact
    for (Site& site : moved) site = {site.x + 0x1p40, site.y - 0x1p45 + 1, site.r - 0x1p30};
    ASSERT_EQ(isVertexInConflict(&moved[0], &moved[1], &moved[2], moved[3]), expected)
        << toText(insertAll(circles));
  }
}

TEST(VertexConflict, EasyCasesAreAnsweredByTheFilter) {
  Random random(84);
  const std::vector<Site> s = toSites(visibleOnly(randomCircles(random, 60, Hidden::k20Percent)));
  const stages::Counts before = stages::counts();
  int asked = 0;
  for (int run = 0; run < 5000; ++run) {
    const Site* t[4];
    for (const Site*& site : t) site = &s[random.below(s.size())];
    if (t[0] == t[1] || t[0] == t[2] || t[1] == t[2] || t[3] == t[0] || t[3] == t[1] ||
        t[3] == t[2])
      continue;
    if (!hasVoronoiCircle(*t[0], *t[1], *t[2])) continue;
    (void)isVertexInConflict(t[0], t[1], t[2], *t[3]);
    ++asked;
  }
  EXPECT_GT(asked, 1000);
  EXPECT_LE(stages::counts().vertexExact - before.vertexExact, static_cast<unsigned>(asked) / 1000);
  EXPECT_EQ(stages::counts().vertexOfPoints, before.vertexOfPoints) << "weights differ";
  EXPECT_EQ(stages::counts().vertexTwofold, before.vertexTwofold) << "weights differ";
  EXPECT_GE(stages::counts().vertexFilter - before.vertexFilter, static_cast<unsigned>(asked));
  EXPECT_EQ(stages::counts().vertexDegenerate, before.vertexDegenerate);
}

TEST(VertexConflict, PointsOnGridsOfAnySize) {
  Random random(85);
  int zeros = 0, unknown = 0;
  for (int run = 0; run < runs(40000); ++run) {
    // A square lattice, or a line, in any direction, about some place far away; some of the points
    // are often a little off.
    const int bits = static_cast<int>(random.integer(1, 30)),
              places = static_cast<int>(random.integer(0, 20));
    const double unit = std::ldexp(1.0, static_cast<int>(random.integer(-60, 60)));
    const std::int64_t most = std::int64_t{1} << bits,
                       far = std::int64_t{1} << (bits + places < 45 ? bits + places : 45);
    const double x0 = static_cast<double>(random.integer(-far, far)),
                 y0 = static_cast<double>(random.integer(-far, far));
    const double dx = static_cast<double>(random.integer(-most, most)),
                 dy = static_cast<double>(random.integer(-most, most));
    const bool onLine = random.integer(0, 1) == 0;
    std::vector<Site> s;
    for (int k = 0; k < 4; ++k) {
      const double a = static_cast<double>(random.integer(-3, 3)),
                   b = onLine ? 0 : static_cast<double>(random.integer(-3, 3));
      s.push_back({(x0 + a * dx - b * dy) * unit, (y0 + a * dy + b * dx) * unit, 7});
    }
    if (random.integer(0, 3) == 0) s[3].x = std::nextafter(s[3].x, random.oneIn(2) ? 0 : 1e300);
    if (random.integer(0, 3) == 0) s[2].y += unit / 2;
    bool areDistinct = true;
    for (int a = 0; a < 4; ++a) {
      for (int b = 0; b < a; ++b)
        areDistinct = areDistinct && (s[a].x != s[b].x || s[a].y != s[b].y);
    }
    if (!areDistinct) continue;
    Corner i = &s[0], j = &s[1], k = random.integer(0, 3) == 0 ? nullptr : &s[2];
    const Corner q = k != nullptr && random.integer(0, 3) == 0 ? nullptr : &s[3];
    rotateToReference(i, j, k);
    const Sign exact = stages::vertexExact(*i, j, k, q);
    const MaybeSign early = stages::vertexOfPoints(*i, j, k, q);
    for (const MaybeSign answer : {early, stages::vertexTwofold(*i, j, k, q)}) {
      if (answer.known) {
        ASSERT_EQ(answer.sign, exact) << "run " << run;
      }
    }
    zeros += exact == Sign::kZero;
    unknown += !early.known;
    if (exact != Sign::kZero) continue;
    // The rule in degenerate position, in doubles and exactly.
    const auto product = [](Corner a, Corner b) {
      return a == nullptr || b == nullptr
                 ? Dyadic(1)
                 : (Dyadic(a->x) - Dyadic(b->x)) * (Dyadic(a->x) - Dyadic(b->x)) +
                       (Dyadic(a->y) - Dyadic(b->y)) * (Dyadic(a->y) - Dyadic(b->y));
    };
    const Dyadic withReference = product(i, q) * product(j, k),
                 withJ = product(j, q) * product(i, k), withK = product(k, q) * product(i, j);
    const auto isLargest = [](const Dyadic& a, const Dyadic& b, const Dyadic& c) {
      return (a - b).sign() == Sign::kPositive && (a - c).sign() == Sign::kPositive;
    };
    const bool expected = q == nullptr   ? true
                          : j == nullptr ? isLargest(withJ, withReference, withK)
                          : k == nullptr
                              ? isLargest(withK, withReference, withJ)
                              : precedes(*i, *q) || isLargest(withReference, withJ, withK);
    ASSERT_EQ(stages::vertexDegenerate(*i, j, k, q), expected) << "run " << run;
  }
  EXPECT_GT(zeros, runs(40000) / 10);
  EXPECT_LT(unknown, runs(40000) / 3);
}

TEST(VertexConflict, FirstStageKnowsSmallIntegersAndLongLines) {
  const Site a{1e6, 1e6, 2}, b{1e6 + 1, 1e6, 2}, c{1e6 + 1, 1e6 + 1, 2}, d{1e6, 1e6 + 1, 2},
      far{1e6 + (1 << 21), 1e6, 2};
  for (const Corner q : {&a, &d}) {
    const MaybeSign sign = stages::vertexOfPoints(c, q == &a ? &d : &a, &b, q);
    EXPECT_TRUE(sign.known && sign.sign == Sign::kZero);
  }
  const MaybeSign inLine = stages::vertexOfPoints(far, &a, &b, nullptr),
                  beside = stages::vertexOfPoints(far, &a, &c, nullptr);
  EXPECT_TRUE(inLine.known && inLine.sign == Sign::kZero);
  EXPECT_TRUE(beside.known && beside.sign != Sign::kZero);
  EXPECT_FALSE(stages::vertexOfPoints({1e6, 1e6, 3}, &b, &c, &d).known) << "weights differ";
}

TEST(VertexConflict, DegenerateCasesReachTheDegenerateStage) {
  const Site square[] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const stages::Counts before = stages::counts();
  EXPECT_TRUE(isVertexInConflict(&square[0], &square[1], &square[3], square[2]))
      << "the largest is opposite to the edge 1, 3";
  EXPECT_EQ(stages::counts().vertexDegenerate, before.vertexDegenerate + 1);
  EXPECT_FALSE(isVertexInConflict(&square[0], &square[1], &square[2], square[3]));
  EXPECT_EQ(stages::counts().vertexDegenerate, before.vertexDegenerate + 2);
}

TEST(VertexConflict, OneUlpFromDegenerate) {
  const Site a{-5, 0, 0}, b{0, -5, 0}, c{5, 0, 0};
  const Site inside{0, std::nextafter(5.0, 4), 0}, outside{0, std::nextafter(5.0, 6), 0};
  EXPECT_TRUE(isVertexInConflict(&a, &b, &c, inside));
  EXPECT_FALSE(isVertexInConflict(&a, &b, &c, outside));
  const Site heavier{0, 5, 1e-100}, lighter{0, 5, -1e-100};
  EXPECT_TRUE(isVertexInConflict(&a, &b, &c, heavier));
  EXPECT_FALSE(isVertexInConflict(&a, &b, &c, lighter));
}

}  // namespace
}  // namespace apollonius::internal
