// The hull, the disk about a site and the areas, for circles that touch, or fail to by a rounding.
// The tests do not use the curves, but hulls of sampled circles, and points whose nearest site is
// found by comparing all.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/curve/moments.h"
#include "geometry/shapes.h"
#include "support/effort.h"
#include "support/operations.h"

namespace apollonius::test {

using namespace internal;
namespace {

const double kPi = std::acos(-1.0);

/// Circles with decimal fractions for numbers; some touch others from outside, some from inside,
/// some are points on a rim, in a direction of small integers: up to rounding, to either side.
Circles decimalContacts(Random& random, std::size_t n) {
  const double unit = random.oneIn(2) ? 0.1 : 0.01;
  const auto decimal = [&](int low, int high) {
    return unit * static_cast<double>(random.integer(low, high));
  };
  Circles circles;
  while (circles.size() < n) {
    const double x = decimal(0, 40), y = decimal(0, 40), r = decimal(0, 25);
    if (circles.empty() || random.oneIn(3)) {
      circles.push_back({x, y, r});
      continue;
    }
    const Circle from = circles[random.below(circles.size())];
    const int triples[][3] = {{3, 4, 5},     {4, 3, 5}, {-3, 4, 5}, {5, -12, 13},
                              {-8, -15, 17}, {1, 0, 1}, {0, -1, 1}};
    const auto& [a, b, c] = triples[random.below(std::size_t{7})];
    const double k = decimal(1, 6);
    const double sum = c * k, other = random.oneIn(2) ? sum - from.r : from.r - sum;
    circles.push_back({from.x + a * k, from.y + b * k, std::max(0.0, random.oneIn(4) ? 0 : other)});
  }
  return circles;
}

/// The convex hull of points on all circles (Andrew's chain); area and perimeter.
void sampledHull(const Circles& circles, double& area, double& perimeter) {
  constexpr int kSamples = 4096;
  std::vector<std::pair<double, double>> points;
  for (const Circle& c : circles) {
    for (int k = 0; k < kSamples; ++k) {
      const double angle = 2 * kPi * k / kSamples;
      points.emplace_back(c.x + c.r * std::cos(angle), c.y + c.r * std::sin(angle));
    }
  }
  std::sort(points.begin(), points.end());
  std::vector<std::pair<double, double>> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t base = hull.size();
    for (const auto& p : points) {
      while (hull.size() >= base + 2) {
        const auto &a = hull[hull.size() - 2], &b = hull[hull.size() - 1];
        if ((b.first - a.first) * (p.second - a.second) -
                (b.second - a.second) * (p.first - a.first) >
            0)
          break;
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  area = perimeter = 0;
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const auto &a = hull[k], &b = hull[(k + 1) % hull.size()];
    area += (a.first * b.second - a.second * b.first) / 2;
    perimeter += std::hypot(b.first - a.first, b.second - a.second);
  }
}

/// Area and length of a drawn figure, its cubics sampled.
void measureDrawing(const Path& path, double& area, double& length) {
  area = length = 0;
  double x = 0, y = 0, startX = 0, startY = 0;
  const double* xy = path.coordinates.data();
  const auto to = [&](double nx, double ny) {
    area += (x * ny - y * nx) / 2;
    length += std::hypot(nx - x, ny - y);
    x = nx;
    y = ny;
  };
  for (const std::uint8_t command : path.commands) {
    switch (static_cast<Command>(command)) {
      case Command::kMove:
        startX = x = xy[0];
        startY = y = xy[1];
        xy += 2;
        break;
      case Command::kLine:
        to(xy[0], xy[1]);
        xy += 2;
        break;
      case Command::kCurve: {
        const double px = x, py = y;
        for (int k = 1; k <= 64; ++k) {
          const double t = k / 64.0, s = 1 - t;
          to(s * s * s * px + 3 * s * s * t * xy[0] + 3 * s * t * t * xy[2] + t * t * t * xy[4],
             s * s * s * py + 3 * s * s * t * xy[1] + 3 * s * t * t * xy[3] + t * t * t * xy[5]);
        }
        xy += 6;
        break;
      }
      case Command::kClose:
        to(startX, startY);
        break;
    }
  }
}

void checkHull(const Circles& circles) {
  Diagram diagram;
  insertInto(diagram, circles);
  Path path;
  ASSERT_EQ(Voronoi(diagram).drawHull(1e-5, path), Error::kNone);
  double area = 0, perimeter = 0, drawnArea = 0, drawnPerimeter = 0;
  sampledHull(circles, area, perimeter);
  measureDrawing(path, drawnArea, drawnPerimeter);
  EXPECT_NEAR(drawnArea, area, 1e-4 * perimeter) << toText(insertAll(circles));
  EXPECT_NEAR(drawnPerimeter, perimeter, 1e-4 * perimeter) << toText(insertAll(circles));
}

TEST(Contacts, HullsAreThoseOfSampledCircles) {
  Random random(611);
  for (int run = 0; run < runs(250) && !HasFailure(); ++run) {
    checkHull(decimalContacts(random, 2 + random.below(std::size_t{5})));
  }
}

TEST(Contacts, APointOnTheRimKeepsTheHullsArc) {
  checkHull({{0, 0, .5}, {.3, .4, 0}});
  checkHull({{.63, 0, 1.53}, {1.03, .3, 1.03}});
}

/// The share of the disk about a site where no other site is nearer, by a grid of points.
double sampledShare(const Circles& circles, std::size_t site, double radius) {
  constexpr int kSide = 160;
  int inside = 0, own = 0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double dx = (2 * i + 1.0) / kSide - 1, dy = (2 * j + 1.0) / kSide - 1;
      if (dx * dx + dy * dy > 1) continue;
      ++inside;
      const double x = circles[site].x + radius * dx, y = circles[site].y + radius * dy;
      const double distance = distanceTo(circles[site], x, y);
      own += std::all_of(circles.begin(), circles.end(),
                         [&](const Circle& c) { return distanceTo(c, x, y) >= distance - 1e-9; });
    }
  }
  return static_cast<double>(own) / inside;
}

void checkDisk(const Circles& circles, SiteId site, double radius) {
  Diagram diagram;
  insertInto(diagram, circles);
  bool hidden = false;
  ASSERT_EQ(diagram.isHidden(site, hidden), Error::kNone);
  const CellMeasures measures = measuresWithin(diagram, site, radius);
  const double share = hidden ? 0 : sampledShare(circles, site, radius);
  EXPECT_NEAR(measures.area / (kPi * radius * radius), share, 0.03)
      << "site " << site << " radius " << radius << "\n"
      << toText(insertAll(circles));
}

TEST(Contacts, DisksAreSharedAsSampled) {
  Random random(612);
  for (int run = 0; run < runs(400) && !HasFailure(); ++run) {
    const Circles circles = decimalContacts(random, 2 + random.below(std::size_t{3}));
    // Two identical circles own the same points; only one of them is visible.
    for (SiteId site = 0; site < circles.size(); ++site) {
      checkDisk(circles, site, random.oneIn(2) ? 25 : random.between(0.1, 4));
    }
  }
}

TEST(Contacts, ASliverOfACellIsNotADisk) {
  checkDisk({{.6000000000000001, .7000000000000001, 1.5}, {1.2000000000000002, 1.5, 2.5}}, 0, 25);
  checkDisk(
      {{.7, .3, 1.5000000000000002}, {3.1000000000000005, 3.5, 2.5}, {1.6, 1.5000000000000002, 0}},
      2, 35);
}

TEST(Contacts, HalfADiskOfAnyRadius) {
  // Found by geometry_fuzz: where the radius was more than 2^511 times the sites' distance, nothing
  // was left of it.
  for (int exponent = -250; exponent <= 330; exponent += 20) {
    const double radius = std::ldexp(1.0, exponent), small = 0x1p-280;
    Diagram diagram;
    insertInto(diagram, {{small, 0, small / 4}, {-small, 0, small / 4}, {0, 0.75 * small, 0}});
    const CellMeasures measures = measuresWithin(diagram, 0, radius);
    // The third site takes less than a quarter.
    EXPECT_GT(measures.area / radius / radius, kPi / 4) << exponent;
    EXPECT_LT(measures.area / radius / radius, kPi / 2 * (1 + 1e-9)) << exponent;
    EXPECT_GT(measures.perimeter / radius, 2 + kPi / 2) << exponent;
    EXPECT_LT(measures.perimeter / radius, 2 + kPi) << exponent;
  }
}

TEST(Contacts, ADiskSmallerThanTheDistanceOfDoublesIsFinite) {
  // Found by geometry_fuzz: the ends of its arcs are the centre itself, in no direction, and
  // measures were NaN.
  for (const double radius : {1e-30, 0.15, 1e15, 1e25}) {
    Diagram diagram;
    insertInto(
        diagram,
        {{1e-79, 1e36, 0}, {1.0000000000000001e-79, 1e36, 0}, {2e-79, 1e36, 0}, {1e-79, 3e36, 0}});
    for (SiteId site = 0; site < 4; ++site) {
      const CellMeasures measures = measuresWithin(diagram, site, radius);
      EXPECT_GE(measures.perimeter, 0) << radius;
      EXPECT_LE(measures.perimeter, 10 * (radius + 1e21)) << radius;
      EXPECT_LE(measures.area, 10 * (radius + 1e21) * (radius + 1e21)) << radius;
    }
  }
}

TEST(Areas, AddUpWhereSitesAreOneOrTwoDoublesApart) {
  Random random(613);
  for (int run = 0; run < runs(4000); ++run) {
    const double base = run % 3 == 0 ? 1e6 : run % 3 == 1 ? 0.5 : random.between(-1000, 1000);
    const double ulp = std::abs(std::nextafter(base, 1e9) - base);
    const int span = 1 + random.below(4), width = 8 << random.below(8);
    Circles circles;
    for (int k = 2 + random.below(6); k > 0; --k) {
      const double x = base + ulp * static_cast<double>(random.integer(-span, span));
      const double y = base + ulp * static_cast<double>(random.integer(-span, span));
      circles.push_back(
          {x, y, random.oneIn(3) ? ulp * static_cast<double>(random.integer(0, 2)) : 0});
    }
    const double left = base - ulp * static_cast<double>(random.integer(0, width));
    const double bottom = base - ulp * static_cast<double>(random.integer(0, width));
    const Bounds bounds{left, bottom, left + ulp * width, bottom + ulp * width};
    // Contacts are off by a double or two; a few on each side.
    ASSERT_NEAR(sumOfAreas(circles, bounds), 1, 8.0 / width) << "run " << run;
  }
}

TEST(Areas, AddUpInWindowsAtTheEndsOfTheRange) {
  const Circles circles{
      {1, 2, 1}, {-3, 1, 0}, {2, -4, 0.5}, {-1e-90, 1e-95, 0}, {1e60, -1e60, 1e50}};
  for (const double size : {1e-100, 1e-90, 1.0, 1e50, 1e100}) {
    for (const double shape : {1e-100, 1e-90, 1.0, 1e50, 1e100}) {
      EXPECT_NEAR(sumOfAreas(circles, {-size, -shape, size, shape}), 1, 1e-9)
          << size << " " << shape;
      EXPECT_NEAR(sumOfAreas(circles, {0, -shape, size, 0}), 1, 1e-9) << size << " " << shape;
    }
  }
}

}  // namespace
}  // namespace apollonius::test
