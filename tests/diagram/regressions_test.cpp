// Replays tests/data/regressions/*.sites: every bug that was found, by name. Each step is validated
// and compared with fresh builds (and the oracle where it can be). Format: support/operations.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "support/replay.h"

namespace apollonius::test {
namespace {

std::vector<std::filesystem::path> regressionFiles() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(APOLLONIUS_TEST_DATA "/regressions")) {
    if (entry.path().extension() == ".sites") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Regressions, AllFilesReplay) {
  const auto files = regressionFiles();
  EXPECT_FALSE(files.empty()) << "no files in " APOLLONIUS_TEST_DATA "/regressions";
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename().string());
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    std::string error;
    const History history = fromText(text.str(), error);
    ASSERT_EQ(error, "");
    ASSERT_FALSE(history.empty());
    for (const Location location : {Location::kHierarchy, Location::kWalk}) {
      Checks checks;
      checks.location = location;
      checks.compareEveryStep = history.size() <= 100;
      checks.oracleUpTo = 10;
      EXPECT_EQ(checkHistory(history, checks), "");
    }
  }
}

TEST(Regressions, TextFormatKeepsEveryBit) {
  Random random(231);
  const Circles pool = rangeEnds(random, 20, Range::kMixed);
  History history = randomHistory(random, pool, 60);
  for (std::size_t k = 1; k < history.size(); ++k) {
    history[k].isJoined = history[k].kind == history[k - 1].kind &&
                          history[k].kind != Operation::Kind::kRestore && random.oneIn(2);
  }
  std::string error;
  const History read = fromText(toText(history), error);
  ASSERT_EQ(error, "");
  ASSERT_EQ(read.size(), history.size());
  EXPECT_EQ(toText(read), toText(history));
}

/// The operations of a call that are left stay one call.
TEST(Regressions, ShorteningKeepsCallsTogether) {
  std::string error;
  const History history = fromText(
      "insert 0 0 1\nand insert 5 0 1\nand insert 9 0 1\nupdate 0 1 0 1\nand update 1 5 1 1\nand "
      "update 2 9 1 1\n",
      error);
  ASSERT_EQ(error, "");
  EXPECT_EQ(endOfCall(history, 0), 3u);
  EXPECT_EQ(endOfCall(history, 3), 6u);
  const auto movesTheLastTwoTogether = [](const History& candidate) {
    const auto isMove = [&](std::size_t k, double x) {
      return candidate[k].kind == Operation::Kind::kUpdate && candidate[k].circle.x == x;
    };
    for (std::size_t k = 1; k < candidate.size(); ++k) {
      if (isMove(k - 1, 5) && isMove(k, 9) && candidate[k].isJoined) return true;
    }
    return false;
  };
  const History shorter = shorten(history, movesTheLastTwoTogether);
  EXPECT_EQ(toText(shorter),
            "insert 0x1.4p+2 0x0p+0 0x1p+0\nand insert 0x1.2p+3 0x0p+0 0x1p+0\n"
            "update 0 0x1.4p+2 0x1p+0 0x1p+0\nand update 1 0x1.2p+3 0x1p+0 0x1p+0\n");
}

TEST(Regressions, TextFormatNamesTheBrokenLine) {
  const auto errorOf = [](const char* text) {
    std::string error;
    EXPECT_TRUE(fromText(text, error).empty());
    return error;
  };
  EXPECT_EQ(errorOf("insert 0 0 1\nremove 1\n"), "line 2: no such circle: remove 1");
  EXPECT_EQ(errorOf("# comment\n\nmove 0 0 1\n"), "line 3: not an operation: move 0 0 1");
  EXPECT_EQ(errorOf("insert 0 0\n"), "line 1: not three numbers: insert 0 0");
  EXPECT_EQ(errorOf("insert 0 0 1 2\n"), "line 1: too many words: insert 0 0 1 2");
  EXPECT_EQ(errorOf("insert 0 0 1\nand update 0 1 1 1\n"),
            "line 2: not of the kind of the line before: and update 0 1 1 1");
  EXPECT_EQ(errorOf("and insert 0 0 1\n"),
            "line 1: not of the kind of the line before: and insert 0 0 1");
  EXPECT_EQ(errorOf("and\n"), "line 1: not an operation: and");
  EXPECT_EQ(errorOf("insert 0 0 1\nremove 0\nupdate 0 1 1 1\n"),
            "line 3: no such circle: update 0 1 1 1");
}

}  // namespace
}  // namespace apollonius::test
