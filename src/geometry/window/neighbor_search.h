// The neighbours of a cell that a segment can lead to. For a cell with many neighbours that is
// searched repeatedly, a tree finds them.
//
// Let c and r be the centre and the weight of the cell's own site. All of a segment is nearer to
// that than to a site with centre c' and weight r' if
//
//     (distance of c' from the segment) - r' > ρ - r,
//
// where ρ is the distance from c to the farther end of the segment: distances from a point are
// convex, so none on the segment is more than ρ.
//
// A node of the tree stands for neighbours that follow each other around the cell. Seen from c, a
// neighbour has a direction u, a distance R and a near side R - r'. With the same direction and the
// same near side, the circle grows with R, and each such circle contains the smaller ones. So all
// circles of a node are contained in circles with their centres on an arc about c: it spans their
// directions; its radius is the largest R; their weight is this radius less the least near side.
// The distance of these circles from the segment is that of the arc less the weight. For a point of
// the segment outside of the arc's sector, the nearest point of the arc is one of its ends. For a
// point x in the sector, the distance from the arc is at least the radius less |x - c|.
//
// Rounding. Let N be the sum of the sizes of all coordinates and weights that are involved. A
// neighbour is left out if on all of the segment it is farther by more than 2^-34 N. The walk would
// not go to it, as it only goes to a neighbour at one of these:
//   - A point of the bisector, up to the segment's end, where it meets the segment's line. Of the
//     terms of a bisector the root of p is the least precise: p has a relative error of 2^-40
//     (bisector.cpp), so the root has 2^-41, and a point within N has an error of 2^-41 N. All
//     other errors are about 2^-50 N; the roots of the quadratic equation, too, are those of an
//     equation whose terms differ by that. So at a point of the segment the two distances differ by
//     at most 2^-39 N.
//   - The current point of the walk, within 2^-46 N of the edge: it is on the segment, too.
//   - A point of the segment where the neighbour is nearer by isNearer(), which rounds by 2^-46 N.
// The error of the bounds above is about 2^-50 N.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "delaunay/delaunay_graph.h"
#include "number/fp.h"
#include "predicate/point.h"

namespace apollonius::internal {

/// Distances below this share of the numbers that they are computed from are rounding.
inline constexpr double kNegligible = powerOfTwo(-46);

inline double distanceOf(const Site& site, Point p) {
  return length(p - Point{site.x, site.y}) - site.r;
}

/// A point in the cell of a site, and how much farther the other sites are.
struct CellPlace {
  const Site& own;
  Point at;
  double distance, size;

  CellPlace(const Site& site, Point p)
      : own(site),
        at(p),
        distance(distanceOf(site, p)),
        size(absolute(p.x) + absolute(p.y) + absolute(distance)) {}

  [[nodiscard]] double roundingOf(const Site& other) const {
    return kNegligible * (size + absolute(own.x) + absolute(own.y) + absolute(own.r) +
                          absolute(other.x) + absolute(other.y) + absolute(other.r));
  }
  /// How much farther another site is, less what may be rounding.
  [[nodiscard]] double extraOf(const Site& other, double rounding) const {
    return distanceOf(other, at) - distance - rounding;
  }
};

class NeighborSearch {
 public:
  explicit NeighborSearch(const DelaunayGraph& delaunay) : delaunay_(delaunay) {}

  /// Lists half-edges of a cell, in the order of its star: all but those whose sites are certainly
  /// farther than the cell's own site from the rest of a segment, which begins at `place`. False if
  /// any may have been left out. Half-edges to infinity are not listed.
  bool list(VertexId cell, const CellPlace& place, Point from, Point to,
            FlatArray<HalfedgeId>& found);
  /// The least extraOf() of all neighbours. REQUIRES: list() has not listed all.
  double leastExtra(VertexId cell, const CellPlace& place);
  /// Has the cell a tree, and is a point in it by more than rounding? (If no neighbour is nearer
  /// than the cell's own site, no other site is.)
  bool surelyHolds(VertexId cell, Point p);

  /// Number of neighbours and nodes examined.
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  struct Node {
    Point first, last;  // directions of the arc's ends; 0: all directions, no arc
    double radius, near;
    double size;  // the largest size of a site's numbers
  };
  /// Level k has a node for every 4^k neighbours; level 1 comes first.
  struct Tree {
    std::size_t timesListed = 0;  // number of listings before the tree is built
    std::size_t firstNeighbor = 0, count = 0, firstNode = 0;
  };
  struct Levels;
  struct Way;

  [[nodiscard]] const Tree* treeOf(VertexId cell) const;

  static Node unite(std::span<const Node> parts);
  static Node nodeOf(const Site& own, const Site& other);
  double bound(const Node& node, const Way& way);
  void countListing(VertexId cell, const FlatArray<HalfedgeId>& all);
  void plant(Tree& tree, VertexId cell, const FlatArray<HalfedgeId>& all);
  void listNear(const Tree& tree, const Way& way, double most, FlatArray<HalfedgeId>& found);

  const DelaunayGraph& delaunay_;
  FlatArray<std::uint32_t> treeNumbers_;  // by graph vertex: index in trees_ plus 1, or 0
  FlatArray<Tree> trees_;
  FlatArray<HalfedgeId> neighbors_;  // those of all trees
  FlatArray<Node> nodes_;
  std::size_t asked_ = 0;
};

}  // namespace apollonius::internal
