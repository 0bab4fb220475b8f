// Twofold: a number as the unevaluated sum of two doubles, with twice the digits. Not exact, but
// the relative error of each operation is less than half of kTwofoldRoundoff, if nothing overflows
// and no part is subnormal (Dekker 1971; Joldes, Muller and Popescu 2017 derive 3 times 2^-106 for
// such sums and 7 for products; a quotient and a root here add a few roundings to a product, in all
// 12).
#pragma once

#include "number/fp.h"

namespace apollonius::internal {

inline constexpr double kTwofoldRoundoff = powerOfTwo(-101);

struct Twofold {
  double value = 0;  ///< the double nearest to the sum
  double rest = 0;

  Twofold() = default;
  Twofold(double x) : value(x) {}  // NOLINT: implicit on purpose
  Twofold(double x, double y) : value(x), rest(y) {}
};

// Not inline: each formula would get its own copies, several kilobytes of the WebAssembly module.
/// The exact product.
Twofold productOf(double x, double y);
Twofold operator+(const Twofold& a, const Twofold& b);
Twofold operator*(const Twofold& a, const Twofold& b);
Twofold operator/(const Twofold& a, const Twofold& b);
/// Square root. REQUIRES: a > 0.
Twofold root(const Twofold& a);

inline Twofold operator-(const Twofold& a) { return {-a.value, -a.rest}; }
inline Twofold operator-(const Twofold& a, const Twofold& b) { return a + -b; }

}  // namespace apollonius::internal
