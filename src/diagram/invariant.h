// What must hold if the code is right, whatever the user's data: a broken one ends the program with its name. Never used to
// check arguments.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace apollonius {

inline void invariant(bool holds, const char* name) {
  if (holds) return;
  std::fprintf(stderr, "apollonius: broken invariant: %s\n", name);
  std::abort();
}

}  // namespace apollonius
