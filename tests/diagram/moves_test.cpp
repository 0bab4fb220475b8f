// Moves, small ones above all, which mostly leave the graph as it is and take a shorter way: after
// each step the diagram is valid and that of a fresh construction.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "diagram/bulk_insertion.h"
#include "diagram/diagram_core.h"
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

/// The diagram restored from a snapshot: it has no circles, which are computed when needed.
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

/// Steps of all sizes, in mean spacings, of sets that are large enough for some to flip edges.
/// Small ones move each site by itself, or the whole set, which stays degenerate.
TEST_P(MovesOn, StepsOfAllSizesLeaveTheDiagramOfTheNewSites) {
  Random random(94);
  Circles circles = GetParam().make(random, GetParam().large ? 200 : 30);
  if (circles.empty()) return;
  std::vector<SiteId> ids;
  Diagram diagram = diagramOf(circles, ids);
  const double spacing = 2 * extentOf(circles) / std::sqrt(static_cast<double>(circles.size()));
  for (const double step : {0.0001, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0}) {
    for (const bool isRigid : {false, true}) {
      const double reach = step * spacing;
      const double turn = isRigid ? step / 30 : 0, shift = isRigid ? reach : 0;
      Circles next = circles;
      for (Circle& c : next) {
        const double x = c.x, y = c.y;
        c.x += shift - turn * y;
        c.y += shift + turn * x;
        if (isRigid) continue;
        c.x += random.between(-reach, reach);
        c.y += random.between(-reach, reach);
        if (random.oneIn(3)) c.r += random.between(-reach, reach);
      }
      const Error error = diagram.updateMany(ids, flat(next));
      if (error == Error::kOutOfRange) continue;
      ASSERT_EQ(error, Error::kNone);
      circles = next;
      std::string broken;
      ASSERT_EQ(diagram.validate(broken), Error::kNone);
      ASSERT_EQ(broken, "") << "step " << step;
      std::vector<SiteId> freshIds;
      const Diagram fresh = diagramOf(circles, freshIds);
      const Canonical expected = canonicalForm(fresh, broken), got = canonicalForm(diagram, broken);
      ASSERT_EQ(broken, "");
      ASSERT_EQ(difference(expected, got), "") << "step " << step << ", rigid " << isRigid;
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

/// Small circles beside the rims of large ones, which some of them enter at each step and others
/// leave.
TEST(Moves, SitesGetHiddenAndAppearWhileEdgesAreFlipped) {
  Random random(95);
  const auto n = static_cast<std::size_t>(runs(900));
  Circles circles;
  const double side = std::sqrt(static_cast<double>(n));
  while (circles.size() < n) {
    const Circle large{random.between(0, side), random.between(0, side), random.between(0.3, 0.6)};
    circles.push_back(large);
    const double r = random.between(0, 0.2), way = large.r - r + random.between(-0.01, 0.01);
    const double t = random.between(-1, 1), norm = 1 + t * t;
    circles.push_back({large.x + way * (1 - t * t) / norm, large.y + way * 2 * t / norm, r});
  }
  std::vector<SiteId> ids, freshIds;
  Diagram diagram = diagramOf(circles, ids);
  std::size_t least = n, most = 0;
  for (int frame = 0; frame < 12; ++frame) {
    const double reach = frame % 3 == 0 ? 0.003 : 0.0005;
    for (Circle& c : circles) {
      c.x += random.between(-reach, reach);
      c.y += random.between(-reach, reach);
    }
    ASSERT_EQ(diagram.updateMany(ids, flat(circles)), Error::kNone);
    least = std::min(least, diagram.hiddenSize());
    most = std::max(most, diagram.hiddenSize());
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "") << "frame " << frame;
    const Diagram fresh = diagramOf(circles, freshIds);
    const Canonical expected = canonicalForm(fresh, broken), got = canonicalForm(diagram, broken);
    ASSERT_EQ(difference(expected, got), "") << "frame " << frame;
  }
  EXPECT_GT(least, 0u);
  EXPECT_LT(least, most);
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

/// The layout of a diagram shows whether it was rebuilt.
TEST(Moves, AFewFlipsBuildNothingAnewAndFarMovesDo) {
  Random random(96);
  const auto n = static_cast<std::size_t>(runs(2000));
  const double spacing = 2e6 / std::sqrt(static_cast<double>(n));  // mean one of randomCircles()
  for (const Hidden hidden : {Hidden::kNone, Hidden::k5Percent}) {
    Circles circles = randomCircles(random, n, hidden);
    DiagramCore core(Location::kHierarchy);
    std::vector<SiteId> ids(n);
    insertAll(core, flat(circles), ids);
    for (const double step : {0.01, 0.02, 30.0}) {
      for (Circle& c : circles) {
        c.x += step * spacing * random.between(-1, 1);
        c.y += step * spacing * random.between(-1, 1);
      }
      const std::uint32_t layout = core.layout();
      core.updateMany(ids, flat(circles));
      EXPECT_EQ(core.layout() == layout, step < 1) << "step " << step;
    }
  }
}

}  // namespace
}  // namespace apollonius::internal
