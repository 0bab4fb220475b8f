// Wrong snapshots, with a right checksum. As anyone's bytes they are refused, or they are the
// diagram of the sites that they hold, by fresh builds and brute force. As trusted bytes they do no
// harm: every call ends (under the sanitizers: within its memory).
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "predicate/shadow_check.h"
#include "support/corpus.h"
#include "support/effort.h"
#include "support/mutants.h"
#include "support/saved.h"
#include "support/snapshots.h"

namespace apollonius::test {

using namespace internal;
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes snapshotOf(const Circles& circles, std::size_t removed = 0) {
  Diagram diagram;
  SiteId id = kNoSite;
  for (const Circle& c : circles) EXPECT_EQ(diagram.insert(c.x, c.y, c.r, id), Error::kNone);
  bool was = false;
  for (SiteId k = 0; k < removed; ++k) EXPECT_EQ(diagram.remove(3 * k, was), Error::kNone);
  return saved(diagram);
}

/// Many hidden, grids, lines, two giants with small ones between (several edges between two sites),
/// a giant with small ones at its rim (degree 2), decimals, few.
std::vector<Bytes> originals() {
  Random random(11);
  std::vector<Bytes> all;
  all.push_back(snapshotOf(randomCircles(random, 24, Hidden::k50Percent), 3));
  all.push_back(snapshotOf(tinyGrid(random, 30, 5, 2), 2));
  all.push_back(snapshotOf(lattice(random, 4, 4, 1, 0)));
  all.push_back(snapshotOf(lattice(random, 4, 3, 0.1, 0.01), 1));
  all.push_back(snapshotOf(collinear(random, 9, Line::kDiagonal, true, 2)));
  all.push_back(snapshotOf(giantDisk(random, 12), 2));
  all.push_back(snapshotOf(giantDiskExact(random, 10)));
  all.push_back(snapshotOf(
      {{-10, 0, 8}, {10, 0, 8}, {0, 0, 1}, {0, 5, 1}, {0, -6, 0.5}, {0, 0.5, 0}, {-10, 0, 3}}));
  all.push_back(snapshotOf({{0, 0, 1}, {10, 0, 2}}));
  all.push_back(snapshotOf({{0, 0, 1}, {10, 0, 2}, {5, 1, 0}}));
  all.push_back(snapshotOf({{0, 0, 3}, {0, 1, 1}, {1, 0, 1}, {0, 0, 1}}));
  all.push_back(snapshotOf(powerLaw(random, 20), 4));
  all.push_back(snapshotOf(commonTangent(random, 10, 5)));
  return all;
}

Error restored(Diagram& diagram, const Bytes& bytes, Source source) {
  const Error error = diagram.fromBytes(bytes, source);
  EXPECT_TRUE(error == Error::kNone || error == Error::kCorruptSnapshot);
  return error;
}

TEST(SnapshotMutants, OfAnyoneAreRefusedOrRight) {
  const std::vector<Bytes> sources = originals();
  int accepted = 0, refused = 0;
  const int all = sized(3000, 12000);
  for (int run = 0; run < runs(all); ++run) {
    Random random(static_cast<std::uint64_t>(run));
    const Bytes bytes = mutant(sources[random.below(sources.size())], random);
    Diagram diagram;
    if (restored(diagram, bytes, Source::kAnyone) != Error::kNone) {
      ++refused;
      continue;
    }
    ++accepted;
    ASSERT_EQ(whatIsWrong(diagram, random), "") << run;
    ASSERT_FALSE(callEverything(diagram, random.next())) << run;
  }
  EXPECT_GT(accepted, runs(all / 25));
  EXPECT_GT(refused, runs(all / 4));
}

// Bytes are accepted from anyone exactly if validate() accepts the diagram that they make if
// trusted.
TEST(SnapshotMutants, ValidateAndFromBytesAgree) {
  const std::vector<Bytes> all = originals();
  int wrong = 0;
  for (int run = 0; run < runs(6000); ++run) {
    Random random(static_cast<std::uint64_t>(run) + 100000);
    const Bytes bytes = mutant(all[random.below(all.size())], random);
    Diagram diagram, trusted;
    const Error error = restored(diagram, bytes, Source::kAnyone);
    if (restored(trusted, bytes, Source::kTrusted) != Error::kNone) {
      ASSERT_EQ(error, Error::kCorruptSnapshot) << run;
      continue;
    }
    std::string broken;
    ASSERT_EQ(trusted.validate(broken), Error::kNone);
    ASSERT_EQ(broken.empty(), error == Error::kNone) << run << ": " << broken;
    wrong += !broken.empty();
  }
  EXPECT_GT(wrong, runs(1500));
}

TEST(SnapshotMutants, TrustedDoNoHarm) {
  // On an invalid graph a filter may contradict the exact stage.
  if (kShadowCheck) GTEST_SKIP() << "with the shadow check";
  const std::vector<Bytes> sources = originals();
  int found = 0, accepted = 0;
  const int all = sized(5000, 20000);
  for (int run = 0; run < runs(all); ++run) {
    Random random(static_cast<std::uint64_t>(run) + 200000);
    const Bytes bytes = mutant(sources[random.below(sources.size())], random);
    Diagram diagram(random.oneIn(4)   ? Location::kWalk
                    : random.oneIn(4) ? Location::kPlainHierarchy
                                      : Location::kHierarchy);
    if (restored(diagram, bytes, Source::kTrusted) != Error::kNone) continue;
    ++accepted;
    found += callEverything(diagram, random.next());
  }
  EXPECT_GT(accepted, runs(all / 4));
  EXPECT_GT(found, runs(all / 25));
}

// With a hierarchy, from which a search comes down to sites that trusted bytes have under another.
TEST(SnapshotMutants, LargeTrustedDoNoHarm) {
  if (kShadowCheck) GTEST_SKIP() << "with the shadow check";
  for (const bool isGrid : {false, true}) {
    Random make(5);
    const Circles circles =
        isGrid ? lattice(make, 30, 30, 1, 0.25) : randomCircles(make, 1200, Hidden::k5Percent);
    const Bytes original = snapshotOf(circles, 30);
    for (int run = 0; run < runs(150); ++run) {
      Random random(static_cast<std::uint64_t>(run) + 300000);
      const Bytes bytes = mutant(original, random, random.below(150u));
      Diagram diagram(random.oneIn(4) ? Location::kPlainHierarchy : Location::kHierarchy);
      if (restored(diagram, bytes, Source::kTrusted) == Error::kNone)
        (void)callEverything(diagram, random.next());
    }
  }
}

// --- Found by others: tests/data/snapshots/forged_*.bin

class Forged : public ::testing::TestWithParam<const char*> {};

TEST_P(Forged, IsRefusedAndDoesNoHarmIfTrusted) {
  std::ifstream file(std::string(APOLLONIUS_TEST_DATA "/snapshots/forged_") + GetParam() + ".bin",
                     std::ios::binary);
  ASSERT_TRUE(file);
  const Bytes bytes{std::istreambuf_iterator<char>(file), {}};
  ASSERT_EQ(withChecksum(bytes), bytes);
  Diagram diagram;
  EXPECT_EQ(diagram.fromBytes(bytes), Error::kCorruptSnapshot);
  if (kShadowCheck) return;
  for (std::uint64_t seed = 0; seed < sized(40u, 200u); ++seed) {
    Diagram trusted(seed % 3 == 0 ? Location::kWalk : Location::kHierarchy);
    ASSERT_EQ(restored(trusted, bytes, Source::kTrusted), Error::kNone);
    (void)callEverything(trusted, seed);
  }
}

INSTANTIATE_TEST_SUITE_P(Snapshots, Forged,
                         ::testing::Values("hang", "find_out_of_bounds",
                                           "validate_clean_find_wrong", "area_of_no_cell"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace apollonius::test
