// Edges inside a window as a graph, and their narrowest places: against the curves, searched along
// them, and against all circles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/shapes.h"
#include "support/corpus.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

struct Graph : EdgeGraph {
  CurveArrays curves;

  explicit Graph(const Voronoi& view) {
    EXPECT_EQ(view.edgeCurves(curves), Error::kNone);
    EXPECT_EQ(view.edgeGraph(*this), Error::kNone);
  }
  [[nodiscard]] std::size_t edgeCount() const { return edges.sites.size() / 2; }
  [[nodiscard]] std::size_t vertexCount() const { return vertices.clearance.size(); }
  [[nodiscard]] Conic curve(std::size_t k) const {
    const double* c = &curves.curves[7 * k];
    return {{c[0], c[1]}, {c[2], c[3]}, c[4], {c[5], c[6]}};
  }
  [[nodiscard]] Point vertex(std::size_t row) const {
    return {vertices.coordinates[2 * row], vertices.coordinates[2 * row + 1]};
  }
  [[nodiscard]] Point place(std::size_t k) const {
    return {narrowest.coordinates[2 * k], narrowest.coordinates[2 * k + 1]};
  }
  [[nodiscard]] bool isCut(std::size_t row) const { return vertices.sites[3 * row + 2] == kNoSite; }
  [[nodiscard]] std::size_t cutCount() const {
    std::size_t count = 0;
    for (std::size_t row = 0; row < vertexCount(); ++row) count += isCut(row) ? 1 : 0;
    return count;
  }
};

double clearanceAt(const Circle& c, Point p) { return length(p - Point{c.x, c.y}) - c.r; }

double clearanceAt(const Circles& circles, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Circle& c : circles) least = std::min(least, clearanceAt(c, p));
  return least;
}

/// The distance from both sites, as far as a point of a curve has one.
double clearanceOn(const Conic& curve, double t, const Circle& a, const Circle& b) {
  const Point p = curve.at(t);
  return (clearanceAt(a, p) + clearanceAt(b, p)) / 2;
}

/// The least clearance on an edge, by search: along the edge it falls and then rises.
double leastOn(const Conic& curve, const Circle& a, const Circle& b) {
  double low = 0, high = 1;
  for (int step = 0; step < 200; ++step) {
    const double first = low + (high - low) / 3, second = high - (high - low) / 3;
    if (clearanceOn(curve, first, a, b) < clearanceOn(curve, second, a, b)) {
      high = second;
    } else {
      low = first;
    }
  }
  return std::min(
      {clearanceOn(curve, low, a, b), clearanceOn(curve, 0, a, b), clearanceOn(curve, 1, a, b)});
}

double sizeOf(const Circles& circles) {
  double size = 0;
  for (const Circle& c : circles)
    size = std::max({size, std::abs(c.x), std::abs(c.y), std::abs(c.r)});
  return size;
}

