#include "number/invariant.h"

#include <cstdio>

void apollonius::reportBrokenInvariant(const char* name) {
  std::fprintf(stderr, "apollonius: broken invariant: %s\n", name);
}
