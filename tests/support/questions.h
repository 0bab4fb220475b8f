// Work that is counted instead of timed: how often the predicates have been asked.
#pragma once

#include <array>
#include <bit>
#include <numeric>

#include "predicate/stage_counts.h"

namespace apollonius::test {

using namespace internal;

/// Number of questions to predicates so far, whichever stage answered. Steps of a walk that filters
/// settle without a question do not count.
inline double questions() {
  using Count = unsigned long long;
  const auto counts =
      std::bit_cast<std::array<Count, sizeof(stages::Counts) / sizeof(Count)>>(stages::counts());
  return static_cast<double>(std::accumulate(counts.begin(), counts.end(), Count{0}));
}

}  // namespace apollonius::test