/// Checks all that holds in every view. Distances may be off by `tolerance`.
void expectGraph(const Graph& graph, const Circles& circles, double tolerance) {
  const VertexArrays& vertices = graph.vertices;
  ASSERT_EQ(graph.edges.sites, graph.curves.sites);
  ASSERT_EQ(graph.edges.vertices.size(), 2 * graph.edgeCount());
  ASSERT_EQ(vertices.coordinates.size(), 2 * graph.vertexCount());
  ASSERT_EQ(vertices.sites.size(), 3 * graph.vertexCount());
  ASSERT_EQ(graph.narrowest.clearance.size(), graph.edgeCount());
  ASSERT_EQ(graph.narrowest.coordinates.size(), 2 * graph.edgeCount());
  EXPECT_TRUE(graph.narrowest.sites.empty());
  std::vector<int> degrees(graph.vertexCount(), 0);
  for (std::size_t k = 0; k < graph.edgeCount(); ++k) {
    const Conic curve = graph.curve(k);
    const SiteId left = graph.edges.sites[2 * k], right = graph.edges.sites[2 * k + 1];
    const Circle &a = circles[left], &b = circles[right];
    for (const std::size_t end : {0u, 1u}) {
      ASSERT_GE(graph.edges.vertices[2 * k + end], 0);
      const auto row = static_cast<std::size_t>(graph.edges.vertices[2 * k + end]);
      ASSERT_LT(row, graph.vertexCount());
      ++degrees[row];
      EXPECT_TRUE(graph.vertex(row) == (end == 0 ? curve.p0 : curve.p2));
      EXPECT_NEAR(clearanceAt(a, graph.vertex(row)), vertices.clearance[row], tolerance);
      EXPECT_NEAR(clearanceAt(b, graph.vertex(row)), vertices.clearance[row], tolerance);
      EXPECT_GE(vertices.clearance[row], graph.narrowest.clearance[k]);
      if (!graph.isCut(row)) continue;
      // Counter-clockwise, as at a vertex beyond.
      EXPECT_EQ(vertices.sites[3 * row], end == 1 ? left : right);
      EXPECT_EQ(vertices.sites[3 * row + 1], end == 1 ? right : left);
    }
    const double least = graph.narrowest.clearance[k];
    EXPECT_NEAR(least, leastOn(curve, a, b), tolerance) << "edge " << k;
    EXPECT_NEAR(clearanceAt(a, graph.place(k)), least, tolerance) << "edge " << k;
    EXPECT_NEAR(clearanceAt(b, graph.place(k)), least, tolerance) << "edge " << k;
  }
  std::set<std::vector<SiteId>> triples;
  for (std::size_t row = 0; row < graph.vertexCount(); ++row) {
    const SiteId* const sites = &vertices.sites[3 * row];
    EXPECT_GE(degrees[row], 1) << "no edge ends there";
    if (graph.isCut(row)) {
      EXPECT_EQ(degrees[row], 1);
    } else {
      EXPECT_TRUE(triples.insert({sites, sites + 3}).second) << "twice";
      EXPECT_EQ(sites[0], std::min({sites[0], sites[1], sites[2]}));
      EXPECT_NEAR(clearanceAt(circles[sites[2]], graph.vertex(row)), vertices.clearance[row],
                  tolerance);
    }
    EXPECT_NEAR(clearanceAt(circles, graph.vertex(row)), vertices.clearance[row], tolerance);
  }
}

/// visit(name, view, distance) for windows of each kind.
template <class Visit>
void inEachWindow(const Diagram& diagram, const Bounds& box, double distance, Visit&& visit) {
  const double w = box.xmax - box.xmin, h = box.ymax - box.ymin;
  Region lake;  // the box, and a hole in it
  const std::vector<double> corners{box.xmin,           box.ymin,           box.xmax,
                                    box.ymin,           box.xmax,           box.ymax,
                                    box.xmin,           box.ymax,           box.xmin + 0.31 * w,
                                    box.ymin + 0.4 * h, box.xmin + 0.6 * w, box.ymin + 0.37 * h,
                                    box.xmin + 0.5 * w, box.ymin + 0.71 * h};
  const std::vector<std::uint32_t> starts{0, 4, 7};
  ASSERT_EQ(lake.assign(corners, starts), Error::kNone);
  const Reach reach(distance);
  visit("rectangle", Voronoi(diagram, box));
  visit("region", Voronoi(diagram, lake));
  visit("rectangle, up to a distance", Voronoi(diagram, box, &reach));
  visit("region, up to a distance", Voronoi(diagram, lake, &reach));
}

TEST(EdgeGraph, OfALatticeHasOneVertexWhereFourCellsMeet) {
  constexpr int kColumns = 5;
  for (const double unit : {1.0, 0.1, 7.0, 1e-90, 1e80}) {
    for (const double far : {0.0, 1e6, -0x1p30}) {
      for (const double weight : {0.0, 0.3}) {
        SCOPED_TRACE(testing::Message() << unit << " " << far << " " << weight);
        Circles circles;
        for (int k = 0; k < kColumns * kColumns; ++k)
          circles.push_back({unit * (far + k / kColumns), unit * (k % kColumns), unit * weight});
        Diagram diagram;
        insertInto(diagram, circles);
        const double size = sizeOf(circles);
        const Graph graph(
            Voronoi(diagram, {unit * (far - 0.5), unit * -0.5, unit * (far + 4.5), unit * 4.5}));
        expectGraph(graph, circles, 1e-12 * size);
        EXPECT_EQ(graph.edgeCount(), 40u);
        EXPECT_EQ(graph.vertexCount(), 32u);
        EXPECT_EQ(graph.cutCount(), 16u);
        // Each is narrowest in its middle, between two neighbours.
        for (std::size_t k = 0; k < graph.edgeCount(); ++k)
          EXPECT_NEAR(graph.narrowest.clearance[k], unit * (0.5 - weight), 1e-12 * size);
        // Up to where no four cells meet, the edges are apart.
        const Reach reach(unit * (0.6 - weight));
        const Graph pieces(Voronoi(
            diagram, {unit * (far - 0.5), unit * -0.5, unit * (far + 4.5), unit * 4.5}, &reach));
        expectGraph(pieces, circles, 1e-12 * size);
        EXPECT_EQ(pieces.edgeCount(), 40u);
        EXPECT_EQ(pieces.cutCount(), 80u);
        EXPECT_EQ(pieces.vertexCount(), 80u);
      }
    }
  }
}

