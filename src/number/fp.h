// The library's assumptions about `double`, and powers of two.
//
// Only + - * / and sqrt are used (correctly rounded to nearest, subnormals kept), contraction is
// off in every build, so that native code and WebAssembly give the same bits. Directed rounding,
// fma and libm are not used: WebAssembly has none of them.
#pragma once

#include <bit>
#include <cfloat>
#include <cstdint>
#include <limits>

namespace apollonius::internal {

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53);
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    __FINITE_MATH_ONLY__
#error "fast-math breaks the error bounds: compile without -ffast-math, -Ofast and their parts"
#endif
#if FLT_EVAL_METHOD != 0
#error "results of more than 53 bits break the error bounds: compile with -msse2 -mfpmath=sse"
#endif

/// A description of what is wrong with floating-point arithmetic in this program, or null:
/// contraction, which no macro reveals, if everything was compiled without the flags of
/// cmake/CompileFlags.cmake; subnormals flushed to zero, as in a program linked with -ffast-math;
/// another direction of rounding. WebAssembly has none of these.
#ifdef __wasm__
constexpr const char* arithmeticViolation() { return nullptr; }
#else
const char* arithmeticViolation();
#endif

/// 2^exponent, for exponents of normal numbers (-1022 … 1023).
constexpr double powerOfTwo(int exponent) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

/// Unit roundoff: fl(a op b) = (a op b)(1 + d) with |d| <= kUnitRoundoff, unless the result
/// underflows.
inline constexpr double kUnitRoundoff = powerOfTwo(-53);

/// The magnitude of a finite double taken apart: digits · 2^exponent, with digits < 2^53.
struct Decomposed {
  std::uint64_t digits;
  int exponent;
};

/// Takes a double apart: the only code that depends on its representation.
constexpr Decomposed decompose(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>((bits >> 52) & 0x7FF);
  const std::uint64_t digits = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased == 0) return {digits, 1 - 1075};  // subnormal
  return {digits | std::uint64_t{1} << 52, biased - 1075};
}

/// floor(log2 |x|) of a normal number.
constexpr int exponentOf(double x) { return decompose(x).exponent + 52; }

/// Exponent of the lowest digit of a nonzero double: the largest e for which x is a multiple of
/// 2^e.
constexpr int lowestExponentOf(double x) {
  const auto [digits, exponent] = decompose(x);
  return exponent + std::countr_zero(digits);
}

constexpr double absolute(double x) { return __builtin_fabs(x); }

}  // namespace apollonius::internal
