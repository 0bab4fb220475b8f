// The grid of starting places: gives some site of the cell asked for, nothing where it is crowded,
// and never more than a hint.
#include "diagram/hint_grid.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace apollonius::internal {
namespace {

using Slots = std::set<Slot>;

Slots near(const HintGrid& grid, double x, double y) {
  Slots slots;
  grid.forEachNear(x, y, [&](Slot slot) { slots.insert(slot); });
  return slots;
}

TEST(HintGrid, GivesNothingBeforeItIsBuilt) {
  HintGrid grid;
  grid.insert(3, {1, 2, 0});
  EXPECT_EQ(near(grid, 1, 2), Slots{});
}

TEST(HintGrid, GivesASiteOfEachOfTheFourClosestCells) {
  HintGrid grid;
  grid.rebuild(100, {0, 0, 0}, {110, 110, 0});  // 11 cells a side, 10 wide
  for (Slot id = 0; id < 121; ++id)
    grid.insert(id, {10.0 * (id % 11) + 5, 10.0 * (id / 11) + 5, 1});
  EXPECT_EQ(near(grid, 51, 59), (Slots{59, 60, 70, 71}));  // column 5, row 5; 4 and 6 are closer
  EXPECT_EQ(near(grid, 59, 51), (Slots{49, 50, 60, 61}));
  EXPECT_EQ(near(grid, 1, 59), (Slots{55, 66}));
  EXPECT_EQ(near(grid, 109, 109), (Slots{120}));
}

TEST(HintGrid, PointsOutsideBelongToTheCellsAtTheBorder) {
  HintGrid grid;
  grid.rebuild(100, {0, 0, 0}, {110, 110, 0});
  grid.insert(7, {109, 109, 0});
  EXPECT_EQ(near(grid, 1e100, 1e100), Slots{7});
  EXPECT_EQ(near(grid, -1e100, 1e100), Slots{});
}

/// A slot that a cell names may have gone to a site elsewhere by now.
TEST(HintGrid, CloseIsWhatIsInTheCellOrBesideIt) {
  HintGrid grid;
  grid.rebuild(100, {0, 0, 0}, {110, 110, 0});
  grid.insert(7, {55, 55, 0});
  ASSERT_EQ(near(grid, 51, 59), Slots{7});
  EXPECT_TRUE(grid.isClose({55, 55, 0}, 51, 59));
  EXPECT_TRUE(grid.isClose({69, 41, 0}, 51, 59));
  EXPECT_FALSE(grid.isClose({71, 55, 0}, 51, 59));
  EXPECT_FALSE(grid.isClose({55, 39, 0}, 51, 59));
  EXPECT_TRUE(grid.isClose({-5, 1e100, 0}, 3, 105));  // outside belongs to the border
}

TEST(HintGrid, CrowdedCellsAreLeftToTheHierarchy) {
  HintGrid grid;
  grid.rebuild(100, {0, 0, 0}, {110, 110, 0});
  for (Slot id = 0; id < 6; ++id) grid.insert(id, {1, 1, 0});
  grid.insert(6, {11, 1, 0});
  EXPECT_EQ(near(grid, 9, 1), (Slots{5, 6}));
  grid.insert(7, {1, 1, 0});
  EXPECT_EQ(near(grid, 9, 1), Slots{});
  EXPECT_EQ(near(grid, 11, 1), Slots{6});
}

TEST(HintGrid, SitesOnALineOrAtOnePlace) {
  HintGrid grid;
  grid.rebuild(100, {5, 0, 0}, {5, 110, 0});
  grid.insert(1, {5, 15, 0});
  EXPECT_EQ(near(grid, 5, 15), Slots{1});
  grid.rebuild(100, {5, 5, 0}, {5, 5, 0});
  grid.insert(2, {5, 5, 0});
  EXPECT_EQ(near(grid, 0, 9), Slots{2});
}

TEST(HintGrid, IsOutgrownByAsMuchAsItHolds) {
  HintGrid grid;
  for (Slot id = 0; id < 64; ++id) grid.insert(id, {0, 0, 0});
  EXPECT_FALSE(grid.isOutgrown(0));
  grid.insert(64, {0, 0, 0});
  EXPECT_TRUE(grid.isOutgrown(0));
  grid.rebuild(100, {0, 0, 0}, {1, 1, 0});
  EXPECT_FALSE(grid.isOutgrown(0));
}

TEST(HintGrid, GapsGetASiteFromBeside) {
  HintGrid grid;
  grid.rebuild(120, {0, 0, 0}, {110, 110, 0});  // eleven cells a side
  grid.insert(7, {55, 55, 1});
  grid.fillGaps();
  // In the middle of a cell's lower left quarter, so that the other three are below and on the
  // left.
  for (const auto& [x, y] : {std::pair{52, 52}, {42, 52}, {62, 52}, {52, 42}, {52, 62}})
    EXPECT_EQ(near(grid, x, y), Slots{7}) << x << " " << y;
  EXPECT_EQ(near(grid, 22, 22), Slots{});
  EXPECT_EQ(near(grid, 72, 82), Slots{});
  grid.insert(8, {45, 55, 1});
  EXPECT_EQ(near(grid, 42, 58), Slots{8});
  HintGrid{}.fillGaps();
}

}  // namespace
}  // namespace apollonius::internal
