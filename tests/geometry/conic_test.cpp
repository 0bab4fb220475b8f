// Conics, their approximations within a tolerance, and their measures, against sampling.
#include "geometry/curve/conic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/cell/rectangle_cell.h"
#include "geometry/curve/moments.h"
#include "geometry/draw/cubics.h"
#include "geometry/shapes.h"
#include "support/effort.h"
#include "support/generators.h"

namespace apollonius::test {

using namespace internal;
namespace {

const double kWeights[] = {0, 1e-3, 0.3, 0.70710678, 0.99, 1, 1.0001, 1.2, 3, 50, 1e4, 1e9};

Conic randomConic(Random& random, double w) {
  const auto point = [&] { return Point{random.between(-10, 10), random.between(-10, 10)}; };
  Conic conic{point(), point(), w, point()};
  if (w == 0) conic.p1 = middle(conic.p0, conic.p2);
  return conic;
}

double distanceToSegment(Point p, Point a, Point b) {
  const Point ab = b - a;
  const double t = std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0);
  return length(p - a - t * ab);
}

/// Points of the conic, close together however unevenly the parameter runs.
std::vector<Point> sampled(const Conic& conic, int halvings) {
  if (halvings == 0) return {conic.p0};
  Conic first, second;
  conic.halve(first, second);
  std::vector<Point> points = sampled(first, halvings - 1);
  for (const Point p : sampled(second, halvings - 1)) points.push_back(p);
  return points;
}

double distanceToPolyline(Point p, const std::vector<Point>& line) {
  double best = 1e300;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    if (!(line[k] == line[k + 1]))
      best = std::min(best, distanceToSegment(p, line[k], line[k + 1]));
  }
  return best;
}

TEST(Conic, HalvesAreTheSameCurve) {
  Random random(511);
  for (const double w : kWeights) {
    const Conic conic = randomConic(random, w);
    Conic first, second;
    conic.halve(first, second);
    EXPECT_LT(length(first.p2 - conic.at(0.5)), 1e-13);
    EXPECT_TRUE(first.p2 == second.p0);
    for (double t = 0; t <= 1; t += 0.25) {
      const Point p = first.at(t);
      // On the conic: barycentric coordinates (a, b, c) with respect to the triangle satisfy b² = 4
      // w² a c.
      const double all = cross(conic.p1 - conic.p0, conic.p2 - conic.p0);
      if (w == 0 || std::abs(all) < 1) continue;
      const double a = cross(conic.p1 - p, conic.p2 - p) / all,
                   b = cross(conic.p2 - p, conic.p0 - p) / all;
      const double c = 1 - a - b;
      EXPECT_NEAR(b * b, 4 * w * w * a * c, 1e-10 * (1 + 4 * w * w)) << w;
    }
  }
}

TEST(Conic, ApproximationsAreWithinTheTolerance) {
  Random random(512);
  for (int run = 0; run < runs(6); ++run) {
    for (const double w : kWeights) {
      for (const double tolerance : {1.0, 0.1, 1e-3}) {
        const Conic conic = randomConic(random, w);
        const std::vector<Point> polyline = chordsOf(conic, tolerance);
        ASSERT_TRUE(polyline.back() == conic.p2);

        Path path;
        drawConic(conic, {tolerance}, path);
        std::vector<Point> drawn{conic.p0};
        std::size_t at = 0;
        for (const std::uint8_t command : path.commands) {
          const double* xy = path.coordinates.data() + at;
          if (static_cast<Command>(command) == Command::kLine) {
            drawn.push_back({xy[0], xy[1]});
            at += 2;
            continue;
          }
          const Point p = drawn.back(), a{xy[0], xy[1]}, b{xy[2], xy[3]}, q{xy[4], xy[5]};
          at += 6;
          for (int k = 1; k <= 150; ++k) {
            const double t = k / 150.0, s = 1 - t;
            drawn.push_back(s * s * s * p + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * q);
          }
        }
        double worstFlat = 0, worstDrawn = 0;
        for (const Point p : sampled(conic, 8)) {
          worstFlat = std::max(worstFlat, distanceToPolyline(p, polyline));
          worstDrawn = std::max(worstDrawn, distanceToPolyline(p, drawn));
        }
        ASSERT_LE(worstFlat, tolerance * 1.001) << "w " << w;
        ASSERT_LE(worstDrawn, tolerance * 1.01 + 1e-3)
            << "w " << w;  // the samples themselves are 1e-3 apart from the curve
        ASSERT_LE(path.commands.size(), 24u) << "w " << w << " tolerance " << tolerance;
        ASSERT_LE(polyline.size(), 4 + 12 / std::sqrt(tolerance));
      }
    }
  }
}

