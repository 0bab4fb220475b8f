// neighbors(), vertices(), edges() and faces() against each other, and the vertices' coordinates
// against their definition.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

struct Listed {
  std::vector<SiteId> ids, faces;
  VertexArrays vertices;
  EdgeArrays edges;
};

Listed build(Diagram& diagram, const Circles& circles) {
  Listed listed;
  listed.ids = insertInto(diagram, circles);
  EXPECT_EQ(diagram.faces(listed.faces), Error::kNone);
  EXPECT_EQ(diagram.vertices(listed.vertices), Error::kNone);
  EXPECT_EQ(diagram.edges(listed.edges), Error::kNone);
  return listed;
}

/// The neighbours of `site` in counter-clockwise order, once around, from the faces; empty if a
/// neighbour occurs more than once (then faces alone do not say how they follow each other).
std::vector<SiteId> turnAround(const std::vector<SiteId>& faces, SiteId site) {
  std::map<SiteId, SiteId> following;
  std::size_t count = 0;
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k] != site) continue;
    const std::size_t base = k - k % 3;
    following[faces[base + (k + 1) % 3]] = faces[base + (k + 2) % 3];
    ++count;
  }
  if (following.size() != count || count == 0) return {};
  std::vector<SiteId> around;
  SiteId at = following.begin()->first;
  for (std::size_t k = 0; k < count; ++k) {
    around.push_back(at);
    at = following.at(at);
  }
  return around;
}

class ListingOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(ListingOn, NeighborsAreThoseOfTheFacesCounterClockwise) {
  Random random(281);
  for (int run = 0; run < runs(5); ++run) {
    Diagram diagram;
    const Circles circles =
        GetParam().make(random, GetParam().large ? 40 + 30 * static_cast<std::size_t>(run) : 10);
    const Listed listed = build(diagram, circles);
    std::map<SiteId, std::set<SiteId>> adjacent, acrossEdges;
    for (std::size_t k = 0; k < listed.edges.sites.size(); k += 2) {
      const SiteId a = listed.edges.sites[k], b = listed.edges.sites[k + 1];
      acrossEdges[a].insert(b);
      acrossEdges[b].insert(a);
    }
    for (std::size_t k = 0; k < listed.faces.size(); ++k) {
      const SiteId a = listed.faces[k], b = listed.faces[k - k % 3 + (k + 1) % 3];
      if (a != kNoSite && b != kNoSite) adjacent[a].insert(b);
    }
    for (const SiteId id : listed.ids) {
      std::vector<SiteId> neighbors;
      ASSERT_EQ(diagram.neighbors(id, neighbors), Error::kNone);
      ASSERT_EQ(std::set<SiteId>(neighbors.begin(), neighbors.end()), adjacent[id]);
      ASSERT_EQ(acrossEdges[id], adjacent[id]);
      ASSERT_EQ(neighbors.size(), adjacent[id].size()) << "each once";
      for (const SiteId other : neighbors) ASSERT_EQ(adjacent[other].count(id), 1u) << "symmetric";
      std::vector<SiteId> around = turnAround(listed.faces, id);
      if (around.empty()) continue;
      around.erase(std::remove(around.begin(), around.end(), kNoSite), around.end());
      std::rotate(around.begin(),
                  std::find(around.begin(), around.end(), neighbors.empty() ? 0 : neighbors[0]),
                  around.end());
      ASSERT_EQ(neighbors, around) << "counter-clockwise";
    }
  }
}

TEST_P(ListingOn, EdgesAndVerticesAreConsistent) {
  // canonicalForm does the checking: three edges a vertex, ends that fit, sites that are visible.
  Random random(282);
  const Circles circles = GetParam().make(random, GetParam().large ? 500 : 16);
  std::string broken;
  (void)freshBuild(circles, Build::kBulk, Location::kHierarchy, broken);
  EXPECT_EQ(broken, "");
}

INSTANTIATE_TEST_SUITE_P(Corpus, ListingOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Listing, VerticesAreEquidistantAndNothingIsNearer) {
  Random random(283);
  for (const Hidden hidden : {Hidden::kNone, Hidden::k20Percent, Hidden::k50Percent}) {
    Diagram diagram;
    const Circles circles = randomCircles(random, 300, hidden);
    const Listed listed = build(diagram, circles);
    for (std::size_t k = 0; k < listed.vertices.clearance.size(); ++k) {
      const double x = listed.vertices.coordinates[2 * k],
                   y = listed.vertices.coordinates[2 * k + 1];
      const double clearance = listed.vertices.clearance[k];
      ASSERT_TRUE(std::isfinite(x) && std::isfinite(y) && std::isfinite(clearance));
      const double size = std::abs(x) + std::abs(y) + 2e6;
      // Far vertices (three sites nearly in line) are ill-conditioned along their edge, not across
      // it: the distances agree.
      const double tolerance = 1e-9 * size;
      for (std::size_t c = 0; c < 3; ++c) {
        Circle circle{};
        ASSERT_EQ(diagram.site(listed.vertices.sites[3 * k + c], circle), Error::kNone);
        const double dx = x - circle.x, dy = y - circle.y;
        ASSERT_NEAR(std::sqrt(dx * dx + dy * dy) - circle.r, clearance, tolerance);
      }
      for (const Circle& circle : circles) {
        const double dx = x - circle.x, dy = y - circle.y;
        ASSERT_GT(std::sqrt(dx * dx + dy * dy) - circle.r, clearance - tolerance);
      }
    }
  }
}

