#include "number/invariant.h"

#ifdef __EMSCRIPTEN__
#include <emscripten/console.h>

#include <array>
#include <cstddef>
#else
#include <cstdio>
#endif

void apollonius::internal::reportBrokenInvariant(const char* name) {
#ifdef __EMSCRIPTEN__
  // C's output functions would be 2 % of the bytes that a page loads.
  std::array<char, 200> text{};
  std::size_t length = 0;
  for (const char* part : {"apollonius: broken invariant: ", name}) {
    for (; *part != '\0' && length + 1 < text.size(); ++part) text[length++] = *part;
  }
  emscripten_console_error(text.data());
#else
  std::fprintf(stderr, "apollonius: broken invariant: %s\n", name);
#endif
}
