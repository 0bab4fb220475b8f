// Polygons of the segments around a cell.
#include "geometry/polygons/ring_tracer.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace apollonius::test {
namespace {

using namespace internal;

/// A ring, closed.
std::vector<double> ringOf(std::initializer_list<Point> corners) {
  std::vector<double> ring;
  for (const Point p : corners) ring.insert(ring.end(), {p.x, p.y});
  ring.insert(ring.end(), {corners.begin()->x, corners.begin()->y});
  return ring;
}

double areaOf(std::span<const double> ring) {
  double twice = 0;
  for (std::size_t k = 0; k + 3 < ring.size(); k += 2)
    twice += ring[k] * ring[k + 3] - ring[k + 2] * ring[k + 1];
  return twice / 2;
}

Rings traced(const std::vector<std::vector<double>>& given) {
  Tracer tracer;
  tracer.clear();
  for (const std::vector<double>& ring : given) tracer.addRing(ring);
  Rings rings;
  tracer.trace(rings);
  return rings;
}

TEST(RingTracer, AHoleBelongsToTheRingAroundItAndNotToOneThatGoesAroundThat) {
  // A square with a hole, in the notch of a thin U, which has less area and a larger box.
  const Rings rings = traced({ringOf({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}}),
                              ringOf({{-2, -2}, {-2, 2}, {2, 2}, {2, -2}}),
                              ringOf({{-12, 12},
                                      {-12, -12},
                                      {12, -12},
                                      {12, 12},
                                      {11, 12},
                                      {11, -11},
                                      {-11, -11},
                                      {-11, 12}})});
  ASSERT_EQ(rings.ringCount(), 3u);
  ASSERT_EQ(rings.parts.size(), 3u);
  for (std::size_t part = 0; part < 2; ++part) {
    const std::uint32_t first = rings.parts[part], end = rings.parts[part + 1];
    const bool isSquare = areaOf(rings.ring(first)) == 400;
    EXPECT_EQ(end - first, isSquare ? 2u : 1u);
    if (isSquare) {
      EXPECT_EQ(areaOf(rings.ring(first + 1)), -16);
    }
  }
}

TEST(RingTracer, WhatGoesAlongASegmentAndBackGoes) {
  const Rings rings =
      traced({ringOf({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), ringOf({{1, 0}, {2, 0}, {2, 1}, {1, 1}})});
  ASSERT_EQ(rings.ringCount(), 1u);
  EXPECT_EQ(areaOf(rings.ring(0)), 2);
  EXPECT_EQ(rings.ring(0).size(), 2 * 7u);
}

}  // namespace
}  // namespace apollonius::test
