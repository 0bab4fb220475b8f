#include "geometry/draw/path_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "number/fp.h"

namespace apollonius::internal {

namespace {

constexpr double kTooLarge = 1e15;        // has kMostDigits + 1
constexpr std::size_t kMostOfPoint = 48;  // characters: a letter or comma, a sign, 15 digits, ".",
                                          // up to "e-15" or a few zeros; twice
constexpr std::array<std::uint8_t, 4> kLetters{'M', 'L', 'C', 'Z'};  // by Command
constexpr std::array<std::size_t, 4> kPointsOf{1, 1, 3, 0};

}  // namespace

PathWriter::PathWriter(unsigned digits) : digits_(digits) {
  for (unsigned k = 0; k < digits; ++k) scale_ *= 10;  // exact
}

bool PathWriter::write(const Path& path, std::vector<std::uint8_t>& text) {
  const std::size_t most = path.commands.size() + kMostOfPoint * (path.coordinates.size() / 2);
  if (scratch_.size() < most) scratch_.resize(2 * most);
  std::uint8_t* to = scratch_.data();
  const double* number = path.coordinates.data();
  for (const std::uint8_t command : path.commands) {
    *to++ = kLetters[command];
    for (std::size_t k = 0; k < 2 * kPointsOf[command]; ++k) {
      if (k > 0) *to++ = ',';
      to = writeNumber(*number++, to);
      if (to == nullptr) return false;
    }
  }
  text.insert(text.end(), scratch_.data(), to);
  return true;
}

std::uint8_t* PathWriter::writeNumber(double x, std::uint8_t* to) const {
  // Math.round
  const double scaled = x * scale_, below = std::floor(scaled);
  const double rounded = scaled - below >= 0.5 ? below + 1 : below;
  if (!(absolute(rounded) < kTooLarge)) return nullptr;
  if (rounded < 0) *to++ = '-';
  // The digits from the last one on; 32 bits as soon as that will do.
  std::array<std::uint8_t, 40> backwards;
  std::uint8_t* at = backwards.data();
  auto rest = static_cast<std::uint64_t>(absolute(rounded));
  for (; rest > 0xFFFFFFFFu; rest /= 10) *at++ = static_cast<std::uint8_t>('0' + rest % 10);
  for (auto few = static_cast<std::uint32_t>(rest); few > 0; few /= 10)
    *at++ = static_cast<std::uint8_t>('0' + few % 10);
  const std::uint8_t* last = backwards.data();
  unsigned places = digits_;
  for (; places > 0 && last != at && *last == '0'; --places) ++last;
  if (last == at) places = 0;  // zero
  const auto count = static_cast<unsigned>(at - last);
  if (places > count + 5) {  // JavaScript writes numbers below 1e-6 with an exponent
    *to++ = *--at;
    if (count > 1) *to++ = '.';
    while (at != last) *to++ = *--at;
    *to++ = 'e';
    *to++ = '-';
    const unsigned exponent = places + 1 - count;
    if (exponent >= 10) *to++ = '1';
    *to++ = static_cast<std::uint8_t>('0' + exponent % 10);
    return to;
  }
  while (at <= last + places) *at++ = '0';
  for (const std::uint8_t* point = last + places; at != last;) {
    if (at == point) *to++ = '.';
    *to++ = *--at;
  }
  return to;
}

}  // namespace apollonius::internal
