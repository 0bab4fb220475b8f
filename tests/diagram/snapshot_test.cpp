// Snapshots restore the saved diagram, on every platform; and any other bytes give a valid diagram
// or kCorruptSnapshot. (snapshot_mutants_test.cpp tests bytes that are wrong more cleverly.)
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/insert_into.h"
#include "support/replay.h"
#include "support/saved.h"
#include "support/snapshots.h"

namespace apollonius::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// All that a diagram says, row by row.
struct Answers {
  std::vector<SiteId> ids, faces;
  std::vector<bool> hidden;
  std::vector<SiteId> covers, neighbors;
  VertexArrays vertices;
  EdgeArrays edges;

  explicit Answers(const Diagram& diagram) {
    EXPECT_EQ(diagram.ids(ids), Error::kNone);
    EXPECT_EQ(diagram.faces(faces), Error::kNone);
    EXPECT_EQ(diagram.vertices(vertices), Error::kNone);
    EXPECT_EQ(diagram.edges(edges), Error::kNone);
    for (const SiteId id : ids) {
      bool isHidden = false;
      EXPECT_EQ(diagram.isHidden(id, isHidden), Error::kNone);
      hidden.push_back(isHidden);
      covers.emplace_back();
      EXPECT_EQ(diagram.coverOf(id, covers.back()), Error::kNone);
      std::vector<SiteId> around;
      EXPECT_EQ(diagram.neighbors(id, around), Error::kNone);
      neighbors.insert(neighbors.end(), around.begin(), around.end());
      neighbors.push_back(kNoSite);
    }
  }
  bool operator==(const Answers& other) const {
    return ids == other.ids && faces == other.faces && hidden == other.hidden &&
           covers == other.covers && neighbors == other.neighbors &&
           vertices.coordinates == other.vertices.coordinates &&
           vertices.clearance == other.vertices.clearance &&
           vertices.sites == other.vertices.sites && edges.sites == other.edges.sites &&
           edges.vertices == other.edges.vertices;
  }
};

std::string validated(const Diagram& diagram) {
  std::string broken;
  EXPECT_EQ(diagram.validate(broken), Error::kNone);
  return broken;
}

Canonical canonical(const Diagram& diagram) {
  std::string broken;
  Canonical form = canonicalForm(diagram, broken);
  EXPECT_EQ(broken, "");
  return form;
}

/// Restores; everything must be as in the original, now and after more of the same operations.
void expectSame(Diagram& original, Location location, Random& random, const Circles& pool) {
  const Bytes bytes = saved(original);
  {
    Diagram restored(location);
    ASSERT_EQ(restored.fromBytes(bytes), Error::kNone);
    EXPECT_EQ(validated(restored), "");
    EXPECT_TRUE(Answers(restored) == Answers(original));
    EXPECT_EQ(saved(restored), bytes);
  }
  // Free ids are used again in the same order; what hung on what still does. The second one has no
  // circles at first.
  Diagram restored(location);
  ASSERT_EQ(restored.fromBytes(bytes, Source::kTrusted), Error::kNone);
  for (std::size_t k = 0; k < 2 * pool.size(); ++k) {
    const Circle& c = pool[random.below(pool.size())];
    SiteId id = kNoSite, same = kNoSite;
    const auto some = static_cast<SiteId>(random.below(original.size() + 2));
    if (random.oneIn(3)) {
      double distance = 0, alike = 0;
      ASSERT_EQ(original.find(c.x, c.y, id, distance), Error::kNone);
      ASSERT_EQ(restored.find(c.x, c.y, same, alike), Error::kNone);
      ASSERT_EQ(id, same);
      ASSERT_EQ(distance, alike);
    } else if (random.oneIn(4)) {
      // Hardly at all: in place, if the circles of its faces allow it.
      Circle old{};
      if (original.site(some, old) != Error::kNone) continue;
      const double x = old.x + (c.x - old.x) * 0x1p-20;
      ASSERT_EQ(original.update(some, x, old.y, old.r), restored.update(some, x, old.y, old.r));
    } else if (random.oneIn(2)) {
      ASSERT_EQ(original.insert(c.x, c.y, c.r, id), Error::kNone);
      ASSERT_EQ(restored.insert(c.x, c.y, c.r, same), Error::kNone);
      ASSERT_EQ(id, same);
    } else if (random.oneIn(2)) {
      ASSERT_EQ(original.update(some, c.x, c.y, c.r), restored.update(some, c.x, c.y, c.r));
    } else {
      bool removed = false, alike = false;
      ASSERT_EQ(original.remove(some, removed), Error::kNone);
      ASSERT_EQ(restored.remove(some, alike), Error::kNone);
      ASSERT_EQ(removed, alike);
    }
  }
  EXPECT_EQ(validated(restored), "");
  EXPECT_EQ(difference(canonical(original), canonical(restored)), "");
  std::vector<SiteId> ids, same;
  ASSERT_EQ(original.ids(ids), Error::kNone);
  ASSERT_EQ(restored.ids(same), Error::kNone);
  EXPECT_EQ(ids, same);
}

