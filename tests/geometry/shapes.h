// Shared by the geometry tests: windows around sets of circles, and plain geometry of polygons.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "apollonius/voronoi.h"
#include "geometry/curve/moments.h"
#include "geometry/polygons/chords.h"
#include "geometry/window/rectangle_sides.h"
#include "predicate/orientation.h"
#include "support/generators.h"
#include "support/insert_into.h"

namespace apollonius::test {

using namespace internal;

/// The box of the centres, enlarged on all sides by this share of its size and moved a little off
/// centre; false if it cannot be one.
inline bool windowAround(const Circles& circles, double share, Bounds& bounds) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Circle& c : circles) {
    low = std::min({low, c.x, c.y});
    high = std::max({high, c.x, c.y});
  }
  const double size = high - low;
  bounds = {low - share * size, low - 0.9 * share * size, high + share * size,
            high + 1.1 * share * size};
  const auto isGood = [](double x) {
    return x == 0 || (std::abs(x) >= kSmallestMagnitude && std::abs(x) <= kLargestMagnitude);
  };
  return size > 0 && isGood(bounds.xmin) && isGood(bounds.ymin) && isGood(bounds.xmax) &&
         isGood(bounds.ymax) && bounds.xmin < bounds.xmax && bounds.ymin < bounds.ymax;
}

inline double areaOf(const Bounds& b) { return (b.xmax - b.xmin) * (b.ymax - b.ymin); }

/// Points of a conic within a tolerance, both ends included, as chords.h chooses them between sites
/// far on both sides of it.
inline std::vector<Point> chordsOf(const Conic& conic, double tolerance) {
  const Point away = 10 * leftOf(conic.p2 - conic.p0), center = middle(conic.p0, conic.p2);
  const RectangleSides everywhere({-1e300, -1e300, 1e300, 1e300});
  ChordFinder finder(everywhere, Tolerance{tolerance});
  const auto points = finder.find({conic, center + away, center - away});
  return {points.begin(), points.end()};
}

/// Measures of what of a cell is within a radius of its site's centre: of a reach, in a window that
/// holds the disc.
inline CellMeasures measuresWithin(const Diagram& diagram, SiteId id, double radius) {
  Circle c;
  CellMeasures measures;
  EXPECT_EQ(diagram.site(id, c), Error::kNone);
  const SiteId ids[] = {id};
  const double distances[] = {radius - c.r};
  const Reach reach(ids, distances);
  const double margin = 2 * radius + 0x1p-30 * (std::abs(c.x) + std::abs(c.y) + radius);
  const Bounds box{c.x - margin, c.y - margin, c.x + margin, c.y + margin};
  EXPECT_EQ(Voronoi(diagram, box, &reach).cellMeasures(id, measures), Error::kNone);
  return measures;
}

/// The sum of the lengths of curves.
inline double lengthOfCurves(const CurveArrays& arrays) {
  double sum = 0;
  for (std::size_t k = 0; k + 6 < arrays.curves.size(); k += 7) {
    const double* c = &arrays.curves[k];
    sum += lengthOf(Conic{{c[0], c[1]}, {c[2], c[3]}, c[4], {c[5], c[6]}});
  }
  return sum;
}

/// The drawn edges of a window, `whole`; expects the same of portions of this many commands, or a
/// few more.
inline void drawEdgesInPortions(const Voronoi& voronoi, double tolerance, std::size_t commands,
                                Path& whole) {
  Path part, joined;
  Portion all, portion{0, commands};
  ASSERT_EQ(voronoi.drawEdges(tolerance, all, whole), Error::kNone);
  EXPECT_TRUE(all.isDone);
  int portions = 0;
  for (; !portion.isDone; ++portions) {
    ASSERT_EQ(voronoi.drawEdges(tolerance, portion, part), Error::kNone);
    joined.commands.insert(joined.commands.end(), part.commands.begin(), part.commands.end());
    joined.coordinates.insert(joined.coordinates.end(), part.coordinates.begin(),
                              part.coordinates.end());
  }
  EXPECT_GT(portions, 2);
  EXPECT_EQ(joined.commands, whole.commands);
  EXPECT_EQ(joined.coordinates, whole.coordinates);
}

/// The areas of all cells in units of the window's: together, or one by one if that is further
/// off 1.
inline double sumOfAreas(const Circles& circles, const Bounds& bounds) {
  Diagram diagram;
  insertInto(diagram, circles);
  std::vector<double> areas;
  EXPECT_EQ(Voronoi(diagram, bounds).cellAreas(areas), Error::kNone);
  double sum = 0, cells = 0;
  for (const double area : areas) sum += area;
  for (SiteId id = 0; id < circles.size(); ++id) {
    CellMeasures measures;
    EXPECT_EQ(Voronoi(diagram, bounds).cellMeasures(id, measures), Error::kNone);
    cells += measures.area;
  }
  cells /= areaOf(bounds);
  sum /= areaOf(bounds);
  return std::abs(cells - 1) > std::abs(sum - 1) ? cells : sum;
}

/// Is a point inside rings? (The even-odd rule is enough: they do not overlap.)
inline bool isInside(const RingArrays& rings, double x, double y) {
  bool inside = false;
  for (std::size_t r = 0; r + 1 < rings.starts.size(); ++r) {
    for (std::size_t k = rings.starts[r]; k + 1 < rings.starts[r + 1]; ++k) {
      const double *a = &rings.coordinates[2 * k], *b = a + 2;
      if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        inside = !inside;
    }
  }
  return inside;
}

/// Signed area of rings.
inline double areaOf(const RingArrays& rings) {
  double sum = 0;
  for (std::size_t r = 0; r + 1 < rings.starts.size(); ++r) {
    const double x0 = rings.coordinates[2 * rings.starts[r]],
                 y0 = rings.coordinates[2 * rings.starts[r] + 1];
    for (std::size_t k = rings.starts[r]; k + 1 < rings.starts[r + 1]; ++k) {
      const double *a = &rings.coordinates[2 * k], *b = a + 2;
      sum += (a[0] - x0) * (b[1] - y0) - (b[0] - x0) * (a[1] - y0);
    }
  }
  return sum / 2;
}

/// Is there a proper crossing of two sides of a ring? By exact orientations.
inline bool crossesItself(const std::vector<Point>& p) {
  const std::size_t sides = p.size() - 1;
  for (std::size_t i = 0; i < sides; ++i) {
    for (std::size_t j = i + 2; j < sides; ++j) {
      const Point a = p[i], b = p[i + 1], c = p[j], d = p[j + 1];
      if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x))
        continue;
      if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
        continue;
      const auto apart = [](Sign s, Sign t) { return s * t == Sign::kNegative; };
      if (apart(orient2d(a, b, c), orient2d(a, b, d)) &&
          apart(orient2d(c, d, a), orient2d(c, d, b)))
        return true;
    }
  }
  return false;
}

inline double distanceTo(const Circle& c, double x, double y) {
  return std::sqrt((x - c.x) * (x - c.x) + (y - c.y) * (y - c.y)) - c.r;
}

}  // namespace apollonius::test
