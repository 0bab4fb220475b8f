// bench_sites FOLDER FAMILY N...
// Writes, as raw little-endian doubles, the files that every contender reads (so that all work on
// the same bits):
//   FOLDER/FAMILY-N.sites   N x, y, r triples in random order
//   FOLDER/FAMILY-N.box     x, y pairs uniform in the bounding box of the centres
//   FOLDER/FAMILY-N.near    x, y pairs near random sites
// For a FAMILY that it does not know (real data), FAMILY-N.sites must be there, and only the
// queries are written.
#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/sites/families.h"

namespace {

using apollonius::Circle;
using namespace apollonius::bench;

static_assert(std::endian::native == std::endian::little, "the files are little-endian");
constexpr std::size_t kFewestQueries = 100'000;
constexpr std::size_t kMostQueries = 1'000'000;

template <class Record>
bool write(const std::string& name, std::span<const Record> records) {
  static_assert(sizeof(Record) % sizeof(double) == 0);
  std::ofstream file(name + ".part", std::ios::binary);
  file.write(reinterpret_cast<const char*>(records.data()),
             static_cast<std::streamsize>(records.size_bytes()));
  file.close();
  return file.good() && std::rename((name + ".part").c_str(), name.c_str()) == 0;
}

std::optional<SiteSet> readSet(const std::string& stem, std::size_t n) {
  SiteSet set{std::vector<Circle>(n)};
  std::ifstream file(stem + ".sites", std::ios::binary);
  file.read(reinterpret_cast<char*>(set.circles.data()),
            static_cast<std::streamsize>(n * sizeof(Circle)));
  return file.good() ? std::optional(std::move(set)) : std::nullopt;
}

bool writeSet(const std::string& stem, const SiteSet& set) {
  const std::size_t queries = std::min(kMostQueries, std::max(kFewestQueries, set.circles.size()));
  return write<Circle>(stem + ".sites", set.circles) &&
         write<Point>(stem + ".box", pointsInBox(set, queries)) &&
         write<Point>(stem + ".near", pointsNearSites(set, queries));
}

int usage() {
  std::cerr << "usage: bench_sites FOLDER FAMILY N...\nfamilies:";
  for (const std::string_view name : familyNames()) std::cerr << ' ' << name;
  std::cerr << "\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return usage();
  const std::string folder = argv[1];
  const std::string family = argv[2];
  for (int k = 3; k < argc; ++k) {
    const std::size_t n = std::strtoull(argv[k], nullptr, 10);
    if (n == 0) return usage();
    const std::string stem = folder + "/" + family + "-" + std::to_string(n);
    std::optional<SiteSet> set = makeSites(family, n);
    if (!set) set = readSet(stem, n);
    if (!set) return usage();
    if (!writeSet(stem, *set)) {
      std::cerr << "cannot write " << stem << "\n";
      return 1;
    }
  }
  return 0;
}
