// Windows of any shape against brute force: areas that add up, rectangles against bounds, points
// against the nearest site and the even-odd rule, and shapes on everything that is degenerate.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/shapes.h"
#include "number/fp.h"
#include "support/corpus.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

/// Rings as the interface takes them.
struct Rings {
  std::vector<double> coordinates;
  std::vector<std::uint32_t> starts{0};

  Rings& add(std::initializer_list<double> ring) { return add(std::vector<double>(ring)); }
  Rings& add(const std::vector<double>& ring) {
    coordinates.insert(coordinates.end(), ring.begin(), ring.end());
    starts.push_back(static_cast<std::uint32_t>(coordinates.size() / 2));
    return *this;
  }
  /// By the even-odd rule, as anyone would write it.
  [[nodiscard]] bool holds(double x, double y) const {
    bool inside = false;
    for (std::size_t r = 0; r + 1 < starts.size(); ++r) {
      for (std::size_t k = starts[r]; k < starts[r + 1]; ++k) {
        const std::size_t m = k + 1 < starts[r + 1] ? k + 1 : starts[r];
        const double *a = &coordinates[2 * k], *b = &coordinates[2 * m];
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
          inside = !inside;
      }
    }
    return inside;
  }
};

Rings rectangle(const Bounds& b) {
  return Rings().add({b.xmin, b.ymin, b.xmax, b.ymin, b.xmax, b.ymax, b.xmin, b.ymax});
}

Region regionOf(const Rings& rings) {
  Region region;
  EXPECT_EQ(region.assign(rings.coordinates, rings.starts), Error::kNone);
  return region;
}

/// A ring of random points in a box: crosses itself.
std::vector<double> scribble(Random& random, const Bounds& box, int count) {
  std::vector<double> ring;
  for (int k = 0; k < count; ++k) {
    ring.push_back(random.between(box.xmin, box.xmax));
    ring.push_back(random.between(box.ymin, box.ymax));
  }
  return ring;
}

/// What must be true of any region on any diagram; `tolerance` for the raster.
void check(const Diagram& diagram, const Circles& circles, const Rings& rings, Random& random,
           const std::string& where) {
  Region region;
  const Error error = region.assign(rings.coordinates, rings.starts);
  if (error == Error::kBadBounds) return;  // nothing is inside
  ASSERT_EQ(error, Error::kNone);
  const Voronoi voronoi(diagram, region);
  const Bounds box = region.box();
  const double whole = areaOf(box);
  std::vector<double> areas, centroids, perimeters;
  ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
  ASSERT_EQ(voronoi.cellCentroids(centroids), Error::kNone);
  ASSERT_EQ(voronoi.cellPerimeters(perimeters), Error::kNone);
  double sum = 0;
  std::vector<RingArrays> polygons(circles.size());
  const double tolerance = 1e-4 * (box.xmax - box.xmin + box.ymax - box.ymin);
  const double span = perimeters.empty() ? 0 : box.xmax - box.xmin + box.ymax - box.ymin;
  for (SiteId id = 0; id < areas.size(); ++id) {
    sum += areas[id];
    CellMeasures one;
    ASSERT_EQ(voronoi.cellMeasures(id, one), Error::kNone);
    ASSERT_NEAR(one.area / whole, areas[id] / whole, 1e-12) << "site " << id << " " << where;
    if (one.area > 1e-6 * whole) {
      ASSERT_NEAR(one.centroidX, centroids[2 * id], 1e-6 * span) << "site " << id << " " << where;
      ASSERT_NEAR(one.centroidY, centroids[2 * id + 1], 1e-6 * span);
      ASSERT_NEAR(one.perimeter, perimeters[id], 1e-6 * span) << "site " << id << " " << where;
    }
    ASSERT_EQ(voronoi.cellPolygon(id, tolerance, polygons[id]), Error::kNone);
    CurveArrays cell;
    ASSERT_EQ(voronoi.cellCurves(id, cell), Error::kNone);
    for (std::size_t ring = 0; ring + 1 < cell.regions.size(); ++ring) {
      const std::uint32_t begin = cell.regions[ring], end = cell.regions[ring + 1];
      for (std::uint32_t k = begin; k < end; ++k) {
        const double *c = &cell.curves[7 * k],
                     *next = &cell.curves[7 * (k + 1 < end ? k + 1 : begin)];
        ASSERT_TRUE(c[5] == next[0] && c[6] == next[1]) << "a gap, site " << id << " " << where;
      }
    }
  }
  if (diagram.visibleSize() > 0) {
    ASSERT_NEAR(sum / whole, region.area() / whole, 1e-12) << where;
  }
  for (int k = 0; k < 30; ++k) {
    const double x = random.between(box.xmin, box.xmax), y = random.between(box.ymin, box.ymax);
    if (std::abs(x) < kSmallestMagnitude || std::abs(y) < kSmallestMagnitude) continue;
    SiteId nearest = kNoSite;
    double distance = 0, second = std::numeric_limits<double>::infinity();
    ASSERT_EQ(diagram.find(x, y, nearest, distance), Error::kNone);
    for (SiteId id = 0; id < circles.size(); ++id) {
      bool hidden = false;
      ASSERT_EQ(diagram.isHidden(id, hidden), Error::kNone);
      if (id != nearest && !hidden) second = std::min(second, distanceTo(circles[id], x, y));
    }
    if (!(second - distance > 2.5 * tolerance)) continue;
    const bool isInside = rings.holds(x, y);
    for (SiteId id = 0; id < circles.size(); ++id) {
      ASSERT_EQ(test::isInside(polygons[id], x, y), isInside && id == nearest)
          << "site " << id << " at " << x << " " << y << " " << where;
    }
  }
}

class RegionsOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(RegionsOn, RectanglesAreBounds) {
  Random random(811);
  for (int run = 0; run < runs(6); ++run) {
    const Circles circles =
        GetParam().make(random, GetParam().large ? 5 + 25 * static_cast<std::size_t>(run) : 6);
    Diagram diagram;
    insertInto(diagram, circles);
    for (const double share : {0.0, -0.3, 0.4, 3.0}) {
      Bounds bounds;
      if (!windowAround(circles, share, bounds)) continue;
      const Region region = regionOf(rectangle(bounds));
      const Voronoi voronoi(diagram, region), plain(diagram, bounds);
      std::vector<double> areas, expected;
      ASSERT_EQ(voronoi.cellAreas(areas), Error::kNone);
      ASSERT_EQ(plain.cellAreas(expected), Error::kNone);
      ASSERT_EQ(areas.size(), expected.size());
      // Where the window is only a few doubles wide, coordinates are rounded by a share of it.
      const double doubles = std::max(std::abs(bounds.xmin), std::abs(bounds.ymax)) /
                             (bounds.xmax - bounds.xmin) * powerOfTwo(-50);
      for (std::size_t id = 0; id < areas.size(); ++id) {
        ASSERT_NEAR(areas[id] / areaOf(bounds), expected[id] / areaOf(bounds), 1e-11 + doubles)
            << "site " << id << " run " << run << " share " << share;
      }
    }
  }
}

TEST_P(RegionsOn, ScribblesFollowTheEvenOddRule) {
  Random random(812);
  for (int run = 0; run < runs(8); ++run) {
    const Circles circles = GetParam().make(random, GetParam().large ? 30 : 7);
    Diagram diagram;
    insertInto(diagram, circles);
    for (const double share : {0.0, 0.4}) {
      Bounds bounds;
      if (!windowAround(circles, share, bounds)) continue;
      Rings rings;
      for (int ring = 0; ring <= run % 3; ++ring)
        rings.add(scribble(random, bounds, 3 + 2 * (run % 5)));
      check(diagram, circles, rings, random, "run " + std::to_string(run));
      if (HasFatalFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, RegionsOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Regions, IntegerShapesOnIntegerCircles) {
  // Corners on sites, vertices and edges, sides along edges, rings that touch and overlap: nearly
  // every run has some. Once as they are and once times 0.1, where rounding puts everything next
  // to where it should be.
  Random random(813);
  for (int run = 0; run < runs(6000); ++run) {
    const int size = 1 + 2 * random.below(5);
    Circles circles = tinyGrid(random, 1 + random.below(std::size_t{9}), size, random.below(5));
    const double unit = random.oneIn(2) ? 1 : 0.1, step = random.oneIn(2) ? 1 : 0.5;
    for (Circle& c : circles) c = {c.x * unit, c.y * unit, c.r * unit};
    Rings rings;
    for (int ring = static_cast<int>(random.integer(0, 2)); ring >= 0; --ring) {
      std::vector<double> points;
      const auto coordinate = [&] {
        return unit * step *
               static_cast<double>(random.integer(-2, static_cast<int>((size + 2) / step)));
      };
      if (random.oneIn(2)) {
        for (int k = static_cast<int>(random.integer(3, 8)); k > 0; --k)
          points.insert(points.end(), {coordinate(), coordinate()});
      } else {
        const double a = coordinate(), b = coordinate(), c = coordinate(), d = coordinate();
        points = {a, b, c, b, c, d, a, d};
      }
      rings.add(points);
    }
    Diagram diagram;
    insertInto(diagram, circles);
    check(diagram, circles, rings, random, "run " + std::to_string(run));
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace apollonius::test
