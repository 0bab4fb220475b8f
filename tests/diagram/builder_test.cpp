// Builders: the diagram that insertMany makes, in steps of any length; nothing of it if it is given
// up.
#include "apollonius/builder.h"

#include <gtest/gtest.h>

#include <limits>

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

TYPED_TEST(BuilderOn, RefusesWhatIsNoSite) {
  std::vector<std::pair<Triples, Error>> refused = {{{0, 0}, Error::kBadLength}};
  for (const auto& [site, error] : TypeParam::badSites())
    refused.push_back({{0, 0, 1, site[0], site[1], site[2]}, error});
  typename TestFixture::Diagram diagram;
  expectRefused<typename TestFixture::Builder>(diagram, refused);
}

}  // namespace
}  // namespace apollonius::test
