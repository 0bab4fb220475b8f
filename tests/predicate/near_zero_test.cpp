// Filters where the exact answer changes: for random sites one coordinate is bisected until the
// exact sign differs between two neighbouring doubles. There the value is smaller than its rounding
// errors, so a filter whose bound is too small by much gives itself away within a few tries.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "apollonius/types.h"
#include "predicate/circle_fan.h"
#include "predicate/compute_circle.h"
#include "predicate/predicates.h"
#include "predicate/reference_site.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;
using test::runs;
using test::sized;

/// Calls `ask` with the doubles around a place between `low` and `high` where `sign` changes; false
/// if it is the same at both.
template <class SignAt, class Ask>
bool askAroundChange(double low, double high, SignAt&& sign, Ask&& ask) {
  const auto atLow = sign(low);
  if (atLow == sign(high)) return false;
  for (int step = 0; step < 200; ++step) {
    const double middle = low + (high - low) / 2;
    if (middle == low || middle == high || !isInRange(middle)) break;
    (sign(middle) == atLow ? low : high) = middle;
  }
  double below = low, above = low;
  for (int step = 0; step < 4; ++step) {
    if (isInRange(below)) ask(below);
    above = std::nextafter(above, HUGE_VAL);
    if (isInRange(above)) ask(above);
    below = std::nextafter(below, -HUGE_VAL);
  }
  return true;
}

/// Sites of several kinds, ordinary ones and those that make something cancel, underflow or
/// overflow.
enum Kind {
  kOrdinary,
  kPoints,
  kFarFromTheOrigin,
  kLargeDiscs,      // each sticks out of the others by little
  kNegative,        // weights
  kTouchingWithin,  // a disc and others within it that seem to touch it
  kGiant,           // and small ones at its rim
  kOfAnySize,
  kCluster,  // so close together that products of differences underflow
  kKinds
};

struct Family {
  Kind kind;
  double size;  // magnitude of differences

  Family(int run, Random& random) : kind(static_cast<Kind>(run % kKinds)), size(1) {
    if (kind == kGiant) size = 1e-3;
    if (kind == kOfAnySize) size = powerOfTwo(static_cast<int>(random.integer(-120, 160)));
  }

  Site site(Random& random) const {
    const double x = size * random.between(-1, 1), y = size * random.between(-1, 1);
    const double r = size * random.between(0, 0.3);
    switch (kind) {
      case kPoints:
        return {x, y, 0};
      case kFarFromTheOrigin:
        return {1000 + x, -3000 + y, r};
      case kLargeDiscs:
        return {x, y, 100 + r};
      case kNegative:
        return {x, y, -3 * r};
      case kTouchingWithin: {
        if (random.oneIn(3)) return {0.1, 0.2, 1};
        const double t = 3 * x, cosine = (1 - t * t) / (1 + t * t), sine = 2 * t / (1 + t * t);
        return {0.1 + (1 - r) * cosine, 0.2 + (1 - r) * sine, r};
      }
      case kCluster: {
        const double scale = random.oneIn(3) ? 1 : 0x1p-100;
        return {scale * x, scale * y, random.oneIn(2) ? 0 : scale * r};
      }
      case kGiant:
        return random.oneIn(3) ? Site{1000.3, 0.1, 1000.3} : Site{x, y, r};
      default:
        return {x, y, r};
    }
  }
};

bool coversNot(const Site& a, const Site& b) { return !covers(a, b) && !covers(b, a); }

/// Three sites of a face, the largest first; false if these have none. Now and then they are almost
/// in line, as a common tangent has it.
bool takeFace(const Family& family, Random& random, Site& i, Site& j, Site& k) {
  i = family.site(random), j = family.site(random), k = family.site(random);
  if (random.oneIn(3)) {
    const double t = random.between(0.5, 2),
                 bend = powerOfTwo(-static_cast<int>(random.integer(0, 45)));
    const double dx = j.x - i.x, dy = j.y - i.y;
    k = {j.x + t * dx - bend * dy, j.y + t * dy + bend * dx, j.r + t * (j.r - i.r)};
  }
  if (precedes(i, j)) std::swap(i, j);
  if (precedes(i, k)) std::swap(i, k);
  if (!coversNot(i, j) || !coversNot(j, k) || !coversNot(k, i)) return false;
  return hasVoronoiCircle(i, j, k) || (std::swap(j, k), hasVoronoiCircle(i, j, k));
}

