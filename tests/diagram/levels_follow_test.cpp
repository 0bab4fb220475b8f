// A level of the hierarchy that cannot follow moves in place, while the base can: its sites are on
// a lattice, where any move changes faces; those of the base are not. Its sites leave it and enter
// again; the levels show that none is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/effort.h"
#include "support/random.h"

namespace apollonius::test {
namespace {

std::vector<std::uint8_t> levelsOf(const Diagram& diagram) {
  std::vector<std::uint8_t> levels;
  EXPECT_EQ(diagram.levels(levels), Error::kNone);
  return levels;
}

/// Inserts one after the other, so that slots and with them levels do not depend on the positions.
void insertOneByOne(Diagram& diagram, const std::vector<double>& xyr) {
  SiteId id = kNoSite;
  for (std::size_t k = 0; k < xyr.size(); k += 3)
    ASSERT_EQ(diagram.insert(xyr[k], xyr[k + 1], xyr[k + 2], id), Error::kNone);
}

TEST(Levels, OnALatticeFollowTheBase) {
  constexpr std::size_t kSites = 2500, kColumns = 9;
  Random random(211);
  std::vector<double> xyr;
  for (std::size_t k = 0; k < kSites; ++k)
    xyr.insert(xyr.end(), {random.between(0, 90), random.between(0, 90), 0});
  Diagram first;
  insertOneByOne(first, xyr);
  const std::vector<std::uint8_t> levels = levelsOf(first);
  std::size_t count = 0;
  for (std::size_t k = 0; k < kSites; ++k) {
    if (levels[k] < 2) continue;
    xyr[3 * k] = 10 * static_cast<double>(count % kColumns);
    xyr[3 * k + 1] = 10 * static_cast<double>(count / kColumns);
    ++count;
  }
  ASSERT_GT(count, 50u);

  Diagram diagram;
  insertOneByOne(diagram, xyr);
  ASSERT_EQ(levelsOf(diagram), levels);
  std::vector<SiteId> ids(kSites);
  for (SiteId id = 0; id < kSites; ++id) ids[id] = id;
  for (int step = 0; step < 3; ++step) {
    for (std::size_t k = 0; k < xyr.size(); ++k) {
      if (k % 3 != 2) xyr[k] += 1e-9 * random.between(-1, 1);
    }
    ASSERT_EQ(diagram.updateMany(ids, xyr), Error::kNone);
    std::string broken;
    ASSERT_EQ(diagram.validate(broken), Error::kNone);
    ASSERT_EQ(broken, "");
    ASSERT_EQ(levelsOf(diagram), levels) << "step " << step;
  }
}

}  // namespace
}  // namespace apollonius::test
