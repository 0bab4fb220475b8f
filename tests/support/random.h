// The tests' own pseudo-random numbers: the same sequence from the same seed on every platform.
//
// <random>'s engines are portable but its distributions are not, and libm differs between native
// code and wasm, so both stay out of here: xoshiro256** (Blackman and Vigna), seeded by splitmix64,
// with our own few distributions on top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace apollonius::test {

class Random {
 public:
  explicit Random(std::uint64_t seed);

  std::uint64_t next();

  /// Uniform in [0, bound); bound > 0. The modulo's bias (bound / 2^64) does not matter to a test.
  template <class Whole>
  Whole below(Whole bound) {
    return static_cast<Whole>(next() % static_cast<std::uint64_t>(bound));
  }

  /// Uniform integer in [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high) { return low + below(high - low + 1); }

  /// Uniform in [0, 1), a multiple of 2^-53.
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  double between(double low, double high) { return low + (high - low) * unit(); }

  /// True once in `n` times.
  bool oneIn(std::uint64_t n) { return below(n) == 0; }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[below(k)]);
  }

 private:
  std::uint64_t state_[4];
};

}  // namespace apollonius::test
