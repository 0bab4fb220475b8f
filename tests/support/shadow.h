// Less of the shadow check (predicate/shadow_check.h) for a while.
#pragma once

#include "predicate/shadow_check.h"

namespace apollonius::test {

/// While this lives, one of `every` answers is compared, or with 0 no answer: where a test asks the
/// same questions again for each allocation that fails, which other tests compare.
class ShadowCheckOf {
 public:
  explicit ShadowCheckOf(unsigned every) { internal::shadowCheckEvery = every; }
  ~ShadowCheckOf() { internal::shadowCheckEvery = before_; }
  ShadowCheckOf(const ShadowCheckOf&) = delete;
  ShadowCheckOf& operator=(const ShadowCheckOf&) = delete;

 private:
  const unsigned before_ = internal::shadowCheckEvery;
};

}  // namespace apollonius::test
