// Snapshots that somebody wants to be believed: the words, the numbers and the checksum of
// docs/SNAPSHOTS.md, written a second time.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace apollonius::test {

/// The word where the numbers of the sites begin: x, y, r of each slot.
inline constexpr std::size_t kNumbersAt = 8;

inline std::uint32_t wordAt(const std::vector<std::uint8_t>& bytes, std::size_t k) {
  std::uint32_t value = 0;
  for (std::size_t byte = 4; byte-- > 0;) value = value << 8 | bytes[4 * k + byte];
  return value;
}

inline void setWord(std::vector<std::uint8_t>& bytes, std::size_t k, std::uint32_t value) {
  for (std::size_t byte = 0; byte < 4; ++byte, value >>= 8)
    bytes[4 * k + byte] = static_cast<std::uint8_t>(value);
}

/// Numbers take two words; k is that of the first.
inline double numberAt(const std::vector<std::uint8_t>& bytes, std::size_t k) {
  return std::bit_cast<double>(std::uint64_t{wordAt(bytes, k + 1)} << 32 | wordAt(bytes, k));
}

inline void setNumber(std::vector<std::uint8_t>& bytes, std::size_t k, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  setWord(bytes, k, static_cast<std::uint32_t>(bits));
  setWord(bytes, k + 1, static_cast<std::uint32_t>(bits >> 32));
}

/// The bytes with the right checksum for what comes before it; too few for one are left as they
/// are.
inline std::vector<std::uint8_t> withChecksum(std::vector<std::uint8_t> bytes) {
  if (bytes.size() < 8) return bytes;
  const auto add = [](std::uint64_t& sum, std::uint64_t word) {
    sum = (sum ^ word) * 0x9E3779B97F4A7C15u;
    sum ^= sum >> 29;
  };
  std::uint64_t sums[2] = {0, 0};
  for (std::size_t k = 0; k + 16 <= bytes.size(); k += 8) {
    std::uint64_t word = 0;
    for (std::size_t byte = 0; byte < 8; ++byte)
      word |= std::uint64_t{bytes[k + byte]} << (8 * byte);
    add(sums[k / 8 % 2], word);
  }
  add(sums[0], sums[1]);
  for (std::size_t byte = 0; byte < 8; ++byte)
    bytes[bytes.size() - 8 + byte] = static_cast<std::uint8_t>(sums[0] >> (8 * byte));
  return bytes;
}

}  // namespace apollonius::test
