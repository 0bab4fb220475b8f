// Neumaier's summation: a sum of many terms that is as good as one of few.
#pragma once

#include "number/fp.h"

namespace apollonius::internal {

class Sum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    lost_ += absolute(sum_) >= absolute(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0;
  double lost_ = 0;  // by rounding, so far
};

}  // namespace apollonius::internal
