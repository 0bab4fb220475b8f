// Builders: the diagram that insertMany makes, in steps of any length; nothing of it if it is given
// up.
#include "apollonius/builder.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "support/building.h"
#include "support/effort.h"
#include "support/surfaces.h"

namespace apollonius::test {
namespace {

template <class Surface>
class BuilderOn : public ::testing::Test {
 protected:
  using Diagram = typename Surface::Diagram;
  using Builder = typename Surface::Builder;
};
TYPED_TEST_SUITE(BuilderOn, Surfaces, NamesOfSurfaces);

/// The snapshot has the slots, or the pole and the state of the draws, too.
TYPED_TEST(BuilderOn, MakesTheSameDiagramInSteps) {
  Random random(461);
  for (const std::size_t n : {std::size_t{12}, sized(std::size_t{300}, std::size_t{2000})}) {
    for (const auto& [name, triples] : TypeParam::sets(random, n)) {
      SCOPED_TRACE(name);
      const auto whole = madeOf<TypeParam>(triples);
      for (const std::size_t steps : kLengths) {
        typename TestFixture::Diagram diagram;
        build<typename TestFixture::Builder>(diagram, triples, 100, steps);
        ASSERT_EQ(saved(diagram), saved(whole));
        ASSERT_NO_FATAL_FAILURE(expectValid(diagram));
      }
    }
  }
}

TYPED_TEST(BuilderOn, GivenUpLeavesAnEmptyDiagram) {
  Random random(462);
  const Triples triples = TypeParam::sites(random, 400);
  typename TestFixture::Diagram diagram;
  for (int most = 0; most < 80; most += 3) {
    ASSERT_NO_FATAL_FAILURE(
        expectNothingIfGivenUp<typename TestFixture::Builder>(diagram, triples, most));
    ASSERT_NO_FATAL_FAILURE(expectValid(diagram));
  }
  std::vector<SiteId> ids(triples.size() / 3);
  ASSERT_EQ(diagram.insertMany(triples, ids), Error::kNone);
  EXPECT_EQ(ids.front(), 0u);
  EXPECT_EQ(ids.back(), ids.size() - 1);
  EXPECT_EQ(allNeighbors(diagram), allNeighbors(madeOf<TypeParam>(triples)));
}

TYPED_TEST(BuilderOn, StepsAreShort) {
  Random random(463);
  typename TestFixture::Diagram diagram;
  const Triples triples = TypeParam::sites(random, 5000);
  EXPECT_GE(build<typename TestFixture::Builder>(diagram, triples, 5000, 50), 100);
}

// (Places were read that are no more.)
TYPED_TEST(BuilderOn, MovedGoesOnWhereItWasAndIsDoneOnce) {
  Random random(464);
  const Triples triples = TypeParam::sites(random, 300);
  expectMovedAndDoneOnce<typename TestFixture::Builder>(triples, madeOf<TypeParam>(triples));
}

TYPED_TEST(BuilderOn, ReadsASnapshotInSteps) {
  Random random(465);
  for (const auto& [name, triples] : TypeParam::sets(random, 200)) {
    SCOPED_TRACE(name);
    auto whole = madeOf<TypeParam>(triples);
    for (SiteId id = 0; id < triples.size() / 3; id += 5) {
      bool removed = false;
      ASSERT_EQ(whole.remove(id, removed), Error::kNone);
    }
    for (const std::size_t steps : kLengths) {
      typename TestFixture::Diagram diagram;
      typename TestFixture::Builder builder(diagram);
      ASSERT_EQ(builder.read(saved(whole)), Error::kNone);
      finish(builder, steps);
      bool isDone = false;
      ASSERT_EQ(builder.advance(1, isDone), Error::kNone);
      EXPECT_TRUE(isDone);
      EXPECT_EQ(builder.progress(), 1);
      ASSERT_EQ(saved(diagram), saved(whole));
      ASSERT_NO_FATAL_FAILURE(expectValid(diagram));
    }
  }
}

TYPED_TEST(BuilderOn, ReadsNothingOfASnapshotThatIsGivenUpOrIsNone) {
  Random random(466);
  const auto whole = madeOf<TypeParam>(TypeParam::sites(random, 300));
  std::vector<std::uint8_t> bytes = saved(whole);
  typename TestFixture::Diagram diagram;
  for (int most = 0; most < 40; ++most) {
    typename TestFixture::Builder builder(diagram);
    ASSERT_EQ(builder.read(bytes), Error::kNone);
    bool isDone = false;
    for (int k = 0; k < most && !isDone; ++k) ASSERT_EQ(builder.advance(5, isDone), Error::kNone);
    ASSERT_FALSE(isDone);
    ASSERT_EQ(diagram.size(), 0u);
  }
  for (const std::size_t at : {std::size_t{3}, bytes.size() / 2, bytes.size() - 1}) {
    std::vector<std::uint8_t> wrong = bytes;
    wrong[at] ^= 1;
    typename TestFixture::Builder builder(diagram);
    ASSERT_EQ(builder.read(wrong), Error::kNone);
    bool isDone = false;
    for (int again = 0; again < 3; ++again) {
      EXPECT_EQ(builder.advance(SIZE_MAX, isDone), Error::kCorruptSnapshot);
      EXPECT_FALSE(isDone);
    }
    EXPECT_EQ(diagram.size(), 0u);
  }
}

TYPED_TEST(BuilderOn, RefusesWhatIsNoSite) {
  std::vector<std::pair<Triples, Error>> refused = {{{0, 0}, Error::kBadLength}};
  for (const auto& [site, error] : TypeParam::badSites())
    refused.push_back({{0, 0, 1, site[0], site[1], site[2]}, error});
  typename TestFixture::Diagram diagram;
  expectRefused<typename TestFixture::Builder>(diagram, refused);
}

}  // namespace
}  // namespace apollonius::test
