// libFuzzer target: bytes are a snapshot, whose checksum is made right and of which the mutator
// changes parts that it knows. Taken as anyone's, it is refused or right; taken as trusted, every
// call ends in its memory. Start from real ones; how to run: README.md beside this file.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "predicate/shadow_check.h"
#include "support/mutants.h"
#include "support/snapshots.h"

namespace apollonius::test {
namespace {

void run(const std::vector<std::uint8_t>& input) {
  const std::vector<std::uint8_t> bytes = withChecksum(input);
  const std::size_t n = bytes.size();
  const std::uint64_t seed = n < 8 ? 0 : bytes[n - 1] | std::uint64_t{bytes[n - 2]} << 8;
  Random random(seed);
  Diagram diagram;
  if (diagram.fromBytes(bytes) == Error::kNone) {
    const std::string wrong = diagram.size() > 60 ? std::string() : whatIsWrong(diagram, random);
    if (!wrong.empty() || callEverything(diagram, seed)) {
      std::fprintf(stderr, "accepted from anyone: %s\n", wrong.c_str());
      std::abort();
    }
  }
  // On an invalid graph a filter may contradict the exact stage.
  if (diagram.fromBytes(bytes, Source::kTrusted) == Error::kNone && !internal::kShadowCheck)
    (void)callEverything(diagram, seed);
}

}  // namespace
}  // namespace apollonius::test

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  using namespace apollonius::test;
  std::vector<std::uint8_t> bytes(data, data + size);
  apollonius::Diagram diagram;
  // Random bytes have no parts.
  if (seed % 8 == 0 || diagram.fromBytes(withChecksum(bytes), apollonius::Source::kTrusted) !=
                           apollonius::Error::kNone) {
    return LLVMFuzzerMutate(data, size, most);
  }
  Random random(seed);
  bytes = mutant(bytes, random);
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::run({data, data + size});
  return 0;
}
