#include "bench/sites/families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "support/generators.h"

namespace apollonius::bench {

namespace {

using test::Circles;
using test::Random;

constexpr std::uint64_t kSeed = 20020917;  // ESA 2002, where the paper was presented
constexpr double kHalfSide = 1e6;          // as in the paper: centres in [-kHalfSide, kHalfSide]^2

/// Table 1's "h/n = 1.00": the paper's own numbers (99 995 of 100 000, 999 351 of 1 000 000) are
/// not points, but few hidden sites.
constexpr double kNearlyAllVisible = 0.0437;

SiteSet random(Random& numbers, std::size_t n, test::Hidden hidden) {
  return {test::randomCircles(numbers, n, hidden)};
}

/// Like randomCircles, with R = factor * side / sqrt(n).
SiteSet randomWithFactor(Random& numbers, std::size_t n, double factor) {
  const double largest = factor * 2 * kHalfSide / std::sqrt(static_cast<double>(n));
  Circles circles = test::randomCircles(numbers, n, test::Hidden::kNone);
  for (Circle& circle : circles) circle.r = largest * numbers.unit();
  return {std::move(circles)};
}

SiteSet lattice(Random& numbers, std::size_t n, double spacing, double r) {
  const int columns = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(n))));
  const int rows = static_cast<int>((n + columns - 1) / columns);
  Circles circles = test::lattice(numbers, columns, rows, spacing, r);
  circles.resize(n);  // at most one row's worth of random gaps
  return {std::move(circles), spacing};
}

/// Equal circles with centres cos, sin on one circle: cocircular up to rounding.
SiteSet cocircular(Random& numbers, std::size_t n) {
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const double angle = 2 * 3.141592653589793 * static_cast<double>(k) / static_cast<double>(n);
    circles.push_back({kHalfSide * std::cos(angle), kHalfSide * std::sin(angle), 1});
  }
  numbers.shuffle(circles);
  return {std::move(circles), 1000};
}

SiteSet collinear(Random& numbers, std::size_t n) {
  return {test::collinear(numbers, n, test::Line::kRandomSlope, true, 1), 10};
}

/// A hundred clusters, a thousandth of the square wide each (the sum of four uniform numbers is
/// nearly normal).
SiteSet clustered(Random& numbers, std::size_t n) {
  constexpr double kWidth = 2e3;
  std::array<Point, 100> centres;
  for (Point& centre : centres)
    centre = {numbers.between(-kHalfSide, kHalfSide), numbers.between(-kHalfSide, kHalfSide)};
  const double spacing = kWidth / std::sqrt(static_cast<double>(n) / centres.size() + 1);
  const auto offset = [&] {
    return kWidth * (numbers.unit() + numbers.unit() + numbers.unit() + numbers.unit() - 2);
  };
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const Point centre = centres[numbers.below(centres.size())];
    const double x = centre.x + offset();
    circles.push_back({x, centre.y + offset(), 0.45 * spacing * numbers.unit()});
  }
  return {std::move(circles), spacing};
}

/// Radii over six orders of magnitude, the largest as large as it can be with most sites visible at
/// every n.
SiteSet powerLaw(Random& numbers, std::size_t n) {
  Circles circles = test::powerLaw(numbers, n);
  const double scale = std::sqrt(1000 / static_cast<double>(n));
  for (Circle& circle : circles) circle.r *= scale;
  return {std::move(circles)};
}

/// Points (k, row) for all k, row by row: a line for one row.
SiteSet rowByRow(std::size_t n, std::size_t rows) {
  Circles circles;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t perRow = (n + rows - 1) / rows;
    circles.push_back({static_cast<double>(k % perRow), static_cast<double>(k / perRow), 0});
  }
  return {std::move(circles), 1};
}

std::size_t sideOf(std::size_t n) {
  return static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
}

SiteSet shuffled(Random& numbers, SiteSet sites) {
  numbers.shuffle(sites.circles);
  return sites;
}

/// Circles k = 1 … n about (k spread, 0) with radius k: concentric for 0, each touching the next
/// from inside for 1.
SiteSet nested(Random& numbers, std::size_t n, double spread) {
  Circles circles;
  for (std::size_t k = 1; k <= n; ++k)
    circles.push_back({spread * static_cast<double>(k), 0, static_cast<double>(k)});
  return shuffled(numbers, {std::move(circles), 1});
}

struct Family {
  std::string_view name;
  SiteSet (*make)(Random&, std::size_t);
};