class OnCorpus : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(OnCorpus, RestoredIsTheSameAfterAnyHistory) {
  const NamedGenerator& generator = GetParam();
  for (const Location location : {Location::kHierarchy, Location::kWalk}) {
    for (const std::size_t n : {3u, 9u, generator.large ? 120u : 14u}) {
      SCOPED_TRACE(n);
      Random random(n + 7);
      const Circles pool = generator.make(random, n);
      Diagram diagram(location);
      std::vector<SiteId> ids;
      for (std::size_t k = 0; k < 3 * n; ++k) {
        const Circle& c = pool[random.below(pool.size())];
        if (ids.size() > 2 && random.oneIn(3)) {
          const std::size_t at = random.below(ids.size());
          bool removed = false;
          ASSERT_EQ(diagram.remove(ids[at], removed), Error::kNone);
          ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(at));
        } else {
          ids.emplace_back();
          ASSERT_EQ(diagram.insert(c.x, c.y, c.r, ids.back()), Error::kNone);
        }
      }
      expectSame(diagram,
                 location == Location::kWalk ? Location::kHierarchy : Location::kPlainHierarchy,
                 random, pool);
    }
  }
}

TEST_P(OnCorpus, RestoredIsTheSameAfterBulk) {
  Random random(17);
  const Circles pool = GetParam().make(random, GetParam().large ? 700 : 14);
  Diagram diagram;
  const std::vector<SiteId> ids = insertInto(diagram, pool);
  std::size_t removed = 0;
  ASSERT_EQ(diagram.removeMany(std::span(ids).first(ids.size() / 5), removed), Error::kNone);
  expectSame(diagram, Location::kHierarchy, random, pool);
}

INSTANTIATE_TEST_SUITE_P(Snapshot, OnCorpus, ::testing::ValuesIn(corpus()),
                         [](const auto& test) { return test.param.name; });

// --- Few sites

Diagram made(const Circles& circles, const std::vector<SiteId>& removed = {}) {
  Diagram diagram;
  SiteId id = kNoSite;
  for (const Circle& c : circles) EXPECT_EQ(diagram.insert(c.x, c.y, c.r, id), Error::kNone);
  bool was = false;
  for (const SiteId gone : removed) EXPECT_EQ(diagram.remove(gone, was), Error::kNone);
  return diagram;
}

/// Small diagrams of every kind: empty, emptied, alone, alone with hidden ones below each other,
/// two, in line, free ids and slots.
std::vector<Diagram> smallOnes() {
  std::vector<Diagram> all;
  all.push_back(made({}));
  all.push_back(made({{1, 2, 3}}));
  all.push_back(made({{1, 2, 3}, {4, 5, 1}, {9, 9, 2}}, {1, 0, 2}));
  all.push_back(made({{0, 0, 1}, {0, 0, 2}, {0, 0, 2}, {0, 1, 9}, {0, 0, 1}}));
  all.push_back(made({{0, 0, 1}, {10, 0, -1}}));
  all.push_back(made({{0, 0, 1}, {10, 0, 1}, {20, 0, 1}, {30, 0, 1}}, {1}));
  all.push_back(
      made({{0, 0, 100}, {0, 0, 5}, {3, 0, 2}, {200, 0, 1}, {0, 99, 2}, {0, 0, 4}, {-300, 1, 0}},
           {4, 1}));
  Random random(4);
  all.push_back(made(tinyGrid(random, 16, 4, 2), {3, 7, 5}));
  all.push_back(made(randomCircles(random, 14, Hidden::k20Percent), {2}));
  return all;
}

