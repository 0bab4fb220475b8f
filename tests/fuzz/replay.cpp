// Feeds files to a fuzz target without libFuzzer: the corpus in the tests, with any compiler.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

/// libFuzzer's own, for mutators that fall back on it: here nothing is mutated.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t*, std::size_t size, std::size_t) {
  return size;
}

namespace {

int fed = 0;

void feed(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
  // If it ends the program, this is the last line.
  std::printf("%s\n", file.filename().c_str());
  std::fflush(stdout);
  const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
  (void)LLVMFuzzerTestOneInput(input.data(), input.size());
  ++fed;
}

}  // namespace

/// Files and folders of files.
int main(int count, char** arguments) {
  for (int k = 1; k < count; ++k) {
    if (!std::filesystem::is_directory(arguments[k])) {
      feed(arguments[k]);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(arguments[k])) feed(entry.path());
  }
  std::printf("%d inputs\n", fed);
  return fed > 0 ? 0 : 1;
}
