// libFuzzer target: bytes are a snapshot, whose checksum is made right. What validate() finds nothing wrong with must stay so while it is changed.
// Start from tests/data/snapshots; how to run: README.md beside this file.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "apollonius.h"
#include "support/snapshots.h"

namespace apollonius::test {
namespace {

void expect(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

bool isValid(const Diagram& diagram) {
  std::string broken;
  expect(diagram.validate(broken) == Error::kNone, "validate failed");
  return broken.empty();
}

void run(const std::vector<std::uint8_t>& bytes) {
  Diagram diagram;
  if (diagram.fromBytes(withChecksum(bytes)) != Error::kNone) return;
  if (!isValid(diagram)) return;
  SiteId id = kNoSite;
  double distance = 0;
  expect(diagram.find(1, 2, id, distance) == Error::kNone, "find failed");
  expect(diagram.insert(3, -4, 5, id) == Error::kNone, "insert failed");
  std::vector<SiteId> ids;
  expect(diagram.ids(ids) == Error::kNone, "ids failed");
  bool removed = false;
  for (std::size_t k = 0; k < ids.size(); k += 2) expect(diagram.remove(ids[k], removed) == Error::kNone && removed, "remove failed");
  expect(isValid(diagram), "no longer valid");
}

}  // namespace
}  // namespace apollonius::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  apollonius::test::run({data, data + size});
  return 0;
}
