// The cached circle of a face: its stated error bounds against the exact circle, the same bits
// whichever corner comes first, and no knowledge rather than wrong knowledge where doubles do not
// suffice.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "predicate/compute_circle.h"
#include "predicate/precise_circle.h"
#include "predicate/predicates.h"
#include "predicate/reference_site.h"
#include "predicate/samples.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::internal {
namespace {

using namespace test;

bool sameBits(const VoronoiCircle& a, const VoronoiCircle& b) {
  const auto same = [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return same(a.x, b.x) && same(a.y, b.y) && same(a.s, b.s) && same(a.error, b.error) &&
         same(a.slope, b.slope);
}

/// Do sites that touch one circle about the origin from outside come in this order,
/// counter-clockwise?
bool touchesTurning(const Site& a, const Site& b, const Site& c) {
  const auto direction = [](const Site& s) {
    const double size = std::sqrt(s.x * s.x + s.y * s.y);
    return std::pair{s.x / size, s.y / size};
  };
  const auto [ax, ay] = direction(a);
  const auto [bx, by] = direction(b);
  const auto [cx, cy] = direction(c);
  return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > 1e-9;
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
    ASSERT_FALSE(circle.isHalfPlane()) << toText(insertAll(c));
    if (!(circle.error < 1e300)) continue;  // says that it knows nothing
    ASSERT_TRUE(
        oracleCircleIsWithin(c[0], c[1], c[2], {circle.x, circle.y, circle.s}, circle.error))
        << "run " << run << ", centre " << circle.x << " " << circle.y << ", error " << circle.error
        << "\n"
        << toText(insertAll(c));
  }
}

TEST_P(VoronoiCircleOn, IsPreciseFromLongNumbers) {
  Random random(103);
  for (int run = 0; run < runs(GetParam().large ? 300 : 40); ++run) {
    const Circles c = visibleOnly(GetParam().make(random, 3));
    if (c.size() < 3 || oracleCircle(c, 0, 1, 2, kInfinity) == CircleAnswer::kNoCircle) continue;
    const std::vector<Site> s = toSites(c);
    const VoronoiCircle circle = preciseVoronoiCircle(&s[0], &s[1], &s[2]);
    const double size = absolute(circle.x) + absolute(circle.y) + absolute(circle.s);
    if (!(size < 1e150)) continue;  // a bound is a float
    if (size < 1e37 && size > 1e-30) {
      // The centre is the reference site's and a way from there: both are rounded.
      Corner reference = &s[0], second = &s[1], third = &s[2];
      rotateToReference(reference, second, third);
      const double referenceSize =
          absolute(reference->x) + absolute(reference->y) + absolute(reference->r);
      ASSERT_LE(circle.error, 0x1p-39 * size + 0x1p-44 * referenceSize) << toText(insertAll(c));
    }
    if (!(circle.error < 1e300)) continue;
    ASSERT_TRUE(
        oracleCircleIsWithin(c[0], c[1], c[2], {circle.x, circle.y, circle.s}, circle.error))
        << "run " << run << ", centre " << circle.x << " " << circle.y << ", error " << circle.error
        << "\n"
        << toText(insertAll(c));
  }
}

/// Sites in line up to a unit in the last place, and magnitudes from end to end of the range: the
/// longest numbers there are.
TEST(VoronoiCircle, IsPreciseWhereTermsCancel) {
  for (const double tiny : {1e-16, 1e-40, 1e-100}) {
    for (const double large : {1.0, 1e30, 1e100}) {
      const Circles c{{-large, 0, tiny}, {0, -tiny, 0}, {large, 0, tiny}};
      const std::vector<Site> s = toSites(c);
      for (const auto& [j, k] : {std::pair{1, 2}, std::pair{2, 1}}) {
        if (!hasVoronoiCircle(s[0], s[static_cast<std::size_t>(j)], s[static_cast<std::size_t>(k)]))
          continue;
        const VoronoiCircle circle = preciseVoronoiCircle(&s[0], &s[static_cast<std::size_t>(j)],
                                                          &s[static_cast<std::size_t>(k)]);
        if (!(circle.error < 1e300)) continue;
        EXPECT_TRUE(oracleCircleIsWithin(c[0], c[static_cast<std::size_t>(j)],
                                         c[static_cast<std::size_t>(k)],
                                         {circle.x, circle.y, circle.s}, circle.error))
            << tiny << " " << large;
      }
    }
  }
}

/// Equal weights make some of the terms 0, whatever the scale.
TEST(VoronoiCircle, IsPreciseOfFlatTrianglesOfAllSizes) {
  for (const double size : {1e-90, 1e-3, 1.0, 1e3, 1e90}) {
    const double height = 0x1p-45 * size;
    const Site left{-size, 0, size}, top{0, height, size}, right{size, 0, size};
    const VoronoiCircle circle = preciseVoronoiCircle(&left, &right, &top);
    EXPECT_NEAR(circle.x / size, 0, 20)
        << size;  // doubles may be used if they are right to a 2^-40th
    EXPECT_NEAR(circle.y / size, -0x1p44, 20) << size;
    EXPECT_NEAR(circle.s / size, 0x1p44, 20) << size;
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
    // Both sites touch the half-plane, and its normal is to the left of the way from the first to
    // the second.
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

/// A circle that many sites touch: the same bits from any three of them with the largest, and its
/// centre is the origin.
TEST(VoronoiCircle, OfManySitesIsTheSameForAll) {
  Random random(104);
  int count = 0;
  for (int run = 0; run < runs(300); ++run) {
    Circles c =
        visibleOnly(run % 3 == 0 ? cocircularPoints(random, 7) : commonTangent(random, 7, 20));
    std::sort(c.begin(), c.end(),
              [](const Circle& a, const Circle& b) { return oracleSmaller(b, a); });
    const double unit = run % 2 == 0 ? 1 : 0x1p-9;
    std::vector<Site> s = toSites(c);
    for (Site& site : s) site = {unit * site.x, unit * site.y, unit * site.r};
    const double clearance = unit * (run % 3 == 0 ? 32044 : 20);
    for (std::size_t j = 1; j < s.size(); ++j) {
      for (std::size_t k = 1; k < s.size(); ++k) {
        if (k == j || !touchesTurning(s[0], s[j], s[k])) continue;
        const VoronoiCircle circle = commonVoronoiCircle(s[j], s[k], s[0]);
        EXPECT_EQ(circle.x, 0);
        EXPECT_EQ(circle.y, 0);
        EXPECT_EQ(circle.s, clearance);
        for (std::size_t q = 1; q < s.size(); ++q) {
          EXPECT_TRUE(q == j || q == k || touchesCircle(s[0], s[j], s[k], s[q]));
        }
        ++count;
      }
    }
    if (HasFailure()) FAIL() << "run " << run;
  }
  EXPECT_GT(count, runs(1000));
}

/// With small integers, the quotient of two integers that doubles hold is rounded once. That the
/// offset from a site is not added with a rounding of its own is what d3 users see: 150, not
/// 149.99999999999997.
TEST(VoronoiCircle, OfSmallIntegersHasTheNearestDoubles) {
  Random random(106);
  int count = 0;
  for (int run = 0; run < runs(20000); ++run) {
    const std::int64_t most = run % 2 == 0 ? 12 : 30000;
    const auto number = [&] { return random.integer(-most, most); };
    const std::int64_t x[]{number(), number(), number()}, y[]{number(), number(), number()};
    const std::int64_t twice = 2 * ((x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]));
    if (twice <= 0) continue;
    // Cramer's rule for the equations of the bisectors, with nothing but integers.
    std::int64_t overX = 0, overY = 0;
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3, last = (k + 2) % 3;
      const std::int64_t squares = x[k] * x[k] + y[k] * y[k];
      overX += squares * (y[next] - y[last]);
      overY += squares * (x[last] - x[next]);
    }
    const double unit = run % 3 == 0 ? 0x1p-20 : 1, r = unit * random.below(5);
    const auto site = [&](int k) {
      return Site{unit * static_cast<double>(x[k]), unit * static_cast<double>(y[k]), r};
    };
    const Site a = site(0), b = site(1), c = site(2);
    for (const VoronoiCircle& circle :
         {preciseVoronoiCircle(&a, &b, &c), commonVoronoiCircle(a, b, c)}) {
      ASSERT_EQ(circle.x, unit * (static_cast<double>(overX) / static_cast<double>(twice)));
      ASSERT_EQ(circle.y, unit * (static_cast<double>(overY) / static_cast<double>(twice)));
    }
    ++count;
  }
  EXPECT_GT(count, runs(8000));
}

/// Far from the origin the offsets are rounded: still the same bits.
TEST(VoronoiCircle, OfManySitesHasTheSameBitsWhereItIsRounded) {
  Random random(105);
  for (int run = 0; run < runs(300); ++run) {
    // A circle about a centre of thirds cannot be held by doubles, but its four sites can: mirror
    // images in two lines.
    const double x = static_cast<double>(random.integer(1, 99)),
                 y = static_cast<double>(random.integer(1, 99));
    const double h = static_cast<double>(random.integer(1, 99));
    const double r = random.oneIn(2) ? 0 : static_cast<double>(random.integer(1, 9));
    const double far = 1000.1, w = 2 * x + 1;
    const std::array<Site, 4> s{Site{far, 0, r}, Site{far, h, r}, Site{far + w, h + y, 0.5},
                                Site{far + w, -y, 0.5}};
    if (covers(s[0], s[2]) || covers(s[2], s[0])) continue;
    // In the order of the contacts, counter-clockwise: 0, 3, 2, 1. The largest is 1 if the first
    // two are larger, else 2.
    const std::size_t z = precedes(s[1], s[2]) ? 2 : 1;
    std::vector<VoronoiCircle> circles;
    for (const auto& [a, b, c] :
         {std::array<std::size_t, 3>{0, 3, 2}, {3, 2, 1}, {2, 1, 0}, {1, 0, 3}}) {
      if (a != z && b != z && c != z) continue;
      if (!hasVoronoiCircle(s[a], s[b], s[c]) || !touchesCircle(s[a], s[b], s[c], s[6 - a - b - c]))
        continue;
      circles.push_back(commonVoronoiCircle(s[a], s[b], s[c]));
    }
    for (const VoronoiCircle& circle : circles) {
      EXPECT_EQ(circle.x, circles[0].x) << "run " << run;
      EXPECT_EQ(circle.y, circles[0].y) << "run " << run;
      EXPECT_EQ(circle.s, circles[0].s) << "run " << run;
    }
  }
}

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

/// Nothing is known where products underflow: the chord's square is far below the smallest double.
TEST(VoronoiCircle, IsNotCertainWhereOneSiteIsNextToAnother) {
  const Site i{0, 0, 0}, j{-1, 0, 0}, k{0, -1e-100, 0};  // the first is the reference
  VoronoiCircle circle;
  EXPECT_FALSE(findCertainVoronoiCircle(&i, &j, &k, circle));
  EXPECT_EQ(circle.error, std::numeric_limits<float>::infinity());
  EXPECT_TRUE(findVoronoiCircle(&i, &j, &k, circle));
  const VoronoiCircle precise = preciseVoronoiCircle(&i, &j, &k);
  EXPECT_EQ(precise.x, -0.5);
  EXPECT_EQ(precise.y, -0.5e-100);
}

}  // namespace
}  // namespace apollonius::internal
