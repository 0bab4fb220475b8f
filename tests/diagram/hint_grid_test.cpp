// The grid of starting places: gives some site of the cell asked for, nothing where it is crowded,
// and never more than a hint.
#include "diagram/hint_grid.h"

#include <gtest/gtest.h>

namespace apollonius::internal {
namespace {

TEST(HintGrid, GivesNothingBeforeItIsBuilt) {
  HintGrid grid;
  grid.insert(3, {1, 2, 0});
  EXPECT_EQ(grid.near(1, 2), kNoSlot);
}

TEST(HintGrid, GivesASiteOfTheCell) {
  HintGrid grid;
  grid.rebuild(100, {0, 0, 0}, {110, 110, 0});  // 11 cells a side, 10 wide
  for (Slot id = 0; id < 121; ++id)
    grid.insert(id, {10.0 * (id % 11) + 5, 10.0 * (id / 11) + 5, 1});
  for (Slot id = 0; id < 121; ++id)
    EXPECT_EQ(grid.near(10.0 * (id % 11) + 1, 10.0 * (id / 11) + 9), id);
}

TEST(HintGrid, PointsOutsideBelongToTheCellsAtTheBorder) {
  HintGrid grid;
  grid.rebuild(100, {0, 0, 0}, {110, 110, 0});
  grid.insert(7, {109, 109, 0});
  EXPECT_EQ(grid.near(1e100, 1e100), 7u);
  EXPECT_EQ(grid.near(-1e100, 1e100), kNoSlot);
}

/// A slot that a cell names may have gone to a site elsewhere by now.
TEST(HintGrid, CloseIsWhatIsInTheCellOrBesideIt) {
  HintGrid grid;
  grid.rebuild(100, {0, 0, 0}, {110, 110, 0});
  grid.insert(7, {55, 55, 0});
  ASSERT_EQ(grid.near(51, 59), 7u);
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
  EXPECT_NE(grid.near(1, 1), kNoSlot);
  grid.insert(6, {1, 1, 0});
  EXPECT_EQ(grid.near(1, 1), kNoSlot);
}

TEST(HintGrid, SitesOnALineOrAtOnePlace) {
  HintGrid grid;
  grid.rebuild(100, {5, 0, 0}, {5, 110, 0});
  grid.insert(1, {5, 15, 0});
  EXPECT_EQ(grid.near(5, 15), 1u);
  grid.rebuild(100, {5, 5, 0}, {5, 5, 0});
  grid.insert(2, {5, 5, 0});
  EXPECT_EQ(grid.near(0, 9), 2u);
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
  for (const Slot near : {grid.near(55, 55), grid.near(45, 55), grid.near(65, 55),
                          grid.near(55, 45), grid.near(55, 65)})
    EXPECT_EQ(near, 7u);
  EXPECT_EQ(grid.near(45, 45), kNoSlot);
  EXPECT_EQ(grid.near(75, 55), kNoSlot);
  grid.insert(8, {45, 55, 1});
  EXPECT_EQ(grid.near(45, 55), 8u);
  HintGrid{}.fillGaps();
}

}  // namespace
}  // namespace apollonius::internal
