// The circles around a new site, computed together: within their stated bounds of the exact ones,
// whichever of the three sites is the new one, and the half-planes of the same faces as
// voronoiCircle's.
#include "predicate/circle_fan.h"

#include <gtest/gtest.h>

#include "predicate/compute_circle.h"
#include "predicate/predicates.h"
#include "predicate/samples.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::internal {
namespace {

using namespace test;

class CircleFanOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(CircleFanOn, IsWithinItsErrorBound) {
  Random random(103);
  CircleFan fan;
  const int count = runs(GetParam().large ? 1000 : 60);
  for (int run = 0; run < count; ++run) {
    const Circles c = visibleOnly(GetParam().make(random, 3));
    if (c.size() < 3 || oracleCircle(c, 0, 1, 2, kInfinity) == CircleAnswer::kNoCircle) continue;
    const std::vector<Site> s = toSites(c);
    const auto expectWithinBound = [&](const VoronoiCircle& circle, std::size_t reference) {
      if (!(circle.error < 1e300)) return;
      ASSERT_TRUE(
          oracleCircleIsWithin(c[0], c[1], c[2], {circle.x, circle.y, circle.s}, circle.error))
          << "run " << run << ", site " << reference << ", centre " << circle.x << " " << circle.y
          << ", error " << circle.error << "\n"
          << toText(insertAll(c));
    };
    const std::array<Corner, 3> faces[] = {
        {&s[0], &s[1], &s[2]}, {&s[1], &s[2], &s[0]}, {&s[2], &s[0], &s[1]}};
    VoronoiCircle separate[3];
    CircleFan::computeFaces(faces, separate);
    for (std::size_t q = 0; q < 3; ++q) expectWithinBound(separate[q], q);
    for (std::size_t q = 0; q < 3; ++q) {
      const Site &j = s[(q + 1) % 3], &k = s[(q + 2) % 3];
      VoronoiCircle circles[2];  // the second face need not have a circle
      fan.reserve(2);
      fan.setCorner(0, &j);
      fan.setCorner(1, &k);
      fan.compute(s[q], circles);
      const VoronoiCircle& circle = circles[0];
      ASSERT_FALSE(circle.isHalfPlane()) << toText(insertAll(c));
      expectWithinBound(circle, q);
      if (HasFatalFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, CircleFanOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(CircleFan, BoundsAreCloseWhereTheSitesAreOrdinary) {
  Random random(104);
  for (std::size_t n = 3; n <= 40; ++n) {
    // Sites around q, some larger and some smaller.
    std::vector<Site> rim;
    for (std::size_t k = 0; k < n; ++k) {
      // Once around, by tangents of half angles.
      const double t = (static_cast<double>(k) + 0.5) / static_cast<double>(n) * 4 - 2;
      const double half = t < -1 ? -1 / (t + 2) : t > 1 ? -1 / (t - 2) : t;
      rim.push_back({(1 - half * half) / (1 + half * half), 2 * half / (1 + half * half),
                     random.between(0, 0.3)});
    }
    const Site q{random.between(-0.1, 0.1), random.between(-0.1, 0.1), random.between(0, 0.3)};
    CircleFan fan;
    fan.reserve(n);
    std::vector<VoronoiCircle> circles(n);
    for (std::size_t k = 0; k < n; ++k) fan.setCorner(k, &rim[k]);
    fan.compute(q, circles);
    for (std::size_t k = 0; k < n; ++k) {
      const Site &a = rim[k], &b = rim[(k + 1) % n];
      const VoronoiCircle one = voronoiCircle(&a, &b, &q);
      if (!(one.error < 1e-9)) continue;
      EXPECT_LT(circles[k].error, 1e-7);
      const std::array<Corner, 3> face{&a, &b, &q};
      VoronoiCircle alone;
      CircleFan::computeFaces({&face, 1}, {&alone, 1});
      EXPECT_LT(alone.error, 1e-7);
      EXPECT_NEAR(alone.x, one.x, 2 * (double{one.error} + double{alone.error}));
      EXPECT_NEAR(alone.s, one.s, 2 * (double{one.error} + double{alone.error}));
      EXPECT_NEAR(circles[k].x, one.x, 2 * (double{one.error} + double{circles[k].error}));
      EXPECT_NEAR(circles[k].y, one.y, 2 * (double{one.error} + double{circles[k].error}));
    }
  }
}

TEST(CircleFan, FacesWithInfinityAreHalfPlanes) {
  const Site q{0, 0, 1}, a{4, 0, 2}, b{0, 5, 1};
  CircleFan fan;
  fan.reserve(3);
  fan.setCorner(0, &a);
  fan.setCorner(1, &b);
  fan.setCorner(2, nullptr);
  VoronoiCircle circles[3];
  fan.compute(q, circles);
  EXPECT_FALSE(circles[0].isHalfPlane());
  for (const auto& [k, plane] : {std::pair{1, voronoiCircle(&b, nullptr, &q)},
                                 std::pair{2, voronoiCircle(nullptr, &a, &q)}}) {
    EXPECT_TRUE(circles[k].isHalfPlane());
    EXPECT_EQ(circles[k].x, plane.x);
    EXPECT_EQ(circles[k].y, plane.y);
    EXPECT_EQ(circles[k].s, plane.s);
  }
}

}  // namespace
}  // namespace apollonius::internal
