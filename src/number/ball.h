// Ball: a double with an absolute bound on its error, computed along with it. Used where a formula
// has divisions and roots (coordinates of Voronoi vertices), so that no constant bound exists.
//
// Each operation adds the propagated errors of its arguments and u |result| for its own rounding.
// The bounds themselves are computed in doubles, each with a handful of roundings: `bound()`
// enlarges the final one by 2^-40, more than a thousand operations can lose. Underflow adds less
// than kBallUnderflow per operation as long as values and bounds stay in range; anything else
// (overflow, a divisor that may be 0, the root of something that may be negative) ends as NaN or
// infinity in `error` and must be taken as "nothing is known".
#pragma once

#include <cmath>
#include <limits>

#include "number/fp.h"

namespace apollonius::internal {

inline constexpr double kBallUnderflow = powerOfTwo(-1000);

class Ball {
 public:
  constexpr Ball() = default;
  constexpr Ball(int constant) : value_(constant) {}  // NOLINT
  static Ball exact(double value) { return Ball(value, 0); }
  static Ball bounded(double value, double error) { return Ball(value, error); }
  /// A value that is itself the rounded result of one operation on exact doubles.
  static Ball rounded(double value) { return Ball(value, kUnitRoundoff * absolute(value)); }

  [[nodiscard]] double value() const { return value_; }
  /// |exact - value()| is at most this; NaN or infinite if nothing is known.
  [[nodiscard]] double bound() const { return error_ * (1 + powerOfTwo(-40)); }

  friend Ball operator+(Ball a, Ball b) { return result(a.value_ + b.value_, a.error_ + b.error_); }
  friend Ball operator-(Ball a, Ball b) { return result(a.value_ - b.value_, a.error_ + b.error_); }
  friend Ball operator*(Ball a, Ball b) {
    return result(a.value_ * b.value_,
                  absolute(a.value_) * b.error_ + (absolute(b.value_) + b.error_) * a.error_);
  }
  friend Ball operator/(Ball a, Ball b) {
    const double value = a.value_ / b.value_;
    const double margin = absolute(b.value_) - b.error_;
    // |a'/b' - a/b| <= (|a'-a| + |a/b| |b'-b|) / |b'|
    return result(value, margin > 0 ? (a.error_ + absolute(value) * b.error_) / margin
                                    : std::numeric_limits<double>::infinity());
  }
  friend Ball sqrt(Ball a) {
    if (!(a.value_ > a.error_)) return Ball(0, std::numeric_limits<double>::infinity());
    const double value = std::sqrt(a.value_);
    return result(value, a.error_ / value);  // |√a' - √a| = |a' - a| / (√a' + √a)
  }

 private:
  constexpr Ball(double value, double error) : value_(value), error_(error) {}
  static Ball result(double value, double propagated) {
    return Ball(value, propagated + (kUnitRoundoff * absolute(value) + kBallUnderflow));
  }

  double value_ = 0;
  double error_ = 0;
};

}  // namespace apollonius::internal
