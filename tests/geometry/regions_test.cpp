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
  /// Does it hold a point? By a plain even-odd rule.
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

/// Checks what must be true of any region on any diagram, with areas right to a share of the box.
void check(const Diagram& diagram, const Circles& circles, const Rings& rings, Random& random,
           const std::string& where, double rounding = 1e-12) {
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
    ASSERT_NEAR(one.area / whole, areas[id] / whole, rounding) << "site " << id << " " << where;
    if (one.area > 1e-6 * whole) {
      ASSERT_NEAR(one.centroidX, centroids[2 * id], 1e-6 * span) << "site " << id << " " << where;
      ASSERT_NEAR(one.centroidY, centroids[2 * id + 1], 1e-6 * span);
      ASSERT_NEAR(one.perimeter, perimeters[id], 1e-6 * span) << "site " << id << " " << where;
    }
    ASSERT_EQ(voronoi.cellPolygon(id, tolerance, polygons[id]), Error::kNone);
    CurveArrays cell;
    ASSERT_EQ(voronoi.cellCurves(id, cell), Error::kNone);
    for (std::size_t ring = 0; ring + 1 < cell.starts.size(); ++ring) {
      const std::uint32_t begin = cell.starts[ring], end = cell.starts[ring + 1];
      for (std::uint32_t k = begin; k < end; ++k) {
        const double *c = &cell.curves[7 * k],
                     *next = &cell.curves[7 * (k + 1 < end ? k + 1 : begin)];
        ASSERT_TRUE(c[5] == next[0] && c[6] == next[1]) << "a gap, site " << id << " " << where;
      }
    }
  }
  if (diagram.visibleSize() > 0) {
    ASSERT_NEAR(sum / whole, region.area() / whole, rounding) << where;
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
  for (int run = 0; run < runs(sized(2000, 6000)); ++run) {
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

TEST(Regions, RectanglesFarLargerThanWhatIsInThem) {
  // A corner is rounded to more than the sites are apart: a cell is left late, or is another one at
  // the segment's end than on the way. (Found by RectanglesAreBounds with other seeds.)
  const Circles sets[] = {
      {{1.1704718019863808e-86, 8.9183208769623363e-61, 0},
       {4.0573293918520891e+53, 0, 0},
       {-6.1706062031535204e+81, 1.2782386729754953e+23, 0},
       {1.4183297430367064e+48, 4.8196978806491166e-77, 0},
       {0, 4.6536047973189672e+29, 0},
       {0, -9.2228059247961906e-38, -2.8767985272820695e-77}},
      {{3.836191500367187e-42, 0, -1287069861310.7908},
       {3.1596743774954455e-55, -7033215486864.5, 0},
       {8.8897589585468339e-61, 0, 0},
       {0, 2.704958293892862e+19, 2.6263647506220512e-11},
       {-4.5962229245021446e+63, -9.1619288439815838e-49, 0},
       {8.1371934791515842e-36, 1.2227982333708516e-52, -5.359446335204859e+89}}};
  for (const Circles& circles : sets) {
    Diagram diagram;
    insertInto(diagram, circles);
    Bounds bounds;
    ASSERT_TRUE(windowAround(circles, 0, bounds));
    const Region region = regionOf(rectangle(bounds));
    std::vector<double> areas, expected;
    ASSERT_EQ(Voronoi(diagram, region).cellAreas(areas), Error::kNone);
    ASSERT_EQ(Voronoi(diagram, bounds).cellAreas(expected), Error::kNone);
    for (std::size_t id = 0; id < areas.size(); ++id)
      EXPECT_NEAR(areas[id] / areaOf(bounds), expected[id] / areaOf(bounds), 1e-11) << id;
  }
}

TEST(Regions, CrossingsAtSmallAnglesAreRoundedOnce) {
  // Decimal rings, some of whose sides are next to parallel: the doubles between two of them were
  // tried one by one, or their crossing was 0/0. Parts of the region were missing.
  Random random(815);
  const auto checkRings = [&](const Rings& rings, const Circles& circles) {
    Diagram diagram;
    insertInto(diagram, circles);
    for (int k = 0; k < 20; ++k) check(diagram, circles, rings, random, "");
  };
  Rings rings;
  rings.add({0.10000000000000001, 0, 0.050000000000000003, 0.25, 0.10000000000000001,
             -0.10000000000000001, 0.25, 0.25});
  rings.add({0.30000000000000004, 0.10000000000000001, 0.20000000000000001, 0.15000000000000002,
             0.050000000000000003, 0.25, 0.30000000000000004, 0.10000000000000001,
             0.050000000000000003, 0.050000000000000003, 0.30000000000000004, 0.050000000000000003,
             0.25, -0.050000000000000003, 0.30000000000000004, 0.050000000000000003});
  rings.add({0, 0.20000000000000001, -0.10000000000000001, 0.25, 0.050000000000000003,
             -0.10000000000000001, 0.050000000000000003, 0.30000000000000004, -0.050000000000000003,
             0.30000000000000004, 0.15000000000000002, 0.15000000000000002, 0,
             0.30000000000000004});
  checkRings(rings, {{0.10000000000000001, 0.10000000000000001, 0},
                     {0.10000000000000001, 0.10000000000000001, 0},
                     {0.10000000000000001, 0.10000000000000001, 0}});
  rings = {};
  rings.add({0.70000000000000007, 0, 0.60000000000000009, 0.5, 0.60000000000000009,
             0.80000000000000004, 0.20000000000000001, 0.60000000000000009, 0.5,
             0.70000000000000007, -0.10000000000000001, 0.90000000000000002});
  rings.add({0.10000000000000001, 0, 0.10000000000000001, 0, 0.70000000000000007,
             0.60000000000000009, 0, 0, 0.5, 0, 0.60000000000000009, -0.10000000000000001,
             0.80000000000000004, 0.80000000000000004});
  rings.add({0.60000000000000009, 0.5, -0.20000000000000001, 0.90000000000000002,
             0.40000000000000002, 0.60000000000000009, 0.5, -0.20000000000000001, 0,
             0.20000000000000001, -0.10000000000000001, 0.20000000000000001, 0.90000000000000002,
             0});
  checkRings(rings, {{0, 0.5, 0},
                     {0.5, 0.5, 0.10000000000000001},
                     {0.5, 0.70000000000000007, 0.20000000000000001},
                     {0.60000000000000009, 0.70000000000000007, 0.10000000000000001},
                     {0.20000000000000001, 0.10000000000000001, 0.20000000000000001}});
}

TEST(Regions, SidesTouchCurvedEdgesWithoutCrossingThem) {
  // At a point from which the centres lie in the directions u and v, their bisector goes along
  // u + v. Pythagorean directions make all of it integers: the side of a ring touches the bisector
  // exactly, from the concave side, and what rounding says of the two places where they meet is
  // anything. (Found by regions_fuzz: there the walk left the reference site's cell for good.)
  struct Direction {
    int x, y, length;
  };
  constexpr Direction kDirections[] = {{3, 4, 5},   {4, 3, 5},    {-5, 12, 13}, {-12, 5, 13},
                                       {8, 15, 17}, {-15, 8, 17}, {7, -24, 25}, {-20, -21, 29}};
  Random random(814);
  for (int run = 0; run < runs(sized(1000, 3000)); ++run) {
    const Direction u = kDirections[random.below(std::size(kDirections))],
                    v = kDirections[random.below(std::size(kDirections))];
    if (u.x * v.y == u.y * v.x) continue;
    const double unit = random.oneIn(2) ? 1 : 0.1;
    const auto integer = [&](int low, int high) {
      return static_cast<double>(random.integer(low, high));
    };
    const double x = integer(-9, 9), y = integer(-9, 9), k = integer(1, 9), m = integer(1, 9),
                 weight = integer(-5, 5);
    Circles circles{{x + k * u.x, y + k * u.y, k * u.length + weight},
                    {x + m * v.x, y + m * v.y, m * v.length + weight}};
    for (int more = static_cast<int>(random.integer(0, 6)); more > 0; --more)
      circles.push_back({integer(-300, 300), integer(-300, 300), integer(-50, 50)});
    const double wayX = u.x * v.length + v.x * u.length, wayY = u.y * v.length + v.y * u.length;
    const double before = integer(0, 3), after = integer(1, 3);
    std::vector<double> ring{x - before * wayX, y - before * wayY, x + after * wayX,
                             y + after * wayY};
    const int corners = static_cast<int>(random.integer(1, 3));
    for (int c = 0; c < corners; ++c)
      ring.insert(ring.end(), {integer(-200, 200), integer(-200, 200)});
    for (double& coordinate : ring) coordinate *= unit;
    for (Circle& c : circles) c = {c.x * unit, c.y * unit, c.r * unit};
    Diagram diagram;
    insertInto(diagram, circles);
    // Where two curves touch, a place is right to half the digits only.
    check(diagram, circles, Rings().add(ring), random, "run " + std::to_string(run), 1e-9);
    if (HasFatalFailure()) return;
  }
}

TEST(Regions, CornersWhereManyCellsMeet) {
  // All circles are as far from one point, exactly, and much further than the rings are wide, which
  // have a corner there. (Found by regions_fuzz: with the side's end just behind the vertex, the
  // walk left for a cell whose edge is ten thousand times as far away as the ring is wide.)
  constexpr double kTriples[][3] = {{3, 4, 5},    {4, 3, 5},    {5, 12, 13},  {12, 5, 13},
                                    {8, 15, 17},  {15, 8, 17},  {7, 24, 25},  {24, 7, 25},
                                    {20, 21, 29}, {21, 20, 29}, {12, 35, 37}, {9, 40, 41}};
  Random random(815);
  const auto integer = [&](int low, int high) {
    return static_cast<double>(random.integer(low, high));
  };
  for (int run = 0; run < runs(300); ++run) {
    const double distance = integer(0, 3) * 1000;
    Circles circles;
    for (int more = static_cast<int>(random.integer(3, 12)); more > 0; --more) {
      const double* const t = kTriples[random.below(std::size(kTriples))];
      const double k = integer(1, random.oneIn(3) ? 9 : 9000);
      circles.push_back({k * (random.oneIn(2) ? t[0] : -t[0]), k * (random.oneIn(2) ? t[1] : -t[1]),
                         k * t[2] - distance});
    }
    std::vector<double> ring{0, 0};
    for (int c = static_cast<int>(random.integer(2, 6)); c > 0; --c)
      ring.insert(ring.end(), {integer(-3, 3), integer(-3, 3)});
    Diagram diagram;
    insertInto(diagram, circles);
    check(diagram, circles, Rings().add(ring), random, "run " + std::to_string(run), 1e-9);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace apollonius::test
