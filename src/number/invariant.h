// What must hold if the code is right, whatever the user's data: a broken one ends the program with
// its name. Never used to check arguments.
#pragma once

#include <cstdlib>

namespace apollonius::internal {

/// Tells whoever runs the program: on stderr, or on JavaScript's console.
void reportBrokenInvariant(const char* name);

inline void invariant(bool holds, const char* name) {
  if (holds) return;
  reportBrokenInvariant(name);
  std::abort();
}

}  // namespace apollonius::internal
