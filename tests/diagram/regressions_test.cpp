// Replays tests/data/regressions/*.sites: every bug that was found, by name. Each step is validated and compared with fresh
// builds (and the oracle where it can be). Format: support/operations.h.
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
  for (const auto& entry : std::filesystem::directory_iterator(APOLLONIUS_TEST_DATA "/regressions")) {
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
  const History history = randomHistory(random, pool, 60);
  std::string error;
  const History read = fromText(toText(history), error);
  ASSERT_EQ(error, "");
  ASSERT_EQ(read.size(), history.size());
  EXPECT_EQ(toText(read), toText(history));
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
  EXPECT_EQ(errorOf("insert 0 0 1\nremove 0\nupdate 0 1 1 1\n"), "line 3: no such circle: update 0 1 1 1");
}

}  // namespace
}  // namespace apollonius::test
