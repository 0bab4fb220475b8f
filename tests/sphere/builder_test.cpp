// SphericalBuilder: the diagram that insertMany makes, in steps of any length; nothing of it if it
// is given up.
#include <gtest/gtest.h>

#include <limits>

#include "apollonius/spherical_builder.h"
#include "sphere/sphere_sets.h"
#include "support/building.h"
#include "support/effort.h"

namespace apollonius::test {
namespace {

/// The snapshot has the pole and the state of the draws, too.
TEST(SphericalBuilder, MakesTheSameDiagramInSteps) {
  Random random(471);
  for (const std::size_t n : {std::size_t{12}, sized(std::size_t{200}, std::size_t{1000})}) {
    for (const NamedSites& set : namedSets(random, n)) {
      SCOPED_TRACE(set.name);
      const SphericalDiagram whole = diagramOf(set.sites);
      for (const std::size_t steps : kLengths) {
        SphericalDiagram diagram;
        build<SphericalBuilder>(diagram, flat(set.sites), 100, steps);
        ASSERT_EQ(saved(diagram), saved(whole));
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
    ASSERT_NO_FATAL_FAILURE(expectNothingIfGivenUp<SphericalBuilder>(diagram, sites, most));
    ASSERT_EQ(saved(diagram), saved(SphericalDiagram(6371)));
  }
}

TEST(SphericalBuilder, StepsAreShort) {
  Random random(473);
  SphericalDiagram diagram;
  EXPECT_GE(build<SphericalBuilder>(diagram, flat(randomSites(random, 5000, 0)), 5000, 50), 100);
}

TEST(SphericalBuilder, MovedGoesOnWhereItWasAndIsDoneOnce) {
  Random random(474);
  const SphericalSites sites = randomSites(random, 300, 0.1);
  expectMovedAndDoneOnce<SphericalBuilder>(flat(sites), diagramOf(sites));
}

TEST(SphericalBuilder, RefusesWhatIsNoSite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SphericalDiagram diagram;
  expectRefused<SphericalBuilder>(diagram, {{{0, 0, 1, nan, 0, 1}, Error::kNotFinite},
                                            {{0, 91, 0}, Error::kOutOfRange},
                                            {{0, 0, 4}, Error::kOutOfRange},
                                            {{0, 0}, Error::kBadLength}});
}

}  // namespace
}  // namespace apollonius::test