TEST(Snapshot, OfFewSites) {
  Random random(5);
  const Circles pool = tinyGrid(random, 12, 5, 3);
  for (Diagram& diagram : smallOnes()) expectSame(diagram, Location::kHierarchy, random, pool);
}

TEST(Snapshot, ReplacesWhatWasThere) {
  const Bytes one = saved(made({{1, 2, 3}})), none = saved(Diagram());
  Random random(6);
  Diagram diagram = made(tinyGrid(random, 30, 6, 2));
  ASSERT_EQ(diagram.fromBytes(one), Error::kNone);
  EXPECT_EQ(diagram.size(), 1u);
  EXPECT_EQ(saved(diagram), one);
  ASSERT_EQ(diagram.fromBytes(none), Error::kNone);
  EXPECT_EQ(diagram.size(), 0u);
  EXPECT_EQ(saved(diagram), none);
  EXPECT_EQ(none.size(), 56u);
}

/// The levels of a restored diagram are made when they are first needed; nothing else may open them
/// before.
TEST(Snapshot, RestoredDiagramsTakeMoreThanTheyHold) {
  Random random(91);
  const Circles circles =
      randomCircles(random, 3000, Hidden::k20Percent);  // three thousand pay for a level
  const auto insert = [&](Diagram& diagram, std::size_t begin, std::size_t end) {
    std::vector<double> xyr;
    for (std::size_t k = begin; k < end; ++k)
      xyr.insert(xyr.end(), {circles[k].x, circles[k].y, circles[k].r});
    std::vector<SiteId> ids(end - begin);
    ASSERT_EQ(diagram.insertMany(xyr, ids), Error::kNone);
  };
  Diagram built, restored;
  insert(built, 0, 1000);
  for (const Source source : {Source::kAnyone, Source::kTrusted}) {
    ASSERT_EQ(restored.fromBytes(saved(built), source), Error::kNone);
    insert(restored, 1000, circles.size());
    EXPECT_EQ(validated(restored), "");
  }
}

TEST(Snapshot, DoesNotDependOnAnAddress) {
  const Bytes bytes = saved(made({{0, 0, 1}, {10, 0, 2}, {3, 7, 1}}));
  for (std::size_t shift = 0; shift < 8; ++shift) {
    Bytes shifted(shift, 0);
    shifted.insert(shifted.end(), bytes.begin(), bytes.end());
    Diagram diagram;
    ASSERT_EQ(diagram.fromBytes(std::span<const std::uint8_t>(shifted).subspan(shift)),
              Error::kNone);
    EXPECT_EQ(saved(diagram), bytes);
  }
}

// --- Damage

/// Refused, with the diagram as it was.
void expectRefused(const Bytes& bytes) {
  Diagram diagram = made({{1, 2, 3}});
  ASSERT_EQ(diagram.fromBytes(bytes), Error::kCorruptSnapshot);
  ASSERT_EQ(diagram.size(), 1u);
}

TEST(Snapshot, EveryTruncationIsNoticed) {
  for (const Diagram& diagram : smallOnes()) {
    const Bytes bytes = saved(diagram);
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      expectRefused(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)));
      if (HasFatalFailure()) FAIL() << length;
    }
    Bytes longer = bytes;
    for (int k = 0; k < 17; ++k) {
      longer.push_back(0);
      expectRefused(longer);
    }
  }
}

TEST(Snapshot, EveryFlippedByteIsNoticed) {
  for (const Diagram& diagram : smallOnes()) {
    Bytes bytes = saved(diagram);
    for (std::size_t k = 0; k < bytes.size(); ++k) {
      for (const unsigned change : {0x01u, 0x80u, 0xFFu, static_cast<unsigned>(k * 37 % 255 + 1)}) {
        bytes[k] ^= static_cast<std::uint8_t>(change);
        expectRefused(bytes);
        if (HasFatalFailure()) FAIL() << k;
        bytes[k] ^= static_cast<std::uint8_t>(change);
      }
    }
  }
}

