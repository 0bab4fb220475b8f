#include "support/scale_run.h"

#include <cmath>
#include <cstdio>

#include "predicate/compute_circle.h"
#include "support/corpus.h"

namespace apollonius::test {

using namespace internal;

namespace {

constexpr std::size_t kSetSize = 16, kCallsOfASet = 6;

double legal(double value) {
  return isInRange(value)       ? value
         : std::fabs(value) < 1 ? 0
                                : std::copysign(kLargestMagnitude, value);
}

/// The value itself, or the next double up or down.
double aside(Random& random, double value) {
  const auto way = random.below(4u);
  return way > 1 ? value
                 : legal(std::nextafter(value,
                                        way == 0 ? -2 * kLargestMagnitude : 2 * kLargestMagnitude));
}

/// Five circles of a set, and a centre, the middle of two, their vertex, or the coordinates of two.
CloseCall drawn(Random& random, const Circles& circles, bool areAside) {
  CloseCall call;
  for (Site& s : call.sites) {
    const Circle& c = circles[random.below(circles.size())];
    s = {c.x, c.y, c.r};
    if (areAside) {
      s.x = aside(random, s.x);
      s.y = aside(random, s.y);
      s.r = aside(random, s.r);
    }
  }
  const Site &a = call.sites[0], &b = call.sites[1], &c = call.sites[2];
  switch (random.below(4u)) {
    case 0:
      call.x = a.x, call.y = b.y;
      break;
    case 1:
      call.x = legal(a.x / 2 + b.x / 2), call.y = legal(a.y / 2 + b.y / 2);
      break;
    case 2:
      call.x = call.sites[4].x, call.y = call.sites[4].y;
      break;
    default: {
      const VoronoiCircle circle = voronoiCircle(&a, &b, &c);  // any numbers, if there is none
      const bool isKnown = !std::isnan(circle.x) && !std::isnan(circle.y);
      call.x = isKnown ? legal(circle.x) : 0;
      call.y = isKnown ? legal(circle.y) : 0;
    }
  }
  return call;
}

std::vector<CloseCall> drawnFrom(const NamedGenerator& generator, Random& random, bool areAside) {
  std::vector<CloseCall> calls;
  const Circles circles = generator.make(random, kSetSize);
  for (std::size_t k = 0; k < kCallsOfASet; ++k) calls.push_back(drawn(random, circles, areAside));
  return calls;
}

double share(std::uint64_t part, std::uint64_t all) {
  return all == 0 ? 0 : 100.0 * static_cast<double>(part) / static_cast<double>(all);
}

}  // namespace

ScaleRun::ScaleRun(std::uint64_t seed) : random_(seed) {
  for (const NamedGenerator& generator : corpus()) {
    for (const bool areAside : {false, true}) {
      families_.push_back({generator.name + (areAside ? ", a double aside" : ""),
                           [&generator, areAside](Random& random) {
                             return drawnFrom(generator, random, areAside);
                           },
                           {}});
    }
  }
  const auto close = [](Random& random) {
    std::vector<CloseCall> calls;
    const auto nextByte = [&] { return static_cast<std::uint8_t>(random.next() >> 56); };
    for (std::size_t k = 0; k < 8 * kCallsOfASet; ++k) calls.push_back(closeCall(nextByte));
    return calls;
  };
  families_.push_back({"CloseCalls", close, {}});
}

void ScaleRun::round() {
  for (Family& family : families_) {
    for (const CloseCall& call : family.make(random_)) family.checks.ask(call);
  }
}

std::uint64_t ScaleRun::sum(std::uint64_t (StageChecks::*count)() const) const {
  std::uint64_t sum = 0;
  for (const Family& family : families_) sum += (family.checks.*count)();
  return sum;
}

std::string ScaleRun::report() const {
  std::string text;
  for (const Family& family : families_) text += family.checks.report();
  return text;
}

std::string ScaleRun::table() const {
  StageChecks all;
  for (const Family& family : families_) all.add(family.checks);
  std::string text = all.table() + "\n";
  char line[160];
  for (const Family& family : families_) {
    const StageChecks& checks = family.checks;
    std::snprintf(line, sizeof line,
                  "%-46s %10llu calls, exact %6.2f %%, zeros %6.2f %%, disagreements %llu\n",
                  family.name.c_str(), static_cast<unsigned long long>(checks.calls()),
                  share(checks.leftToExact(), checks.calls()),
                  share(checks.zeros(), checks.calls()),
                  static_cast<unsigned long long>(checks.disagreements()));
    text += line;
  }
  std::snprintf(line, sizeof line,
                "%-46s %10llu calls, exact %6.2f %%, zeros %6.2f %%, disagreements %llu\n", "all",
                static_cast<unsigned long long>(all.calls()), share(all.leftToExact(), all.calls()),
                share(all.zeros(), all.calls()), static_cast<unsigned long long>(disagreements()));
  return text + line;
}

}  // namespace apollonius::test
