// How much the randomised tests do: one constant, smaller where the same code runs slower
// (WebAssembly, sanitizers), so that every suite stays within a few minutes.
#pragma once

#include <cstdlib>

namespace apollonius::test {

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define APOLLONIUS_UNDER_SANITIZER 1  // clang's way to say it
#endif
#endif

#if defined(__SANITIZE_ADDRESS__) || defined(APOLLONIUS_UNDER_SANITIZER)
inline constexpr int kEffortDivisor = 10;
#elif defined(__EMSCRIPTEN__)
inline constexpr int kEffortDivisor = 3;
#else
inline constexpr int kEffortDivisor = 1;
#endif

/// How many runs to make of a test that makes `native` of them natively.
constexpr int runs(int native) { return native / kEffortDivisor + 1; }

/// Shall tests run that take minutes each? Set APOLLONIUS_THOROUGH=1, best with a build without the
/// shadow check.
inline bool isThorough() { return std::getenv("APOLLONIUS_THOROUGH") != nullptr; }

}  // namespace apollonius::test