/// Bytes with a right checksum: either refused, or a valid diagram that works on. Returns whether
/// it is one.
bool works(const Bytes& bytes) {
  Diagram diagram;
  const Error error = diagram.fromBytes(withChecksum(bytes));
  if (error == Error::kCorruptSnapshot) return false;
  EXPECT_EQ(error, Error::kNone);
  EXPECT_EQ(validated(diagram), "");
  EXPECT_EQ(saved(diagram).size(), bytes.size());
  SiteId id = kNoSite;
  double distance = 0;
  EXPECT_EQ(diagram.find(1, 2, id, distance), Error::kNone);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(diagram.insert(k * 5 - 7, k * k - 3, k, id), Error::kNone);
  std::vector<SiteId> ids;
  EXPECT_EQ(diagram.ids(ids), Error::kNone);
  bool removed = false;
  for (std::size_t k = 0; k < ids.size(); k += 3)
    EXPECT_EQ(diagram.remove(ids[k], removed), Error::kNone);
  EXPECT_EQ(validated(diagram), "");
  return true;
}

TEST(Snapshot, FlippedBytesWithARightChecksumDoNoHarm) {
  int valid = 0, refused = 0;
  for (const Diagram& diagram : smallOnes()) {
    const Bytes bytes = saved(diagram);
    ASSERT_TRUE(works(bytes));
    Random random(8);
    for (std::size_t k = 0; k + 8 < bytes.size(); ++k) {
      for (int run = 0; run < runs(sized(2, 5)); ++run) {
        Bytes flipped = bytes;
        flipped[k] ^=
            static_cast<std::uint8_t>(run < 2 ? 1u << random.below(8) : random.below(255) + 1);
        ++(works(flipped) ? valid : refused);
        ASSERT_FALSE(HasFailure()) << k;
      }
    }
  }
  EXPECT_GT(valid, 100);
  EXPECT_GT(refused, 1000);
}

TEST(Snapshot, ForgedWordsDoNoHarm) {
  Random random(9);
  int valid = 0;
  const std::vector<Diagram> diagrams = smallOnes();
  for (int run = 0; run < runs(20000); ++run) {
    Bytes bytes = saved(diagrams[random.below(diagrams.size())]);
    const std::size_t words = bytes.size() / 4 - 2;
    for (std::uint64_t changes = 1 + random.below(3u); changes > 0; --changes) {
      const std::size_t at = 4 * random.below(words), from = 4 * random.below(words);
      std::uint32_t word = random.oneIn(4) ? 0xFFFFFFFFu - random.below(3u) : random.below(24u);
      for (std::size_t byte = 0; byte < 4; ++byte, word >>= 8) {
        const std::uint8_t other = bytes[from + byte];
        if (run % 2 != 0) bytes[from + byte] = bytes[at + byte];  // words change places
        bytes[at + byte] = run % 2 != 0 ? other : static_cast<std::uint8_t>(word);
      }
    }
    valid += works(bytes);
    ASSERT_FALSE(HasFailure()) << run;
  }
  EXPECT_GT(valid, runs(100));
}

TEST(Snapshot, CountsThatNobodyHasRoomForAreRefused) {
  const Bytes bytes = saved(made({{0, 0, 1}, {10, 0, 2}, {3, 7, 1}}));
  for (std::size_t at = 8; at < 32; at += 4) {
    for (const std::uint32_t count : {0x20000000u, 0x7FFFFFFFu, 0xAAAAAAAAu, 0xFFFFFFFFu}) {
      Bytes forged = bytes;
      for (std::size_t byte = 0; byte < 4; ++byte)
        forged[at + byte] = static_cast<std::uint8_t>(count >> (8 * byte));
      expectRefused(withChecksum(forged));
    }
  }
}

