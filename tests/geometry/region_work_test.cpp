// The work of laying a region over a diagram, counted: not the sides of a ring times the neighbours
// of the cell that they are in.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"
#include "geometry/window/boundary_walk.h"
#include "predicate/stage_counts.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

using namespace internal;

constexpr double kTurn = 2 * 3.14159265358979323846;

Point polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// A site in the middle, with all others around it.
struct Wheel {
  const char* name;
  double hub;           ///< the weight in the middle
  double near, weight;  ///< the others' least distance from the centre, and their weight
  bool isRandom;        ///< neither the directions nor the weights are even
  double margin;        ///< most questions for a side, in levels of a binary tree

  [[nodiscard]] std::vector<double> circles(std::size_t count) const {
    Random random(871);
    std::vector<double> xyr{0, 0, hub};
    for (std::size_t k = 0; k < count; ++k) {
      const double place = static_cast<double>(k) + (isRandom ? random.between(-0.4, 0.4) : 0.0);
      const double radius = isRandom ? weight * random.between(0.5, 1) : weight;
      const Point center = polar(near + radius, kTurn * place / static_cast<double>(count));
      xyr.insert(xyr.end(), {center.x, center.y, radius});
    }
    return xyr;
  }
  /// The radius of the cell in the middle.
  [[nodiscard]] double reach() const { return (near + hub) / 2; }
};

void PrintTo(const Wheel& wheel, std::ostream* out) { *out << wheel.name; }

using Ring = std::vector<Point>;

struct Walked {
  FlatArray<Crossing> crossings;
  FlatArray<Keyed> interiorRings;
  std::size_t asked = 0;
};

Walked walk(const DiagramCore& core, const std::vector<Ring>& rings) {
  NormalizedPolygon polygon;
  polygon.starts.push_back(0);
  for (const Ring& ring : rings) {
    for (const Point p : ring) polygon.points.push_back(p);
    polygon.starts.push_back(static_cast<std::uint32_t>(polygon.points.size()));
  }
  Walked walked;
  walked.asked = walkRings(core, polygon, walked.crossings, walked.interiorRings);
  return walked;
}

/// A ring around the middle, with every second point at another distance.
Ring around(std::size_t points, double outer, double inner) {
  Ring ring;
  for (std::size_t k = 0; k < points; ++k)
    ring.push_back(polar(k % 2 == 0 ? outer : inner,
                         kTurn * static_cast<double>(k) / static_cast<double>(points)));
  return ring;
}

