// The drawn dual graph is an embedding (paper, Appendix A, Theorem 4): no two edges cross. And the
// hull, against its definition.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::test {
namespace {

struct Segment {
  double ax, ay, bx, by;
  std::size_t edge;
};

/// The drawn edges as short segments; every edge begins with a move.
std::vector<Segment> segmentsOf(const Path& path) {
  std::vector<Segment> segments;
  double x = 0, y = 0, startX = 0, startY = 0;
  std::size_t at = 0, edge = 0;
  const auto to = [&](double nx, double ny) {
    segments.push_back({x, y, nx, ny, edge});
    x = nx;
    y = ny;
  };
  for (const std::uint8_t command : path.commands) {
    const double* xy = path.coordinates.data() + at;
    switch (static_cast<Command>(command)) {
      case Command::kMove:
        ++edge;
        startX = x = xy[0];
        startY = y = xy[1];
        at += 2;
        break;
      case Command::kLine:
        to(xy[0], xy[1]);
        at += 2;
        break;
      case Command::kCurve: {
        const double px = x, py = y;
        for (int k = 1; k <= 24; ++k) {
          const double t = k / 24.0, s = 1 - t;
          to(s * s * s * px + 3 * s * s * t * xy[0] + 3 * s * t * t * xy[2] + t * t * t * xy[4],
             s * s * s * py + 3 * s * s * t * xy[1] + 3 * s * t * t * xy[3] + t * t * t * xy[5]);
        }
        at += 6;
        break;
      }
      case Command::kClose:
        to(startX, startY);
        break;
    }
  }
  return segments;
}

double side(const Segment& s, double x, double y) {
  return (s.bx - s.ax) * (y - s.ay) - (s.by - s.ay) * (x - s.ax);
}

/// Do two segments cross properly: is each clearly on both sides of the other, by more than
/// `margin`?
bool cross(const Segment& s, const Segment& t, double margin) {
  if (std::max(s.ax, s.bx) < std::min(t.ax, t.bx) || std::max(t.ax, t.bx) < std::min(s.ax, s.bx))
    return false;
  if (std::max(s.ay, s.by) < std::min(t.ay, t.by) || std::max(t.ay, t.by) < std::min(s.ay, s.by))
    return false;
  const double ls = std::hypot(s.bx - s.ax, s.by - s.ay), lt = std::hypot(t.bx - t.ax, t.by - t.ay);
  if (!(ls > 0 && lt > 0)) return false;
  const double a = side(s, t.ax, t.ay) / ls, b = side(s, t.bx, t.by) / ls,
               c = side(t, s.ax, s.ay) / lt, d = side(t, s.bx, s.by) / lt;
  return std::min(std::abs(a), std::abs(b)) > margin &&
         std::min(std::abs(c), std::abs(d)) > margin && (a > 0) != (b > 0) && (c > 0) != (d > 0);
}

std::size_t crossings(const std::vector<Segment>& segments, double margin) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      count += segments[i].edge != segments[j].edge && cross(segments[i], segments[j], margin);
    }
  }
  return count;
}

class DualOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(DualOn, NoTwoEdgesCross) {
  Random random(531);
  for (int run = 0; run < runs(6); ++run) {
    const Circles circles =
        GetParam().make(random, GetParam().large ? 12 + static_cast<std::size_t>(run) : 7);
    Bounds bounds;
    if (!windowAround(circles, 0.2, bounds)) continue;
    Diagram diagram;
    insertInto(diagram, circles);
    const Voronoi voronoi(diagram, bounds);
    const double size = bounds.xmax - bounds.xmin;
    Path path;
    Portion portion;
    ASSERT_EQ(voronoi.drawDual(size * 1e-7, true, portion, path), Error::kNone);
    ASSERT_TRUE(portion.isDone);
    for (const double number : path.coordinates) ASSERT_TRUE(std::isfinite(number));
    const std::vector<Segment> segments = segmentsOf(path);
    if (segments.size() > 6000) continue;
    // Curves are sampled: chords of a strongly bent one may cut a neighbour off by the sampling's
    // own error.
    ASSERT_EQ(crossings(segments, size * 2e-4), 0u) << "run " << run;
  }
}

