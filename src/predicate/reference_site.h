// Choice of the pole: the site of a face or an edge from which the others are seen. The largest one
// is taken, so that the directions of a bounded edge span at most half a turn, the degenerate rule
// applies directly, and equal triples of sites are computed alike whichever comes first.
#pragma once

#include <utility>

#include "predicate/site.h"

namespace apollonius {

/// Is `a` to be the pole rather than b?
inline bool isBetterPole(Corner a, Corner b) {
  return a != nullptr && (b == nullptr || precedes(*b, *a));
}

/// Rotates a face so that its largest finite site comes first.
inline void rotateToPole(Corner& i, Corner& j, Corner& k) {
  if (isBetterPole(j, i) && !isBetterPole(k, j)) {
    std::swap(i, j);
    std::swap(j, k);
  } else if (isBetterPole(k, i)) {
    std::swap(i, k);
    std::swap(j, k);
  }
}

}  // namespace apollonius
