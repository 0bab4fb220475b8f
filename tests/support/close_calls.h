// Arguments for the predicates, most of them degenerate up to a few roundings: made of bytes, so
// that a fuzzer can look for them, or of random ones. Sites of grids and of raw bits; copies a few
// doubles away; circles that touch another one from inside or outside, the Voronoi circle of three
// others, or the tangent line of two; a shadow whose middle is the direction of a vertex; points on
// bisectors and on the directions of vertices.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "predicate/site.h"

namespace apollonius::test {

using namespace internal;

struct CloseCall {
  std::array<Site, 5> sites;
  double x = 0, y = 0;  ///< a point
};

/// All numbers are in the range that the library accepts; sites may cover each other.
CloseCall closeCall(const std::function<std::uint8_t()>& nextByte);

/// Hex floats, as tests/data/regressions has them; the point as a comment.
std::string toText(const CloseCall& call);

}  // namespace apollonius::test
