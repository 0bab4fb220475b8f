// Marks the symbols that a shared build of the library exports; all others are hidden
// (CXX_VISIBILITY_PRESET). A static build exports none, so that a library that it is linked into
// does not export them either.
#pragma once

#ifdef APOLLONIUS_SHARED
#define APOLLONIUS_EXPORT __attribute__((visibility("default")))
#else
#define APOLLONIUS_EXPORT
#endif