/// The cached circle of a face as different operations leave it: seen from its largest site, or
/// from another, which came last.
VoronoiCircle someCircle(Corner i, Corner j, Corner k, Random& random) {
  const std::uint64_t way = random.below(4u);
  if (way == 0) return voronoiCircle(i, j, k);
  for (std::uint64_t turn = 0; turn < way || i == nullptr; ++turn) std::swap(i, j), std::swap(j, k);
  if (j != nullptr && k != nullptr && random.oneIn(2)) {
    const std::array<Corner, 3> face{i, j, k};
    VoronoiCircle circle;
    CircleFan::computeFaces({&face, 1}, {&circle, 1});
    return circle;
  }
  CircleFan fan;
  fan.reserve(2);
  fan.setCorner(0, j);
  fan.setCorner(1, k);
  VoronoiCircle circles[2];
  fan.compute(*i, circles);
  return circles[0];
}

void expectSame(MaybeSign filtered, Sign exact, const char* what) {
  if (filtered.known) {
    EXPECT_EQ(filtered.sign, exact) << what;
  }
}

/// Calls `ask(family, random, asked)` for `times` families in turn. Each call adds the number of
/// its questions to `asked`. Returns the total.
template <class Ask>
int askFamilies(std::uint64_t seed, int times, Ask&& ask) {
  Random random(seed);
  int asked = 0;
  for (int run = 0; run < runs(sized(times / 2, times)) && !::testing::Test::HasFailure(); ++run) {
    SCOPED_TRACE("run " + std::to_string(run));
    ask(Family(run, random), random, asked);
  }
  return asked;
}

TEST(NearZero, Covering) {
  const int all = askFamilies(131, 3000, [](const Family& family, Random& random, int& asked) {
    Site a = family.site(random), b = family.site(random);
    a.r += family.size / 2;
    const double y = b.y;
    asked += askAroundChange(
        a.x, a.x + 2 * family.size, [&](double x) { return stages::lorentzExact(a, {x, y, b.r}); },
        [&](double x) {
          const Site q{x, y, b.r};
          expectSame(stages::lorentzFilter(a, q), stages::lorentzExact(a, q), "filter");
          expectSame(stages::lorentzMiddle(a, q), stages::lorentzExact(a, q), "middle");
        });
  });
  EXPECT_GT(all, runs(sized(500, 1000)));
}

TEST(NearZero, Distance) {
  const int all = askFamilies(132, 5000, [](const Family& family, Random& random, int& asked) {
    const Site a = family.site(random), b = family.site(random), p = family.site(random);
    asked += askAroundChange(
        p.x - 2 * family.size, p.x + 2 * family.size,
        [&](double x) { return stages::distanceExact(x, p.y, a, b); },
        [&](double x) {
          const Sign exact = stages::distanceExact(x, p.y, a, b);
          expectSame(stages::distanceFilter(x, p.y, a, b), exact, "filter");
          expectSame(stages::distanceMiddle(x, p.y, a, b), exact, "middle");
          expectSame(stages::distanceFixed(x, p.y, a, b), exact, "fixed");
        });
  });
  EXPECT_GT(all, runs(sized(500, 1000)));
}

/// The filters of vertex conflicts, the cached circles among them, of faces with and without
/// infinity.
TEST(NearZero, VertexConflict) {
  const int all = askFamilies(133, 4000, [](const Family& family, Random& random, int& asked) {
    Site i, j, k;
    if (!takeFace(family, random, i, j, k)) return;
    const Corner third = random.oneIn(5) ? nullptr : &k;
    const Site q = family.site(random);
    const VoronoiCircle circle = someCircle(&i, &j, third, random);
    asked += askAroundChange(
        q.x - 3 * family.size, q.x + 3 * family.size,
        [&](double x) { return isVertexInConflict(&i, &j, third, {x, q.y, q.r}); },
        [&](double x) {
          const Site at{x, q.y, q.r};
          const Sign conflict =
              isVertexInConflict(&i, &j, third, at) ? Sign::kPositive : Sign::kNegative;
          expectSame(circleFilter(circle, at), conflict, "circle");
          if (!coversNot(i, at) || !coversNot(j, at) || !coversNot(k, at)) return;
          const Sign exact = stages::vertexExact(i, &j, third, &at);
          expectSame(stages::vertexOfPoints(i, &j, third, &at), exact, "of points");
          expectSame(stages::vertexTwofold(i, &j, third, &at), exact, "twofold");
          expectSame(stages::vertexFilter(i, &j, third, &at), exact, "filter");
          expectSame(stages::vertexMiddle(i, &j, third, &at), exact, "middle");
          expectSame(stages::vertexFixed(i, &j, third, &at), exact, "fixed");
        });
  });
  EXPECT_GT(all, runs(sized(500, 1000)));
}

