// Bearings: where a ray from a site lies as seen along the direction of a face's vertex.
#include "predicate/bearing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "predicate/compute_circle.h"
#include "predicate/direction.h"
#include "predicate/samples.h"
#include "support/corpus.h"
#include "support/effort.h"

namespace apollonius::internal {
namespace {

using namespace test;
using stages::RayPart;

constexpr VoronoiCircle kKnowsNothing{0, 0, 0, std::numeric_limits<float>::infinity(), -1};

/// Returns the answer of the four stages; those that know must agree.
Sign agreedSign(double x, double y, const Site& i, Corner j, Corner k, RayPart part) {
  const Sign exact = stages::rayExact(x, y, i, j, k, part);
  for (const MaybeSign stage :
       {stages::rayFilter(x, y, i, j, k, part), stages::rayMiddle(x, y, i, j, k, part),
        stages::rayFixed(x, y, i, j, k, part)}) {
    if (stage.known) {
      EXPECT_EQ(stage.sign, exact) << x << " " << y;
    }
  }
  return exact;
}

/// Circles that touch the circle of radius 5 about the origin from outside, in directions of
/// Pythagorean triples: the vertex of each face of them is the origin, and a ray may run exactly
/// along its direction.
TEST(Bearing, KnowsExactDirections) {
  const int direction[][3] = {{3, 4, 5},    {-4, 3, 5},    {-3, -4, 5},  {4, -3, 5}, {5, 12, 13},
                              {-12, 5, 13}, {-5, -12, 13}, {12, -5, 13}, {15, 8, 17}};
  Random random(181);
  int faces = 0;
  for (int run = 0; run < runs(3000); ++run) {
    Site sites[3];
    for (Site& site : sites) {
      const int* d = direction[random.below(9)];
      const auto scale = static_cast<double>(random.integer(1, 12));
      site = {scale * d[0], scale * d[1], scale * d[2] - 5};
    }
    const auto turned = [](const Site& a, const Site& b) { return a.x * b.y - a.y * b.x; };
    // Counter-clockwise around the origin, and no two in one direction.
    const int lefts = (turned(sites[0], sites[1]) > 0) + (turned(sites[1], sites[2]) > 0) +
                      (turned(sites[2], sites[0]) > 0);
    if (lefts < 2 ||
        turned(sites[0], sites[1]) * turned(sites[1], sites[2]) * turned(sites[2], sites[0]) == 0)
      continue;
    ++faces;
    const Site& i = sites[0];
    const auto bearing = [&](double x, double y) {
      for (const RayPart part : {RayPart::kLeftwards, RayPart::kAlong})
        agreedSign(x, y, i, &sites[1], &sites[2], part);
      const Bearing result =
          bearingOf(x, y, voronoiCircle(&i, &sites[1], &sites[2]), i, &sites[1], &sites[2]);
      EXPECT_EQ(result, bearingOf(x, y, kKnowsNothing, i, &sites[1], &sites[2]));
      return result;
    };
    const auto size = static_cast<double>(random.integer(1, 9)) / 8;
    const double towards = 1 - size,
                 away = 1 + size;  // times the site: the way to the origin, and from it
    EXPECT_EQ(bearing(towards * i.x, towards * i.y), Bearing::kAlong);
    EXPECT_EQ(bearing(away * i.x, away * i.y), Bearing::kOpposite);
    // A turn of the way to the origin by about 2^-40, to either side.
    const double bend = std::ldexp(size, -40);
    EXPECT_EQ(bearing(towards * i.x + bend * i.y, towards * i.y - bend * i.x), Bearing::kLeft);
    EXPECT_EQ(bearing(towards * i.x - bend * i.y, towards * i.y + bend * i.x), Bearing::kRight);
  }
  EXPECT_GT(faces, runs(3000) / 10);
}

class BearingOn : public ::testing::TestWithParam<NamedGenerator> {};

/// On all faces, those with infinity included: every stage that knows says the same, and where
/// doubles can tell the direction of a precise vertex from the ray, they tell that.
TEST_P(BearingOn, AgreesWithPreciseVertices) {
  Random random(182);
  for (int run = 0; run < runs(GetParam().large ? 30 : 3); ++run) {
    const Circles circles = visibleOnly(GetParam().make(random, 7));
    const std::vector<Site> sites = toSites(circles);
    const OracleDiagram diagram = oracleDiagram(circles);
    for (const Triple& face : diagram.triples) {
      for (int c = 0; c < 3; ++c) {
        if (face[c] == kInfinity) continue;
        const Site& i = sites[face[c]];
        const Corner j = corner(sites, face[(c + 1) % 3]), k = corner(sites, face[(c + 2) % 3]);
        const Site& other = sites[random.below(sites.size())];
        const double t = random.between(-2, 2),
                     bend = std::ldexp(random.between(-1, 1), -random.below(60));
        const double x = i.x + t * (other.x - i.x) - bend * (other.y - i.y),
                     y = i.y + t * (other.y - i.y) + bend * (other.x - i.x);
        if (!isInRange(x) || !isInRange(y) || (x == i.x && y == i.y)) continue;
        const Sign left = agreedSign(x, y, i, j, k, RayPart::kLeftwards),
                   along = agreedSign(x, y, i, j, k, RayPart::kAlong);
        ASSERT_FALSE(left == Sign::kZero && along == Sign::kZero);
        const VoronoiCircle circle = voronoiCircle(&i, j, k);
        const MaybeSign turned = turn(directionOf(circle, i), directionOf(x, y, i));
        if (turned.known) {
          ASSERT_EQ(turned.sign, left);
        }
        const Bearing expected = left == Sign::kPositive    ? Bearing::kLeft
                                 : left == Sign::kNegative  ? Bearing::kRight
                                 : along == Sign::kPositive ? Bearing::kAlong
                                                            : Bearing::kOpposite;
        ASSERT_EQ(bearingOf(x, y, circle, i, j, k), expected);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, BearingOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::internal
