// Moves, small ones above all, which mostly leave the graph as it is and take a shorter way: after
// each step the diagram is valid and that of a fresh construction.
#include <gtest/gtest.h>

#include "apollonius/diagram.h"
#include "support/canonical.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/saved.h"

namespace apollonius::internal {
namespace {

using namespace test;

Diagram diagramOf(const Circles& circles, std::vector<SiteId>& ids) {
  Diagram diagram;
  ids = insertInto(diagram, circles);
  return diagram;
}

double extentOf(const Circles& circles) {
  double extent = 0;
  for (const Circle& c : circles)
    extent = std::max({extent, std::abs(c.x - circles[0].x), std::abs(c.y - circles[0].y)});
  return extent > 0 ? extent : 1;
}

/// As a snapshot leaves it: with none of its circles, which are computed when they are asked for.
Diagram restored(const Diagram& diagram) {
  Diagram same;
  EXPECT_EQ(same.fromBytes(saved(diagram), Source::kTrusted), Error::kNone);
  return same;
}

class MovesOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(MovesOn, LeaveTheDiagramOfTheNewSites) {
  Random random(91);
  for (const double step : {1e-12, 1e-6, 1e-3, 1e-2, 0.1}) {
    Circles circles = GetParam().make(random, 40);
    if (circles.empty()) continue;
    const double reach = step * extentOf(circles);
    std::vector<SiteId> ids;
    Diagram diagram = diagramOf(circles, ids);
    for (int run = 0; run < runs(sized(4, 8)); ++run) {
      if (random.oneIn(3)) diagram = restored(diagram);
      for (std::size_t k = 0; k < circles.size(); ++k) {
        if (random.oneIn(4)) continue;
        Circle c = circles[k];
        c.x += random.between(-reach, reach);
        c.y += random.between(-reach, reach);
        if (random.oneIn(2)) c.r += random.between(-reach, reach);
        const Error error = diagram.update(ids[k], c.x, c.y, c.r);
        if (error == Error::kOutOfRange) continue;
        ASSERT_EQ(error, Error::kNone);
        circles[k] = c;
      }
      std::string broken;
      ASSERT_EQ(diagram.validate(broken), Error::kNone);
      ASSERT_EQ(broken, "") << "step " << step << ", run " << run;
      std::vector<SiteId> freshIds;
      const Diagram fresh = diagramOf(circles, freshIds);
      const Canonical expected = canonicalForm(fresh, broken), got = canonicalForm(diagram, broken);
      ASSERT_EQ(broken, "");
      ASSERT_EQ(difference(expected, got), "") << "step " << step << ", run " << run;
    }
  }
}

/// Frames of an animation: constant velocities, all circles at once.
TEST_P(MovesOn, ManyAtOnceLeaveTheDiagramOfTheNewSites) {
  Random random(92);
  for (const double step : {1e-9, 1e-4, 1e-3, 1e-2, 0.05, 0.3}) {  // sites may jump over others
    Circles circles = GetParam().make(random, GetParam().large ? 120 : 40);
    if (circles.empty()) continue;
    const double reach = step * extentOf(circles);
    std::vector<SiteId> ids;
    Diagram diagram = diagramOf(circles, ids);
    std::vector<Circle> velocities(circles.size());
    for (Circle& v : velocities)
      v = {random.between(-reach, reach), random.between(-reach, reach),
           random.oneIn(3) ? random.between(-reach, reach) : 0};
    for (int run = 0; run < runs(sized(4, 12)); ++run) {
      if (random.oneIn(3)) diagram = restored(diagram);
      Circles next = circles;
      std::vector<double> xyr;
      for (std::size_t k = 0; k < next.size(); ++k) {
        next[k].x += velocities[k].x;
        next[k].y += velocities[k].y;
        next[k].r += velocities[k].r;
        xyr.insert(xyr.end(), {next[k].x, next[k].y, next[k].r});
      }
      const Error error = diagram.updateMany(ids, xyr);
      if (error == Error::kOutOfRange) break;
      ASSERT_EQ(error, Error::kNone);
      circles = next;
      std::string broken;
      ASSERT_EQ(diagram.validate(broken), Error::kNone);
      ASSERT_EQ(broken, "") << "step " << step << ", run " << run;
      std::vector<SiteId> freshIds;
      const Diagram fresh = diagramOf(circles, freshIds);
      const Canonical expected = canonicalForm(fresh, broken), got = canonicalForm(diagram, broken);
      ASSERT_EQ(broken, "");
      ASSERT_EQ(difference(expected, got), "") << "step " << step << ", run " << run;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, MovesOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Moves, AFewSitesJumpAnywhere) {
  Random random(93);
  for (int run = 0; run < runs(4000); ++run) {
    const std::size_t n = 2 + random.below(6);
    const auto some = [&] {
      return random.oneIn(2) ? tinyGrid(random, n, 5, 2) : randomCircles(random, n, Hidden::kNone);
    };
    const Circles circles = some(), next = some();
    std::vector<SiteId> ids, freshIds;
    Diagram diagram = restored(diagramOf(circles, ids));
    ASSERT_EQ(diagram.updateMany(ids, flat(next)), Error::kNone);
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "") << "run " << run;
    const Diagram fresh = diagramOf(next, freshIds);
    const Canonical expected = canonicalForm(fresh, broken), got = canonicalForm(diagram, broken);
    ASSERT_EQ(difference(expected, got), "") << "run " << run;
  }
}

TEST(Moves, HiddenSitesFollowTheirCover) {
  std::vector<SiteId> ids;
  Diagram diagram =
      diagramOf({{0, 0, 5}, {1, 0, 1}, {20, 0, 1}, {0, 20, 1}, {-20, 0, 1}, {0, -20, 1}}, ids);
  ASSERT_EQ(diagram.hiddenSize(), 1u);
  ASSERT_EQ(diagram.update(ids[0], 0.5, 0, 5), Error::kNone);
  EXPECT_EQ(diagram.hiddenSize(), 1u);
  ASSERT_EQ(diagram.update(ids[0], -4, 0, 5),
            Error::kNone);  // within the same cell of the graph, but no longer over site 1
  EXPECT_EQ(diagram.hiddenSize(), 0u);
  std::string broken;
  ASSERT_EQ(diagram.validate(broken), Error::kNone);
  EXPECT_EQ(broken, "");
}

}  // namespace
}  // namespace apollonius::internal
