// DelaunayGraph::check, Hierarchy::check and DiagramCore::check name each kind of damage: every
// message of src/delaunay/check.cpp and src/diagram/hierarchy.cpp is provoked here. (Those of the
// topology: tests/topology/check_test.cpp.)
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "delaunay/diagram_breaker.h"
#include "diagram/validate.h"
#include "support/random.h"
#include "topology/graph_breaker.h"

namespace apollonius::internal {
namespace {

using Breaker = DiagramBreaker;

VertexId vertex(std::uint32_t v) { return VertexId{v}; }

std::string broken(const DelaunayGraph& diagram) {
  std::uint32_t where = 0;
  const char* what = diagram.check(where);
  return what == nullptr ? std::string() : what;
}

bool startsWith(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

/// Vertices 1, 2, …
DelaunayGraph graphOf(const std::vector<Site>& sites) {
  DelaunayGraph diagram;
  diagram.reserve(sites.size() + 1);
  for (std::uint32_t k = 0; k < sites.size(); ++k) {
    diagram.setSite(vertex(k + 1), sites[k]);
    diagram.insert(vertex(k + 1), kNoVertex);
  }
  return diagram;
}

const std::vector<Site> kFive{{0, 0, 1}, {10, 0, 2}, {10, 11, 1}, {0, 10, 3}, {5, 4, 0.5}};

// --- One graph

TEST(DelaunayGraphCheck, FindsNothingWhereNothingIsBroken) {
  for (std::size_t n = 0; n <= kFive.size(); ++n) {
    EXPECT_EQ(broken(graphOf(std::vector<Site>(kFive.begin(),
                                               kFive.begin() + static_cast<std::ptrdiff_t>(n)))),
              "");
  }
}

TEST(DelaunayGraphCheck, ChecksTheTopologyFirst) {
  DelaunayGraph diagram = graphOf(kFive);
  GraphBreaker(Breaker::graph(diagram)).outgoing(vertex(3)) = kNoHalfedge;
  EXPECT_EQ(broken(diagram), "half-edges start at a vertex that has none: vertex");
}

TEST(DelaunayGraphCheck, CountOfVisibleSites) {
  for (const std::size_t wrong : {0u, 1u, 4u, 6u}) {
    DelaunayGraph diagram = graphOf(kFive);
    Breaker::visibleCount(diagram) = wrong;
    EXPECT_EQ(broken(diagram), "the count of visible sites is wrong: count") << wrong;
  }
}

TEST(DelaunayGraphCheck, StartOfWalks) {
  DelaunayGraph diagram = graphOf(kFive);
  for (const VertexId start : {kNoVertex, vertex(6), vertex(1000)}) {
    Breaker::recent(diagram) = start;
    EXPECT_EQ(broken(diagram), "walks start from a site without a cell: count");
  }
  DelaunayGraph single = graphOf({{0, 0, 1}});
  Breaker::recent(single) = kNoVertex;
  EXPECT_EQ(broken(single), "walks start from a site without a cell: count");
}

TEST(DelaunayGraphCheck, CachedCircle) {
  for (std::uint32_t f = 0; f < graphOf(kFive).graph().faceSlots(); ++f) {
    for (double VoronoiCircle::* part : {&VoronoiCircle::x, &VoronoiCircle::y, &VoronoiCircle::s}) {
      DelaunayGraph diagram = graphOf(kFive);
      Breaker::circle(diagram, FaceId{f}).*part += 1e-3;
      EXPECT_EQ(broken(diagram), "the cached circle of a face is not its circle: half-edge");
    }
    DelaunayGraph diagram = graphOf(kFive);
    VoronoiCircle& circle = Breaker::circle(diagram, FaceId{f});
    circle.slope = circle.isHalfPlane() ? -1 : 1;
    EXPECT_EQ(broken(diagram), "the cached circle of a face is not its circle: half-edge");
  }
}

TEST(DelaunayGraphCheck, FacesOfOtherSites) {
  // Sites are moved behind the graph's back, and circles computed again. Which damage is found
  // first depends on the numbers of the faces, so all displacements on a grid are tried. A
  // displacement that changes nothing leaves the graph of a fresh build.
  const std::string conflict = "the faces of an edge contradict each other: half-edge";
  const std::string covered = "a visible site is covered by a neighbour: half-edge";
  const std::string noCircle = "a face has no Voronoi circle: half-edge";
  std::set<std::string> messages;
  for (std::uint32_t v = 1; v <= kFive.size(); ++v) {
    for (int x = -2; x <= 12; x += 2) {
      for (int y = -2; y <= 12; y += 2) {
        std::vector<Site> sites = kFive;
        sites[v - 1] = {x + 0.1, y + 0.3, 0.25};
        DelaunayGraph diagram = graphOf(kFive);
        diagram.setSite(vertex(v), sites[v - 1]);
        Breaker::computeCircles(diagram);
        const DelaunayGraph fresh = graphOf(sites);
        const auto faces = [](const DelaunayGraph& d) {
          std::multiset<std::vector<std::size_t>> all;
          for (std::uint32_t f = 0; f < d.graph().faceSlots(); ++f) {
            if (!d.graph().isLive(FaceId{f})) continue;
            std::vector<std::size_t> corners;
            for (unsigned c = 0; c < 3; ++c)
              corners.push_back(index(d.graph().origin(halfedgeOf(FaceId{f}, c))));
            std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                        corners.end());
            all.insert(corners);
          }
          return all;
        };
        const std::string message = broken(diagram);
        EXPECT_EQ(message.empty(), faces(diagram) == faces(fresh))
            << "site " << v << " at " << x << ", " << y << ": " << message;
        messages.insert(message);
      }
    }
  }
  EXPECT_TRUE(messages.contains(covered));
  EXPECT_TRUE(messages.contains(conflict));
  EXPECT_TRUE(messages.contains(noCircle));
}

// --- The whole diagram

class DiagramCheck : public ::testing::Test {
 protected:
  /// Inserts circles of radius 4 in rows, ten apart, with a hidden one of radius 1 in every third.
  void fill(std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
      const double x = 10.0 * static_cast<double>(k % 16),
                   y = 10.0 * static_cast<double>(k / 16) + 0.25 * static_cast<double>(k % 3);
      last = core.insert({x, y, 4});
      if (k % 3 == 0) lastHidden = core.insert({x + 1, y, 1});
    }
    ASSERT_EQ(validate(core).text(), "");
  }