// Locally all is well, but the graph goes twice around the middle: such a thing is no diagram of
// the plane.
TEST(Snapshot, SheetsOnTopOfEachOtherAreFoundOut) {
  // Points on a spiral around the origin, twice round; the graph is the wheel of them, with
  // infinity around.
  Circles circles{{0, 0, 0}};
  constexpr int kSpokes = 10;
  constexpr double kX[] = {100, 31, -81, -81, 31}, kY[] = {0, 95, 59, -59, -95};
  for (int k = 0; k < kSpokes; ++k) circles.push_back({kX[k % 5] + k / 5, kY[k % 5] + k / 5, 0});
  Diagram plain = made(circles);
  Bytes bytes = saved(plain);
  // Equal counts are needed: a wheel of n spokes has 2n faces, as has any triangulation of n + 2
  // vertices.
  const std::size_t slots = circles.size();
  const std::size_t twins = 4 * (8 + 6 * slots + slots + 2);
  const auto put = [&](std::size_t word, int value) {
    for (std::size_t byte = 0; byte < 4; ++byte)
      bytes[twins + 4 * word + byte] =
          static_cast<std::uint8_t>(static_cast<std::uint32_t>(value) >> (8 * byte));
  };
  ASSERT_EQ(bytes.size(), twins + 4 * (6 * kSpokes + slots + 1) +
                              ((twins / 4 + 6 * kSpokes + slots + 1) % 2) * 4 + 8);
  // Face k: (centre, rim k, rim k+1). Face n + k: (infinity, rim k+1, rim k).
  for (int k = 0; k < kSpokes; ++k) {
    const int after = (k + 1) % kSpokes, before = (k + kSpokes - 1) % kSpokes,
              outer = 3 * (kSpokes + k);
    put(static_cast<std::size_t>(3 * k), 3 * before + 2);
    put(static_cast<std::size_t>(3 * k + 1), outer + 1);
    put(static_cast<std::size_t>(3 * k + 2), 3 * after);
    put(static_cast<std::size_t>(outer), 3 * (kSpokes + after) + 2);
    put(static_cast<std::size_t>(outer + 1), 3 * k + 1);
    put(static_cast<std::size_t>(outer + 2), 3 * (kSpokes + before));
  }
  put(6 * kSpokes, 3 * kSpokes);  // infinity's half-edge, the centre's, the rim's
  put(6 * kSpokes + 1, 0);
  for (int k = 0; k < kSpokes; ++k) put(static_cast<std::size_t>(6 * kSpokes + 2 + k), 3 * k + 1);
  EXPECT_FALSE(works(bytes));
}

// --- The format

/// The diagram of tests/data/snapshots/version2.bin: free ids and slots, hidden sites in trees.
Diagram recorded() {
  Random random(10);
  Diagram diagram = made(randomCircles(random, 40, Hidden::k20Percent), {3, 30, 7, 12});
  SiteId id = kNoSite;
  EXPECT_EQ(diagram.insert(0.5, -0.25, 2, id), Error::kNone);
  bool removed = false;
  EXPECT_EQ(diagram.remove(20, removed), Error::kNone);
  return diagram;
}

TEST(Snapshot, TheFormatIsTheRecordedOne) {
  const std::string name = APOLLONIUS_TEST_DATA "/snapshots/version2.bin";
  const Diagram diagram = recorded();
  const Bytes bytes = saved(diagram);
  if (std::getenv("APOLLONIUS_RECORD") != nullptr) {
    std::ofstream(name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  std::ifstream file(name, std::ios::binary);
  ASSERT_TRUE(file) << name;
  const Bytes old{std::istreambuf_iterator<char>(file), {}};
  Diagram restored;
  ASSERT_EQ(restored.fromBytes(old), Error::kNone)
      << "snapshots of version 2 can no longer be read";
  EXPECT_EQ(validated(restored), "");
  EXPECT_EQ(difference(canonical(diagram), canonical(restored)), "");
  EXPECT_EQ(saved(restored), old);
  // The order of faces depends on how diagrams are searched: after a change of that, the bytes
  // differ and can be recorded again.
  EXPECT_EQ(bytes, old) << "the same operations gave other bytes; APOLLONIUS_RECORD=1 writes them";
}

/// Graphs of version 1 may have faces that are no faces any more (docs/SNAPSHOTS.md); later ones
/// are not known.
TEST(Snapshot, OtherVersionsAreRefused) {
  Bytes bytes = saved(recorded());
  ASSERT_EQ(bytes[8], 2);
  for (const int version : {0, 1, 2, 3, 255}) {
    bytes[8] = static_cast<std::uint8_t>(version);
    Diagram restored;
    EXPECT_EQ(restored.fromBytes(withChecksum(bytes)),
              version == 2 ? Error::kNone : Error::kCorruptSnapshot)
        << version;
  }
}

}  // namespace
}  // namespace apollonius::test
