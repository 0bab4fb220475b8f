// Promises of both Builder and SphericalBuilder: a diagram built in steps of any length, and
// nothing of it if the work is given up.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/saved.h"

namespace apollonius::test {

/// Lengths of steps; the last ones mean that all is done at once.
inline constexpr std::size_t kLengths[] = {
    1, 7, 100000, std::size_t{1} << (8 * sizeof(std::size_t) - 6), SIZE_MAX};

/// Goes on to the end; how often advance() was called for that.
template <typename Builder>
int finish(Builder& builder, std::size_t steps) {
  double last = 0;
  for (int calls = 1;; ++calls) {
    bool isDone = false;
    EXPECT_EQ(builder.advance(steps, isDone), Error::kNone);
    EXPECT_GE(builder.progress(), last);
    EXPECT_LE(builder.progress(), 1);
    last = builder.progress();
    if (isDone) return calls;
  }
}

/// Builds a diagram of triples that are added in portions; how often advance() was called.
template <typename Builder, typename Diagram>
int build(Diagram& diagram, const std::vector<double>& triples, std::size_t portion,
          std::size_t steps) {
  Builder builder(diagram);
  EXPECT_EQ(builder.reserve(triples.size() / 3), Error::kNone);
  for (std::size_t k = 0; k < triples.size(); k += 3 * portion) {
    const std::size_t count = std::min(3 * portion, triples.size() - k);
    EXPECT_EQ(builder.add({triples.data() + k, count}), Error::kNone);
  }
  return finish(builder, steps);
}

/// Gives the work up after this many steps: the diagram is empty.
template <typename Builder, typename Diagram>
void expectNothingIfGivenUp(Diagram& diagram, const std::vector<double>& triples, int after) {
  {
    Builder builder(diagram);
    ASSERT_EQ(builder.add(triples), Error::kNone);
    bool isDone = false;
    for (int k = 0; k < after && !isDone; ++k) ASSERT_EQ(builder.advance(5, isDone), Error::kNone);
    ASSERT_FALSE(isDone);
  }
  ASSERT_EQ(diagram.size(), 0u);
}

/// Moves a builder in the middle of its work, and goes on after its end: `whole` is built.
template <typename Builder, typename Diagram>
void expectMovedAndDoneOnce(const std::vector<double>& triples, const Diagram& whole) {
  Diagram diagram;
  bool isDone = false;
  Builder first(diagram);
  ASSERT_EQ(first.add(triples), Error::kNone);
  EXPECT_EQ(first.progress(), 0);
  for (int k = 0; k < 20; ++k) ASSERT_EQ(first.advance(5, isDone), Error::kNone);
  ASSERT_FALSE(isDone);
  Builder second(std::move(first));
  finish(second, 5);
  for (int again = 0; again < 3; ++again) {
    ASSERT_EQ(second.advance(20, isDone), Error::kNone);
    EXPECT_TRUE(isDone);
    EXPECT_EQ(second.progress(), 1);
  }
  EXPECT_EQ(saved(diagram), saved(whole));
}

/// Refuses the triples, each with its error; the diagram of nothing is done at once.
template <typename Builder, typename Diagram>
void expectRefused(Diagram& diagram,
                   const std::vector<std::pair<std::vector<double>, Error>>& refused) {
  Builder builder(diagram);
  for (const auto& [triples, error] : refused) EXPECT_EQ(builder.add(triples), error);
  EXPECT_EQ(builder.reserve(kMostSites + 1), Error::kTooLarge);
  bool isDone = false;
  EXPECT_EQ(builder.advance(1, isDone), Error::kNone);
  EXPECT_TRUE(isDone) << "of nothing";
  EXPECT_EQ(diagram.size(), 0u);
}

}  // namespace apollonius::test