/// Equal sites after another history name the same three of the sites of a vertex.
TEST(EdgeGraph, IsTheSameAfterAnyHistory) {
  Random random(6801);
  Circles circles = cocircularPoints(random, 30);
  for (int k = 0; k < 16; ++k) circles.push_back({1e4 * (k / 4), 1e4 * (k % 4), 1});
  std::set<std::vector<double>> seen;
  for (int run = 0; run < 6; ++run) {
    Diagram diagram;
    std::vector<SiteId> ids = insertInto(diagram, circles);
    for (int k = 0; k < 20 * run; ++k) {
      const SiteId id = random.below(static_cast<SiteId>(circles.size()));
      ASSERT_EQ(diagram.update(id, random.between(-1e4, 1e4), random.between(-1e4, 1e4), 3),
                Error::kNone);
      ASSERT_EQ(diagram.update(id, circles[id].x, circles[id].y, circles[id].r), Error::kNone);
    }
    const Graph graph(Voronoi(diagram, {-4e4, -4e4, 4e4, 4e4}));
    std::set<std::vector<double>> rows;
    for (std::size_t row = 0; row < graph.vertexCount(); ++row) {
      const SiteId* const sites = &graph.vertices.sites[3 * row];
      rows.insert({graph.vertex(row).x, graph.vertex(row).y, graph.vertices.clearance[row],
                   static_cast<double>(sites[0]), static_cast<double>(sites[1]),
                   static_cast<double>(sites[2])});
    }
    EXPECT_EQ(rows.size(), graph.vertexCount());
    if (run == 0) seen = rows;
    EXPECT_EQ(rows, seen);
  }
}

/// An edge of which the window cuts out the middle has two pieces, each with ends of its own; the
/// narrowest place of the edge is on neither.
TEST(EdgeGraph, OfAnEdgeThatMeetsTheWindowTwice) {
  const Circles circles{{0, 0, 6}, {10, 0, 1}};
  for (const double far : {0.0, 0x1p20, -1e6}) {
    for (const bool isRegion : {false, true}) {
      SCOPED_TRACE(testing::Message() << far << " " << isRegion);
      Circles moved;
      for (const Circle& c : circles) moved.push_back({c.x + far, c.y - far, c.r});
      Diagram diagram;
      insertInto(diagram, moved);
      // The edge is nearest to the circles at x = 7.5 and bends to larger x.
      const Bounds box{far + 8, -far - 20, far + 40, -far + 20};
      Region region;
      const std::vector<double> corners{box.xmin, box.ymin, box.xmax, box.ymin,
                                        box.xmax, box.ymax, box.xmin, box.ymax};
      ASSERT_EQ(region.assign(corners, std::vector<std::uint32_t>{0, 4}), Error::kNone);
      const Graph graph(isRegion ? Voronoi(diagram, region) : Voronoi(diagram, box));
      expectGraph(graph, moved, 1e-12 * (1 + std::abs(far)));
      ASSERT_EQ(graph.edgeCount(), 2u);
      EXPECT_EQ(graph.vertexCount(), 4u);
      EXPECT_EQ(graph.cutCount(), 4u);
      for (const std::size_t k : {0u, 1u}) {
        EXPECT_NEAR(graph.place(k).x, far + 8, 1e-9);
        EXPECT_GT(graph.narrowest.clearance[k], 1.6);
      }
      // And of the whole, which has no vertex.
      VertexArrays whole;
      ASSERT_EQ(diagram.narrowest(whole), Error::kNone);
      ASSERT_EQ(whole.clearance.size(), 1u);
      EXPECT_NEAR(whole.clearance[0], 1.5, 1e-9);
      EXPECT_NEAR(whole.coordinates[0], far + 7.5, 1e-9);
      EXPECT_NEAR(whole.coordinates[1], -far, 1e-9);
    }
  }
}

