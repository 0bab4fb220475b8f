// Filters where the exact answer changes: for random sites one coordinate is bisected until the
// exact sign differs between two neighbouring doubles. There the value is smaller than its rounding
// errors, so a filter whose bound is too small by much gives itself away within a few tries.
#include <gtest/gtest.h>

#include <cmath>

#include "predicate/circle_fan.h"
#include "predicate/edge_shortcut.h"
#include "predicate/pole.h"
#include "predicate/predicates.h"
#include "predicate/stages.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius {
namespace {

using test::Random;
using test::runs;

/// Calls `ask` with the doubles around a place between `low` and `high` where `sign` changes; false
/// if it is the same at both.
template <class SignAt, class Ask>
bool askAroundChange(double low, double high, SignAt&& sign, Ask&& ask) {
  const auto atLow = sign(low);
  if (atLow == sign(high)) return false;
  for (int step = 0; step < 200; ++step) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high) break;
    (sign(middle) == atLow ? low : high) = middle;
  }
  double below = low, above = low;
  for (int step = 0; step < 4; ++step) {
    ask(below);
    ask(above = std::nextafter(above, HUGE_VAL));
    below = std::nextafter(below, -HUGE_VAL);
  }
  return true;
}

/// Sites of several kinds: ordinary ones, points, ones far from the origin, large discs of which
/// each sticks out of the others by little, and negative weights.
constexpr int kKinds = 5;
Site siteOf(int kind, Random& random) {
  const double x = random.between(-1, 1), y = random.between(-1, 1), r = random.between(0, 0.3);
  switch (kind) {
    case 0:
      return {x, y, r};
    case 1:
      return {x, y, 0};
    case 2:
      return {1000 + x, -3000 + y, r};
    case 3:
      return {x, y, 100 + r};
    default:
      return {x, y, -3 * r};
  }
}

bool coversNot(const Site& a, const Site& b) { return !covers(a, b) && !covers(b, a); }

/// Three sites of a face, the largest first; false if these have none.
bool takeFace(int kind, Random& random, Site& i, Site& j, Site& k) {
  i = siteOf(kind, random), j = siteOf(kind, random), k = siteOf(kind, random);
  if (precedes(i, j)) std::swap(i, j);
  if (precedes(i, k)) std::swap(i, k);
  if (random.oneIn(4))
    k = {j.x + (j.x - i.x) * random.between(0.5, 2), j.y + (j.y - i.y) * random.between(0.5, 2),
         k.r};  // almost in line
  if (precedes(i, k) || !coversNot(i, j) || !coversNot(j, k) || !coversNot(k, i)) return false;
  return hasVoronoiCircle(i, j, k) || (std::swap(j, k), hasVoronoiCircle(i, j, k));
}

void expectSame(MaybeSign filtered, Sign exact, const char* what) {
  if (filtered.known) {
    EXPECT_EQ(filtered.sign, exact) << what;
  }
}

