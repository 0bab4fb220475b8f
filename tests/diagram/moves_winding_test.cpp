// Moves that keep each face and edge valid by itself, but not the whole: the sites around a site go
// to where they wind around it twice. Triangles stay counter-clockwise and vertices in order along
// edges; the only sign is that a vertex turns by more than a quarter, as seen from a site.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

struct Vector {
  double x, y;
};

/// This many turns in steps of less than half a turn each.
std::vector<double> angles(Random& random, std::size_t count, double turns) {
  constexpr double kTurn = 6.283185307179586;
  for (;;) {
    std::vector<double> steps(count);
    double sum = 0, largest = 0;
    for (double& step : steps) sum += step = random.between(0.05, 1);
    for (double& step : steps) largest = std::max(largest, step *= turns * kTurn / sum);
    if (largest > 0.49 * kTurn) continue;
    double at = random.between(0, kTurn);
    for (double& step : steps) at += step, step = at;
    return steps;
  }
}

/// The centre of the circle through 0, a and b.
Vector center(Vector a, Vector b) {
  const double twice = 2 * (a.x * b.y - a.y * b.x), p = a.x * a.x + a.y * a.y,
               q = b.x * b.x + b.y * b.y;
  return {(p * b.y - q * a.y) / twice, (q * a.x - p * b.x) / twice};
}

TEST(MovesWinding, FromOnceAroundASiteToTwice) {
  Random random(201);
  for (int run = 0; run < runs(200); ++run) {
    const std::size_t count = 5 + random.below(std::size_t{6});
    const auto around = [&](const std::vector<double>& at, double size) {
      std::vector<Vector> points;
      for (const double angle : at) {
        const double way = size * random.between(0.8, 1.2);
        points.push_back({way * std::cos(angle), way * std::sin(angle)});
      }
      return points;
    };
    const double size = std::ldexp(1.0, static_cast<int>(random.integer(-3, 8)));
    const std::vector<Vector> before = around(angles(random, count, 1), 1),
                              after = around(angles(random, count, 2), size);
    // The vertex that turns most stays where it is, or nearly; the site in the middle goes round.
    double most = 2;
    Vector middle{0, 0};
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = (k + 1) % count;
      const Vector c = center(before[k], before[next]), d = center(after[k], after[next]);
      const double cosine = (c.x * d.x + c.y * d.y) / std::hypot(c.x, c.y) / std::hypot(d.x, d.y);
      if (cosine >= most) continue;
      most = cosine;
      const double share = run % 3 == 0 ? 0 : run % 3 == 1 ? 1 : random.between(0.5, 1.2);
      middle = {share * (c.x - d.x), share * (c.y - d.y)};
    }
    std::vector<double> xyr{0, 0, 0}, moved{middle.x, middle.y, 0};
    for (std::size_t k = 0; k < count; ++k) {
      xyr.insert(xyr.end(), {before[k].x, before[k].y, 0});
      moved.insert(moved.end(), {middle.x + after[k].x, middle.y + after[k].y, 0});
    }
    Diagram diagram;
    std::vector<SiteId> ids(count + 1);
    ASSERT_EQ(diagram.insertMany(xyr, ids), Error::kNone);
    ASSERT_EQ(diagram.updateMany(ids, moved), Error::kNone);
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "") << "run " << run;
  }
}

}  // namespace
}  // namespace apollonius::test
