// The circle of a face is computed in two ways, alone and two at a time, by the same formulas with
// the same bound (circle_fan.cpp): each shows errors of the other.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "predicate/circle_fan.h"
#include "predicate/compute_circle.h"
#include "predicate/predicates.h"
#include "predicate/reference_site.h"
#include "support/effort.h"
#include "support/oracle.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;

struct Twins {
  VoronoiCircle alone, fromFan;
  bool isCertain = false;  // alone
  [[nodiscard]] bool isCertainOfFan() const {
    return fromFan.error < std::numeric_limits<float>::infinity();
  }

  Twins(Corner i, Corner j, Corner k) {
    rotateToReference(i, j, k);
    isCertain = findCertainVoronoiCircle(i, j, k, alone);
    const std::array<Corner, 3> face{i, j, k};
    CircleFan::computeFaces({&face, 1}, {&fromFan, 1});
  }
};

Site randomSite(Random& random, double size) {
  return {size * random.between(-1, 1), size * random.between(-1, 1),
          size * random.between(0, random.oneIn(3) ? 0 : 0.3)};
}

bool areVisible(const Site& i, const Site& j, const Site& k) {
  const auto overlapAtMost = [](const Site& a, const Site& b) {
    return !covers(a, b) && !covers(b, a);
  };
  return overlapAtMost(i, j) && overlapAtMost(j, k) && overlapAtMost(k, i);
}

/// Ordinary faces, flat ones, and some with a site next to another one or next to its rim: from
/// where nothing is lost to where nothing is certain.
void takeFace(int run, Random& random, Site& i, Site& j, Site& k) {
  i = randomSite(random, 1), j = randomSite(random, 1), k = randomSite(random, 1);
  const double bend = powerOfTwo(-static_cast<int>(random.integer(0, 50)));
  if (run % 4 == 1) {
    const double dx = j.x - i.x, dy = j.y - i.y, t = random.between(0.5, 2);
    k = {j.x + t * dx - bend * dy, j.y + t * dy + bend * dx, j.r + t * (j.r - i.r)};
  }
  if (run % 4 == 2) k = {j.x + bend * k.x, j.y + bend * k.y, j.r + bend * k.r};
  if (run % 4 == 3) {  // almost covered
    const double t = random.between(-2, 2), way = 0.5 + bend;
    i.r = k.r + 0.5;
    k = {i.x + way * (1 - t * t) / (1 + t * t), i.y + way * 2 * t / (1 + t * t), k.r};
  }
}

TEST(CircleTwins, HaveTheSameBound) {
  Random random(161);
  int certain = 0;
  for (int run = 0; run < test::runs(20000); ++run) {
    Site i, j, k;
    takeFace(run, random, i, j, k);
    if (!areVisible(i, j, k)) continue;
    if (!hasVoronoiCircle(i, j, k)) std::swap(j, k);
    if (!hasVoronoiCircle(i, j, k)) continue;
    const Twins twins(&i, &j, &k);
    if (!twins.isCertain || !twins.isCertainOfFan()) continue;
    ++certain;
    // The fan's quotient has five roundings more, of x, of y and of s.
    Corner a = &i, b = &j, c = &k;
    rotateToReference(a, b, c);
    const double rho = twins.alone.s + a->r;
    const double more = 15 * kUnitRoundoff * rho * (1 + powerOfTwo(-5));
    const double bound = double{twins.alone.error} + more;
    ASSERT_NEAR(twins.fromFan.error / bound, 1, 0x1p-9)
        << "run " << run << ", alone " << twins.alone.error << ", more " << more;
  }
  EXPECT_GT(certain, test::runs(5000));
}

/// Both cease to be certain at the same limits, except for numbers next to a limit.
TEST(CircleTwins, AreCertainOfTheSame) {
  Random random(162);
  int certain = 0, uncertain = 0, different = 0;
  for (int run = 0; run < test::runs(30000); ++run) {
    Site i, j, k;
    takeFace(run, random, i, j, k);
    if (!areVisible(i, j, k)) continue;
    const Twins twins(&i, &j, &k);
    certain += twins.isCertain;
    uncertain += !twins.isCertain;
    different += twins.isCertain != twins.isCertainOfFan();
  }
  EXPECT_GT(certain, test::runs(3000));
  EXPECT_GT(uncertain, test::runs(3000));
  // Where a number is next to a limit of the conditions.
  EXPECT_LE(different, test::runs(30000) / 2000);
}

