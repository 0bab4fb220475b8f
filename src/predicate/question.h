// A question on its way through its stages: each is counted, and in builds with the shadow check
// compared with the exact one.
#pragma once

#include "number/approx.h"
#include "number/sign.h"
#include "predicate/shadow_check.h"
#include "predicate/stage_counts.h"

namespace apollonius::internal {

/// `Exact` is the exact stage, which is called only if it is asked for. `Meaning` maps signs that
/// mean the same to one.
template <class Exact, class Meaning = AsItIs>
class Question {
 public:
  using Count = unsigned long long;

  Question(Exact exact, Count& count, Meaning meaning = {})
      : exact_(exact), count_(count), meaning_(meaning) {}

  /// Has the stage an answer? Counts it.
  bool isSettledBy(MaybeSign answer, Count& count) {
    shadowCheck(answer, exact_, meaning_);
    count += answer.known;
    sign_ = answer.sign;
    return answer.known;
  }
  /// The answer of the stage that has settled the question.
  [[nodiscard]] Sign settled() const { return sign_; }
  /// The answer of the exact stage. Counts it.
  [[nodiscard]] Sign exact() {
    ++count_;
    return exact_();
  }

 private:
  Exact exact_;
  Count& count_;
  Meaning meaning_;
  Sign sign_ = Sign::kZero;
};

/// Where a positive sign means yes and anything else no.
struct PositiveOrNot {
  Sign operator()(Sign s) const { return s == Sign::kPositive ? Sign::kPositive : Sign::kNegative; }
};

}  // namespace apollonius::internal
