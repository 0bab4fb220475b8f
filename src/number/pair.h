// Pairs of doubles, computed with at once: SSE2 and WebAssembly's SIMD have instructions for them.
// Each of + - * / and sqrt rounds as for one double, so the results have the same bits as if
// computed one by one.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace apollonius::internal {

// Vector types are an extension that g++ and clang++ share.
using Pair __attribute__((vector_size(16))) = double;
/// Result of a comparison of Pairs: all bits or none, for each number.
using PairMask __attribute__((vector_size(16))) = std::int64_t;

inline Pair pairOf(double x) { return Pair{x, x}; }
inline Pair loadPair(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}

/// Select two of the four numbers in two pairs: the first and the third, the second and the fourth,
/// the second and the third.
inline Pair firsts(Pair a, Pair b) { return __builtin_shufflevector(a, b, 0, 2); }
inline Pair seconds(Pair a, Pair b) { return __builtin_shufflevector(a, b, 1, 3); }
inline Pair middles(Pair a, Pair b) { return __builtin_shufflevector(a, b, 1, 2); }

inline Pair larger(Pair a, Pair b) { return a > b ? a : b; }
inline bool areBoth(PairMask mask) {
#ifdef __wasm__
  return __builtin_wasm_all_true_i64x2(mask);
#else
  return (mask[0] & mask[1]) != 0;
#endif
}

// If there is a builtin, WebAssembly gets one instruction for it.
inline Pair absolute(Pair x) {
#if __has_builtin(__builtin_elementwise_abs)
  return __builtin_elementwise_abs(x);
#else
  PairMask bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits &= PairMask{INT64_MAX, INT64_MAX};
  std::memcpy(&x, &bits, sizeof bits);
  return x;
#endif
}
inline Pair root(Pair x) {
#if __has_builtin(__builtin_elementwise_sqrt)
  return __builtin_elementwise_sqrt(x);
#else
  return Pair{std::sqrt(x[0]), std::sqrt(x[1])};
#endif
}

/// Each number as a float, infinite beyond the range of floats, followed by `other`.
inline Pair floatsBefore(Pair x, float other) {
  using Floats __attribute__((vector_size(8))) = float;
  return std::bit_cast<Pair>(__builtin_shufflevector(__builtin_convertvector(x, Floats),
                                                     Floats{other, other}, 0, 2, 1, 3));
}

}  // namespace apollonius::internal
