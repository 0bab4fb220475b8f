// libFuzzer target: bytes are read as a sequence of operations on the public API. validate() runs after each of them, and the end
// is compared with fresh builds and, for few sites, with the oracle. A failure prints the history as tests/data/regressions wants
// it. How to run: README.md beside this file.
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "support/replay.h"

namespace apollonius::test {
namespace {

constexpr std::size_t kMostOperations = 48;

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

/// How numbers are made of bytes.
enum class Numbers : std::uint8_t { kTinyGrid, kGrid, kNarrowDoubles, kRawDoubles };

double number(Bytes& bytes, Numbers numbers) {
  switch (numbers) {
    case Numbers::kTinyGrid: return bytes.next() % 4;
    case Numbers::kGrid: return static_cast<std::int8_t>(bytes.next());
    case Numbers::kNarrowDoubles: {  // all bits of a mantissa, magnitudes of about 1
      const double value = std::bit_cast<double>((bytes.next64() & 0x800FFFFFFFFFFFFFu) | 0x3FE0000000000000u);
      return std::ldexp(value, bytes.next() % 4);
    }
    case Numbers::kRawDoubles: return std::bit_cast<double>(bytes.next64());
  }
  return 0;
}

constexpr std::uint8_t kRestoreCode = 0xFD;  // would be one more of many inserts

bool isLegal(double value) {
  const double magnitude = std::abs(value);
  return magnitude == 0 || (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude);
}

/// An illegal circle must be refused; the history goes on with legal ones only.
void expectRefusal(const Circle& circle) {
  Diagram diagram;
  SiteId id = kNoSite;
  if (diagram.insert(circle.x, circle.y, circle.r, id) == Error::kNone || diagram.size() != 0) {
    std::fprintf(stderr, "an illegal circle was accepted: %a %a %a\n", circle.x, circle.y, circle.r);
    std::abort();
  }
}

History decode(Bytes& bytes, Numbers numbers) {
  History history;
  std::vector<std::size_t> live;
  std::size_t inserted = 0;
  while (!bytes.empty() && history.size() < kMostOperations) {
    const std::uint8_t code = bytes.next();
    const std::size_t chosen = live.empty() ? 0 : (code >> 2) % live.size();
    if ((code & 3) == 3 && !live.empty()) {
      history.push_back({Operation::Kind::kRemove, live[chosen], {}});
      live[chosen] = live.back();
      live.pop_back();
      continue;
    }
    if (code == kRestoreCode) {
      history.push_back({Operation::Kind::kRestore, 0, {}});
      continue;
    }
    Circle circle{};
    circle.x = number(bytes, numbers);
    circle.y = number(bytes, numbers);
    circle.r = number(bytes, numbers);
    if (!isLegal(circle.x) || !isLegal(circle.y) || !isLegal(circle.r)) {
      expectRefusal(circle);
    } else if ((code & 3) == 2 && !live.empty()) {
      history.push_back({Operation::Kind::kUpdate, live[chosen], circle});
    } else {
      history.push_back({Operation::Kind::kInsert, 0, circle});
      live.push_back(inserted++);
    }
  }
  return history;
}

void run(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  const std::uint8_t mode = bytes.next();
  const auto numbers = static_cast<Numbers>(mode & 3);
  Checks checks;
  checks.location = (mode & 4) != 0 ? Location::kWalk : Location::kHierarchy;
  checks.oracleUpTo = numbers == Numbers::kRawDoubles ? 4 : 6;
  const History history = decode(bytes, numbers);
#ifdef APOLLONIUS_FUZZ_PRINT
  std::fprintf(stderr, "---\n%s", toText(history).c_str());
#endif
  const std::string wrong = checkHistory(history, checks);
  if (wrong.empty()) return;
  std::fprintf(stderr, "%s\n%s", wrong.c_str(), failureOf(history, checks).c_str());
  std::abort();
}

}  // namespace
}  // namespace apollonius::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::run({data, size});
  return 0;
}
