// Snapshots of which one part lies, with a right checksum: each is refused for that part alone.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "apollonius/diagram.h"
#include "support/saved.h"
#include "support/snapshots.h"

namespace apollonius::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// Three sites, two free slots and two free ids; by docs/SNAPSHOTS.md.
class SnapshotParts : public ::testing::Test {
 protected:
  static constexpr std::size_t kSlots = 5, kSites = 3;
  static constexpr std::size_t kIds = 8 + 6 * kSlots, kFreeSlots = kIds + kSlots,
                               kFreeIds = kFreeSlots + 2, kRecent = kFreeIds + 2,
                               kTwins = kRecent + 2;

  void SetUp() override {
    SiteId id = kNoSite;
    for (const auto& [x, y, r] :
         {Circle{0, 0, 1}, {10, 0, 1}, {3, 7, 1}, {20, 20, 1}, {-9, 4, 1}}) {
      ASSERT_EQ(diagram_.insert(x, y, r, id), Error::kNone);
    }
    bool removed = false;
    for (const SiteId gone : {3u, 4u}) ASSERT_EQ(diagram_.remove(gone, removed), Error::kNone);
    ASSERT_EQ(diagram_.toBytes(bytes_), Error::kNone);
    ASSERT_EQ(word(3), kSlots);
    ASSERT_EQ(word(5), kSites);
    ASSERT_TRUE(isAccepted());
  }

  [[nodiscard]] std::uint32_t word(std::size_t k) const { return wordAt(bytes_, k); }
  void set(std::size_t k, std::uint32_t value) { setWord(bytes_, k, value); }
  void setNumber(std::size_t k, double value) {
    test::setNumber(bytes_, kNumbersAt + 2 * k, value);
  }
  [[nodiscard]] bool isAccepted(Source source = Source::kAnyone) const {
    Diagram restored;
    return restored.fromBytes(withChecksum(bytes_), source) == Error::kNone;
  }

  Diagram diagram_;
  Bytes bytes_;
};

TEST_F(SnapshotParts, MoreThanTheCountsSay) {
  bytes_.insert(bytes_.end() - 8, 8, 0);
  EXPECT_FALSE(isAccepted());
}

TEST_F(SnapshotParts, NumbersOutOfRange) {
  const Bytes good = bytes_;
  for (std::size_t k = 0; k < 3 * kSites; ++k) {
    for (const double bad :
         {1e200, 1e-200, std::numeric_limits<double>::infinity(), std::nan("")}) {
      bytes_ = good;
      setNumber(k, bad);
      EXPECT_FALSE(isAccepted()) << k << " " << bad;
    }
  }
}

TEST_F(SnapshotParts, NegativeZerosAreZeros) {
  setNumber(0, -0.0);
  setNumber(1, -0.0);
  Diagram restored;
  ASSERT_EQ(restored.fromBytes(withChecksum(bytes_)), Error::kNone);
  Circle circle{};
  ASSERT_EQ(restored.site(0, circle), Error::kNone);
  EXPECT_FALSE(std::signbit(circle.x) || std::signbit(circle.y));
}

TEST_F(SnapshotParts, FreeSlotTwice) {
  set(kFreeSlots + 1, word(kFreeSlots));
  EXPECT_FALSE(isAccepted());
}

TEST_F(SnapshotParts, FreeSlotInUse) {
  set(kFreeSlots + 1, 0);
  EXPECT_FALSE(isAccepted());
}

TEST_F(SnapshotParts, FreeIdTwice) {
  set(kFreeIds + 1, word(kFreeIds));
  EXPECT_FALSE(isAccepted());
}

TEST_F(SnapshotParts, FreeIdInUse) {
  set(kFreeIds + 1, 0);
  EXPECT_FALSE(isAccepted());
}

TEST_F(SnapshotParts, IdOfTwoSlots) {
  set(kIds + 1, word(kIds));
  EXPECT_FALSE(isAccepted());
}

TEST_F(SnapshotParts, WalksStartAtInfinity) {
  set(kRecent, 0);
  EXPECT_FALSE(isAccepted());
}

TEST_F(SnapshotParts, WalksStartAtASiteThatIsNotThere) {
  set(kRecent, static_cast<std::uint32_t>(kSlots));
  EXPECT_FALSE(isAccepted());
}

// Site 2 is said to be in a free slot; the graph has it where it was.
TEST_F(SnapshotParts, FreeSlotInTheGraph) {
  const std::uint32_t free = word(kFreeSlots);
  set(kFreeSlots, 2);
  set(kIds + 2, kNoSite);
  set(kIds + free, 2);
  for (std::size_t k = 0; k < 6; ++k) set(8 + 6 * free + k, word(8 + 6 * 2 + k));
  EXPECT_FALSE(isAccepted());
}

// --- The surface, which is checked wherever the bytes come from

TEST_F(SnapshotParts, TwinsThatAreNotMutual) {
  const std::uint32_t halfedges = 3 * word(7);
  for (std::uint32_t h = 0; h < halfedges; ++h) {
    const std::uint32_t twin = word(kTwins + h);
    for (std::uint32_t g = 0; g < halfedges; ++g) {
      if (g == twin) continue;
      set(kTwins + h, g);
      EXPECT_FALSE(isAccepted(Source::kTrusted)) << h << " " << g;
    }
    set(kTwins + h, twin);
  }
}

