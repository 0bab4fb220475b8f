// Valid arguments for the predicates: sites of which none covers another, faces and edges of exact
// diagrams of them.
#pragma once

#include <map>
#include <vector>

#include "predicate/predicates.h"
#include "support/oracle.h"

namespace apollonius::test {

using namespace internal;

inline Site toSite(const Circle& c) { return {c.x, c.y, c.r}; }

inline std::vector<Site> toSites(const Circles& circles) {
  std::vector<Site> sites;
  for (const Circle& c : circles) sites.push_back(toSite(c));
  return sites;
}

/// The circles without those that are covered by another one (of duplicates the first stays).
inline Circles visibleOnly(const Circles& circles) {
  Circles visible;
  for (std::size_t k = 0; k < circles.size(); ++k) {
    bool hidden = false;
    for (std::size_t other = 0; other < circles.size() && !hidden; ++other) {
      if (other == k || !oracleCovers(circles[other], circles[k])) continue;
      hidden = other < k || !oracleCovers(circles[k], circles[other]);
    }
    if (!hidden) visible.push_back(circles[k]);
  }
  return visible;
}

/// A corner of the predicates from an index of the oracle.
inline Corner corner(const std::vector<Site>& sites, int index) {
  return index == kInfinity ? nullptr : &sites[index];
}

/// For each directed edge (a, b) the third corners of the faces on its left.
inline std::map<std::pair<int, int>, std::vector<int>> facesByEdge(const OracleDiagram& diagram) {
  std::map<std::pair<int, int>, std::vector<int>> faces;
  for (const Triple& t : diagram.triples) {
    for (int side = 0; side < 3; ++side)
      faces[{t[side], t[(side + 1) % 3]}].push_back(t[(side + 2) % 3]);
  }
  return faces;
}

}  // namespace apollonius::test