constexpr Family kFamilies[] = {
    // Table 1's four ratios: the digits are the percentage of hidden sites.
    {"random0", [](Random& numbers,
                   std::size_t n) { return randomWithFactor(numbers, n, kNearlyAllVisible); }},
    {"random5",
     [](Random& numbers, std::size_t n) { return random(numbers, n, test::Hidden::k5Percent); }},
    {"random20",
     [](Random& numbers, std::size_t n) { return random(numbers, n, test::Hidden::k20Percent); }},
    {"random50",
     [](Random& numbers, std::size_t n) { return random(numbers, n, test::Hidden::k50Percent); }},
    {"lattice", [](Random& numbers, std::size_t n) { return lattice(numbers, n, 4, 1); }},
    {"decimal", [](Random& numbers, std::size_t n) { return lattice(numbers, n, 0.1, 0.01); }},
    {"cocircular", cocircular},
    {"collinear", collinear},
    {"clustered", clustered},
    {"powerlaw", powerLaw},
    // The giant comes first, so that every later insertion meets it, and removals from the back do
    // not.
    {"planet",
     [](Random& numbers, std::size_t n) { return SiteSet{test::giantDisk(numbers, n - 1), 1000}; }},
    {"outlier",
     [](Random& numbers, std::size_t n) { return SiteSet{test::outlier(numbers, n, 1e5), 1000}; }},
    {"towns", [](Random& numbers, std::size_t n) { return SiteSet{test::towns(numbers, n), 1}; }},
    {"scales",
     [](Random& numbers, std::size_t n) { return SiteSet{test::everyScale(numbers, n), 1}; }},
    // Orders: the same points sorted and in random order.
    {"line", [](Random&, std::size_t n) { return rowByRow(n, 1); }},
    {"line-shuffled",
     [](Random& numbers, std::size_t n) { return shuffled(numbers, rowByRow(n, 1)); }},
    {"parallels", [](Random&, std::size_t n) { return rowByRow(n, 2); }},
    {"parallels-shuffled",
     [](Random& numbers, std::size_t n) { return shuffled(numbers, rowByRow(n, 2)); }},
    {"rows", [](Random&, std::size_t n) { return rowByRow(n, sideOf(n)); }},
    {"rows-shuffled",
     [](Random& numbers, std::size_t n) { return shuffled(numbers, rowByRow(n, sideOf(n))); }},
    // One visible site, all others below it.
    {"duplicates", [](Random&, std::size_t n) { return SiteSet{Circles(n, Circle{1, 1, 1}), 1}; }},
    {"concentric", [](Random& numbers, std::size_t n) { return nested(numbers, n, 0); }},
    {"chain", [](Random& numbers, std::size_t n) { return nested(numbers, n, 1); }},
};

struct Box {
  Point low;
  Point high;
};

Box boundingBox(const SiteSet& sites) {
  Box box{{sites.circles.front().x, sites.circles.front().y},
          {sites.circles.front().x, sites.circles.front().y}};
  for (const Circle& circle : sites.circles) {
    box.low = {std::min(box.low.x, circle.x), std::min(box.low.y, circle.y)};
    box.high = {std::max(box.high.x, circle.x), std::max(box.high.y, circle.y)};
  }
  return box;
}

}  // namespace

std::vector<std::string_view> familyNames() {
  std::vector<std::string_view> names;
  for (const Family& family : kFamilies) names.push_back(family.name);
  return names;
}

std::optional<SiteSet> makeSites(std::string_view name, std::size_t n) {
  for (const Family& family : kFamilies) {
    if (family.name != name) continue;
    Random numbers(kSeed + n);
    return family.make(numbers, n);
  }
  return std::nullopt;
}

std::vector<Point> pointsInBox(const SiteSet& sites, std::size_t count) {
  Random numbers(kSeed + 1);
  const Box box = boundingBox(sites);
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = numbers.between(box.low.x, box.high.x);
    points.push_back({x, numbers.between(box.low.y, box.high.y)});
  }
  return points;
}

std::vector<Point> pointsNearSites(const SiteSet& sites, std::size_t count) {
  Random numbers(kSeed + 2);
  const Box box = boundingBox(sites);
  const double area = (box.high.x - box.low.x) * (box.high.y - box.low.y);
  const double reach = sites.nearness > 0
                           ? sites.nearness
                           : std::sqrt(area / static_cast<double>(sites.circles.size()));
  std::vector<Point> points;
  for (std::size_t k = 0; k < count; ++k) {
    const Circle& site = sites.circles[numbers.below(sites.circles.size())];
    const double x = site.x + numbers.between(-reach, reach);
    points.push_back({x, site.y + numbers.between(-reach, reach)});
  }
  return points;
}

}  // namespace apollonius::bench