/// The listed vertex against the exact circle of its sites.
void expectAccurate(const Circle (&c)[3], double x, double y, double clearance) {
  const double size = std::abs(x) + std::abs(y) + std::abs(clearance);
  if (!std::isfinite(size)) {
    // Only where the exact circle is beyond the doubles, too.
    ASSERT_FALSE(oracleCircleIsWithin(c[0], c[1], c[2], {0, 0, 0}, 1e300))
        << x << " " << y << " " << clearance << " for\n"
        << toText(insertAll({c[0], c[1], c[2]}));
    return;
  }
  double sites = 0;
  for (const Circle& circle : c)
    sites = std::max({sites, std::abs(circle.x), std::abs(circle.y), std::abs(circle.r)});
  const double error = 0x1p-39 * size + 0x1p-48 * sites;
  ASSERT_TRUE(oracleCircleIsWithin(c[0], c[1], c[2], {x, y, clearance}, error))
      << x << " " << y << " " << clearance << " for\n"
      << toText(insertAll({c[0], c[1], c[2]}));
}

TEST_P(ListingOn, CoordinatesAreAccurate) {
  Random random(284);
  for (int run = 0; run < runs(30); ++run) {
    Diagram diagram;
    const Listed listed = build(diagram, GetParam().make(random, GetParam().large ? 15 : 8));
    for (std::size_t k = 0; k < listed.vertices.clearance.size(); ++k) {
      Circle c[3];
      for (std::size_t corner = 0; corner < 3; ++corner) {
        ASSERT_EQ(diagram.site(listed.vertices.sites[3 * k + corner], c[corner]), Error::kNone);
      }
      expectAccurate(c, listed.vertices.coordinates[2 * k], listed.vertices.coordinates[2 * k + 1],
                     listed.vertices.clearance[k]);
      if (HasFatalFailure()) FAIL() << "run " << run;
    }
  }
}

TEST(Listing, TwoSitesShareOneLine) {
  Diagram diagram;
  const Listed listed = build(diagram, {{0, 0, 1}, {10, 0, 2}});
  EXPECT_TRUE(listed.vertices.clearance.empty());
  EXPECT_EQ(listed.edges.vertices, (std::vector<std::int32_t>{-1, -1}));
  EXPECT_EQ(listed.edges.sites.size(), 2u);
  EXPECT_EQ(listed.faces.size(), 6u);
}

TEST(Listing, ThreeInLineShareTwoLines) {
  Diagram diagram;
  const Listed listed = build(diagram, {{0, 0, 1}, {10, 0, 1}, {20, 0, 1}});
  EXPECT_TRUE(listed.vertices.clearance.empty());
  EXPECT_EQ(listed.edges.vertices, (std::vector<std::int32_t>{-1, -1, -1, -1}));
  EXPECT_EQ(listed.edges.sites.size(), 4u);
}

TEST(Listing, NeighborsInLineAreTheTwoBeside) {
  constexpr std::size_t kCount = 100;
  for (const double slope : {0.0, 1.0, -3.0}) {
    Circles circles;
    for (std::size_t k = 0; k < kCount; ++k)
      circles.push_back({static_cast<double>(k), slope * static_cast<double>(k), 2});
    Diagram diagram;
    const Listed listed = build(diagram, circles);
    for (std::size_t k = 0; k < kCount; ++k) {
      std::vector<SiteId> neighbors;
      ASSERT_EQ(diagram.neighbors(listed.ids[k], neighbors), Error::kNone);
      std::sort(neighbors.begin(), neighbors.end());
      std::vector<SiteId> expected;
      if (k > 0) expected.push_back(listed.ids[k - 1]);
      if (k + 1 < kCount) expected.push_back(listed.ids[k + 1]);
      ASSERT_EQ(neighbors, expected);
    }
  }
}

TEST(Listing, NoSitesAndOneSite) {
  Diagram diagram;
  Listed listed = build(diagram, {});
  EXPECT_TRUE(listed.vertices.clearance.empty() && listed.edges.sites.empty() &&
              listed.faces.empty());
  listed = build(diagram, {{0, 0, 1}});
  EXPECT_TRUE(listed.vertices.clearance.empty() && listed.edges.sites.empty() &&
              listed.faces.empty());
  std::vector<SiteId> neighbors{3};
  EXPECT_EQ(diagram.neighbors(listed.ids[0], neighbors), Error::kNone);
  EXPECT_TRUE(neighbors.empty());
}

}  // namespace
}  // namespace apollonius::test
