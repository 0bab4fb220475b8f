// The sector walk (locate.cpp) from any site to any point, where directions coincide: the ray from
// a site of many neighbours runs along that of several of its vertices, or exactly away from them.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "delaunay/delaunay_graph.h"
#include "predicate/predicates.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::internal {
namespace {

using test::Random;
using test::runs;

VertexId vertex(std::size_t v) { return VertexId{static_cast<std::uint32_t>(v)}; }

/// Vertices 1, 2, …
DelaunayGraph graphOf(const std::vector<Site>& sites) {
  DelaunayGraph graph;
  graph.reserve(sites.size() + 1);
  for (std::size_t k = 0; k < sites.size(); ++k) {
    graph.setSite(vertex(k + 1), sites[k]);
    graph.insert(vertex(k + 1), kNoVertex);
  }
  return graph;
}

std::size_t nearestOf(const std::vector<Site>& sites, double x, double y) {
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < sites.size(); ++k) {
    if (isNearer(x, y, sites[nearest], sites[k])) nearest = k;
  }
  return nearest;
}

TEST(SectorWalk, AlongDirectionsOfSeveralVertices) {
  // Integer points on one circle about the middle; on one side there are none, but three others
  // that are on one circle with the middle.
  constexpr int kRadius = 1105;
  std::vector<Site> ring;
  for (int x = -kRadius; x <= kRadius; ++x) {
    for (int y = -kRadius; y < 500; ++y) {
      if (x * x + y * y == kRadius * kRadius)
        ring.push_back({static_cast<double>(x), static_cast<double>(y), 0});
    }
  }
  Random random(192);
  for (int run = 0; run < runs(48); ++run) {
    // The eight symmetries of a square.
    const double signX = (run & 2) != 0 ? -1 : 1, signY = (run & 4) != 0 ? -1 : 1;
    const auto at = [&](double x, double y) {
      return (run & 1) != 0 ? Site{signY * y, signX * x, 0} : Site{signX * x, signY * y, 0};
    };
    std::vector<Site> sites{at(0, 0), at(340, 340), at(-340, 340)};
    for (const Site& s : ring) sites.push_back(at(s.x, s.y));
    random.shuffle(sites);
    // Walks begin at the last neighbour that came.
    sites.insert(run < 24 ? sites.end() : sites.begin(), at(0, 680));
    const DelaunayGraph graph = graphOf(sites);
    for (const int away : {340, 100, 500, -300, -560, -700, -1000}) {
      const Site p = at(0, away);
      const VertexId expected = vertex(1 + nearestOf(sites, p.x, p.y));
      for (std::size_t start = 1; start <= sites.size();
           start += start < sites.size() - 4 ? 4 : 1) {
        ASSERT_EQ(graph.locate(p.x, p.y, vertex(start), Walk::kSectors).nearest, expected)
            << "run " << run << ", point " << away << ", start " << start;
      }
    }
  }
}

TEST(SectorWalk, ToAVertexWhoseLargestSiteIsBesideTheSector) {
  // At 5 in front of the middle's centre four sites are equally near: a larger one behind the
  // point, and two smaller ones, whose edges the ray may be found to leave by. The edge between the
  // middle and the largest has length zero.
  std::vector<Site> around;
  for (int k = 0; k < 40; ++k) {
    const double t = static_cast<double>(k - 20) / 10;  // a half-angle's tangent
    around.push_back({-9 * (1 - t * t / 5) / (1 + t * t / 5), 9 * t / (1 + t * t / 5), 0});
  }
  Random random(193);
  for (int run = 0; run < runs(200); ++run) {
    const double signX = (run & 2) != 0 ? -1 : 1, signY = (run & 4) != 0 ? -1 : 1;
    const auto at = [&](const Site& s) {
      return (run & 1) != 0 ? Site{signY * s.y, signX * s.x, s.r}
                            : Site{signX * s.x, signY * s.y, s.r};
    };
    std::vector<Site> sites{at({0, 0, 0}), at({5, 4, -1}), at({5, -4, -1}), at({11, 0, 1})};
    for (const Site& s : around) sites.push_back(at(s));
    random.shuffle(sites);
    const Site p = at({5, 0, 0});
    const DelaunayGraph graph = graphOf(sites);
    const VertexId expected = vertex(1 + nearestOf(sites, p.x, p.y));
    ASSERT_EQ(graph.site(expected).r, 1);
    for (std::size_t start = 1; start <= sites.size(); ++start) {
      ASSERT_EQ(graph.locate(p.x, p.y, vertex(start), Walk::kSectors).nearest, expected)
          << "run " << run << ", start " << start;
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