// Between neighbouring doubles there is nothing to halve: that must not be tried again and again.
TEST(Conic, IsSplitByFinitePointsThatAreNoEnds) {
  Random random(12);
  const Conic conic = randomConic(random, 1.2);
  Conic first, second;
  conic.halve(first, second);
  EXPECT_TRUE(conic.isSplitBy(first.p2));
  EXPECT_FALSE(conic.isSplitBy(conic.p0));
  EXPECT_FALSE(conic.isSplitBy(conic.p2));
  EXPECT_FALSE(conic.isSplitBy({std::nan(""), 0}));
}

/// Neighbours, which have it in opposite directions, halve it alike.
TEST(Conic, SagittaHasTheSameBitsInBothDirections) {
  Random random(13);
  for (int run = 0; run < 1000; ++run) {
    const Conic conic = randomConic(random, kWeights[1 + run % 11]);
    ASSERT_EQ(conic.sagitta(), conic.reversed().sagitta()) << run;
  }
}

TEST(Conic, OfAFewDoublesIsNotHalvedWithoutEnd) {
  const double step = 0x1p-33;  // between doubles around a million
  for (const double w : {1.0, 3.0, 1e9}) {
    const Conic conic{{1e6, 1e6}, {1e6 + step, 1e6}, w, {1e6 + step, 1e6 + step}};
    Path path;
    drawConic(conic, {1e-30}, path);
    EXPECT_LE(path.commands.size(), 4u);
    EXPECT_LE(chordsOf(conic, 1e-30).size(), 5u);
  }
}

TEST(Measures, CircleIsPi) {
  Moments moments;
  double length = 0, area = 0;
  const Point directions[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 0}};
  for (int k = 0; k < 4; ++k) {
    const Conic arc = Conic::arc({3, -2}, 2, directions[k], directions[k + 1]);
    moments.add(arc, {3, -2});
    length += lengthOf(arc);
    area += areaBeyondChord(arc);
  }
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(moments.area, 4 * pi, 1e-14);
  EXPECT_NEAR(moments.first.x, 0, 1e-14);
  EXPECT_NEAR(moments.first.y, 0, 1e-14);
  EXPECT_NEAR(length, 4 * pi, 1e-13);
  EXPECT_NEAR(area + 8, 4 * pi, 1e-14);
}

TEST(Measures, FactorsAgreeWithTheirClosedForms) {
  for (double w = 1.3; w < 1e6; w *= 1.7) {
    const double u = std::acosh(w), s = std::sinh(u);
    const ArcFactors factors = arcFactors(w);
    EXPECT_NEAR(factors.area, w * (w * s - u) / (s * s * s), 2e-14) << w;
    EXPECT_NEAR(factors.moment, w * w * (s + s * s * s / 3 - w * u) / (s * s * s * s * s), 1e-13)
        << w;
    EXPECT_DOUBLE_EQ(factors.area, arcAreaFactor(w));
  }
  EXPECT_DOUBLE_EQ(arcFactors(1).area, 2.0 / 3);
  EXPECT_DOUBLE_EQ(arcFactors(1).moment, 2.0 / 15);
  // Nearly flat hyperbolas, where the closed forms have no digits left: linear between neighbours.
  EXPECT_NEAR(arcAreaFactor(1 + 1e-6), (arcAreaFactor(1) + arcAreaFactor(1 + 2e-6)) / 2, 1e-12);
}

TEST(Measures, AreaMomentsAndLengthOfPiecesAgreeWithPolylines) {
  Random random(513);
  for (const double w : kWeights) {
    for (int run = 0; run < 4; ++run) {
      const Conic conic = randomConic(random, w);
      Moments exact, summed;
      exact.add(conic, {1, 1});
      double length = 0;
      std::vector<Point> points = sampled(conic, 14);
      points.push_back(conic.p2);
      for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        summed.add(Conic::segment(points[k], points[k + 1]), {1, 1});
        length += apollonius::internal::length(points[k + 1] - points[k]);
      }
      EXPECT_NEAR(exact.area, summed.area, 2e-5) << w;
      EXPECT_NEAR(exact.first.x, summed.first.x, 3e-4) << w;
      EXPECT_NEAR(exact.first.y, summed.first.y, 3e-4) << w;
      EXPECT_NEAR(lengthOf(conic), length, 1e-5) << w;
    }
  }
}

}  // namespace
}  // namespace apollonius::test