TEST_P(DualOn, OneCurveForEachEdge) {
  Random random(532);
  const Circles circles = GetParam().make(random, GetParam().large ? 60 : 8);
  Diagram diagram;
  insertInto(diagram, circles);
  EdgeArrays edges;
  ASSERT_EQ(diagram.edges(edges), Error::kNone);
  Path path;
  Portion portion;
  ASSERT_EQ(Voronoi(diagram).drawDual(1, false, portion, path), Error::kNone);
  const auto moves = std::count(path.commands.begin(), path.commands.end(),
                                static_cast<std::uint8_t>(Command::kMove));
  EXPECT_EQ(static_cast<std::size_t>(moves), edges.sites.size() / 2);
}

TEST_P(DualOn, HullHoldsAllCirclesAndTouchesIt) {
  Random random(533);
  for (int run = 0; run < runs(8); ++run) {
    Circles circles =
        GetParam().make(random, GetParam().large ? 3 + 8 * static_cast<std::size_t>(run) : 6);
    for (Circle& c : circles) c.r = std::max(c.r, 0.0);
    Bounds bounds;
    if (!windowAround(circles, 1, bounds)) continue;
    Diagram diagram;
    insertInto(diagram, circles);
    std::vector<SiteId> sites;
    ASSERT_EQ(diagram.hull(sites), Error::kNone);
    Path path;
    double largest = 0;
    for (const Circle& c : circles) largest = std::max(largest, c.r);
    const double size = bounds.xmax - bounds.xmin + largest, tolerance = size * 1e-6;
    ASSERT_EQ(Voronoi(diagram, bounds).drawHull(tolerance, path), Error::kNone);
    ASSERT_FALSE(path.commands.empty());
    std::vector<Segment> polygon = segmentsOf(path);
    for (int k = 0; k < 64; ++k) {
      // The support function: the furthest point in a direction, of all circles, of the listed
      // sites, and of the drawing.
      const Direction d = randomDirection(random);
      double all = -1e300, listed = -1e300, drawn = -1e300;
      for (const Circle& c : circles) all = std::max(all, c.x * d.x + c.y * d.y + c.r);
      for (const SiteId id : sites)
        listed = std::max(listed, circles[id].x * d.x + circles[id].y * d.y + circles[id].r);
      for (const Segment& s : polygon)
        drawn = std::max({drawn, s.ax * d.x + s.ay * d.y, s.bx * d.x + s.by * d.y});
      if (polygon.empty()) drawn = path.coordinates[0] * d.x + path.coordinates[1] * d.y;
      ASSERT_NEAR(all, listed, 1e-13 * size) << "run " << run;
      ASSERT_NEAR(all, drawn, 4e-3 * largest + 4 * tolerance)
          << "run " << run;  // arcs are sampled every few degrees
      ASSERT_LE(drawn, all + 2 * tolerance);
    }
    // Convex and counter-clockwise: it turns left everywhere, up to the tolerance.
    double area = 0;
    for (const Segment& s : polygon)
      area +=
          (s.ax - bounds.xmin) * (s.by - bounds.ymin) - (s.bx - bounds.xmin) * (s.ay - bounds.ymin);
    ASSERT_GE(area, -size * tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, DualOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

/// Decimal fractions: triples in line and quadruples on a circle up to rounding, so that Voronoi
/// circles are far larger than everything else, or nearly the same.
Circles decimalSet(Random& random, int kind) {
  Circles circles;
  const double step = kind == 3 ? 8.53e-9 : 0.1;
  const std::size_t n = 4 + random.below(std::size_t{17});
  for (std::size_t k = 0; k < n; ++k) {
    const auto i = static_cast<double>(random.integer(0, 9)),
               j = static_cast<double>(random.integer(0, 9));
    const double r =
        kind == 1 && random.oneIn(3) ? step * static_cast<double>(random.integer(0, 3)) : 0;
    const double y = kind == 2 ? 0.3 * i + (random.oneIn(4) ? 0.1 * j : 0) : step * j;
    circles.push_back({step * i, y, r});
  }
  return circles;
}

Path drawnDual(const Circles& circles, const Bounds& bounds, double tolerance) {
  Diagram diagram;
  insertInto(diagram, circles);
  Path path;
  Portion portion;
  EXPECT_EQ(Voronoi(diagram, bounds).drawDual(tolerance, true, portion, path), Error::kNone);
  return path;
}

/// Segments cut where they leave the surroundings of the sites. An edge around a Voronoi circle
/// that is 10^15 times as large as everything else goes there and comes back a site's distance
/// away, which doubles cannot tell apart there.
std::vector<Segment> nearPart(const std::vector<Segment>& segments, double size) {
  std::vector<Segment> near;
  for (Segment s : segments) {
    const double far = 1000 * size, a = std::hypot(s.ax, s.ay), b = std::hypot(s.bx, s.by);
    if (a > far && b > far) continue;
    const auto cut = [&](double& x, double& y, double fromX, double fromY) {
      const double share = far / (std::abs(x - fromX) + std::abs(y - fromY));
      if (share >= 1) return;
      x = fromX + share * (x - fromX);
      y = fromY + share * (y - fromY);
    };
    if (b > a) {
      cut(s.bx, s.by, s.ax, s.ay);
    } else {
      cut(s.ax, s.ay, s.bx, s.by);
    }
    near.push_back(s);
  }
  return near;
}

TEST(Dual, EdgesOfDecimalSetsDoNotCross) {
  Random random(534);
  for (int run = 0; run < runs(200); ++run) {
    const Circles circles = decimalSet(random, run % 4);
    Bounds bounds;
    if (!windowAround(circles, 0.2, bounds)) continue;
    const double size = bounds.xmax - bounds.xmin;
    ASSERT_EQ(
        crossings(nearPart(segmentsOf(drawnDual(circles, bounds, size * 1e-7)), size), size * 2e-4),
        0u)
        << "run " << run << "\n"
        << toText(insertAll(circles));
  }
  const Circles flat{
      {.8, .5, 0}, {.9, .30000000000000004, 0}, {.6000000000000001, .9, 0}, {.3, .3, 0}};
  EXPECT_EQ(crossings(nearPart(segmentsOf(drawnDual(flat, {0, 0, 1, 1}, 1e-7)), 1), 2e-4), 0u);
}

TEST(Dual, EdgesAreWhereTwoVoronoiCirclesAreNearest) {
  // Appendix A by its definition: the embedding is the Voronoi diagram of the Voronoi circles.
  // (Edges with an end at infinity have a half-plane for one of their circles, and are left out.)
  Random random(535);
  int checked = 0;
  for (int run = 0; run < runs(100); ++run) {
    const Circles circles =
        run % 5 == 4 ? randomCircles(random, 30, Hidden::k20Percent) : decimalSet(random, run % 5);
    Bounds bounds;
    if (!windowAround(circles, 0.2, bounds)) continue;
    const double size = bounds.xmax - bounds.xmin, tolerance = 1e-9 * size;
    Diagram diagram;
    insertInto(diagram, circles);
    VertexArrays vertices;
    EdgeArrays edges;
    ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
    ASSERT_EQ(diagram.edges(edges), Error::kNone);
    // A distance to a circle that is far larger than its sites has no digits left.
    const auto isFar = [&](double s) { return s > 1e6 * size; };
    if (std::any_of(vertices.clearance.begin(), vertices.clearance.end(), isFar)) continue;
    std::set<std::array<double, 4>> unbounded;
    for (std::size_t k = 0; k < edges.sites.size(); k += 2) {
      if (edges.vertices[k] >= 0 && edges.vertices[k + 1] >= 0) continue;
      const Circle &a = circles[edges.sites[k]], &b = circles[edges.sites[k + 1]];
      unbounded.insert({a.x, a.y, b.x, b.y});
      unbounded.insert({b.x, b.y, a.x, a.y});
    }
    const std::vector<Segment> segments = segmentsOf(drawnDual(circles, bounds, tolerance));
    for (std::size_t first = 0, end = 0; first < segments.size(); first = end) {
      while (end < segments.size() && segments[end].edge == segments[first].edge) ++end;
      const Segment &head = segments[first], &tail = segments[end - 1];
      if (unbounded.contains({head.ax, head.ay, tail.bx, tail.by})) continue;
      for (std::size_t k = first; k + 1 < end; ++k) {
        const double x = segments[k].bx, y = segments[k].by;
        double nearest = 1e300, second = 1e300;
        for (std::size_t v = 0; v < vertices.clearance.size(); ++v) {
          const double dx = vertices.coordinates[2 * v] - x,
                       dy = vertices.coordinates[2 * v + 1] - y;
          const double distance = std::hypot(dx, dy) - vertices.clearance[v];
          second = std::min(second, std::max(nearest, distance));
          nearest = std::min(nearest, distance);
        }
        ASSERT_LE(second - nearest, 1e-7 * size) << "run " << run << " at " << x << " " << y << "\n"
                                                 << toText(insertAll(circles));
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, runs(500));
}

TEST(Dual, TheRayOfALargeCircleLeavesOnItsFarSide) {
  // A point just outside the rim: nearly all directions are the large circle's, and the middle of
  // them is opposite to the point.
  const Path path = drawnDual({{0, 0, .5}, {.3, .4, 0}}, {-5, -5, 5, 5}, 1e-3);
  bool isFound = false;
  for (std::size_t k = 0; k + 1 < path.coordinates.size(); k += 2) {
    isFound |= path.coordinates[k + 1] == -5 && std::abs(path.coordinates[k] + 3.75) < 1e-9;
  }
  EXPECT_TRUE(isFound);
}

TEST(Hull, OneSiteAndNone) {
  Diagram diagram;
  std::vector<SiteId> sites{7};
  Path path;
  EXPECT_EQ(diagram.hull(sites), Error::kNone);
  EXPECT_TRUE(sites.empty());
  EXPECT_EQ(Voronoi(diagram).drawHull(0.1, path), Error::kNone);
  EXPECT_TRUE(path.commands.empty());
  insertInto(diagram, {{3, 4, 2}});
  EXPECT_EQ(diagram.hull(sites), Error::kNone);
  EXPECT_EQ(sites, std::vector<SiteId>{0});
  EXPECT_EQ(Voronoi(diagram).drawHull(0.1, path), Error::kNone);
  EXPECT_EQ(path.commands.size(), 6u) << "move, four quarters, close";
}

TEST(Hull, OnePoint) {
  Diagram diagram;
  insertInto(diagram, {{3, 4, 0}});
  Path path;
  EXPECT_EQ(Voronoi(diagram).drawHull(0.1, path), Error::kNone);
  EXPECT_EQ(path.commands.size(), 2u) << "move, close";
  EXPECT_EQ(path.coordinates, (std::vector<double>{3, 4}));
}

TEST(Hull, ALargeCircleWithSmallOnesSticksOutBetweenThem) {
  Diagram diagram;
  insertInto(diagram, {{0, 0, 10}, {10, 0, 1}, {-10, 0, 1}, {0, 10, 1}});
  std::vector<SiteId> sites;
  ASSERT_EQ(diagram.hull(sites), Error::kNone);
  EXPECT_EQ(sites.size(), 6u);
  EXPECT_EQ(std::count(sites.begin(), sites.end(), 0u), 3) << "once between each two of the others";
}

}  // namespace
}  // namespace apollonius::test
