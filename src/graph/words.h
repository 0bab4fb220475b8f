// Little-endian 32-bit words in bytes, at any address: what snapshots are made of, the same on every platform.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace apollonius {

/// Writes one word after the other. REQUIRES: room, which the caller has counted.
class WordWriter {
 public:
  explicit WordWriter(std::span<std::uint8_t> bytes) : next_(bytes.data()) {}

  void word(std::uint32_t value) {
    std::uint8_t* const at = next_;  // bytes may be anything's, even this pointer's: without a copy it is read again for each
    for (unsigned byte = 0; byte < 4; ++byte) at[byte] = static_cast<std::uint8_t>(value >> (8 * byte));
    next_ = at + 4;
  }
  void longWord(std::uint64_t value) {
    word(static_cast<std::uint32_t>(value));
    word(static_cast<std::uint32_t>(value >> 32));
  }
  void number(double value) { longWord(std::bit_cast<std::uint64_t>(value)); }

 private:
  std::uint8_t* next_;
};

/// Reads them back. REQUIRES: that many words, which the caller has counted.
class WordReader {
 public:
  explicit WordReader(std::span<const std::uint8_t> bytes) : next_(bytes.data()) {}

  [[nodiscard]] std::uint32_t word() {
    std::uint32_t value = 0;
    for (unsigned byte = 0; byte < 4; ++byte) value |= static_cast<std::uint32_t>(next_[byte]) << (8 * byte);
    next_ += 4;
    return value;
  }
  [[nodiscard]] std::uint64_t longWord() {
    const std::uint64_t low = word();
    return low | static_cast<std::uint64_t>(word()) << 32;
  }
  [[nodiscard]] double number() { return std::bit_cast<double>(longWord()); }

 private:
  const std::uint8_t* next_;
};

}  // namespace apollonius
