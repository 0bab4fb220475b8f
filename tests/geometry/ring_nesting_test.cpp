// Which ring is around a hole: as asked one by one, and without asking all.
#include "geometry/window/ring_nesting.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "apollonius/voronoi.h"
#include "diagram/bulk_insertion.h"
#include "geometry/cell/polygon_cell.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

using namespace internal;

using Corners = std::vector<Point>;

Rectangle boxOf(const Corners& ring) {
  Rectangle box{ring[0].x, ring[0].y, ring[0].x, ring[0].y};
  for (const Point p : ring) box.include(p);
  return box;
}

/// Is the first of two points right of a ray's start where the ray crosses between them?
bool isCrossedBetween(Point a, Point b, Point from) {
  return (a.y > from.y) != (b.y > from.y) && (cross(b - a, from - a) > 0) == (b.y > a.y);
}

class Polygons final : public NestedRings {
 public:
  explicit Polygons(std::vector<Corners> rings) : rings_(std::move(rings)) {}

  std::size_t pieceCount(std::uint32_t ring) const override { return rings_[ring].size(); }
  Piece piece(std::uint32_t ring, std::size_t k) const override {
    const Point from = rings_[ring][k];
    return {from, from, next(ring, k)};
  }
  bool isCrossed(std::uint32_t ring, std::size_t k, Point from) override {
    return isCrossedBetween(rings_[ring][k], next(ring, k), from);
  }
  bool isAround(std::uint32_t ring) override { return nesting.isInside(ring, asked); }

  [[nodiscard]] bool holds(std::uint32_t ring, Point p) const {
    bool isInside = false;
    for (std::size_t k = 0; k < rings_[ring].size(); ++k)
      isInside ^= isCrossedBetween(rings_[ring][k], next(ring, k), p);
    return isInside;
  }

  RingNesting nesting{*this};
  Point asked;

 private:
  [[nodiscard]] Point next(std::uint32_t ring, std::size_t k) const {
    return rings_[ring][(k + 1) % rings_[ring].size()];
  }

  std::vector<Corners> rings_;
};

/// Rings of any shape, that cross each other, many of one area; some far away.
TEST(RingNesting, FindsWhatAskingAllFinds) {
  Random random(921);
  int found = 0;
  for (int run = 0; run < runs(300); ++run) {
    std::vector<Corners> rings(random.below(60u) + std::size_t{1});
    std::vector<double> areas;
    for (Corners& ring : rings) {
      const double size = std::exp2(random.between(-4, 3));
      const Point at{random.between(0, 10), random.oneIn(2) ? 5 : random.between(0, 10)};
      for (std::size_t k = random.below(40u) + std::size_t{3}; k > 0; --k) {
        const Point way{random.between(-size, size), random.between(-size, size)};
        ring.push_back(random.oneIn(3) ? Point{std::round(at.x + way.x), std::round(at.y + way.y)}
                                       : at + way);
      }
      areas.push_back(random.oneIn(2) ? size * size : std::round(size));
    }
    Polygons polygons(rings);
    for (std::uint32_t k = 0; k < rings.size(); ++k)
      polygons.nesting.add(k, areas[k], boxOf(rings[k]));
    for (int ask = 0; ask < 40; ++ask) {
      const Point p{random.between(0, 10), random.between(0, 10)};
      polygons.asked = random.oneIn(3) ? Point{std::round(p.x), std::round(p.y)} : p;
      const double least = random.oneIn(3) ? 0 : random.between(0, 4);
      std::uint32_t best = RingNesting::kNoRing;
      for (std::uint32_t k = 0; k < rings.size(); ++k) {
        if (areas[k] > least && boxOf(rings[k]).holds(polygons.asked) &&
            polygons.holds(k, polygons.asked) &&
            (best == RingNesting::kNoRing || areas[k] < areas[best]))
          best = k;
      }
      ASSERT_EQ(polygons.nesting.find(polygons.asked, least), best) << "run " << run;
      found += best == RingNesting::kNoRing ? 0 : 1;
    }
  }
  EXPECT_GT(found, runs(300) * 10);
}

/// Number of looks per hole to sort the holes of the first site's cell.
double looksOfEach(const std::vector<Corners>& rings, const std::vector<double>& circles) {
  NormalizedPolygon polygon;
  std::vector<double> coordinates;
  std::vector<std::uint32_t> starts{0};
  for (const Corners& ring : rings) {
    for (const Point p : ring) coordinates.insert(coordinates.end(), {p.x, p.y});
    starts.push_back(static_cast<std::uint32_t>(coordinates.size() / 2));
  }
  polygon = normalizePolygon(coordinates, starts);
  DiagramCore core(Location::kHierarchy);
  std::vector<SiteId> ids(circles.size() / 3);
  insertAll(core, circles, ids);
  const ClippedDiagram clippedDiagram(core, polygon);
  PolygonCellClipper cells(clippedDiagram, Parts::kWithArea);
  const Cell& cell = cells.find(core.ids().slotOf(ids[0]));
  EXPECT_GE(cell.ringCount(), rings.size() - 1);
  return static_cast<double>(cells.looks()) / static_cast<double>(rings.size());
}

Corners square(double x, double y, double r) {
  return {{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}};
}

/// Twice as many rings, and twice as many curved pieces around them, ask for little more than twice
/// as much. It was rings times holes, and holes times pieces.
TEST(RingNesting, WorkIsNotHolesTimesRings) {
  enum Kind { kIslands, kNested, kNestedAside, kManySizes, kCurved };
  for (const Kind kind : {kIslands, kNested, kNestedAside, kManySizes, kCurved}) {
    SCOPED_TRACE(kind);
    const auto looks = [&](int rows) {
      Random random(922);
      std::vector<Corners> rings;
      std::vector<double> circles{0, 0, 0.6 * rows};
      for (int k = 0; k < rows * rows; ++k) {
        const double x = k % rows - 0.5 * rows, y = k / rows - 0.5 * rows;
        const double size = kind == kManySizes ? 0.4 * std::exp2(-random.between(0, 20)) : 0.4;
        const double aside = kind == kNestedAside ? random.between(-0.4, 0.4) : 0;
        if (kind == kNested || kind == kNestedAside) {
          rings.push_back(square(aside, -aside, k + 1));
        } else {
          rings.push_back(square(x, y, size));
          if (kind != kCurved) rings.push_back(square(x, y, size / 2));
        }
        if (kind != kCurved) continue;
        const double angle = 2 * 3.14159265358979323846 * k / (rows * rows);
        circles.insert(circles.end(),
                       {2.0 * rows * std::cos(angle), 2.0 * rows * std::sin(angle), 0});
      }
      if (kind == kCurved) rings.push_back(square(0, 0, 4 * rows));
      return looksOfEach(rings, circles);
    };
    const int rows = runs(45);
    const double once = looks(rows), twice = looks(rows * 7 / 5);
    EXPECT_LT(once, 15 * std::log2(rows * rows));
    EXPECT_LT(twice, 1.3 * once);
  }
}

}  // namespace
}  // namespace apollonius::test