/// Whether three sites have a circle at all: k is moved until they have none.
TEST(NearZero, Existence) {
  const int all = askFamilies(134, 3000, [](const Family& family, Random& random, int& asked) {
    Site i, j, k;
    if (!takeFace(family, random, i, j, k)) return;
    asked += askAroundChange(
        k.x, k.x + family.size * (random.oneIn(2) ? 4 : -4),
        [&](double x) { return hasVoronoiCircle(i, j, {x, k.y, k.r}); },
        [&](double x) {
          const Site at{x, k.y, k.r};
          if (!coversNot(i, at) || !coversNot(j, at)) return;
          const bool exists = hasVoronoiCircle(i, j, at);
          VoronoiCircle circle;
          EXPECT_EQ(findVoronoiCircle(&i, &j, &at, circle), exists);
          EXPECT_TRUE(!findCertainVoronoiCircle(&i, &j, &at, circle) || exists);
          const std::array<Corner, 3> face{&i, &j, &at};
          CircleFan::computeFaces({&face, 1}, {&circle, 1});
          EXPECT_TRUE(!(circle.error < HUGE_VALF) || exists);
        });
  });
  EXPECT_GT(all, runs(300));
}

TEST(NearZero, EdgeConflict) {
  const int all = askFamilies(135, 24000, [](const Family& family, Random& random, int& asked) {
    Site i, j, k;
    if (!takeFace(family, random, i, j, k)) return;
    const Site l = family.site(random);
    const Corner other = random.oneIn(4) ? nullptr : &j;
    if (other != nullptr &&
        (precedes(i, l) || !coversNot(i, l) || !coversNot(j, l) || !hasVoronoiCircle(i, l, j)))
      return;
    if (other == nullptr && !coversNot(i, l)) return;
    const EdgeCorners edge{&i, other, &k, &l};
    if (isVertexInConflict(&i, other, &k, l) || isVertexInConflict(other, &i, &l, k)) return;
    if (!isDelaunayEdge(edge, voronoiCircle(&i, other, &k), voronoiCircle(other, &i, &l))) return;
    const VoronoiCircle atK = someCircle(&i, other, &k, random),
                        atL = someCircle(other, &i, &l, random);
    Site q = family.site(random);
    if (random.oneIn(3) && other != nullptr)
      q = {j.x + (q.x - j.x) * 1e-9, j.y + (q.y - j.y) * 1e-9, j.r};
    const auto probeOf = [&](const Site& at) {
      return isVertexInConflict(&i, other, &k, at) ? stages::Probe::kOpposite
                                                   : stages::Probe::kMiddle;
    };
    stages::Probe probe = probeOf(q);
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
    const auto expectRight = [&](const Site& at) {
      if (!mayAsk(at)) return;
      const auto expectSameIn = [&](MaybeSign filtered, const char* what) {
        expectSame({isIn(filtered.sign), filtered.known}, exactly(at), what);
      };
      expectSameIn(stages::edgeCircleFilter(i, other, atK, atL, at, probe), "circles");
      expectSameIn(stages::edgeFilter(i, other, &k, &l, at, probe), "filter");
      expectSameIn(stages::edgeMiddle(i, other, &k, &l, at, probe), "middle");
      expectSameIn(stages::edgeFixed(i, other, &k, &l, at, probe), "fixed");
      if (other != nullptr && probe == stages::Probe::kOpposite &&
          isSurelyInConflictBetweenEnds(i, j, atK, atL, at)) {
        EXPECT_TRUE(isEntireEdgeInConflict(edge, at)) << "shortcut";
      }
    };
    asked += askAroundChange(
        q.x - 3 * family.size, q.x + 3 * family.size,
        [&](double x) { return exactly({x, q.y, q.r}); },
        [&](double x) { expectRight({x, q.y, q.r}); });
    // Next to one of the edge's own sites, where nothing but rounding is left of a shadow.
    for (int step = 0; step < 4; ++step) {
      const Site& at = random.oneIn(2) ? j : i;
      const auto aside = [&](double x) {
        for (std::uint64_t ulps = random.below(4u); ulps > 0; --ulps) x = std::nextafter(x, 1e300);
        return x;
      };
      const double r = random.oneIn(2) ? at.r : aside(at.r);
      if (!isInRange(r)) continue;
      const Site close{aside(at.x), -aside(-at.y), r};
      probe = probeOf(close);
      expectRight(close);
    }
  });
  EXPECT_GT(all, runs(sized(500, 1000)));
}

