// Sets of thousands of sites, too many for the oracle: bulk against one by one, validate(), and a
// fresh build after half of them were removed one by one. The giant disks have a site of degree n;
// 95 % hidden circles have deep trees of hidden sites.
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
    if (generator.name == GetParam().generator)
      circles = generator.make(random, static_cast<std::size_t>(runs(GetParam().n / sized(4, 1))));
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

INSTANTIATE_TEST_SUITE_P(
    Sets, LargeSetOf,
    ::testing::Values(LargeSet{"Points", 10000}, LargeSet{"Hidden5Percent", 10000},
                      LargeSet{"Hidden50Percent", 10000}, LargeSet{"Hidden95Percent", 20000},
                      LargeSet{"PowerLaw", 10000}, LargeSet{"GiantDisk", 1000},
                      LargeSet{"GiantDiskExact", 1000}, LargeSet{"IntegerLattice", 2500},
                      LargeSet{"DecimalLattice", 2500}, LargeSet{"Grid20Radius10", 3000},
                      LargeSet{"CocircularPoints", 324}, LargeSet{"CommonTangent", 1000},
                      LargeSet{"RandomSlopeLine", 1000},
                      LargeSet{"HorizontalLineEqualSpacing", 1000}, LargeSet{"Concentric", 3000},
                      LargeSet{"TangentOutside", 3000}, LargeSet{"TangentInside", 3000},
                      LargeSet{"NestedClusters", 3000}));

/// Sites come and go while the place where they are and the size of it change by orders of
/// magnitude: whatever location keeps to start its walks from must follow.
TEST(LargeHistory, DriftingSites) {
  for (const Location location : {Location::kHierarchy, Location::kWalk}) {
    Random random(322);
    Diagram diagram(location);
    std::vector<SiteId> ids;
    Circles circles;
    const std::size_t most =
        static_cast<std::size_t>(runs((location == Location::kWalk ? 800 : 4000) / sized(8, 1)));
    for (const double scale : {1.0, 1e-6, 1e4, 1e60, 1e-60, 1.0}) {
      const double centre = scale * random.between(-3, 3);
      const auto draw = [&] {
        const double x = centre + scale * random.between(-1, 1);
        const double y = centre + scale * random.between(-1, 1);
        return Circle{x, y, 0.01 * scale * random.unit()};
      };
      for (std::size_t step = 0; step < 2 * most; ++step) {
        const std::size_t chosen = ids.empty() ? 0 : random.below(ids.size());
        const int dice = random.below(4);
        if (ids.size() < most && (ids.empty() || dice < 2)) {
          circles.push_back(draw());
          ids.push_back(kNoSite);
          ASSERT_EQ(
              diagram.insert(circles.back().x, circles.back().y, circles.back().r, ids.back()),
              Error::kNone);
        } else if (dice < 3) {
          circles[chosen] = draw();
          ASSERT_EQ(
              diagram.update(ids[chosen], circles[chosen].x, circles[chosen].y, circles[chosen].r),
              Error::kNone);
        } else {
          bool removed = false;
          ASSERT_EQ(diagram.remove(ids[chosen], removed), Error::kNone);
          std::swap(ids[chosen], ids.back());
          std::swap(circles[chosen], circles.back());
          ids.pop_back();
          circles.pop_back();
        }
      }
      for (int point = 0; point < 10; ++point) {
        const Circle at = draw();
        SiteId found = kNoSite;
        double distance = 0;
        ASSERT_EQ(diagram.find(at.x, at.y, found, distance), Error::kNone);
        Circle got{};
        ASSERT_EQ(diagram.site(found, got), Error::kNone);
        const Circle& expected =
            circles[static_cast<std::size_t>(oracleNearest(circles, at.x, at.y))];
        ASSERT_TRUE(got.x == expected.x && got.y == expected.y && got.r == expected.r)
            << "scale " << scale;
      }
      std::string broken;
      ASSERT_EQ(diagram.validate(broken), Error::kNone);
      ASSERT_EQ(broken, "") << "scale " << scale;
      const Canonical got = canonicalForm(diagram, broken);
      ASSERT_EQ(broken, "");
      const Canonical expected = freshBuild(circles, Build::kBulk, location, broken);
      ASSERT_EQ(broken, "");
      ASSERT_TRUE(got == expected) << "scale " << scale;
    }
  }
}

}  // namespace
}  // namespace apollonius::test
