// Snapshots that somebody wants to be believed: the checksum of docs/SNAPSHOTS.md, written a second
// time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace apollonius::test {

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
