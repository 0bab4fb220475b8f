// The cached circle of a face: its stated error bounds against the exact circle, the same bits whichever corner comes first, and
// no knowledge rather than wrong knowledge where doubles do not suffice.
#include "predicate/voronoi_circle.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "predicate/predicates.h"
#include "predicate/samples.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius {
namespace {

using namespace test;

bool sameBits(const VoronoiCircle& a, const VoronoiCircle& b) {
  const auto same = [](double x, double y) { return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y); };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.s, b.s) && same(a.error, b.error) && same(a.slope, b.slope);
}

class VoronoiCircleOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(VoronoiCircleOn, IsWithinItsErrorBound) {
  Random random(101);
  const int count = runs(GetParam().large ? 1000 : 60);
  for (int run = 0; run < count; ++run) {
    const Circles c = visibleOnly(GetParam().make(random, 3));
    if (c.size() < 3 || oracleCircle(c, 0, 1, 2, kInfinity) == CircleAnswer::kNoCircle) continue;
    const std::vector<Site> s = toSites(c);
    const VoronoiCircle circle = voronoiCircle(&s[0], &s[1], &s[2]);
    ASSERT_TRUE(sameBits(circle, voronoiCircle(&s[1], &s[2], &s[0])));
    ASSERT_TRUE(sameBits(circle, voronoiCircle(&s[2], &s[0], &s[1])));
    ASSERT_EQ(circle.isHalfPlane(), isVertexAtInfinity(s[0], s[1], s[2])) << toText(insertAll(c));
    if (circle.isHalfPlane()) {  // three sites in line on the hull: all of them touch the half-plane
      for (const Site& site : s) ASSERT_FALSE(circleFilter(circle, site).known) << toText(insertAll(c));
      continue;
    }
    if (!(circle.error < 1e300)) continue;  // says that it knows nothing
    ASSERT_TRUE(oracleCircleIsWithin(c[0], c[1], c[2], {circle.x, circle.y, circle.s}, circle.error).value_or(true))
        << "run " << run << ", centre " << circle.x << " " << circle.y << ", error " << circle.error << "\n"
        << toText(insertAll(c));
  }
}

TEST_P(VoronoiCircleOn, HalfPlaneTouchesBothSites) {
  Random random(102);
  for (int run = 0; run < runs(300); ++run) {
    Circles c = visibleOnly(GetParam().make(random, 2));
    if (c.size() < 2) continue;
    c.resize(2);
    const std::vector<Site> s = toSites(c);
    const VoronoiCircle plane = voronoiCircle(&s[0], &s[1], nullptr);
    ASSERT_TRUE(plane.isHalfPlane());
    ASSERT_TRUE(sameBits(plane, voronoiCircle(&s[1], nullptr, &s[0])));
    ASSERT_TRUE(sameBits(plane, voronoiCircle(nullptr, &s[0], &s[1])));
    // Both sites touch the half-plane, and its normal is to the left of the way from the first to the second.
    for (const Site& site : s) EXPECT_FALSE(circleFilter(plane, site).known);
    if (plane.slope < 0.1) {
      const double size = absolute(s[1].x - s[0].x) + absolute(s[1].y - s[0].y);
      const double left = (plane.y * (s[1].x - s[0].x) - plane.x * (s[1].y - s[0].y)) / size;
      EXPECT_GT(left, -0.2);
      EXPECT_NEAR(plane.x * plane.x + plane.y * plane.y, 1, 0.5);
    }
    if (HasFailure()) FAIL() << "run " << run << "\n" << toText(insertAll(c));
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, VoronoiCircleOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(VoronoiCircle, SimpleCases) {
  const Site a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  const VoronoiCircle circle = voronoiCircle(&a, &b, &c);
  EXPECT_NEAR(circle.x, 2, 1e-14);
  EXPECT_NEAR(circle.y, 2, 1e-14);
  EXPECT_NEAR(circle.s, std::sqrt(8.0), 1e-14);
  EXPECT_LT(circle.error, 1e-12);
  // All about one circle from within: the clearance is negative.
  const Site d{3, 0, 5}, e{-3, 0, 5}, f{0, 3, 5};
  const VoronoiCircle inner = voronoiCircle(&d, &f, &e);
  EXPECT_NEAR(inner.x, 0, 1e-14);
  EXPECT_NEAR(inner.y, 0, 1e-14);
  EXPECT_NEAR(inner.s, -2, 1e-14);
}

}  // namespace
}  // namespace apollonius
