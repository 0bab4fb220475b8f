// covers() and the order of sites: laws on all circles of a small grid, and against the oracle
// everywhere.
#include "predicate/covers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "predicate/samples.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::internal {
namespace {

using namespace test;

std::vector<Circle> gridOfCircles() {
  std::vector<Circle> all;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 4; ++y) {
      for (int r = -1; r < 4; ++r) all.push_back({x * 1.0, y * 1.0, r * 1.0});
    }
  }
  return all;
}

TEST(Covers, AgreesWithTheOracleOnAGrid) {
  for (const Circle& a : gridOfCircles()) {
    for (const Circle& b : gridOfCircles()) {
      ASSERT_EQ(covers(toSite(a), toSite(b)), oracleCovers(a, b)) << toText(insertAll({a, b}));
    }
  }
}

TEST(Covers, Laws) {
  const std::vector<Circle> all = gridOfCircles();
  for (const Circle& a : all) {
    ASSERT_TRUE(covers(toSite(a), toSite(a))) << "reflexive";
    for (const Circle& b : all) {
      if (!covers(toSite(a), toSite(b))) continue;
      const bool identical = a.x == b.x && a.y == b.y && a.r == b.r;
      ASSERT_EQ(covers(toSite(b), toSite(a)), identical) << "both ways only for identical sites";
      ASSERT_FALSE(precedes(toSite(a), toSite(b))) << "what covers is larger";
      for (const Circle& c : all) {
        if (covers(toSite(b), toSite(c))) {
          ASSERT_TRUE(covers(toSite(a), toSite(c))) << "transitive";
        }
      }
    }
  }
}

TEST(Covers, AgreesWithTheOracleOnEveryGenerator) {
  for (const NamedGenerator& generator : corpus()) {
    Random random(61);
    const Circles circles = generator.make(random, static_cast<std::size_t>(runs(40)));
    for (const Circle& a : circles) {
      for (const Circle& b : circles) {
        ASSERT_EQ(covers(toSite(a), toSite(b)), oracleCovers(a, b)) << generator.name << "\n"
                                                                    << toText(insertAll({a, b}));
        for (const MaybeSign early : {stages::lorentzFilter(toSite(a), toSite(b)),
                                      stages::lorentzMiddle(toSite(a), toSite(b))}) {
          if (early.known) {
            ASSERT_EQ(early.sign, stages::lorentzExact(toSite(a), toSite(b))) << generator.name;
          }
        }
      }
    }
  }
}

TEST(Covers, InternalTangencyByOneUlp) {
  const Site outer{0, 0, 5};
  EXPECT_TRUE(covers(outer, {3, 0, 2}));
  EXPECT_FALSE(covers(outer, {3, 0, std::nextafter(2, 3)}));
  EXPECT_FALSE(covers(outer, {std::nextafter(3.0, 4), 0, 2}));
  EXPECT_TRUE(covers(outer, {std::nextafter(3.0, 2), 0, 2}));
}

TEST(Precedes, IsAStrictTotalOrderByWeightThenXThenY) {
  const std::vector<Circle> all = gridOfCircles();
  for (const Circle& a : all) {
    for (const Circle& b : all) {
      ASSERT_EQ(precedes(toSite(a), toSite(b)), oracleSmaller(a, b));
      const bool identical = a.x == b.x && a.y == b.y && a.r == b.r;
      ASSERT_EQ(precedes(toSite(a), toSite(b)) + precedes(toSite(b), toSite(a)), identical ? 0 : 1);
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