/// Chords shorter than the formulas are made for: two sites at the distance of their last places.
TEST(CircleTwins, AreUncertainWhereChordsUnderflow) {
  Random random(163);
  for (int run = 0; run < test::runs(500); ++run) {
    const double size = powerOfTwo(-static_cast<int>(random.integer(204, 216)));
    const Site i{0, 0, 0}, j{random.between(0.5, 1), random.between(-1, 1), -0.2},
        k{size * random.between(-1, 1), size * random.between(0.5, 1), 0};
    const Twins twins(&i, &j, &k), swapped(&i, &k, &j);
    EXPECT_FALSE(twins.isCertain);
    EXPECT_FALSE(twins.isCertainOfFan());
    EXPECT_FALSE(swapped.isCertain);
    EXPECT_FALSE(swapped.isCertainOfFan());
  }
}

/// Beyond some distance powers of differences are too large for the fan, which must not take what
/// is left of them for numbers.
TEST(CircleTwins, AreTheSameOrUnknownHoweverFarApart) {
  Random random(165);
  CircleFan fan;
  fan.reserve(2);
  for (int exponent = 0; exponent <= 328; ++exponent) {
    const double size = powerOfTwo(exponent);
    Site i = randomSite(random, size), j = randomSite(random, size), k = randomSite(random, size);
    if (!areVisible(i, j, k)) continue;
    if (!hasVoronoiCircle(i, j, k)) std::swap(j, k);
    if (!hasVoronoiCircle(i, j, k)) continue;
    fan.setCorner(0, &j);
    fan.setCorner(1, &k);
    VoronoiCircle around[2];
    fan.compute(i, around);
    const Twins twins(&i, &j, &k);
    for (const VoronoiCircle& circle : {twins.fromFan, around[0]}) {
      if (!(circle.error < std::numeric_limits<float>::infinity())) continue;
      const double bound = double{circle.error} + double{twins.alone.error};
      EXPECT_LE(absolute(circle.x - twins.alone.x), bound) << exponent;
      EXPECT_LE(absolute(circle.y - twins.alone.y), bound) << exponent;
      EXPECT_LE(absolute(circle.s - twins.alone.s), bound) << exponent;
    }
  }
}

/// A site next to where two circles cross seems to be covered by both of them, by rounding.
TEST(CircleTwins, AreUncertainOfSitesThatSeemToBeCovered) {
  Random random(164);
  int seeming = 0;
  for (int run = 0; run < test::runs(1500); ++run) {
    const Site i{random.between(0, 1), random.between(0, 1), random.between(2, 3)},
        j{i.x + random.between(1, 2), i.y + random.between(-1, 1), random.between(1.5, 2.5)};
    // Where their circles cross.
    const double dx = j.x - i.x, dy = j.y - i.y, d2 = dx * dx + dy * dy;
    const double along = (d2 + i.r * i.r - j.r * j.r) / (2 * d2),
                 across = std::sqrt(std::max(0.0, i.r * i.r / d2 - along * along));
    const double side = random.oneIn(2) ? across : -across;
    Site k{i.x + along * dx - side * dy, i.y + along * dy + side * dx, 0};
    for (int step = 0; step < 40; ++step) {
      const auto p = [](const Site& a, const Site& b) {
        const double x = b.x - a.x, y = b.y - a.y, r = b.r - a.r;
        return x * x + y * y - r * r;
      };
      if (areVisible(i, j, k) && p(i, k) <= 0 && p(j, k) <= 0) {
        ++seeming;
        for (const Twins& twins : {Twins(&i, &j, &k), Twins(&i, &k, &j)}) {
          EXPECT_FALSE(twins.isCertain) << "run " << run;
          EXPECT_FALSE(twins.isCertainOfFan()) << "run " << run;
        }
      }
      k.x = std::nextafter(k.x, random.oneIn(2) ? 9.0 : -9.0);
      k.y = std::nextafter(k.y, random.oneIn(2) ? 9.0 : -9.0);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(seeming, test::runs(20));
}

}  // namespace
}  // namespace apollonius::internal
