// How much the randomised tests do: less where the same code runs slower (WebAssembly, sanitizers),
// and in every `npm test` less than in a thorough run, so that a whole run stays within minutes.
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

/// The number of runs of a test that makes `native` of them natively.
constexpr int runs(int native) { return native / kEffortDivisor + 1; }

/// Do tests run in their long forms, which take minutes? With APOLLONIUS_THOROUGH=1, as in
/// `npm run check -- thorough`; best with a build without the shadow check.
inline bool isThorough() { return std::getenv("APOLLONIUS_THOROUGH") != nullptr; }

/// A size or a number of runs: as in every `npm test`, and in a thorough run.
template <class Number>
Number sized(Number usual, Number thorough) {
  return isThorough() ? thorough : usual;
}

}  // namespace apollonius::test