// Each half-edge is still some other's twin, and in one star.
TEST_F(SnapshotParts, TwinsInACycle) {
  const std::uint32_t none = 0xFFFFFFFFu;
  std::vector<bool> isFree(word(7), false);
  for (std::uint32_t h = word(kRecent + 1); h != none; h = word(kTwins + h)) isFree[h / 3] = true;
  std::vector<std::uint32_t> live;
  for (std::uint32_t h = 0; h < 3 * word(7); ++h) {
    if (!isFree[h / 3]) live.push_back(h);
  }
  for (const std::uint32_t h : live) {
    for (const std::uint32_t g : live) {
      for (const std::uint32_t k : live) {
        if (g == h || k <= g || k == h) continue;
        const std::uint32_t a = word(kTwins + h), b = word(kTwins + g), c = word(kTwins + k);
        set(kTwins + h, b), set(kTwins + g, c), set(kTwins + k, a);
        EXPECT_FALSE(isAccepted(Source::kTrusted)) << h << " " << g << " " << k;
        set(kTwins + h, a), set(kTwins + g, b), set(kTwins + k, c);
      }
    }
  }
}

TEST_F(SnapshotParts, OneStarOfTwoVertices) {
  const std::size_t vertices = kTwins + 3 * word(7);
  for (std::size_t v = 0; v <= kSlots; ++v) {
    for (std::size_t u = 0; u <= kSlots; ++u) {
      const std::uint32_t old = word(vertices + v);
      if (old == word(vertices + u)) continue;
      set(vertices + v, word(vertices + u));
      EXPECT_FALSE(isAccepted(Source::kTrusted)) << v << " " << u;
      set(vertices + v, old);
    }
  }
}

TEST_F(SnapshotParts, ListOfFreeFaces) {
  const std::uint32_t none = 0xFFFFFFFFu, first = word(kRecent + 1);
  ASSERT_NE(first, none) << "there are free faces";
  std::uint32_t last = first;
  while (word(kTwins + last) != none) last = word(kTwins + last);
  set(kTwins + last, first);  // it has no end
  EXPECT_FALSE(isAccepted(Source::kTrusted));
  set(kTwins + last, none);
  for (std::uint32_t h = 0; h < 3 * word(7); ++h) {
    if (h == first) continue;
    set(kRecent + 1, h);  // it starts at a live face, within a face, or behind the first one
    EXPECT_FALSE(isAccepted(Source::kTrusted)) << h;
  }
}

// An odd number of words: the one that makes it even is zero.
TEST(SnapshotPadding, IsZero) {
  Diagram diagram;
  SiteId id = kNoSite;
  int padded = 0;
  for (int k = 0; k < 6; ++k) {
    ASSERT_EQ(diagram.insert(10 * k, k * k, 1, id), Error::kNone);
    Bytes bytes = saved(diagram);
    const std::size_t last = bytes.size() - 12;
    if ((bytes[last] | bytes[last + 1] | bytes[last + 2] | bytes[last + 3]) != 0) continue;
    bytes[last] = 1;
    Diagram restored;
    EXPECT_EQ(restored.fromBytes(withChecksum(bytes)), Error::kCorruptSnapshot) << k;
    ++padded;
  }
  EXPECT_GT(padded, 0);
}

// --- The same zero by the other calls

TEST(NegativeZeros, AreZerosHoweverTheyCome) {
  SiteId id = kNoSite;
  const std::vector<double> zeros{-0.0, -0.0, -0.0};
  const auto expectZeros = [&](const Diagram& diagram) {
    Circle circle{};
    ASSERT_EQ(diagram.site(id, circle), Error::kNone);
    EXPECT_FALSE(std::signbit(circle.x) || std::signbit(circle.y) || std::signbit(circle.r));
  };
  Diagram one, many, moved, together;
  ASSERT_EQ(one.insert(-0.0, -0.0, -0.0, id), Error::kNone);
  expectZeros(one);
  std::vector<SiteId> ids(1);
  ASSERT_EQ(many.insertMany(zeros, ids), Error::kNone);
  expectZeros(many);
  for (Diagram* diagram : {&moved, &together}) {
    ASSERT_EQ(diagram->insert(1, 1, 1, id), Error::kNone);
    if (diagram == &moved) {
      ASSERT_EQ(diagram->update(id, -0.0, -0.0, -0.0), Error::kNone);
    } else {
      ASSERT_EQ(diagram->updateMany(ids, zeros), Error::kNone);
    }
    expectZeros(*diagram);
  }
}

TEST(GivenArrays, AreCheckedAsThoseOfOthers) {
  Diagram diagram;
  std::vector<SiteId> ids;
  std::vector<double> good(6);
  for (std::size_t k = 0; k < 6; ++k) good[k] = static_cast<double>(3 * k % 7);
  ASSERT_EQ(diagram.insertMany(std::move(good), ids), Error::kNone);
  EXPECT_EQ(diagram.size(), 2u);
  EXPECT_EQ(ids.size(), 2u);
  std::vector<double> bad(3);
  bad[1] = std::nan("");
  EXPECT_EQ(diagram.insertMany(std::move(bad), ids), Error::kNotFinite);
  EXPECT_EQ(diagram.size(), 2u);
}

}  // namespace
}  // namespace apollonius::test