  void expectBroken(const std::string& message) {
    EXPECT_TRUE(startsWith(validate(core).text(), message)) << validate(core).text();
  }

  DiagramCore core{Location::kHierarchy};
  SiteId last = kNoSite, lastHidden = kNoSite;  // visible, hidden
};

TEST_F(DiagramCheck, ChecksTheGraphFirst) {
  fill(9);
  Breaker::visibleCount(Breaker::delaunay(core)) = 3;
  EXPECT_EQ(validate(core).text(), "the count of visible sites is wrong: count 3");
}

TEST_F(DiagramCheck, StateOfAVisibleSite) {
  fill(9);
  Breaker::ids(core).setState(last, SiteState::kHidden);
  EXPECT_EQ(validate(core).text(),
            "the state of a site contradicts the graph: site " + std::to_string(last));
}

TEST_F(DiagramCheck, StateOfAHiddenSite) {
  fill(9);
  Breaker::ids(core).setState(lastHidden, SiteState::kVisible);
  EXPECT_EQ(validate(core).text(),
            "the state of a site contradicts the graph: site " + std::to_string(lastHidden));
}

TEST_F(DiagramCheck, SiteOfNoState) {
  fill(9);
  IdPool& ids = Breaker::ids(core);
  (void)ids.next();
  ids.take(SiteState::kPending);
  EXPECT_EQ(validate(core).text(),
            "sites are neither visible nor hidden: count " + std::to_string(ids.size()));
}

TEST_F(DiagramCheck, HiddenSiteThatIsForgotten) {
  fill(9);
  IdPool& ids = Breaker::ids(core);
  ids.setState(lastHidden, SiteState::kFree);
  EXPECT_EQ(validate(core).text(),
            "the count of sites is wrong: count " + std::to_string(ids.size() - 1));
}

TEST_F(DiagramCheck, TwoSitesOfOneId) {
  fill(9);
  IdPool& ids = Breaker::ids(core);
  std::vector<SiteId> names(ids.size());
  std::iota(names.begin(), names.end(), SiteId{0});
  names[2] = 5;
  ids.rename(names, ids);
  EXPECT_EQ(validate(core).text(), "the slot of an id is another: site 5");
}

TEST_F(DiagramCheck, VisibleSiteInTheForest) {
  fill(9);
  Breaker::hidden(core).attach(last, 0);
  EXPECT_EQ(validate(core).text(),
            "a site that hangs on another is not hidden: site " + std::to_string(last));
}

TEST_F(DiagramCheck, HiddenSiteOnAnotherThanItsCover) {
  fill(9);
  Breaker::hidden(core).detach(lastHidden);
  Breaker::hidden(core).attach(lastHidden, last);
  EXPECT_EQ(validate(core).text(),
            "a hidden site is not covered by its parent: site " + std::to_string(lastHidden));
}

TEST_F(DiagramCheck, CycleInTheForest) {
  fill(9);
  Breaker::hidden(core).attach(lastHidden, lastHidden);
  expectBroken("the forest of hidden sites has a cycle: site");
}

TEST_F(DiagramCheck, OfIdenticalSitesTheLargerIdIsVisible) {
  (void)core.insert({1, 2, 3});
  (void)core.insert({1, 2, 3});
  ASSERT_EQ(validate(core).text(), "");
  const std::vector<SiteId> names{1, 0};
  Breaker::ids(core).rename(names, IdPool(Breaker::ids(core)));
  EXPECT_EQ(validate(core).text(),
            "a hidden site is identical to its parent and has a lesser id: site 0");
}

TEST_F(DiagramCheck, HiddenSiteOnNothing) {
  fill(9);
  Breaker::hidden(core).detach(lastHidden);
  expectBroken("hidden sites hang on nothing: reached");
}

TEST(Violation, SaysWhatIsBrokenWhere) {
  EXPECT_FALSE(Violation().isFound());
  EXPECT_EQ(Violation().text(), "");
  EXPECT_TRUE((Violation{"a loop: half-edge", 3}.isFound()));
  EXPECT_EQ((Violation{"a loop: half-edge", 3}.text()), "a loop: half-edge 3");
  EXPECT_EQ((Violation{"a loop: half-edge", 3, 2}.text()), "level 2: a loop: half-edge 3");
}

// --- The hierarchy

class HierarchyCheck : public DiagramCheck {
 protected:
  HierarchyCheck() {
    fill(400);
    EXPECT_GE(Breaker::levelCount(core), 1u);
    EXPECT_GE(level().visibleCount(), 3u);
  }
  DelaunayGraph& level() { return Breaker::level(core, 0); }
};

TEST_F(HierarchyCheck, ChecksEachLevel) {
  ++Breaker::visibleCount(level());
  expectBroken("level 1: the count of visible sites is wrong: count");
}

TEST_F(HierarchyCheck, SiteThatALevelLacks) {
  Remover remover;
  (void)remover.remove(level(), level().anyVisible(), {});
  expectBroken("level 1: it lacks a site: slot below");
}

TEST_F(HierarchyCheck, SitesBeyondAllSlotsOfALevel) {
  level() = DelaunayGraph();
  expectBroken("level 1: it lacks a site: slot below");
}

TEST_F(HierarchyCheck, SiteThatDiffers) {
  // Not one on the hull: those are in line, and one that grows takes over a face.
  const Graph& graph = level().graph();
  VertexId v = kNoVertex;
  for (std::uint32_t k = 1; k < graph.vertexSlots() && v == kNoVertex; ++k) {
    if (!graph.hasVertex(vertex(k))) continue;
    bool isOnHull = false;
    const HalfedgeId begin = graph.outgoing(vertex(k));
    HalfedgeId h = begin;
    do {
      isOnHull = isOnHull || graph.target(h) == kInfinity;
      h = graph.rotateCcw(h);
    } while (h != begin);
    if (!isOnHull) v = vertex(k);
  }
  ASSERT_NE(v, kNoVertex);
  const Site site = level().site(v);
  for (const Site& other :
       {Site{site.x + 1e-6, site.y, site.r}, Site{site.x, site.y + 1e-6, site.r},
        Site{site.x, site.y, site.r + 1e-6}}) {
    level().setSite(v, other);
    Breaker::computeCircles(level());
    expectBroken("level 1: levels differ about a site: slot below");
  }
}

TEST_F(HierarchyCheck, SiteThatIsNotBelow) {
  const auto v = vertex(static_cast<std::uint32_t>(level().graph().vertexSlots()));
  level().reserve(index(v) + 1);
  level().setSite(v, {-1000, -1000, 1});
  level().insert(v, kNoVertex);
  expectBroken("level 1: it holds sites that the level below does not: expected");
}

}  // namespace
}  // namespace apollonius::internal
