// The canonical form of a diagram: its facts about its *circles*, free of ids, row orders and
// everything else that depends on the history. Two diagrams of the same circles must have the same
// canonical form, and it must be the oracle's.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apollonius/diagram.h"
#include "support/oracle.h"

namespace apollonius::test {

struct Canonical {
  Circles circles;  ///< all sites, ascending by (r, x, y), duplicates too
  std::vector<bool>
      visible;  ///< per circle; of identical circles the last one is called the visible one
  std::vector<Triple>
      triples;  ///< indices into `circles` (of identical ones the last), sorted; see OracleDiagram

  bool operator==(const Canonical& other) const;
};

/// Canonical form through the public interface. `broken` becomes empty, or names what contradicts
/// itself in the answers of the diagram: counts, flags, edges whose ends do not fit the vertices,
/// and so on.
Canonical canonicalForm(const Diagram& diagram, std::string& broken);

/// Canonical form from the oracle; for a dozen circles at most.
Canonical canonicalByOracle(const Circles& circles);

/// Describes the differences for a person; empty if there are none.
std::string difference(const Canonical& expected, const Canonical& got);

}  // namespace apollonius::test
