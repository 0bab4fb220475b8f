// Bisectors against their definition: equal distances. Would catch a wrong frame, a wrong sign of
// the branch, a control point or weight that is not the curve's, and loss of digits where circles
// nearly touch from within.
#include "geometry/curve/bisector.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/effort.h"
#include "support/generators.h"

namespace apollonius::test {

using namespace internal;
namespace {

double distanceTo(const Site& s, Point p) { return length(p - Point{s.x, s.y}) - s.r; }

/// Two circles of which neither covers the other; `gap` is how far the smaller one sticks out, in
/// units of its distance.
void randomPair(Random& random, double gap, Site& reference, Site& other) {
  const Direction d = randomDirection(random);
  const double distance = random.between(1, 1000);
  reference = {random.between(-100, 100), random.between(-100, 100), random.between(0, 10)};
  other = {reference.x + distance * d.x, reference.y + distance * d.y, 0};
  other.r = reference.r - distance * (1 - gap);
}

TEST(Bisector, PointsAreEquallyFarFromBothSites) {
  Random random(501);
  for (int run = 0; run < runs(3000); ++run) {
    Site reference, other;
    const double gap = run % 3 == 0   ? 1
                       : run % 3 == 1 ? random.unit()
                                      : 1e-9 * random.unit() + 1e-12;
    randomPair(random, gap, reference, other);
    const Bisector bisector(reference, other);
    ASSERT_TRUE(bisector.isKnown());
    for (const double e : {1e-6, 0.01, 0.5, 1.0, 1.7, 40.0, 1e5}) {
      const Point p = bisector.at(e);
      const double size = length(p) + 2000;
      ASSERT_NEAR(distanceTo(reference, p), distanceTo(other, p), 1e-14 * size)
          << "run " << run << " e " << e;
      // Where the curve is steep, the parameter is as good as the point.
      const Point again = bisector.at(bisector.parameterOf(p));
      ASSERT_LT(length(again - p), 1e-13 * size) << "run " << run << " e " << e << " gap " << gap;
    }
  }
}

TEST(Bisector, PiecesAreExactlyRationalQuadratic) {
  Random random(502);
  for (int run = 0; run < runs(2000); ++run) {
    Site reference, other;
    randomPair(random, run % 2 == 0 ? random.unit() : 1, reference, other);
    const Bisector bisector(reference, other);
    const double e0 = random.between(0.01, 2), e1 = e0 * random.between(1.001, 300);
    const Conic piece = bisector.piece(e0, e1);
    EXPECT_EQ(piece.isStraight(), reference.r == other.r);
    for (double t = 0; t <= 1; t += 0.125) {
      const Point p = piece.at(t);
      const double size = length(p) + 2000;
      ASSERT_NEAR(distanceTo(reference, p), distanceTo(other, p), 1e-12 * size) << "run " << run;
      // Tangents of the piece and of the bisector are parallel, and the same way.
      const Point along = piece.tangent(t), tangent = bisector.tangent(bisector.parameterOf(p));
      if (piece.isStraight() && (t == 0 || t == 1))
        continue;  // a segment of weight 0 has no speed at its ends
      ASSERT_GT(dot(along, tangent), 0.9999 * length(along));
    }
  }
}

TEST(Bisector, AsymptotesAndOrientation) {
  const Bisector bisector({0, 0, 3}, {10, 0, 1});
  for (const bool upper : {false, true}) {
    const Point far = bisector.at(upper ? 1e9 : 1e-9);
    const Point direction = bisector.asymptote(upper);
    EXPECT_NEAR(length(direction), 1, 1e-15);
    EXPECT_NEAR(cross(far, direction) / length(far), 0, 1e-6);
    EXPECT_GT(dot(far, direction), 0);
  }
  // Counter-clockwise about the reference site.
  EXPECT_GT(cross(bisector.at(1), bisector.at(2)), 0);
  // The middle of the gap: 6 from the reference site's centre.
  EXPECT_NEAR(bisector.at(1).x, 6, 1e-15);
}

TEST(Bisector, LinesAreCrossedWhereTheyAre) {
  Random random(503);
  int crossed = 0;
  for (int run = 0; run < runs(20000); ++run) {
    Site reference, other;
    randomPair(random, random.unit(), reference, other);
    const Bisector bisector(reference, other);
    const Direction d = randomDirection(random);
    const Point normal{d.x, d.y};
    const double offset = random.between(-800, 800);
    const LineForm form(bisector, normal, offset);
    const auto value = [&](double e) { return dot(normal, bisector.at(e)) - offset; };
    const double e0 = 0.05, e1 = 20;
    const bool from = value(e0) > 0, to = value(e1) > 0;
    if (from != to) {
      const double e = to ? form.rise(e0, e1) : form.fall(e0, e1);
      ASSERT_NEAR(value(e), 0, 1e-9) << "run " << run;
      ++crossed;
      continue;
    }
    double at = 0;
    const int sign = from ? 1 : -1;
    bool hasOther = false;  // by sampling
    for (double e = e0; e < e1; e *= 1.01) hasOther = hasOther || (value(e) > 0) != from;
    const bool has = form.hasExcursion(sign, e0, e1, at);
    ASSERT_TRUE(has || !hasOther) << "run " << run;
    if (!has) continue;
    ASSERT_LE(sign * value(at), 1e-9);
    const double first = from ? form.fall(e0, at) : form.rise(e0, at),
                 second = from ? form.rise(at, e1) : form.fall(at, e1);
    ASSERT_NEAR(value(first), 0, 1e-8);
    ASSERT_NEAR(value(second), 0, 1e-8);
    ASSERT_LE(first, second);
    ++crossed;
  }
  EXPECT_GT(crossed, runs(20000) / 10);
}

/// A line along an asymptote is crossed at infinity, and rounding may put the crossing beyond: the
/// end there is the answer.
TEST(Bisector, LinesAlongAnAsymptoteAreCrossedAtItsEnd) {
  Random random(504);
  const double infinity = std::numeric_limits<double>::infinity();
  for (int run = 0; run < runs(2000); ++run) {
    Site reference, other;
    randomPair(random, random.unit(), reference, other);
    const Bisector bisector(reference, other);
    for (const bool upper : {false, true}) {
      const Point direction = bisector.asymptote(upper);
      const Point normal{-direction.y, direction.x};
      const double offset = dot(normal, bisector.reference()) - 1e4;
      const LineForm form(bisector, normal, offset);
      if (upper) {
        EXPECT_GT(form.fall(0, infinity), 1e10) << "run " << run;
      } else {
        EXPECT_LT(form.rise(0, infinity), 1e-10) << "run " << run;
      }
      const LineForm opposite(bisector, Point{-normal.x, -normal.y}, -offset);
      if (upper) {
        EXPECT_GT(opposite.rise(0, infinity), 1e10) << "run " << run;
      } else {
        EXPECT_LT(opposite.fall(0, infinity), 1e-10) << "run " << run;
      }
    }
  }
}

}  // namespace
}  // namespace apollonius::test
