// Rings that are split where they meet: whether pairs of segments are looked at cell by cell of a
// grid, or only those that a sweep has taken out, the rings are the same; and segments that a grid
// does not keep apart are not looked at in pairs.
#include "geometry/window/arrangement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

using namespace internal;

using Ring = std::vector<double>;

struct Normalized {
  NormalizedPolygon polygon;
  std::size_t looks = 0;
  bool isSplit = false;
};

Normalized normalized(const std::vector<Ring>& rings, double fewLooks) {
  Rectangle box{rings[0][0], rings[0][1], rings[0][0], rings[0][1]};
  for (const Ring& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); k += 2) box.include({ring[k], ring[k + 1]});
  }
  Arrangement lines(box, fewLooks);
  for (const Ring& ring : rings) lines.addRing(ring);
  Normalized result;
  result.isSplit = lines.split();
  if (!result.isSplit) return result;
  lines.orient();
  lines.link(result.polygon);
  result.looks = lines.looks();
  return result;
}

void expectTheSame(const std::vector<Ring>& rings) {
  const Normalized swept = normalized(rings, 0);
  const Normalized expected = normalized(rings, std::numeric_limits<double>::infinity());
  ASSERT_EQ(swept.isSplit, expected.isSplit);
  ASSERT_EQ(swept.polygon.points.size(), expected.polygon.points.size());
  for (std::size_t k = 0; k < expected.polygon.points.size(); ++k)
    ASSERT_EQ(swept.polygon.points[k], expected.polygon.points[k]) << k;
  ASSERT_EQ(swept.polygon.ringCount(), expected.polygon.ringCount());
  for (std::size_t k = 0; k < expected.polygon.starts.size(); ++k)
    ASSERT_EQ(swept.polygon.starts[k], expected.polygon.starts[k]) << k;
}

