#include "number/fp.h"

#ifndef __wasm__

// The operands are volatile, or the compiler would evaluate all this itself, and correctly.
const char* apollonius::internal::arithmeticViolation() {
  const volatile double one = 1;
  const volatile double little = powerOfTwo(-54), more = 3 * powerOfTwo(-54);
  if (one + little != 1 || -one - little != -1 || one + more == 1)
    return "rounding is not to nearest: call fesetround(FE_TONEAREST)";

  const volatile double smallest = std::numeric_limits<double>::min();
  const volatile double half = smallest / 2;
  if (half * 2 != smallest)
    return "subnormal numbers are flushed to zero: do not link with -ffast-math or -Ofast, nor set "
           "FTZ or DAZ";

  const volatile double factor = 1 + powerOfTwo(-30);
  const volatile double square = 1 + powerOfTwo(-29);  // factor², rounded
  const double a = factor, b = square;
  if (a * a - b != 0)
    return "multiplication and addition are contracted: compile with -ffp-contract=off";
  return nullptr;
}

#endif
