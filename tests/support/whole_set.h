// A diagram many of whose sites change at once, and the circles that it should contain: moves and
// batches of whole sets, with everything checked after each.
#pragma once

#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/generators.h"

namespace apollonius::test {

/// Ways to move circles to their new places.
enum class Way {
  kTogether,  ///< updateMany of all
  kOneByOne,  ///< update of each, in random order
  kInParts,   ///< updateMany of a few, of half, of the rest
  kRestored,  ///< updateMany after a snapshot has been taken and read
};

class WholeSet {
 public:
  explicit WholeSet(const Circles& circles, Location location = Location::kHierarchy);

  [[nodiscard]] const Diagram& diagram() const { return diagram_; }
  [[nodiscard]] const Circles& circles() const { return circles_; }
  [[nodiscard]] const std::vector<SiteId>& ids() const { return ids_; }

  // Each returns what went wrong at once, or nothing.
  std::string moveTo(const Circles& next, Way way, Random& random);
  std::string insert(const Circles& more);
  /// Removes the circles at the given positions.
  std::string remove(const std::vector<std::size_t>& positions);
  std::string restore();

  /// Validates everything; compares the graph with that of a fresh build, and found sites with all
  /// distances. Returns the fault, or an empty text.
  std::string check(Random& random) const;

 private:
  std::string update(const std::vector<std::size_t>& positions, const Circles& next);
  std::string findSamples(Random& random) const;

  Diagram diagram_;
  Circles circles_;
  std::vector<SiteId> ids_;
};

/// A way to change a whole set.
struct WholeMove {
  const char* name;
  Circles (*make)(const Circles& circles, Random& random);
};
const std::vector<WholeMove>& wholeMoves();

}  // namespace apollonius::test
