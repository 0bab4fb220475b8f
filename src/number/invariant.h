// Invariants: conditions that hold if the code is right, whatever the user's data. A broken one
// ends the program with its name. Never used to check arguments.
#pragma once

#include <cstdlib>

namespace apollonius::internal {

/// Reports the name on stderr, or on JavaScript's console.
void reportBrokenInvariant(const char* name);

inline void invariant(bool holds, const char* name) {
  if (holds) return;
  reportBrokenInvariant(name);
  std::abort();
}

}  // namespace apollonius::internal