/// Where one circle nearly covers the other, both sides of the edge are one ray in doubles, and the
/// narrowest place is where that begins.
TEST(EdgeGraph, OfACircleThatNearlyCoversAnother) {
  for (const double gap : {1e-3, 0x1p-30, 0x1p-50}) {
    for (const double far : {0.0, 1024.0}) {
      const Circles circles{{far, far, 2}, {far + 1, far, 1 + gap}};
      Diagram diagram;
      insertInto(diagram, circles);
      for (const double distance : {0.5, 3.0, std::numeric_limits<double>::infinity()}) {
        SCOPED_TRACE(testing::Message() << gap << " " << far << " " << distance);
        const Reach reach(distance);
        const Graph graph(Voronoi(diagram, {far - 10, far - 10, far + 10, far + 10}, &reach));
        ASSERT_EQ(graph.edgeCount(), 1u);
        EXPECT_EQ(graph.cutCount(), 2u);
        EXPECT_NEAR(graph.narrowest.clearance[0], -1 - gap / 2, 1e-9);
        EXPECT_NEAR(graph.place(0).x, far + 1, 2e-3);
      }
    }
  }
}

/// Ends at a distance are there, inclusive; different ones of two sites end at the less.
TEST(EdgeGraph, EndsAtDistances) {
  Random random(6802);
  for (int run = 0; run < runs(sized(20, 200)); ++run) {
    const double far = run % 2 == 0 ? 0 : 0x1p16;
    Circles circles;
    std::vector<double> distances;
    for (int k = 0; k < 20; ++k) {
      circles.push_back(
          {far + random.between(0, 100), random.between(0, 100), random.between(0, 5)});
      distances.push_back(run % 3 == 0 ? 8 : random.between(-2, 20));
    }
    Diagram diagram;
    insertInto(diagram, circles);
    const Reach reach{std::span<const double>(distances)};
    // All is within the window.
    const Graph graph(Voronoi(diagram, {far - 200, -200, far + 300, 300}, &reach));
    expectGraph(graph, circles, 1e-9);
    for (std::size_t row = 0; row < graph.vertexCount(); ++row) {
      const SiteId* const sites = &graph.vertices.sites[3 * row];
      const double clearance = graph.vertices.clearance[row];
      const double most = std::min(distances[sites[0]], distances[sites[1]]);
      if (!graph.isCut(row)) continue;
      EXPECT_NEAR(clearance, most, 1e-9) << run;
    }
    // Nothing of an edge is missing: the whole ones, as far as they are within.
    const Graph whole(Voronoi(diagram, {far - 200, -200, far + 300, 300}));
    std::multiset<std::pair<SiteId, SiteId>> expected, found;
    for (std::size_t k = 0; k < whole.edgeCount(); ++k) {
      const SiteId a = whole.edges.sites[2 * k], b = whole.edges.sites[2 * k + 1];
      if (whole.narrowest.clearance[k] < std::min(distances[a], distances[b]) - 1e-9)
        expected.insert({a, b});
    }
    for (std::size_t k = 0; k < graph.edgeCount(); ++k)
      found.insert({graph.edges.sites[2 * k], graph.edges.sites[2 * k + 1]});
    EXPECT_EQ(found, expected) << run;
  }
}

TEST(EdgeGraph, OfFewSitesAndBadWindows) {
  Diagram diagram;
  const Voronoi view(diagram, {0, 0, 10, 10});
  for (int sites = 0; sites < 2; ++sites) {
    const Graph graph(view);
    EXPECT_EQ(graph.edgeCount() + graph.vertexCount(), 0u);
    VertexArrays places{{1}, {2}, {3}};
    EXPECT_EQ(diagram.narrowest(places), Error::kNone);
    EXPECT_TRUE(places.coordinates.empty() && places.clearance.empty() && places.sites.empty());
    insertInto(diagram, {{2, 5, 1}});
  }
  const Voronoi none(diagram, {0, 0, 0, 10});
  EdgeGraph graph;
  graph.edges.sites = {1, 2};
  EXPECT_EQ(none.edgeGraph(graph), Error::kBadBounds);
  EXPECT_EQ(graph.edges.sites.size(), 2u);
}

class EdgeGraphOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(EdgeGraphOn, IsThatOfTheCurves) {
  Random random(6803);
  for (int run = 0; run < runs(sized(4, 30)); ++run) {
    const Circles circles = GetParam().make(random, GetParam().large ? 60 : 12);
    Diagram diagram;
    insertInto(diagram, circles);
    Bounds bounds;
    if (!windowAround(circles, run % 2 == 0 ? 0.6 : 0.01, bounds)) continue;
    const double size = bounds.xmax - bounds.xmin;
    const double tolerance = 1e-7 * std::max(sizeOf(circles), size);
    inEachWindow(diagram, bounds, 0.2 * size, [&](const char* name, const Voronoi& view) {
      SCOPED_TRACE(testing::Message() << name << " run " << run);
      expectGraph(Graph(view), circles, tolerance);
    });
  }
}

/// Checks the whole diagram by all circles: the middle of two sites is on an edge of them if no
/// other is nearer to it. Where that is decided by less than the tolerance, the edge may go
/// anywhere.
TEST_P(EdgeGraphOn, HasTheNarrowestPlacesOfTheDiagram) {
  Random random(6804);
  for (int run = 0; run < runs(sized(4, 30)); ++run) {
    const Circles circles = GetParam().make(random, GetParam().large ? 60 : 12);
    Diagram diagram;
    insertInto(diagram, circles);
    VertexArrays vertices, places;
    EdgeArrays edges;
    ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
    ASSERT_EQ(diagram.edges(edges), Error::kNone);
    ASSERT_EQ(diagram.narrowest(places), Error::kNone);
    ASSERT_EQ(places.clearance.size(), edges.sites.size() / 2);
    ASSERT_EQ(places.coordinates.size(), edges.sites.size());
    const double tolerance = 1e-7 * sizeOf(circles);
    std::map<std::pair<SiteId, SiteId>, std::pair<double, double>> least;  // found, at the ends
    for (std::size_t k = 0; k < places.clearance.size(); ++k) {
      const SiteId a = edges.sites[2 * k], b = edges.sites[2 * k + 1];
      const Point place{places.coordinates[2 * k], places.coordinates[2 * k + 1]};
      const double found = places.clearance[k];
      if (length(place) < 1e3 * sizeOf(circles)) {  // vertices far away are known as well as that
        EXPECT_NEAR(clearanceAt(circles[a], place), found, tolerance);
        EXPECT_NEAR(clearanceAt(circles[b], place), found, tolerance);
        EXPECT_NEAR(clearanceAt(circles, place), found, tolerance);
      }
      double ends = std::numeric_limits<double>::infinity();
      for (const std::size_t end : {2 * k, 2 * k + 1}) {
        if (edges.vertices[end] >= 0)
          ends = std::min(ends, vertices.clearance[static_cast<std::size_t>(edges.vertices[end])]);
      }
      EXPECT_LE(found, ends);
      const auto [entry, isNew] = least.insert({std::minmax(a, b), {found, ends}});
      if (!isNew) {
        entry->second.first = std::min(entry->second.first, found);
        entry->second.second = std::min(entry->second.second, ends);
      }
    }
    for (const auto& [pair, both] : least) {
      const Circle &a = circles[pair.first], &b = circles[pair.second];
      const Point way{b.x - a.x, b.y - a.y};
      const double between = (length(way) - a.r - b.r) / 2;
      const Point middle = Point{a.x, a.y} + (a.r + between) * unit(way);
      double nearest = std::numeric_limits<double>::infinity();
      for (SiteId id = 0; id < circles.size(); ++id) {
        if (id != pair.first && id != pair.second)
          nearest = std::min(nearest, clearanceAt(circles[id], middle));
      }
      EXPECT_GE(both.first, between - tolerance);
      if (nearest > between + tolerance) {
        EXPECT_NEAR(both.first, std::min(between, both.second), tolerance) << run;
      } else if (nearest < between - tolerance) {
        EXPECT_EQ(both.first, both.second) << run;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, EdgeGraphOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace apollonius::test