/// A polygon with its corners on the axes, or turned.
Ring polygon(int corners, double x, double y, double radius, double turn = 0) {
  Ring ring;
  for (int k = 0; k < corners; ++k) {
    const double angle = turn + 2 * 3.14159265358979323846 * k / corners;
    ring.insert(ring.end(), {x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return ring;
}

Ring square(double x, double y, double r) {
  return {x - r, y - r, x + r, y - r, x + r, y + r, x - r, y + r};
}
Ring diamond(double x, double y, double r) { return {x - r, y, x, y - r, x + r, y, x, y + r}; }

/// Integer coordinates: sides overlap, pass points, and are vertical.
TEST(Arrangement, SweptAsInAGridOnALattice) {
  Random random(911);
  for (int run = 0; run < runs(600); ++run) {
    const int size = static_cast<int>(random.integer(2, 12));
    std::vector<Ring> rings(random.below(4u) + std::size_t{1});
    for (Ring& ring : rings) {
      for (std::size_t k = random.below(12u) + std::size_t{3}; k > 0; --k) {
        ring.push_back(static_cast<double>(random.below(size + 1)));
        ring.push_back(static_cast<double>(random.below(size + 1)));
      }
    }
    rings.push_back(square(0, 0, size));
    SCOPED_TRACE(run);
    expectTheSame(rings);
    if (HasFatalFailure()) return;
  }
}

/// Few crossings among many sides that do not cross: it matters which the sweep takes out.
TEST(Arrangement, SweptAsInAGridAroundEachOther) {
  Random random(912);
  for (int run = 0; run < runs(80); ++run) {
    std::vector<Ring> rings;
    const int count = static_cast<int>(random.integer(2, 60));
    const auto kind = random.below(4u);
    const double turn = random.between(0, 3), aside = random.oneIn(2) ? 0.6 : 0;
    const int corners = static_cast<int>(random.integer(3, 9));
    for (int k = 1; k <= count; ++k) {
      const double x = aside * random.unit();
      rings.push_back(kind == 0   ? square(x, 0, k)
                      : kind == 1 ? diamond(x, 0, k)
                      : kind == 2 ? polygon(corners, x, 0, k, turn)
                                  : polygon(corners, 0, 0, k, turn + 0.001 * k));
    }
    for (auto k = random.below(5u); k > 0; --k) {
      const double x = random.between(-count, count), y = random.between(-count, count);
      const bool isWhole = random.oneIn(2);
      rings.push_back(diamond(isWhole ? std::round(x) : x, isWhole ? std::round(y) : y,
                              random.oneIn(3) ? 0.5 * count : 1));
    }
    random.shuffle(rings);
    SCOPED_TRACE(run);
    expectTheSame(rings);
    if (HasFatalFailure()) return;
  }
}

/// Crossings whose rounded places are crossed again, up to the grid of the last rounds.
TEST(Arrangement, SweptAsInAGridWhereCrossingsAreRounded) {
  Random random(913);
  for (int run = 0; run < runs(60); ++run) {
    Ring ring;
    const bool areClose = random.oneIn(2), isNeedle = random.oneIn(3);
    for (int k = 0; k < 24; ++k) {
      double x = random.between(0.5, 1), y = random.unit();
      if (areClose) y = 1.1 * x + static_cast<double>(random.integer(-20, 20)) * 0x1p-52;
      if (isNeedle && k % 2 != 0) {
        x = -410706247680.99976 - static_cast<double>(random.below(4)) * 0x1p-14;
        y = -470600908800.99976;
      }
      ring.insert(ring.end(), {x, y});
    }
    SCOPED_TRACE(run);
    expectTheSame({ring});
    if (HasFatalFailure()) return;
  }
}

/// A side is split at the corner on it, not at the place beside it where rounding has the crossing
/// of the two: 1/49 times 49 is not 1.
TEST(Arrangement, ACornerOnASideSplitsItThere) {
  for (int parts = 2; parts < 200; ++parts) {
    for (const double sign : {1.0, -1.0}) {
      const Ring side{0, 0, sign * parts, 2.0 * parts, sign * 300, 0};
      const Ring corner{-5 * sign, 3, sign, 2, -5 * sign, 9};
      const Normalized result = normalized({side, corner}, SegmentPairs::kFewLooks);
      ASSERT_TRUE(result.isSplit);
      ASSERT_EQ(result.polygon.points.size(), 7u) << parts << " " << sign;
      for (const Point p : result.polygon.points)
        EXPECT_TRUE(p.x == std::round(p.x) && p.y == std::round(p.y)) << parts << " " << sign;
    }
  }
}

/// Twice as many segments ask for little more than twice the looks. A grid shows each pair again in
/// every cell that both share: four times as many, and a thousand times more of them.
TEST(Arrangement, WorkIsNotPairsOfSegments) {
  enum Kind { kSquares, kDiamonds, kTurned, kCrossed, kIslands };
  for (const Kind kind : {kSquares, kDiamonds, kTurned, kCrossed, kIslands}) {
    SCOPED_TRACE(kind);
    const auto looksOf = [&](int count) {
      std::vector<Ring> rings;
      for (int k = 1; k <= count; ++k) {
        if (kind == kSquares) rings.push_back(square(0, 0, k));
        if (kind == kDiamonds || kind == kCrossed) rings.push_back(diamond(0, 0, k));
        if (kind == kTurned) rings.push_back(polygon(4, 0, 0, k, 0.3));
        if (kind == kIslands) rings.push_back(square(k % 50, k / 50, 0.3));
      }
      if (kind == kCrossed) rings.push_back(square(0.4 * count + 0.1, 0.3 * count, 0.7));
      if (kind == kIslands) rings.push_back(square(1e7, 1e7, 1));  // all others are in one cell
      const Normalized result = normalized(rings, SegmentPairs::kFewLooks);
      EXPECT_TRUE(result.isSplit);
      return static_cast<double>(result.looks) / (4.0 * count);
    };
    const int count = runs(2000);
    const double once = looksOf(count), twice = looksOf(2 * count);
    EXPECT_LT(once, 10 * std::log2(4 * count));
    EXPECT_LT(twice, 1.2 * once);
  }
}

}  // namespace
}  // namespace apollonius::test
