// Shadow check: in builds with APOLLONIUS_SHADOW_CHECK answers of filters are compared with the
// exact stage, each one or one of the number that it is set to, and a contradiction ends the
// program. Other builds contain nothing of it.
#pragma once

#include <cstdio>
#include <cstdlib>

#include "number/approx.h"
#include "number/sign.h"

namespace apollonius::internal {

#ifdef APOLLONIUS_SHADOW_CHECK
inline constexpr bool kShadowCheck = true;
inline unsigned shadowCheckEvery = APOLLONIUS_SHADOW_CHECK;  ///< tests change it; 0: no answer
#else
inline constexpr bool kShadowCheck = false;
inline unsigned shadowCheckEvery = 0;
#endif
inline unsigned answersSinceShadowCheck = 0;

struct AsItIs {
  Sign operator()(Sign s) const { return s; }
};

/// `normalise` maps signs that mean the same to one.
template <class Exact, class Normalise = AsItIs>
void shadowCheck(MaybeSign filtered, Exact&& exact, Normalise&& normalise = {}) {
  if constexpr (kShadowCheck) {
    if (!filtered.known || shadowCheckEvery == 0) return;
    if (++answersSinceShadowCheck < shadowCheckEvery) return;
    answersSinceShadowCheck = 0;
    if (normalise(filtered.sign) != normalise(exact())) {
      std::fprintf(stderr, "shadow check: a filter contradicts the exact stage\n");
      std::abort();
    }
  }
}

}  // namespace apollonius::internal
