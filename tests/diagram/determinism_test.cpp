// Equal bits everywhere: one fixed sequence of operations, and all output bits of it in two hashes
// that are written down here. Natively at any optimisation level, with any compiler, and as wasm
// they must come out the same; a build that differs (a fused multiply-add, x87, another libm in the
// core) fails here.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "support/corpus.h"
#include "support/hash.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

/// Hash of the diagram's facts about its circles. It does not depend on their order, so a change
/// here means that the bits of some coordinate, clearance or distance have changed. Update it only
/// with an intended change of those formulas.
constexpr std::uint64_t kExpectedValues = 0x5c510c7416ed6f90;

/// Hash of the raw arrays in their order, which depends on how the diagram is stored and searched.
/// Update it after any change of that; it must be equal natively and in wasm.
constexpr std::uint64_t kExpectedRaw = 0x16f8421ca21b4819;

/// Hash of generated circles: native code and wasm must be tested with the same sets.
constexpr std::uint64_t kExpectedGenerated = 0x6ac375aed8e7af2a;

std::string hex(const Hash& hash) {
  char text[20];
  std::snprintf(text, sizeof text, "%#018llx", static_cast<unsigned long long>(hash.value()));
  return text;
}

struct Hashes {
  Hash values;
  Hash raw;
};

void addOutputs(const Diagram& diagram, Random& random, Hashes& hashes) {
  std::vector<SiteId> faces;
  VertexArrays vertices;
  EdgeArrays edges;
  ASSERT_EQ(diagram.faces(faces), Error::kNone);
  ASSERT_EQ(diagram.vertices(vertices), Error::kNone);
  ASSERT_EQ(diagram.edges(edges), Error::kNone);
  hashes.raw.addAll(faces);
  hashes.raw.addAll(vertices.coordinates);
  hashes.raw.addAll(vertices.clearance);
  hashes.raw.addAll(vertices.sites);
  hashes.raw.addAll(edges.sites);
  hashes.raw.addAll(edges.vertices);

  std::vector<std::array<double, 3>> rows;
  for (std::size_t k = 0; k < vertices.clearance.size(); ++k) {
    rows.push_back(
        {vertices.coordinates[2 * k], vertices.coordinates[2 * k + 1], vertices.clearance[k]});
    for (const double number : rows.back()) ASSERT_FALSE(std::isnan(number));
  }
  std::sort(rows.begin(), rows.end());
  for (const auto& row : rows) {
    for (const double number : row) hashes.values.add(number + 0.0);  // -0 and 0 sort as equals
  }
  for (int k = 0; k < 50; ++k) {
    SiteId id = kNoSite;
    double distance = 0;
    const double x = random.between(-1e6, 1e6);
    const double y = random.between(-1e6, 1e6);
    ASSERT_EQ(diagram.find(x, y, id, distance), Error::kNone);
    hashes.raw.add(static_cast<std::uint64_t>(id));
    hashes.values.add(distance);
  }
}

TEST(Determinism, HashesOfAFixedSequence) {
  Hashes hashes;
  for (const NamedGenerator& generator : corpus()) {
    Random random(291);
    const std::size_t n = generator.large ? 60 : 12;
    const Circles pool = generator.make(random, n);
    Replay replay;
    for (const Operation& operation : randomHistory(random, pool, 2 * n))
      ASSERT_EQ(replay.apply({&operation, 1}), "");
    addOutputs(replay.diagram(), random, hashes);
    if (HasFatalFailure()) return;
  }
  std::printf("values %s\nraw    %s\n", hex(hashes.values).c_str(), hex(hashes.raw).c_str());
  EXPECT_EQ(hashes.values.value(), kExpectedValues)
      << "bits of coordinates or distances changed, to " << hex(hashes.values);
  EXPECT_EQ(hashes.raw.value(), kExpectedRaw)
      << "order of the arrays changed; hash " << hex(hashes.raw);
}

TEST(Determinism, VerticesHaveTheSameBitsAfterAnyHistory) {
  for (const NamedGenerator& generator : corpus()) {
    SCOPED_TRACE(generator.name);
    Random random(292);
    Circles circles = generator.make(random, generator.large ? 80 : 10);
    std::array<Hashes, 3> hashes;
    for (Hashes& run : hashes) {
      Replay replay;
      for (const Operation& operation : insertAll(circles))
        ASSERT_EQ(replay.apply({&operation, 1}), "");
      Random points(293);
      addOutputs(replay.diagram(), points, run);
      random.shuffle(circles);
    }
    EXPECT_EQ(hashes[0].values.value(), hashes[1].values.value());
    EXPECT_EQ(hashes[0].values.value(), hashes[2].values.value());
  }
}

TEST(Determinism, GeneratorsAreTheSameEverywhere) {
  Hash hash;
  for (const NamedGenerator& generator : corpus()) {
    Random random(294);
    for (const Circle& c : generator.make(random, 20)) {
      for (const double number : {c.x, c.y, c.r}) hash.add(number);
    }
  }
  EXPECT_EQ(hash.value(), kExpectedGenerated)
      << "the generators made other circles; hash " << hex(hash);
}

}  // namespace
}  // namespace apollonius::test
