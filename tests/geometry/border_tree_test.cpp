// The border as a tree of pieces against all of its curves, cut finely.
#include "geometry/inscribed/border_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/random.h"

namespace apollonius::test {
namespace {

using namespace internal;

using Ring = std::vector<Conic>;

/// A star-shaped ring about a centre; every second side is a curve, to either side of its chord.
Ring randomRing(Random& random, Point center, double size, std::size_t sides) {
  std::vector<Point> corners;
  for (std::size_t k = 0; k < sides; ++k) {
    const double turn = 6.283185307179586 * static_cast<double>(k) / static_cast<double>(sides);
    const double r = size * (0.4 + 0.6 * random.unit());
    corners.push_back(center + r * Point{std::cos(turn), std::sin(turn)});
  }
  Ring ring;
  for (std::size_t k = 0; k < sides; ++k) {
    const Point a = corners[k], b = corners[(k + 1) % sides];
    if (k % 2 == 0) {
      ring.push_back(Conic::segment(a, b));
    } else {
      const Point apex = middle(a, b) + (0.3 * random.unit() - 0.15) * leftOf(b - a);
      ring.push_back({a, apex, 0.3 + 3 * random.unit(), b});
    }
  }
  return ring;
}

std::vector<Point> pointsOf(const Ring& ring, int parts) {
  std::vector<Point> points;
  for (const Conic& curve : ring)
    for (int k = 0; k < parts; ++k) points.push_back(curve.at(static_cast<double>(k) / parts));
  return points;
}

double distanceTo(const std::vector<Point>& ring, Point p) {
  double least = 1e300;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const BorderChord chord{ring[k], ring[(k + 1) % ring.size()]};
    least = std::min(least, length(p - chord.nearestTo(p)));
  }
  return least;
}

bool surrounds(const std::vector<Point>& ring, Point p) {
  bool isInside = false;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point a = ring[k], b = ring[(k + 1) % ring.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
      isInside = !isInside;
  }
  return isInside;
}

TEST(BorderTree, TellsDistanceAndInsideAsAllCurvesDo) {
  Random random(91);
  for (const std::size_t sides : {3u, 4u, 7u, 40u, 300u}) {
    const Ring outer = randomRing(random, {0, 0}, 1, sides),
               hole = randomRing(random, {0.05, 0}, 0.3, sides);
    BorderTree border;
    border.clear(0x1p-50);
    border.addRing(outer);
    border.addRing(hole);
    const auto outerPoints = pointsOf(outer, 200), holePoints = pointsOf(hole, 200);
    for (int k = 0; k < 200; ++k) {
      const Point p{2.4 * random.unit() - 1.2, 2.4 * random.unit() - 1.2};
      const double distance = std::min(distanceTo(outerPoints, p), distanceTo(holePoints, p));
      for (const double share : {0.0, 0x1p-10}) {
        const double found = border.distance(p, share, -1);
        EXPECT_LE(found, distance + 2e-5);  // the chords' distance
        EXPECT_GE(found, distance * (1 - 2 * share) - 2e-5);
      }
      EXPECT_LE(border.distance(p, 0, 2 * distance), 2 * distance);
      EXPECT_GT(border.distance(p, 0, 0.9 * distance - 2e-5), 0.9 * distance - 2e-5);
      if (distance > 1e-4) {
        EXPECT_EQ(border.surrounds(p), surrounds(outerPoints, p) != surrounds(holePoints, p));
      }
    }
  }
}

TEST(BorderTree, PiecesAreWithinTheirHeightsAndSidesOfConvexRingsHaveNothingBeyond) {
  Random random(92);
  const Ring ring = randomRing(random, {3, 4}, 2, 50);
  BorderTree border;
  border.clear(0x1p-50);
  border.addRing(ring);
  const auto points = pointsOf(ring, 50);
  std::vector<std::uint32_t> todo(border.rings().begin(), border.rings().end());
  std::size_t curves = 0;
  while (!todo.empty() && curves < 500) {
    const std::uint32_t piece = todo.back();
    todo.pop_back();
    const BorderChord chord = border.chord(piece);
    const double height = border.height(piece), limit = std::max(4 * height, 1e-12),
                 overhang = border.overhang(piece, limit);
    // The border goes around: of each chord, the ends of pieces are on it.
    EXPECT_LE(distanceTo(points, middle(chord.a, chord.b)), height + 1e-3);
    if (!(chord.a == chord.b)) {
      const Point normal = leftOf(unit(chord.b - chord.a));
      double most = 0;
      for (const Point p : points) most = std::max(most, -dot(normal, p - chord.a));
      EXPECT_GE(overhang, most - 1e-12);  // it is infinite above the limit
      if (overhang > limit) {
        EXPECT_GT(most + 2 * height, limit / 4);
      }
    }
    const std::uint32_t half = border.firstHalf(piece);
    if (half == BorderTree::kWhole) {
      ++curves;
      continue;
    }
    EXPECT_EQ(border.chord(half).a, chord.a);
    EXPECT_EQ(border.chord(half).b, border.chord(half + 1).a);
    EXPECT_EQ(border.chord(half + 1).b, chord.b);
    todo.push_back(half + 1);
    todo.push_back(half);
  }

  const Point corners[] = {{0, 0}, {5, 1}, {6, 3}, {2, 7}, {-1, 4}};
  Ring convex;
  for (std::size_t k = 0; k < 5; ++k)
    convex.push_back(Conic::segment(corners[k], corners[(k + 1) % 5]));
  border.clear(0x1p-48);
  border.addRing(convex);
  todo.assign(border.rings().begin(), border.rings().end());
  std::size_t sides = 0;
  while (!todo.empty()) {
    const std::uint32_t piece = todo.back(), half = border.firstHalf(piece);
    todo.pop_back();
    if (half == BorderTree::kWhole) {
      EXPECT_LE(border.overhang(piece, 0x1p-46), 0x1p-46);
      ++sides;
    } else {
      todo.insert(todo.end(), {half, half + 1});
    }
  }
  EXPECT_EQ(sides, 5u);
}

}  // namespace
}  // namespace apollonius::test
