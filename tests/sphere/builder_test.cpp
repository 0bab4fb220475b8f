// SphericalBuilder: the diagram that insertMany makes, in steps of any length; nothing of it if it
// is given up.
#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "apollonius/spherical_builder.h"
#include "sphere/sphere_sets.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

std::vector<std::uint8_t> bytesOf(const SphericalDiagram& diagram) {
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(diagram.toBytes(bytes), Error::kNone);
  return bytes;
}

/// How often advance() was called; the sites are added in portions.
int build(SphericalDiagram& diagram, const std::vector<double>& sites, std::size_t portion,
          std::size_t steps) {
  SphericalBuilder builder(diagram);
  EXPECT_EQ(builder.reserve(sites.size() / 3), Error::kNone);
  for (std::size_t k = 0; k < sites.size(); k += 3 * portion) {
    const std::size_t count = std::min(3 * portion, sites.size() - k);
    EXPECT_EQ(builder.add({sites.data() + k, count}), Error::kNone);
  }
  double last = 0;
  for (int calls = 1;; ++calls) {
    bool isDone = false;
    EXPECT_EQ(builder.advance(steps, isDone), Error::kNone);
    EXPECT_GE(builder.progress(), last);
    EXPECT_LE(builder.progress(), 1);
    last = builder.progress();
    if (isDone) return calls;
  }
}

/// The snapshot has the pole and the state of the draws, too.
TEST(SphericalBuilder, MakesTheSameDiagramInSteps) {
  Random random(471);
  for (const std::size_t n : {std::size_t{12}, sized(std::size_t{200}, std::size_t{1000})}) {
    for (const NamedSites& set : namedSets(random, n)) {
      SCOPED_TRACE(set.name);
      const SphericalDiagram whole = diagramOf(set.sites);
      for (const std::size_t steps : {1, 7, 100000}) {
        SphericalDiagram diagram;
        build(diagram, flat(set.sites), 100, steps);
        ASSERT_EQ(bytesOf(diagram), bytesOf(whole));
        Violation violation;
        ASSERT_EQ(diagram.validate(violation), Error::kNone);
        ASSERT_EQ(violation.text(), "");
      }
    }
  }
}

TEST(SphericalBuilder, GivenUpLeavesAnEmptyDiagram) {
  Random random(472);
  const std::vector<double> sites = flat(randomSites(random, 400, 0.1));
  SphericalDiagram diagram(6371);
  for (int most = 0; most < 80; most += 3) {
    {
      SphericalBuilder builder(diagram);
      ASSERT_EQ(builder.add(sites), Error::kNone);
      bool isDone = false;
      for (int k = 0; k < most && !isDone; ++k) ASSERT_EQ(builder.advance(5, isDone), Error::kNone);
      ASSERT_FALSE(isDone);
    }
    ASSERT_EQ(diagram.size(), 0u);
    ASSERT_EQ(diagram.radius(), 6371);
    ASSERT_EQ(bytesOf(diagram), bytesOf(SphericalDiagram(6371)));
  }
}

TEST(SphericalBuilder, StepsAreShort) {
  Random random(473);
  SphericalDiagram diagram;
  EXPECT_GE(build(diagram, flat(randomSites(random, 5000, 0)), 5000, 50), 100);
}

TEST(SphericalBuilder, MovedGoesOnWhereItWasAndIsDoneOnce) {
  Random random(474);
  const SphericalSites sites = randomSites(random, 300, 0.1);
  SphericalDiagram diagram;
  bool isDone = false;
  SphericalBuilder first(diagram);
  ASSERT_EQ(first.add(flat(sites)), Error::kNone);
  for (int k = 0; k < 20; ++k) ASSERT_EQ(first.advance(5, isDone), Error::kNone);
  SphericalBuilder second(std::move(first));
  while (!isDone) ASSERT_EQ(second.advance(5, isDone), Error::kNone);
  const std::vector<std::uint8_t> bytes = bytesOf(diagram);
  EXPECT_EQ(bytes, bytesOf(diagramOf(sites)));
  for (int again = 0; again < 3; ++again) {
    ASSERT_EQ(second.advance(20, isDone), Error::kNone);
    EXPECT_TRUE(isDone);
    EXPECT_EQ(second.progress(), 1);
  }
  EXPECT_EQ(bytesOf(diagram), bytes);
}

TEST(SphericalBuilder, RefusesWhatIsNoSite) {
  SphericalDiagram diagram;
  SphericalBuilder builder(diagram);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(builder.add(std::vector<double>{0, 0, 1, nan, 0, 1}), Error::kNotFinite);
  EXPECT_EQ(builder.add(std::vector<double>{0, 91, 0}), Error::kOutOfRange);
  EXPECT_EQ(builder.add(std::vector<double>{0, 0, 4}), Error::kOutOfRange);
  EXPECT_EQ(builder.add(std::vector<double>{0, 0}), Error::kBadLength);
  EXPECT_EQ(builder.reserve(kMostSites + 1), Error::kTooLarge);
  bool isDone = false;
  EXPECT_EQ(builder.advance(1, isDone), Error::kNone);
  EXPECT_TRUE(isDone) << "of nothing";
  EXPECT_EQ(diagram.size(), 0u);
}

}  // namespace
}  // namespace apollonius::test
