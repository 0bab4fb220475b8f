// The generators keep their promises: shares of hidden circles, exact tangencies, values within the
// legal range.
#include "support/generators.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/corpus.h"
#include "support/oracle.h"
#include "support/oracle_numbers.h"

namespace apollonius::test {
namespace {

std::size_t hiddenCount(const Circles& circles) {
  std::size_t hidden = 0;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    for (std::size_t other = 0; other < circles.size(); ++other) {
      if (other == k || circles[other].r < circles[k].r ||
          !oracleCovers(circles[other], circles[k]))
        continue;
      ++hidden;
      break;
    }
  }
  return hidden;
}

TEST(Generators, SharesOfHiddenCircles) {
  struct Share {
    Hidden hidden;
    double expected;
  };
  Random random(331);
  for (const auto& [hidden, expected] :
       {Share{Hidden::kNone, 0}, Share{Hidden::k5Percent, 0.05}, Share{Hidden::k20Percent, 0.2},
        Share{Hidden::k50Percent, 0.5}, Share{Hidden::k95Percent, 0.95}}) {
    const Circles circles = randomCircles(random, 1000, hidden);
    EXPECT_NEAR(static_cast<double>(hiddenCount(circles)) / 1000, expected, 0.04);
  }
}

TEST(Generators, StayWithinTheLegalRange) {
  for (const NamedGenerator& generator : corpus()) {
    Random random(332);
    const Circles circles = generator.make(random, 200);
    EXPECT_GE(circles.size(), 100u) << generator.name;
    for (const Circle& c : circles) {
      for (const double value : {c.x, c.y, c.r}) {
        const double magnitude = std::abs(value);
        ASSERT_TRUE(magnitude == 0 ||
                    (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude))
            << generator.name << " " << value;
      }
    }
  }
}

/// Pairs for which (xa-xb)^2 + (ya-yb)^2 = (ra +- rb)^2 exactly, integers assumed.
std::size_t tangentPairs(const Circles& circles, int sign) {
  std::size_t count = 0;
  for (std::size_t a = 0; a < circles.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      const Integer dx = static_cast<long long>(circles[a].x - circles[b].x),
                    dy = static_cast<long long>(circles[a].y - circles[b].y);
      const Integer radii = static_cast<long long>(circles[a].r + sign * circles[b].r);
      count += dx * dx + dy * dy == radii * radii && (dx != 0 || dy != 0);
    }
  }
  return count;
}

TEST(Generators, TangenciesAreExact) {
  Random random(333);
  EXPECT_GE(tangentPairs(tangentOutside(random, 50), 1), 40u);
  EXPECT_GE(tangentPairs(tangentInside(random, 50), -1), 40u);
  const Circles giant = giantDiskExact(random, 90);
  EXPECT_GE(tangentPairs(giant, 1), 10u);
  EXPECT_GE(tangentPairs(giant, -1), 10u);
}

TEST(Generators, CommonTangentCirclesTouchOneCircle) {
  Random random(334);
  for (const Circle& c : commonTangent(random, 100, 20)) {
    // Distance 20 from the origin.
    EXPECT_EQ(c.x * c.x + c.y * c.y, (c.r + 20) * (c.r + 20));
  }
  for (const Circle& c : cocircularPoints(random, 324))
    EXPECT_EQ(c.x * c.x + c.y * c.y, 32045.0 * 32045.0);
  EXPECT_EQ(cocircularPoints(random, 1000).size(), 324u);
}

}  // namespace
}  // namespace apollonius::test