TEST(NearZero, Covering) {
  Random random(131);
  int asked = 0;
  for (int run = 0; run < runs(3000); ++run) {
    Site a = siteOf(run % kKinds, random), b = siteOf(run % kKinds, random);
    a.r += 0.5;
    const double y = b.y;
    asked += askAroundChange(
        a.x, a.x + 2,
        [&](double x) {
          return stages::lorentzExact(a, {x, y, b.r});
        },
        [&](double x) {
          const Site q{x, y, b.r};
          expectSame(stages::lorentzFilter(a, q), stages::lorentzExact(a, q), "filter");
          expectSame(stages::lorentzMiddle(a, q), stages::lorentzExact(a, q), "middle");
        });
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(asked, runs(1000));
}

TEST(NearZero, Distance) {
  Random random(132);
  int asked = 0;
  for (int run = 0; run < runs(5000); ++run) {
    const Site a = siteOf(run % kKinds, random), b = siteOf(run % kKinds, random),
               p = siteOf(run % kKinds, random);
    asked += askAroundChange(
        p.x - 2, p.x + 2, [&](double x) { return stages::distanceExact(x, p.y, a, b); },
        [&](double x) {
          const Sign exact = stages::distanceExact(x, p.y, a, b);
          expectSame(stages::distanceFilter(x, p.y, a, b), exact, "filter");
          expectSame(stages::distanceMiddle(x, p.y, a, b), exact, "middle");
          expectSame(stages::distanceWhole(x, p.y, a, b), exact, "whole");
        });
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(asked, runs(1000));
}

/// The filters of vertex conflicts, the cached circles among them, of faces with and without
/// infinity.
TEST(NearZero, VertexConflict) {
  Random random(133);
  CircleFan fan;
  fan.reserve(2);
  int asked = 0;
  for (int run = 0; run < runs(4000); ++run) {
    const int kind = run % kKinds;
    Site i, j, k;
    if (!takeFace(kind, random, i, j, k)) continue;
    const Corner third = random.oneIn(5) ? nullptr : &k;
    const Site q = siteOf(kind, random);
    const VoronoiCircle circle = voronoiCircle(&i, &j, third);
    VoronoiCircle fans[2];
    fan.setCorner(0, &j);
    fan.setCorner(1, third);
    fan.compute(i, fans);
    asked += askAroundChange(
        q.x - 3, q.x + 3,
        [&](double x) {
          return isVertexInConflict(&i, &j, third, {x, q.y, q.r});
        },
        [&](double x) {
          const Site at{x, q.y, q.r};
          const Sign conflict =
              isVertexInConflict(&i, &j, third, at) ? Sign::kPositive : Sign::kNegative;
          expectSame(circleFilter(circle, at), conflict, "circle");
          expectSame(circleFilter(fans[0], at), conflict, "circle of a fan");
          if (!coversNot(i, at) || !coversNot(j, at) || !coversNot(k, at)) return;
          const Sign exact = stages::vertexExact(i, &j, third, &at);
          expectSame(stages::vertexOfPoints(i, &j, third, &at), exact, "of points");
          expectSame(stages::vertexFilter(i, &j, third, &at), exact, "filter");
          expectSame(stages::vertexMiddle(i, &j, third, &at), exact, "middle");
          expectSame(stages::vertexWhole(i, &j, third, &at), exact, "whole");
        });
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(asked, runs(1000));
}

/// Whether three sites have a circle at all: k is moved until they have none.
TEST(NearZero, Existence) {
  Random random(134);
  int asked = 0;
  for (int run = 0; run < runs(3000); ++run) {
    Site i, j, k;
    if (!takeFace(run % kKinds, random, i, j, k)) continue;
    asked += askAroundChange(
        k.x, k.x + (random.oneIn(2) ? 4 : -4),
        [&](double x) {
          return hasVoronoiCircle(i, j, {x, k.y, k.r});
        },
        [&](double x) {
          const Site at{x, k.y, k.r};
          if (!coversNot(i, at) || !coversNot(j, at)) return;
          const bool exists = hasVoronoiCircle(i, j, at);
          VoronoiCircle circle;
          EXPECT_EQ(findVoronoiCircle(&i, &j, &at, circle), exists);
          EXPECT_TRUE(!findCertainVoronoiCircle(&i, &j, &at, circle) || exists);
          CircleFan fan;
          fan.reserve(1);
          const std::array<Corner, 3> face{&i, &j, &at};
          fan.computeFaces({&face, 1}, {&circle, 1});
          EXPECT_TRUE(!(circle.error < HUGE_VALF) || exists);
        });
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(asked, runs(300));
}

TEST(NearZero, EdgeConflict) {
  Random random(135);
  int asked = 0;
  for (int run = 0; run < runs(20000); ++run) {
    const int kind = run % kKinds;
    Site i, j, k;
    if (!takeFace(kind, random, i, j, k)) continue;
    const Site l = siteOf(kind, random);
    const Corner other = random.oneIn(4) ? nullptr : &j;
    if (other != nullptr &&
        (precedes(i, l) || !coversNot(i, l) || !coversNot(j, l) || !hasVoronoiCircle(i, l, j)))
      continue;
    if (other == nullptr && !coversNot(i, l)) continue;
    if (isVertexInConflict(&i, other, &k, l) || isVertexInConflict(other, &i, &l, k)) continue;
    const VoronoiCircle atK = voronoiCircle(&i, other, &k), atL = voronoiCircle(other, &i, &l);
    Site q = siteOf(kind, random);
    if (random.oneIn(3) && other != nullptr)
      q = {j.x + (q.x - j.x) * 1e-9, j.y + (q.y - j.y) * 1e-9, j.r};
    const stages::Probe probe =
        isVertexInConflict(&i, other, &k, q) ? stages::Probe::kOpposite : stages::Probe::kMiddle;
    const auto isIn = [](Sign sign) { return sign == Sign::kPositive ? sign : Sign::kNegative; };
    const auto exactly = [&](const Site& at) {
      return isIn(stages::edgeExact(i, other, &k, &l, at, probe));
    };
    const auto mayAsk = [&](const Site& at) {
      if (covers(at, i) || (other != nullptr && covers(at, j))) return false;
      const bool conflict = isVertexInConflict(&i, other, &k, at);
      return conflict == isVertexInConflict(other, &i, &l, at) &&
             conflict == (probe == stages::Probe::kOpposite);
    };
    asked += askAroundChange(
        q.x - 3, q.x + 3,
        [&](double x) {
          return exactly({x, q.y, q.r});
        },
        [&](double x) {
          const Site at{x, q.y, q.r};
          if (!mayAsk(at)) return;
          const auto expectSameIn = [&](MaybeSign filtered, const char* what) {
            expectSame({isIn(filtered.sign), filtered.known}, exactly(at), what);
          };
          expectSameIn(stages::edgeCircleFilter(i, other, atK, atL, at, probe), "circles");
          expectSameIn(stages::edgeFilter(i, other, &k, &l, at, probe), "filter");
          expectSameIn(stages::edgeMiddle(i, other, &k, &l, at, probe), "middle");
          expectSameIn(stages::edgeWhole(i, other, &k, &l, at, probe), "whole");
          if (other != nullptr && probe == stages::Probe::kOpposite &&
              isSurelyInConflictBetweenEnds(i, j, atK, atL, at)) {
            EXPECT_TRUE(isEntireEdgeInConflict(EdgeCorners{&i, &j, &k, &l}, at)) << "shortcut";
          }
        });
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(asked, runs(1000));
}

TEST(NearZero, Rays) {
  Random random(136);
  int asked = 0;
  for (int run = 0; run < runs(4000); ++run) {
    const int kind = run % kKinds;
    Site i, j, k;
    if (!takeFace(kind, random, i, j, k)) continue;
    const Corner third = random.oneIn(5) ? nullptr : &k;
    const VoronoiCircle circle = voronoiCircle(&i, &j, third);
    const Site p = siteOf(kind, random);
    for (const stages::RayPart part : {stages::RayPart::kLeftwards, stages::RayPart::kAlong}) {
      asked += askAroundChange(
          p.x - 3, p.x + 3, [&](double x) { return stages::rayExact(x, p.y, i, &j, third, part); },
          [&](double x) {
            const Sign exact = stages::rayExact(x, p.y, i, &j, third, part);
            expectSame(stages::rayFilter(x, p.y, i, &j, third, part), exact, "filter");
            expectSame(stages::rayMiddle(x, p.y, i, &j, third, part), exact, "middle");
            expectSame(stages::rayWhole(x, p.y, i, &j, third, part), exact, "whole");
            (void)bearingOf(x, p.y, circle, i, &j,
                            third);  // the shadow check looks at the cached circle's answer
          });
    }
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(asked, runs(1000));
}

TEST(NearZero, TurnBetweenShadows) {
  Random random(137);
  int asked = 0;
  for (int run = 0; run < runs(6000); ++run) {
    const int kind = run % kKinds;
    Site i = siteOf(kind, random), j = siteOf(kind, random);
    if (precedes(i, j)) std::swap(i, j);
    const Site l = siteOf(kind, random), k = siteOf(kind, random);
    asked += askAroundChange(
        k.x - 3, k.x + 3,
        [&](double x) {
          return stages::shadowTurnExact(i, j, l, {x, k.y, k.r});
        },
        [&](double x) {
          const Site at{x, k.y, k.r};
          expectSame(stages::shadowTurnFilter(i, j, l, at), stages::shadowTurnExact(i, j, l, at),
                     "filter");
        });
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(asked, runs(300));
}

/// The hull's normals: which way they point, and the turn from one to the next.
TEST(NearZero, Hull) {
  Random random(138);
  int asked = 0;
  for (int run = 0; run < runs(3000); ++run) {
    const int kind = run % kKinds;
    const Site i = siteOf(kind, random), l = siteOf(kind, random), k = siteOf(kind, random);
    asked += askAroundChange(
        l.y - 3, l.y + 3,
        [&](double y) {
          return stages::normalIsUpExact(i, {l.x, y, l.r});
        },
        [&](double y) {
          const Site at{l.x, y, l.r};
          if (!coversNot(i, at)) return;
          EXPECT_EQ(pointsUp(i, at, voronoiCircle(&i, &at, nullptr)),
                    stages::normalIsUpExact(i, at));
        });
    if (!coversNot(i, l)) continue;
    asked += askAroundChange(
        k.x - 3, k.x + 3,
        [&](double x) {
          return stages::spanExact(i, l, {x, k.y, k.r});
        },
        [&](double x) {
          const Site at{x, k.y, k.r};
          if (!coversNot(i, at)) return;
          const VoronoiCircle atL = voronoiCircle(&i, &l, nullptr),
                              atK = voronoiCircle(&at, &i, nullptr);
          EXPECT_EQ(turnOfHull(i, l, at, atL, atK), stages::spanExact(i, l, at));
        });
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(asked, runs(1000));
}

}  // namespace
}  // namespace apollonius