TEST(NearZero, Rays) {
  const int all = askFamilies(136, 4000, [](const Family& family, Random& random, int& asked) {
    Site i, j, k;
    if (!takeFace(family, random, i, j, k)) return;
    const Corner third = random.oneIn(5) ? nullptr : &k;
    const VoronoiCircle circle = someCircle(&i, &j, third, random);
    const Site p = family.site(random);
    for (const stages::RayPart part : {stages::RayPart::kLeftwards, stages::RayPart::kAlong}) {
      asked += askAroundChange(
          p.x - 3 * family.size, p.x + 3 * family.size,
          [&](double x) { return stages::rayExact(x, p.y, i, &j, third, part); },
          [&](double x) {
            const Sign exact = stages::rayExact(x, p.y, i, &j, third, part);
            expectSame(stages::rayFilter(x, p.y, i, &j, third, part), exact, "filter");
            expectSame(stages::rayMiddle(x, p.y, i, &j, third, part), exact, "middle");
            expectSame(stages::rayFixed(x, p.y, i, &j, third, part), exact, "fixed");
            (void)bearingOf(x, p.y, circle, i, &j,
                            third);  // the shadow check looks at the cached circle's answer
          });
    }
  });
  EXPECT_GT(all, runs(sized(500, 1000)));
}

TEST(NearZero, TurnBetweenShadows) {
  const int all = askFamilies(137, 6000, [](const Family& family, Random& random, int& asked) {
    Site i = family.site(random), j = family.site(random);
    if (precedes(i, j)) std::swap(i, j);
    const Site l = family.site(random), k = family.site(random);
    asked += askAroundChange(
        k.x - 3 * family.size, k.x + 3 * family.size,
        [&](double x) { return stages::shadowTurnExact(i, j, l, {x, k.y, k.r}); },
        [&](double x) {
          const Site at{x, k.y, k.r};
          expectSame(stages::shadowTurnFilter(i, j, l, at), stages::shadowTurnExact(i, j, l, at),
                     "filter");
        });
  });
  EXPECT_GT(all, runs(300));
}

/// Points in line, two of them neighbouring doubles: the degenerate rule asks which of them is
/// between.
TEST(NearZero, OppositeOnALine) {
  Random random(139);
  for (int run = 0; run < runs(2000); ++run) {
    const Site i{random.between(1, 3), 0, 0}, j{random.between(-1, 1), 0, 0};
    Site q = run % 2 == 0 ? j : i;
    for (std::uint64_t ulps = 1 + random.below(3u); ulps > 0; --ulps) {
      q.x = std::nextafter(q.x, run % 4 < 2 ? -9.0 : 0.5);
    }
    ASSERT_EQ(stages::vertexExact(i, &j, nullptr, &q), Sign::kZero);
    EXPECT_EQ(stages::vertexDegenerate(i, &j, nullptr, &q),
              stages::isOppositeExact(i, &j, nullptr, &q, stages::FaceCorner::kK))
        << "run " << run;
    EXPECT_EQ(stages::vertexDegenerate(i, nullptr, &j, &q),
              stages::isOppositeExact(i, nullptr, &j, &q, stages::FaceCorner::kJ))
        << "run " << run;
  }
}

/// The hull's normals: which way they point, and the turn from one to the next.
TEST(NearZero, Hull) {
  const int all = askFamilies(138, 3000, [](const Family& family, Random& random, int& asked) {
    const Site i = family.site(random), l = family.site(random), k = family.site(random);
    asked += askAroundChange(
        l.y - 3 * family.size, l.y + 3 * family.size,
        [&](double y) { return stages::normalIsUpExact(i, {l.x, y, l.r}); },
        [&](double y) {
          const Site at{l.x, y, l.r};
          if (!coversNot(i, at)) return;
          EXPECT_EQ(pointsUp(i, at, voronoiCircle(&i, &at, nullptr)),
                    stages::normalIsUpExact(i, at));
        });
    if (!coversNot(i, l)) return;
    asked += askAroundChange(
        k.x - 3 * family.size, k.x + 3 * family.size,
        [&](double x) { return stages::spanExact(i, l, {x, k.y, k.r}); },
        [&](double x) {
          const Site at{x, k.y, k.r};
          if (!coversNot(i, at)) return;
          const VoronoiCircle atL = voronoiCircle(&i, &l, nullptr),
                              atK = voronoiCircle(&at, &i, nullptr);
          EXPECT_EQ(turnOfHull(i, l, at, atL, atK), stages::spanExact(i, l, at));
        });
  });
  EXPECT_GT(all, runs(sized(500, 1000)));
}

}  // namespace
}  // namespace apollonius::internal
