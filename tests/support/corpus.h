// Every generator under a name, so that a test can run over all of them and say which one it failed
// on.
#pragma once

#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "support/generators.h"

namespace apollonius::test {

struct NamedGenerator {
  std::string name;  ///< letters and digits only: it becomes part of a test's name
  std::function<Circles(Random&, std::size_t n)> make;  ///< about n circles
  /// False where exact arithmetic takes long (exponents far apart): such sets stay small.
  bool large = true;
};

/// GoogleTest shows a parameter by its name.
inline void PrintTo(const NamedGenerator& generator, std::ostream* out) { *out << generator.name; }

/// All generators, from harmless to degenerate to the ends of the number range.
const std::vector<NamedGenerator>& corpus();

}  // namespace apollonius::test
