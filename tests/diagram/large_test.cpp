// Sets of thousands of sites, too many for the oracle: bulk against one by one, validate(), and a fresh build after half of them
// were removed one by one. The giant disks have a site of degree n; 95 % hidden circles have deep trees of hidden sites.
#include <gtest/gtest.h>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

struct LargeSet {
  const char* generator;
  int n;
};

void PrintTo(const LargeSet& set, std::ostream* out) { *out << set.generator << " " << set.n; }

class LargeSetOf : public ::testing::TestWithParam<LargeSet> {};

TEST_P(LargeSetOf, BulkOneByOneAndRemovalOfHalf) {
  Random random(321);
  Circles circles;
  for (const NamedGenerator& generator : corpus()) {
    if (generator.name == GetParam().generator) circles = generator.make(random, static_cast<std::size_t>(runs(GetParam().n)));
  }
  ASSERT_FALSE(circles.empty());
  std::string broken;
  const Canonical bulk = freshBuild(circles, Build::kBulk, Location::kHierarchy, broken);
  ASSERT_EQ(broken, "");

  Diagram diagram;
  std::vector<SiteId> ids(circles.size());
  for (std::size_t k = 0; k < circles.size(); ++k) {
    ASSERT_EQ(diagram.insert(circles[k].x, circles[k].y, circles[k].r, ids[k]), Error::kNone);
  }
  const Canonical oneByOne = canonicalForm(diagram, broken);
  ASSERT_EQ(broken, "");
  ASSERT_TRUE(oneByOne == bulk) << difference(bulk, oneByOne);

  Circles rest;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    bool removed = true;
    if (k % 2 == 0) {
      ASSERT_EQ(diagram.remove(ids[k], removed), Error::kNone);
    } else {
      rest.push_back(circles[k]);
    }
    ASSERT_TRUE(removed);
  }
  ASSERT_EQ(diagram.validate(broken), Error::kNone);
  ASSERT_EQ(broken, "");
  const Canonical expected = freshBuild(rest, Build::kBulk, Location::kHierarchy, broken);
  const Canonical got = canonicalForm(diagram, broken);
  ASSERT_EQ(broken, "");
  ASSERT_TRUE(got == expected) << difference(expected, got);
}

INSTANTIATE_TEST_SUITE_P(Sets, LargeSetOf,
                         ::testing::Values(LargeSet{"Points", 10000}, LargeSet{"Hidden5Percent", 10000},
                                           LargeSet{"Hidden50Percent", 10000}, LargeSet{"Hidden95Percent", 20000},
                                           LargeSet{"PowerLaw", 10000}, LargeSet{"GiantDisk", 1000},
                                           LargeSet{"GiantDiskExact", 1000}, LargeSet{"IntegerLattice", 2500},
                                           LargeSet{"DecimalLattice", 2500}, LargeSet{"Grid20Radius10", 3000},
                                           LargeSet{"CocircularPoints", 324}, LargeSet{"CommonTangent", 1000},
                                           LargeSet{"RandomSlopeLine", 1000}, LargeSet{"HorizontalLineEqualSpacing", 1000},
                                           LargeSet{"Concentric", 3000}, LargeSet{"TangentOutside", 3000},
                                           LargeSet{"TangentInside", 3000}, LargeSet{"NestedClusters", 3000}));

}  // namespace
}  // namespace apollonius::test
