// What must hold if the code is right, whatever the user's data: a broken one ends the program with its name. Never used to
// check arguments.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace apollonius {

inline void invariant(bool holds, const char* name) {
  if (holds) return;
  for (const char* part : {"apollonius: broken invariant: ", name, "\n"}) std::fputs(part, stderr);  // printf would be 1 % of the wasm module
  std::abort();
}

}  // namespace apollonius
