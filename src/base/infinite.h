// Infinity, by a name that is short.
#pragma once

#include <limits>

namespace apollonius::internal {

inline constexpr double kInfinite = std::numeric_limits<double>::infinity();

}  // namespace apollonius::internal
