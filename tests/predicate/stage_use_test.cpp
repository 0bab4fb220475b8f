// Which stage answers: easy input must not reach the slow stages, and input that is exactly
// degenerate must not be answered by rounding. Counted along whole builds through the public
// interface, and on single questions.
#include <gtest/gtest.h>

#include <array>

#include "predicate/predicates.h"
#include "predicate/samples.h"
#include "predicate/stage_counts.h"
#include "support/corpus.h"
#include "support/effort.h"

namespace apollonius::internal {
namespace {

using namespace test;

/// The number of answers of each stage during a build.
stages::Counts countsOfBuild(const Circles& circles) {
  stages::counts() = {};
  Diagram diagram;
  for (const Circle& c : circles) {
    SiteId id = kNoSite;
    EXPECT_EQ(diagram.insert(c.x, c.y, c.r, id), Error::kNone);
  }
  return stages::counts();
}

Circles make(const char* name, std::size_t n) {
  for (const NamedGenerator& generator : corpus()) {
    Random random(111);
    if (generator.name == name) return generator.make(random, n);
  }
  ADD_FAILURE() << name;
  return {};
}

TEST(StageUse, RandomCirclesNeedNoExactArithmetic) {
  for (const char* name : {"Hidden5Percent", "Hidden20Percent", "Hidden50Percent", "PowerLaw"}) {
    const stages::Counts counts = countsOfBuild(make(name, 2000));
    // One in ten thousand insertions may be close enough to degenerate by chance.
    EXPECT_LE(counts.vertexExact + counts.edgeExact + counts.lorentzExact + counts.distanceExact,
              1u)
        << name;
    EXPECT_EQ(counts.vertexDegenerate, 0u) << name;
  }
}

TEST(StageUse, SmallIntegersAreSettledInDoubles) {
  for (const char* name : {"IntegerLattice", "Grid3Radius0", "Grid4Radius1", "Grid20Radius10",
                           "HorizontalLineEqualSpacing"}) {
    const stages::Counts counts = countsOfBuild(make(name, 400));
    EXPECT_EQ(counts.vertexExact, 0u) << name;
    EXPECT_GT(counts.vertexDegenerate, 0u) << name << ": zeros are known to be zeros";
  }
}

TEST(StageUse, CocircularPointsOfManyDigitsAreSettledByLongIntegers) {
  const stages::Counts counts = countsOfBuild(make("CocircularPoints", 200));
  EXPECT_GT(counts.vertexFixed, 0u);
  EXPECT_EQ(counts.vertexExact, 0u);
  EXPECT_GT(counts.vertexDegenerate, 0u);
}

TEST(StageUse, DecimalLatticeIsNotDegenerateEverywhere) {
  // 0.1 * i is rounded: the in-circle determinant of a cell of the lattice is tiny, mostly not
  // zero, and no double can tell; numbers of twice the digits can.
  const stages::Counts counts = countsOfBuild(make("DecimalLattice", 400));
  EXPECT_GT(counts.vertexTwofold, 10 * (counts.vertexFixed + counts.vertexMiddle));
  EXPECT_EQ(counts.vertexExact, 0u);
  EXPECT_LT(counts.vertexDegenerate, counts.vertexTwofold + counts.vertexFixed +
                                         counts.vertexMiddle + counts.vertexFilter +
                                         counts.vertexOfPoints);
}

/// Numbers from end to end of the range, all digits in use: whatever the exact stage makes of them
/// has room (number/dyadic.h). An integer that had not would end the program.
TEST(StageUse, LongestNumbersFitTheExactStage) {
  Random random(112);
  const auto number = [&] {
    const double digits = 1 - static_cast<double>(random.below(std::uint64_t{1} << 52)) * 0x1p-53;
    const double x = random.below(2) == 0 ? 1e100 * digits : 1e-100 / digits;
    return random.below(2) == 0 ? x : -x;
  };
  for (int run = 0; run < runs(200); ++run) {
    std::array<Site, 5> s;
    for (Site& site : s) site = {number(), number(), number()};
    (void)stages::vertexExact(s[0], &s[1], &s[2], &s[3]);
    (void)stages::isOppositeExact(s[0], &s[1], &s[2], &s[3], stages::FaceCorner::kReference);
    (void)stages::isOppositeExact(s[0], &s[1], nullptr, &s[3], stages::FaceCorner::kK);
    (void)stages::distanceExact(s[0].x, s[0].y, s[1], s[2]);
    for (const stages::RayPart part : {stages::RayPart::kLeftwards, stages::RayPart::kAlong}) {
      (void)stages::rayExact(s[0].x, s[1].y, s[2], &s[3], &s[4], part);
    }
    for (const stages::Probe probe : {stages::Probe::kMiddle, stages::Probe::kOpposite}) {
      (void)stages::edgeExact(s[0], &s[1], &s[2], &s[3], s[4], probe);
      (void)stages::edgeExact(s[0], nullptr, &s[2], &s[3], s[4], probe);
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
