// Paths as SVG path data, with the numbers that JavaScript writes (wasm/package/core/path.ts),
// several times as fast.
#pragma once

#include <cstdint>
#include <vector>

#include "apollonius/path.h"
#include "base/flat_array.h"

namespace apollonius::internal {

class PathWriter {
 public:
  /// Of doubles: decimal numbers of this many digits are all different as doubles, so that the
  /// shortest text of one is the number itself.
  static constexpr unsigned kMostDigits = 15;

  /// Numbers are rounded to this many decimal places, halves upwards. REQUIRES: <= kMostDigits.
  explicit PathWriter(unsigned digits);

  /// Adds it to the text. false if a number has more than kMostDigits digits when it is rounded:
  /// then a part is missing. Throws std::bad_alloc, std::length_error.
  [[nodiscard]] bool write(const Path& path, std::vector<std::uint8_t>& text);

 private:
  /// Writes a number at `to` and returns its end; nullptr if it has too many digits.
  [[nodiscard]] std::uint8_t* writeNumber(double x, std::uint8_t* to) const;

  unsigned digits_;
  double scale_ = 1;
  FlatArray<std::uint8_t> scratch_;
};

}  // namespace apollonius::internal
