// Choice of the reference site: the site of a face or an edge from which the others are seen. The
// largest one is taken, so that the directions of a bounded edge span at most half a turn, the
// degenerate rule applies directly, and equal triples of sites are computed alike whichever comes
// first.
#pragma once

#include <utility>

#include "predicate/site.h"

namespace apollonius::internal {

/// Is `a` to be the reference site rather than b?
inline bool isBetterReference(Corner a, Corner b) {
  return a != nullptr && (b == nullptr || precedes(*b, *a));
}

/// Rotates a face so that its largest finite site comes first.
inline void rotateToReference(Corner& i, Corner& j, Corner& k) {
  if (isBetterReference(j, i) && !isBetterReference(k, j)) {
    std::swap(i, j);
    std::swap(j, k);
  } else if (isBetterReference(k, i)) {
    std::swap(i, k);
    std::swap(j, k);
  }
}

}  // namespace apollonius::internal
