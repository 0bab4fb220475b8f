// Builder: the diagram that insertMany makes, in steps of any length; nothing of it if it is given
// up.
#include "apollonius/builder.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <utility>

#include "support/canonical.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

std::vector<double> triples(const Circles& circles) {
  std::vector<double> xyr;
  for (const Circle& c : circles) xyr.insert(xyr.end(), {c.x, c.y, c.r});
  return xyr;
}

std::vector<std::uint8_t> bytesOf(const Diagram& diagram) {
  std::vector<std::uint8_t> bytes;
  EXPECT_EQ(diagram.toBytes(bytes), Error::kNone);
  return bytes;
}

/// How often advance() was called; the circles are added in portions.
int build(Diagram& diagram, const std::vector<double>& xyr, std::size_t portion,
          std::size_t steps) {
  Builder builder(diagram);
  EXPECT_EQ(builder.reserve(xyr.size() / 3), Error::kNone);
  for (std::size_t k = 0; k < xyr.size(); k += 3 * portion) {
    const std::size_t count = std::min(3 * portion, xyr.size() - k);
    EXPECT_EQ(builder.add({xyr.data() + k, count}), Error::kNone);
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

class BuilderOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(BuilderOn, MakesTheSameDiagramInSteps) {
  Random random(461);
  const std::vector<double> xyr =
      triples(GetParam().make(random, GetParam().large ? sized(1000, 3000) : 15));
  Diagram whole;
  std::vector<SiteId> ids(xyr.size() / 3);
  ASSERT_EQ(whole.insertMany(xyr, ids), Error::kNone);
  for (const std::size_t steps : {1, 7, 100000}) {
    Diagram diagram;
    build(diagram, xyr, 100, steps);
    ASSERT_EQ(bytesOf(diagram), bytesOf(whole)) << "slots, too, are the same";
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, BuilderOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Builder, GivenUpLeavesAnEmptyDiagram) {
  Random random(462);
  const std::vector<double> xyr = triples(randomCircles(random, 400, Hidden::k20Percent));
  Diagram fresh;
  std::vector<SiteId> ids(xyr.size() / 3);
  ASSERT_EQ(fresh.insertMany(xyr, ids), Error::kNone);
  Diagram diagram;
  for (int most = 0; most < 80; most += 3) {
    {
      Builder builder(diagram);
      ASSERT_EQ(builder.add(xyr), Error::kNone);
      bool isDone = false;
      for (int k = 0; k < most && !isDone; ++k) {
        ASSERT_EQ(builder.advance(5, isDone), Error::kNone);
      }
      ASSERT_FALSE(isDone);
    }
    ASSERT_EQ(diagram.size(), 0u);
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
  }
  ASSERT_EQ(diagram.insertMany(xyr, ids), Error::kNone);
  EXPECT_EQ(ids.front(), 0u);
  EXPECT_EQ(ids.back(), ids.size() - 1);
  std::string broken;
  EXPECT_EQ(difference(canonicalForm(fresh, broken), canonicalForm(diagram, broken)), "");
}

TEST(Builder, StepsAreShort) {
  Random random(463);
  const std::vector<double> xyr = triples(randomCircles(random, 5000, Hidden::kNone));
  Diagram diagram;
  EXPECT_GE(build(diagram, xyr, 5000, 50), 100);
}

TEST(Builder, MovedGoesOnWhereItWas) {
  Random random(464);
  const std::vector<double> xyr = triples(randomCircles(random, 300, Hidden::k20Percent));
  Diagram whole, diagram;
  std::vector<SiteId> ids(300);
  ASSERT_EQ(whole.insertMany(xyr, ids), Error::kNone);
  bool isDone = false;
  Builder first(diagram);
  ASSERT_EQ(first.add(xyr), Error::kNone);
  for (int k = 0; k < 40; ++k) ASSERT_EQ(first.advance(5, isDone), Error::kNone);
  Builder second(std::move(first));
  while (!isDone) ASSERT_EQ(second.advance(5, isDone), Error::kNone);
  EXPECT_EQ(bytesOf(diagram), bytesOf(whole));
}

// (Places were read that are no more.)
TEST(Builder, IsDoneOnce) {
  Random random(465);
  const std::vector<double> xyr = triples(randomCircles(random, 100, Hidden::kNone));
  Diagram diagram;
  Builder builder(diagram);
  ASSERT_EQ(builder.add(xyr), Error::kNone);
  bool isDone = false;
  while (!isDone) {
    ASSERT_EQ(builder.advance(20, isDone), Error::kNone);
  }
  const std::vector<std::uint8_t> bytes = bytesOf(diagram);
  for (int again = 0; again < 3; ++again) {
    ASSERT_EQ(builder.advance(20, isDone), Error::kNone);
    EXPECT_TRUE(isDone);
    EXPECT_EQ(builder.progress(), 1);
  }
  EXPECT_EQ(bytesOf(diagram), bytes);
}

TEST(Builder, RefusesWhatIsNoCircle) {
  Diagram diagram;
  Builder builder(diagram);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(builder.add(std::vector<double>{0, 0, 1, 0, nan, 1}), Error::kNotFinite);
  EXPECT_EQ(builder.add(std::vector<double>{0, 0, 1e101}), Error::kOutOfRange);
  EXPECT_EQ(builder.add(std::vector<double>{0, 0}), Error::kBadLength);
  EXPECT_EQ(builder.reserve(kMostSites + 1), Error::kTooLarge);
  bool isDone = false;
  EXPECT_EQ(builder.advance(1, isDone), Error::kNone);
  EXPECT_TRUE(isDone) << "of nothing";
  EXPECT_EQ(diagram.size(), 0u);
}

}  // namespace
}  // namespace apollonius::test