/// A cell with many neighbours in the middle of a diagram.
class RegionWork : public ::testing::TestWithParam<Wheel> {
 protected:
  RegionWork() {
    const std::vector<double> circles = GetParam().circles(neighbors());
    std::vector<SiteId> ids(circles.size() / 3);
    insertAll(core_, circles, ids);
  }
  static std::size_t neighbors() { return static_cast<std::size_t>(runs(10'000)); }
  /// The most that walking these sides may ask. It was all neighbours for each of them.
  static std::size_t mostAsked(std::size_t sides) {
    const double level = std::log2(static_cast<double>(neighbors()));
    return 6 * neighbors() +
           static_cast<std::size_t>(GetParam().margin * level * static_cast<double>(sides));
  }

  DiagramCore core_{Location::kHierarchy};
};

TEST_P(RegionWork, OfARingIsNotItsSidesTimesTheNeighbors) {
  const double reach = GetParam().reach();
  struct {
    const char* name;
    double outer, inner;
    bool isInside;
  } const kinds[] = {{"along the border", 0.9999998, 0.9999999, true},
                     {"farther inside", 0.999, 0.9995, true},
                     {"spikes to the border", 0.9999999, 0.2, true},
                     {"spikes from the middle", 0.3, 1e-9, true},
                     {"across the border", 1.001, 0.99, false}};
  for (const auto& kind : kinds) {
    SCOPED_TRACE(kind.name);
    const auto ring = static_cast<std::size_t>(runs(sized(800, 1600)));
    const Walked walked = walk(core_, {around(ring, kind.outer * reach, kind.inner * reach)});
    EXPECT_EQ(walked.crossings.empty(), kind.isInside);
    EXPECT_EQ(walked.interiorRings.empty(), !kind.isInside);
    EXPECT_LT(walked.asked, mostAsked(ring + 2 * walked.crossings.size()));
  }
}

/// Rings side by side in the cell, each with a hole; and rings around each other.
TEST_P(RegionWork, OfManyRingsIsNotTheirNumberTimesTheNeighbors) {
  const double reach = GetParam().reach();
  const auto rows = static_cast<std::size_t>(runs(sized(12, 20)));
  std::vector<Ring> islands, nested;
  for (std::size_t k = 0; k < rows * rows; ++k) {
    const Point at = (1.2 * reach / static_cast<double>(rows)) *
                     Point{static_cast<double>(k % rows) - static_cast<double>(rows) / 2,
                           static_cast<double>(k / rows) - static_cast<double>(rows) / 2};
    for (const double size : {0.4, 0.2}) {
      Ring ring = around(4, size * reach / static_cast<double>(rows),
                         size * reach / static_cast<double>(rows));
      for (Point& p : ring) p = p + at;
      islands.push_back(ring);
    }
    const double outer =
        reach * static_cast<double>(k + 1) / static_cast<double>(rows * rows) * 0.999999;
    nested.push_back(around(4, outer, outer));
  }
  for (const auto* rings : {&islands, &nested}) {
    stages::counts() = {};
    const Walked walked = walk(core_, *rings);
    EXPECT_EQ(walked.interiorRings.size(), rings->size());
    EXPECT_LT(walked.asked, mostAsked(4 * rings->size()));
    // Location turned around the cell for each ring.
    EXPECT_LT(stages::counts().rayCached, 2 * neighbors());
  }
}

/// Which neighbours are asked makes no difference: a ring alone has too few sides for a tree.
TEST_P(RegionWork, RingsAreWalkedTogetherAsAlone) {
  const std::vector<double> circles = GetParam().circles(300);
  std::vector<SiteId> ids(circles.size() / 3);
  DiagramCore core(Location::kHierarchy);
  insertAll(core, circles, ids);
  Random random(872);
  const double reach = GetParam().reach();
  std::vector<Ring> rings;
  for (int k = 0; k < runs(sized(100, 300)); ++k) {
    // From the middle to beyond the border, many close to that.
    const double angle = random.between(0, kTurn), size = std::exp2(random.between(-20, 0));
    Ring ring;
    for (int corner = 0; corner < 3; ++corner) {
      const double radius = random.oneIn(2) ? 1 - size * random.between(-0.5, 1) : random.unit();
      ring.push_back(polar(radius * reach, angle + size * random.between(0, 3)));
    }
    rings.push_back(ring);
  }
  const Walked together = walk(core, rings);
  std::size_t at = 0, atInterior = 0;
  for (std::uint32_t k = 0; k < rings.size(); ++k) {
    const Walked alone = walk(core, {rings[k]});
    ASSERT_LE(at + alone.crossings.size(), together.crossings.size());
    for (const Crossing& expected : alone.crossings) {
      const Crossing& crossing = together.crossings[at++];
      ASSERT_EQ(crossing.ring, k);
      ASSERT_EQ(crossing.edge, expected.edge) << "ring " << k;
      ASSERT_EQ(crossing.e, expected.e) << "ring " << k;
      ASSERT_EQ(crossing.point, expected.point) << "ring " << k;
      ASSERT_EQ(crossing.firstPoint, expected.firstPoint) << "ring " << k;
    }
    for (const Keyed& expected : alone.interiorRings) {
      ASSERT_LT(atInterior, together.interiorRings.size());
      ASSERT_EQ(together.interiorRings[atInterior++].key, expected.key) << "ring " << k;
    }
  }
  EXPECT_EQ(at, together.crossings.size());
  EXPECT_EQ(atInterior, together.interiorRings.size());
  EXPECT_GT(at, rings.size());
  EXPECT_GT(atInterior, rings.size() / 10);
}

INSTANTIATE_TEST_SUITE_P(Wheels, RegionWork,
                         ::testing::Values(Wheel{"Points", 0, 1e6, 0, false, 6},
                                           Wheel{"TinyOnes", 1e6, 1e6 + 10, 1, false, 6},
                                           Wheel{"RandomTinyOnes", 1e6, 1e6 + 10, 1, true, 6},
                                           // For numbers of their size the cell is small: with
                                           // what may be rounding, many are as far away.
                                           Wheel{"LargeOnes", 0, 1, 1e6, false, 40},
                                           Wheel{"RandomOnes", 0, 1e6, 1e6, true, 6}),
                         [](const auto& wheel) { return std::string(wheel.param.name); });

}  // namespace
}  // namespace apollonius::test
