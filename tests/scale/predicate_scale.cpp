// Exactness at scale: as many predicate calls as wished, each stage compared with the exact one, by
// families of arguments; and which stage settles how much. Deterministic by the seed.
//
//   cmake --build build --target predicate_scale && build/predicate_scale 1e8 [seed]
//
// Says every ten million calls where it is. Ends with 1 if a stage contradicts the exact one.
#include <cstdio>
#include <cstdlib>

#include "support/scale_run.h"

int main(int count, char** arguments) {
  using namespace apollonius::test;
  const double wanted = count > 1 ? std::strtod(arguments[1], nullptr) : 1e6;
  const std::uint64_t seed = count > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  ScaleRun run(seed);
  for (double next = 1e7; static_cast<double>(run.calls()) < wanted;) {
    run.round();
    if (static_cast<double>(run.calls()) < next) continue;
    next += 1e7;
    std::fprintf(stderr, "%.0f calls, %llu disagreements\n", static_cast<double>(run.calls()),
                 static_cast<unsigned long long>(run.disagreements()));
  }
  std::printf("%s%s", run.report().c_str(), run.table().c_str());
  return run.disagreements() == 0 ? 0 : 1;
}
