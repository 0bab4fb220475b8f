// Builder: the diagram that insertMany makes, in steps of any length; nothing of it if it is given
// up.
#include "apollonius/builder.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/building.h"
#include "support/canonical.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

Diagram insertedAtOnce(const std::vector<double>& xyr) {
  Diagram diagram;
  std::vector<SiteId> ids(xyr.size() / 3);
  EXPECT_EQ(diagram.insertMany(xyr, ids), Error::kNone);
  return diagram;
}

class BuilderOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(BuilderOn, MakesTheSameDiagramInSteps) {
  Random random(461);
  const std::vector<double> xyr =
      flat(GetParam().make(random, GetParam().large ? sized(1000, 3000) : 15));
  const Diagram whole = insertedAtOnce(xyr);
  for (const std::size_t steps : kLengths) {
    Diagram diagram;
    build<Builder>(diagram, xyr, 100, steps);
    ASSERT_EQ(saved(diagram), saved(whole)) << "slots, too, are the same";
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, BuilderOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Builder, GivenUpLeavesAnEmptyDiagram) {
  Random random(462);
  const std::vector<double> xyr = flat(randomCircles(random, 400, Hidden::k20Percent));
  Diagram diagram;
  for (int most = 0; most < 80; most += 3) {
    ASSERT_NO_FATAL_FAILURE(expectNothingIfGivenUp<Builder>(diagram, xyr, most));
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
  }
  std::vector<SiteId> ids(xyr.size() / 3);
  ASSERT_EQ(diagram.insertMany(xyr, ids), Error::kNone);
  EXPECT_EQ(ids.front(), 0u);
  EXPECT_EQ(ids.back(), ids.size() - 1);
  std::string broken;
  EXPECT_EQ(difference(canonicalForm(insertedAtOnce(xyr), broken), canonicalForm(diagram, broken)),
            "");
}

TEST(Builder, StepsAreShort) {
  Random random(463);
  const std::vector<double> xyr = flat(randomCircles(random, 5000, Hidden::kNone));
  Diagram diagram;
  EXPECT_GE(build<Builder>(diagram, xyr, 5000, 50), 100);
}

// (Places were read that are no more.)
TEST(Builder, MovedGoesOnWhereItWasAndIsDoneOnce) {
  Random random(464);
  const std::vector<double> xyr = flat(randomCircles(random, 300, Hidden::k20Percent));
  expectMovedAndDoneOnce<Builder>(xyr, insertedAtOnce(xyr));
}

TEST(Builder, RefusesWhatIsNoCircle) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Diagram diagram;
  expectRefused<Builder>(diagram, {{{0, 0, 1, 0, nan, 1}, Error::kNotFinite},
                                   {{0, 0, 1e101}, Error::kOutOfRange},
                                   {{0, 0}, Error::kBadLength}});
}

}  // namespace
}  // namespace apollonius::test
