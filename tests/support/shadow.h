// Less of the shadow check (predicate/shadow_check.h) for a while.
#pragma once

#include "predicate/shadow_check.h"

namespace apollonius::test {

/// Compares one of `every` answers as long as this lives; 0: none. None is enough where a test asks
/// the same questions again for each allocation that fails: other tests compare the answers.
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
