// FNV-1a over bits, for comparing outputs between platforms.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace apollonius::test {

class Hash {
 public:
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) {
      value_ = (value_ ^ ((bits >> (8 * byte)) & 0xFF)) * 0x100000001B3u;
    }
  }
  void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
  template <class Number>
  void addAll(const std::vector<Number>& numbers) {
    add(static_cast<std::uint64_t>(numbers.size()));
    for (const Number number : numbers) {
      if constexpr (std::is_same_v<Number, double>) {
        add(number);
      } else {
        add(static_cast<std::uint64_t>(static_cast<std::int64_t>(number)));
      }
    }
  }
  [[nodiscard]] std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xCBF29CE484222325u;
};

}  // namespace apollonius::test
