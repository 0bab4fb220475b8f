// findContradiction (delaunay/proof.h) in both directions: a surface with sites is accepted exactly
// if it is the Delaunay graph of them. Surfaces: graphs of other sites, of moved or exchanged ones,
// and with flipped edges.
#include "delaunay/proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "delaunay/diagram_breaker.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "topology/graph_breaker.h"

namespace apollonius::internal {
namespace {

using test::Circles;
using test::Random;
using test::runs;
using test::sized;

VertexId vertex(std::size_t v) { return VertexId{static_cast<std::uint32_t>(v)}; }

std::vector<Site> sitesOf(const Circles& circles) {
  std::vector<Site> sites;
  for (const Circle& c : circles) sites.push_back({c.x, c.y, c.r});
  return sites;
}

/// Vertices 1, 2, …
DelaunayGraph graphOf(const std::vector<Site>& sites) {
  DelaunayGraph diagram;
  diagram.reserve(sites.size() + 1);
  for (std::size_t k = 0; k < sites.size(); ++k) {
    diagram.setSite(vertex(k + 1), sites[k]);
    diagram.insert(vertex(k + 1), kNoVertex);
  }
  return diagram;
}

/// The sites across each side of each face. In a Delaunay graph the keys are different from each
/// other.
using Adjacency = std::multimap<std::array<std::size_t, 3>, std::size_t>;
Adjacency adjacencyOf(const Graph& graph) {
  Adjacency all;
  for (std::uint32_t i = 0; i < 3 * graph.faceSlots(); ++i) {
    const HalfedgeId h{i};
    if (!graph.isLive(faceOf(h))) continue;
    const std::array<std::size_t, 3> key{index(graph.origin(h)), index(graph.target(h)),
                                         index(graph.apex(h))};
    all.insert({key, index(graph.apex(graph.twin(h)))});
  }
  return all;
}

/// The verdict must be right. Returns whether the graph is that of its sites.
bool judge(const DelaunayGraph& diagram, std::size_t sites) {
  std::vector<Site> all;
  for (std::size_t k = 1; k <= sites; ++k) all.push_back(diagram.site(vertex(k)));
  const bool isRight = adjacencyOf(diagram.graph()) == adjacencyOf(graphOf(all).graph());
  FlatArray<VoronoiCircle> circles;
  std::uint32_t where = 0;
  const char* what = findContradiction(diagram, circles, where);
  if ((what == nullptr) != isRight) {
    std::string text;
    char line[100];
    for (const Site& s : all) {
      std::snprintf(line, sizeof line, "{%.17g, %.17g, %.17g}, ", s.x, s.y, s.r);
      text += line;
    }
    for (const auto& [key, across] : adjacencyOf(diagram.graph())) {
      text += '\n';
      for (const std::size_t v : key) text += std::to_string(v) + ' ';
      text += "| " + std::to_string(across);
    }
    const char* const verdict = what != nullptr ? what : "accepted";
    ADD_FAILURE() << verdict << " " << where << (isRight ? ", but is right" : ", but is wrong")
                  << "\n"
                  << text;
  }
  return isRight;
}

struct Tally {
  int right = 0, wrong = 0;
  void add(bool isRight) { ++(isRight ? right : wrong); }
};

/// Visible ones of a set.
std::vector<Site> visibleOf(const std::vector<Site>& sites) {
  const DelaunayGraph diagram = graphOf(sites);
  std::vector<Site> visible;
  for (std::size_t k = 0; k < sites.size(); ++k) {
    if (diagram.graph().hasVertex(vertex(k + 1))) visible.push_back(sites[k]);
  }
  return visible;
}

/// Replaces an edge by the other diagonal of its faces; returns false if there is none.
bool flip(DelaunayGraph& diagram, HalfedgeId h) {
  Graph& graph = DiagramBreaker::graph(diagram);
  GraphBreaker breaker(graph);
  const HalfedgeId t = graph.twin(h);
  const HalfedgeId hn = next(h), hp = previous(h), tn = next(t), tp = previous(t);
  const VertexId a = graph.origin(h), b = graph.origin(t), c = graph.apex(h), d = graph.apex(t);
  if (c == d || a == b) return false;
  const HalfedgeId outer[] = {graph.twin(hn), graph.twin(hp), graph.twin(tn), graph.twin(tp)};
  for (const HalfedgeId o : outer) {
    if (o == hn || o == hp || o == tn || o == tp) return false;
  }
  // Faces (c, d, b) and (d, c, a): h = c→d, hn = d→b, hp = b→c; t = d→c, tn = c→a, tp = a→d.
  const auto set = [&](HalfedgeId x, VertexId origin, HalfedgeId twin) {
    breaker.origin(x) = origin;
    breaker.twin(x) = twin;
    breaker.twin(twin) = x;
    breaker.outgoing(origin) = x;
  };
  set(h, c, t);
  set(t, d, h);
  set(hn, d, outer[3]);
  set(hp, b, outer[0]);
  set(tn, c, outer[1]);
  set(tp, a, outer[2]);
  // outer[0] was b→c's twin, outer[1] c→a's, outer[2] a→d's, outer[3] d→b's.
  return true;
}

/// All sorts of surfaces for the sites: as they are, flipped, with sites moved, exchanged or
/// replaced.
void judgeAround(const std::vector<Site>& some, Random& random,
                 const std::function<Site()>& another, Tally& tally) {
  const std::vector<Site> sites = visibleOf(some);
  const std::size_t n = sites.size();
  if (n < 2) return;
  const DelaunayGraph diagram = graphOf(sites);
  tally.add(judge(diagram, n));
  for (int k = 0; k < 4; ++k) {
    DelaunayGraph moved = graphOf(sites);
    moved.setSite(vertex(1 + random.below(n)), another());
    if (random.oneIn(3)) moved.setSite(vertex(1 + random.below(n)), another());
    tally.add(judge(moved, n));
    DelaunayGraph exchanged = graphOf(sites);
    const VertexId u = vertex(1 + random.below(n)), v = vertex(1 + random.below(n));
    exchanged.setSite(u, diagram.site(v));
    exchanged.setSite(v, diagram.site(u));
    tally.add(judge(exchanged, n));
    DelaunayGraph flipped = graphOf(sites);
    for (std::uint64_t flips = 1 + random.below(3u); flips > 0; --flips) {
      (void)flip(
          flipped,
          HalfedgeId{static_cast<std::uint32_t>(random.below(3 * flipped.graph().faceSlots()))});
    }
    std::uint32_t where = 0;
    ASSERT_EQ(flipped.graph().check(where), nullptr);
    tally.add(judge(flipped, n));
  }
  DelaunayGraph replaced = graphOf(sites);
  for (std::size_t k = 1; k <= n; ++k) replaced.setSite(vertex(k), another());
  tally.add(judge(replaced, n));
}

TEST(Proof, SurfacesOfSmallGrids) {
  Tally tally;
  const int count = runs(sized(1000, 6000));
  for (int run = 0; run < count; ++run) {
    SCOPED_TRACE(run);
    Random random(static_cast<std::uint64_t>(run) + 100);
    const int extent = 1 + static_cast<int>(random.below(5u)),
              weights = static_cast<int>(random.below(4u));
    const auto another = [&]() -> Site {
      const auto upTo = [&](int most) { return static_cast<double>(random.below(most + 1)); };
      const double x = upTo(extent), y = upTo(extent);
      return {x, y, upTo(weights)};
    };
    judgeAround(sitesOf(tinyGrid(random, 2 + random.below(9u), extent, weights)), random, another,
                tally);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(tally.right, count);
  EXPECT_GT(tally.wrong, 6 * count);
}

// One or two giants and small ones at their boundaries and between: several edges between two
// sites, sites of degree 2.
TEST(Proof, SurfacesWithMultipleEdges) {
  Tally tally;
  const int count = runs(sized(1000, 6000));
  for (int run = 0; run < count; ++run) {
    SCOPED_TRACE(run);
    Random random(static_cast<std::uint64_t>(run) + 100000);
    const bool onGrid = random.oneIn(2);
    const auto number = [&](int from, int to) {
      return onGrid ? static_cast<double>(random.integer(from, to)) : random.between(from, to);
    };
    const auto another = [&]() -> Site {
      const double x = number(-14, 14), y = number(-14, 14);
      return {x, y, random.oneIn(3) ? number(0, 9) : number(0, 2)};
    };
    std::vector<Site> sites{{-10, 0, number(5, 9)}, {10, 0, number(5, 9)}};
    if (random.oneIn(3)) sites[1] = {-10, 0, 20};
    for (std::uint64_t k = 1 + random.below(6u); k > 0; --k) {
      sites.push_back({number(-8, 8), number(-8, 8), number(0, 2)});
    }
    judgeAround(sites, random, another, tally);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(tally.right, count);
  EXPECT_GT(tally.wrong, 5 * count);
}

class ProofOnCorpus : public ::testing::TestWithParam<test::NamedGenerator> {};

TEST_P(ProofOnCorpus, SurfacesOfFewSites) {
  Tally tally;
  for (int run = 0; run < runs(sized(15, 40)); ++run) {
    SCOPED_TRACE(run);
    Random random(static_cast<std::uint64_t>(run) + 5000);
    const std::vector<Site> pool = sitesOf(GetParam().make(random, 40));
    const auto another = [&]() -> Site {
      Site site = pool[random.below(pool.size())];
      if (random.oneIn(2)) site.x = pool[random.below(pool.size())].x;
      if (random.oneIn(2)) site.r = pool[random.below(pool.size())].r;
      return site;
    };
    const std::size_t n =
        std::min<std::size_t>(pool.size(), 2 + random.below(GetParam().large ? 20u : 8u));
    judgeAround({pool.begin(), pool.begin() + static_cast<std::ptrdiff_t>(n)}, random, another,
                tally);
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(tally.wrong + tally.right, 0);
}

TEST_P(ProofOnCorpus, LargeGraphsAreProved) {
  Random random(77);
  const std::vector<Site> sites =
      visibleOf(sitesOf(GetParam().make(random, GetParam().large ? 400 : 20)));
  if (sites.size() < 2) return;
  EXPECT_TRUE(judge(graphOf(sites), sites.size()));
}

INSTANTIATE_TEST_SUITE_P(Proof, ProofOnCorpus, ::testing::ValuesIn(test::corpus()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace apollonius::internal
