// Bytes of a fuzzer's input, and the numbers that are made of them.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace apollonius::test {

/// Reads the input from front to back; zeros after its end.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  [[nodiscard]] bool empty() const { return at_ >= bytes_.size(); }
  std::uint8_t next() { return empty() ? 0 : bytes_[at_++]; }
  std::uint64_t next64() {
    std::uint64_t value = 0;
    for (int k = 0; k < 8; ++k) value |= std::uint64_t{next()} << (8 * k);
    return value;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

/// Ways to make numbers of bytes.
enum class Numbers : std::uint8_t { kTinyGrid, kGrid, kNarrowDoubles, kRawDoubles };

inline double number(Bytes& bytes, Numbers numbers) {
  switch (numbers) {
    case Numbers::kTinyGrid:
      return bytes.next() % 4;
    case Numbers::kGrid:
      return static_cast<std::int8_t>(bytes.next());
    case Numbers::kNarrowDoubles: {  // all bits of a mantissa, magnitudes of about 1
      const double value =
          std::bit_cast<double>((bytes.next64() & 0x800FFFFFFFFFFFFFu) | 0x3FE0000000000000u);
      return std::ldexp(value, bytes.next() % 4);
    }
    case Numbers::kRawDoubles:
      return std::bit_cast<double>(bytes.next64());
  }
  return 0;
}

}  // namespace apollonius::test
