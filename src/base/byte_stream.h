// Little-endian 32-bit words in bytes, at any address: what snapshots are made of, the same on
// every platform.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace apollonius::internal {

/// A word with its bytes in the order of the file, or one of the file in that of the machine.
template <class Word>
constexpr Word littleEndian(Word word) {
  if constexpr (std::endian::native == std::endian::little) {
    return word;
  } else {
    Word reversed = 0;
    for (std::size_t byte = 0; byte < sizeof(Word); ++byte, word >>= 8)
      reversed = reversed << 8 | (word & 0xFF);
    return reversed;
  }
}

/// Writes one word after the other. REQUIRES: room, which the caller has counted.
class WordWriter {
 public:
  explicit WordWriter(std::span<std::uint8_t> bytes) : next_(bytes.data()) {}

  void word(std::uint32_t value) { write(value); }
  void longWord(std::uint64_t value) { write(value); }
  void number(double value) { longWord(std::bit_cast<std::uint64_t>(value)); }

 private:
  template <class Word>
  void write(Word value) {
    const Word word = littleEndian(value);
    std::memcpy(next_, &word, sizeof(Word));
    next_ += sizeof(Word);
  }

  std::uint8_t* next_;
};

/// Reads them back. REQUIRES: that many words, which the caller has counted.
class WordReader {
 public:
  explicit WordReader(std::span<const std::uint8_t> bytes) : next_(bytes.data()) {}

  [[nodiscard]] std::uint32_t word() { return read<std::uint32_t>(); }
  [[nodiscard]] std::uint64_t longWord() { return read<std::uint64_t>(); }
  [[nodiscard]] double number() { return std::bit_cast<double>(longWord()); }

 private:
  template <class Word>
  Word read() {
    Word word;
    std::memcpy(&word, next_, sizeof(Word));
    next_ += sizeof(Word);
    return littleEndian(word);
  }

  const std::uint8_t* next_;
};

/// Checksum of a multiple of eight bytes. Every step is a bijection, so bytes that differ in one
/// group of eight differ in their checksum. Two sums run side by side, as each step waits for a
/// product.
inline std::uint64_t checksumOf(std::span<const std::uint8_t> bytes) {
  const auto add = [](std::uint64_t& sum, std::uint64_t word) {
    sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
    sum ^= sum >> 29;
  };
  WordReader in(bytes);
  std::uint64_t sum = 0, other = 0;
  for (std::size_t k = 0; k < bytes.size() / 16; ++k) {
    add(sum, in.longWord());
    add(other, in.longWord());
  }
  if (bytes.size() % 16 != 0) add(sum, in.longWord());
  add(sum, other);
  return sum;
}

}  // namespace apollonius::internal
