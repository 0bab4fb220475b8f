// Two doubles computed with at once: SSE2 and WebAssembly's SIMD have instructions for them. Each
// of + - * / and sqrt rounds as it does for one double, so results are the same bits as computed
// one by one.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

namespace apollonius::internal {

// Vector types are an extension that g++ and clang++ share.
using Pair __attribute__((vector_size(16))) = double;
/// What comparisons of Pairs yield: all bits or none.
using PairMask __attribute__((vector_size(16))) = std::int64_t;

inline Pair pairOf(double x) { return Pair{x, x}; }
inline Pair loadPair(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}
inline void storePair(double* to, Pair pair) { std::memcpy(to, &pair, sizeof pair); }
inline Pair absolute(Pair x) {
  PairMask bits;
  std::memcpy(&bits, &x, sizeof bits);
  bits &= PairMask{INT64_MAX, INT64_MAX};
  std::memcpy(&x, &bits, sizeof bits);
  return x;
}
inline Pair root(Pair x) { return Pair{std::sqrt(x[0]), std::sqrt(x[1])}; }

}  // namespace apollonius::internal
