// Predicate calls in any number: families of arguments in turn (every generator of the corpus, the
// same with numbers a double aside, and close calls), each stage compared with the exact one.
// Deterministic by the seed.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "support/random.h"
#include "support/stage_checks.h"

namespace apollonius::test {

class ScaleRun {
 public:
  explicit ScaleRun(std::uint64_t seed);

  /// Makes some hundred calls of each family.
  void round();

  [[nodiscard]] std::uint64_t calls() const { return sum(&StageChecks::calls); }
  [[nodiscard]] std::uint64_t disagreements() const { return sum(&StageChecks::disagreements); }
  [[nodiscard]] std::string report() const;
  /// Returns what each stage settled in all, and how many calls of each family the exact stage had
  /// to.
  [[nodiscard]] std::string table() const;

 private:
  struct Family {
    std::string name;
    std::function<std::vector<CloseCall>(Random&)> make;
    StageChecks checks;
  };
  [[nodiscard]] std::uint64_t sum(std::uint64_t (StageChecks::*count)() const) const;

  Random random_;
  std::vector<Family> families_;
};

}  // namespace apollonius::test
