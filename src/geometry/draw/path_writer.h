// Paths as SVG path data, with the same numbers as JavaScript writes (wasm/package/core/path.ts),
// but several times as fast.
#pragma once

#include <cstdint>
#include <vector>

#include "apollonius/path.h"
#include "base/flat_array.h"

namespace apollonius::internal {

class PathWriter {
 public:
  /// Decimal numbers of this many digits are all different as doubles, so that the shortest text of
  /// such a double is the decimal number itself.
  static constexpr unsigned kMostDigits = 15;

  /// Rounds numbers to this many decimal places, halves upwards. REQUIRES: <= kMostDigits.
  explicit PathWriter(unsigned digits);

  /// Adds the path to the text. False if a rounded number has more than kMostDigits digits: then a
  /// part is missing. Throws std::bad_alloc, std::length_error.
  [[nodiscard]] bool write(const Path& path, std::vector<std::uint8_t>& text);

 private:
  /// Writes a number at `to` and returns its end; nullptr if it has too many digits.
  [[nodiscard]] std::uint8_t* writeNumber(double x, std::uint8_t* to) const;

  unsigned digits_;
  double scale_ = 1;
  FlatArray<std::uint8_t> scratch_;
};

}  // namespace apollonius::internal
