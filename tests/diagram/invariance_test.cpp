// Changes that must not change the graph: scaling by powers of two, exact translation, one amount
// added to all weights. These keep the order of sites too, so the canonical forms are equal index
// by index, in degenerate position as well. Turning the plane by 90 degrees does not keep the
// order; there the answers in general position are compared.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/corpus.h"
#include "support/effort.h"
#include "support/replay.h"

namespace apollonius::test {
namespace {

/// Canonical form of the circles after a change, with the circles taken out: only indices remain.
template <class Change>
Canonical shape(Circles circles, Change&& change) {
  for (Circle& c : circles) c = change(c);
  std::string broken;
  Canonical form = freshBuild(circles, Build::kOneByOne, Location::kHierarchy, broken);
  EXPECT_EQ(broken, "");
  form.circles.clear();
  return form;
}

Circle unchanged(const Circle& c) { return c; }

bool isLegal(const Circle& c) {
  const auto inRange = [](double value) {
    return value == 0 ||
           (std::abs(value) >= kSmallestMagnitude && std::abs(value) <= kLargestMagnitude);
  };
  return inRange(c.x) && inRange(c.y) && inRange(c.r);
}

class InvarianceOn : public ::testing::TestWithParam<NamedGenerator> {};

TEST_P(InvarianceOn, ScalingByPowersOfTwo) {
  Random random(311);
  const Circles circles = GetParam().make(random, GetParam().large ? 60 : 12);
  const Canonical expected = shape(circles, unchanged);
  for (const int exponent : {-500, -200, -20, -1, 5, 20, 200, 500}) {
    const auto scaled = [&](const Circle& c) {
      return Circle{std::ldexp(c.x, exponent), std::ldexp(c.y, exponent),
                    std::ldexp(c.r, exponent)};
    };
    if (!std::all_of(circles.begin(), circles.end(),
                     [&](const Circle& c) { return isLegal(scaled(c)); }))
      continue;
    EXPECT_TRUE(shape(circles, scaled) == expected) << "scaled by 2^" << exponent;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, InvarianceOn, ::testing::ValuesIn(corpus()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(Invariance, TranslationAndCommonWeight) {
  Random random(312);
  for (int run = 0; run < runs(1000); ++run) {
    const int side = 1 + random.below(8);
    const int heaviest = random.below(5);
    const Circles circles = tinyGrid(random, 12, side, heaviest);
    const Canonical expected = shape(circles, unchanged);
    const auto moved = [](const Circle& c) { return Circle{c.x + 0x1p40, c.y - 0x1p48, c.r}; };
    const auto heavier = [](const Circle& c) { return Circle{c.x, c.y, c.r + 0x1p45}; };
    const auto lighter = [](const Circle& c) { return Circle{c.x, c.y, c.r - 1000}; };
    ASSERT_TRUE(shape(circles, moved) == expected) << toText(insertAll(circles));
    ASSERT_TRUE(shape(circles, heavier) == expected) << toText(insertAll(circles));
    ASSERT_TRUE(shape(circles, lighter) == expected)
        << toText(insertAll(circles)) << "negative weights are legal";
  }
}

TEST(Invariance, TurningThePlaneInGeneralPosition) {
  Random random(313);
  for (const Hidden hidden : {Hidden::kNone, Hidden::k20Percent, Hidden::k95Percent}) {
    const Circles circles = randomCircles(random, 200, hidden);
    std::string broken;
    // Triples as circles in the original plane.
    const auto triplesOf = [&](const Canonical& form, auto&& back) {
      std::vector<std::array<std::array<double, 3>, 3>> triples;
      for (const Triple& t : form.triples) {
        std::array<std::array<double, 3>, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
          if (t[k] == kInfinity) {
            corners[k] = {HUGE_VAL, 0, 0};
            continue;
          }
          const Circle c = back(form.circles[static_cast<std::size_t>(t[k])]);
          corners[k] = {c.x, c.y, c.r};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()),
                    corners.end());
        triples.push_back(corners);
      }
      std::sort(triples.begin(), triples.end());
      return triples;
    };
    Circles turned;
    for (const Circle& c : circles) turned.push_back({-c.y, c.x, c.r});
    const Canonical form = freshBuild(circles, Build::kBulk, Location::kHierarchy, broken);
    const Canonical turnedForm = freshBuild(turned, Build::kBulk, Location::kHierarchy, broken);
    EXPECT_TRUE(triplesOf(form, unchanged) ==
                triplesOf(turnedForm, [](const Circle& c) { return Circle{c.y, -c.x, c.r}; }));
  }
}

}  // namespace
}  // namespace apollonius::test
