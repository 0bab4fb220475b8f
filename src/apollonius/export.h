// What a shared build of the library shows; all else is hidden (CXX_VISIBILITY_PRESET). A static
// one shows nothing, so that a library that it is linked into does not show it either.
#pragma once

#ifdef APOLLONIUS_SHARED
#define APOLLONIUS_EXPORT __attribute__((visibility("default")))
#else
#define APOLLONIUS_EXPORT
#endif
