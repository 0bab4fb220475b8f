// Replays histories on the public API and checks the diagram on the way: validate() after every
// operation, and the canonical form against that of fresh builds of the surviving circles (and
// against the oracle, if they are few).
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/canonical.h"
#include "support/operations.h"

namespace apollonius::test {

/// A diagram together with the circles that it should contain.
class Replay {
 public:
  explicit Replay(Location location = Location::kHierarchy) : diagram_(location) {}

  /// Applies the operations of one call; returns what went wrong at once (an error code, a wrong
  /// size, an id that changed), or nothing.
  std::string apply(std::span<const Operation> call);

  [[nodiscard]] const Diagram& diagram() const { return diagram_; }
  [[nodiscard]] Circles survivors() const;

 private:
  struct Entry {
    Circle circle;
    SiteId id;
    bool lives;
  };
  std::string insert(std::span<const Operation> call);
  std::string remove(std::span<const Operation> call);
  std::string update(std::span<const Operation> call);
  [[nodiscard]] std::vector<SiteId> idsOf(std::span<const Operation> call) const;

  Diagram diagram_;
  std::vector<Entry> entries_;  // by the operations' names
  std::set<SiteId> taken_;      // ids of those that live
};

/// The comparisons that checkHistory makes, and how often.
struct Checks {
  Location location = Location::kHierarchy;
  /// Except after a restoration, whose diagram the next operation is to meet as it is.
  bool validateEveryStep = true;
  bool compareEveryStep = false;  ///< with the same exception; else only at the end
  std::size_t oracleUpTo = 0;     ///< most distinct survivors for which the oracle is asked, too
};

/// Replays a history; returns what went wrong and at which operation, or an empty text.
std::string checkHistory(const History& history, const Checks& checks);

/// Canonical form of a diagram built from scratch: one by one in the given order, or in bulk.
/// `broken` as of canonicalForm, validate() included.
enum class Build { kOneByOne, kBulk };
Canonical freshBuild(const Circles& circles, Build build, Location location, std::string& broken);

/// checkHistory; if it fails, the history is shortened and returned with the message, ready for
/// tests/data/regressions.
std::string failureOf(const History& history, const Checks& checks);

}  // namespace apollonius::test
