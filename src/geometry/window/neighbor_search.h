// The neighbours of a cell that a segment can lead to. Of a cell with many neighbours that is asked
// again and again, a tree finds them.
//
// Let c and r be the centre and the weight of the cell's own site. All of a segment is nearer to
// that than to a site with centre c' and weight r' if
//
//     (distance of c' from the segment) - r' > ρ - r,
//
// where ρ is the distance from c to the end of the segment that is farther away: distances from a
// point are convex, so none on the segment is more than ρ.
//
// A node of the tree stands for neighbours that follow each other around the cell. Seen from c, a
// neighbour has a direction u, a distance R and a near side R - r'. With the same direction and the
// same near side, the circle becomes larger with R, and each of these holds the one before. So all
// circles of a node are held by circles with their centres on an arc about c: it spans their
// directions; its radius is the largest R; their weight is that, less the nearest near side. Such a
// circle is as far from the segment as the nearest point of the arc, less the weight. Outside of
// the sector of the arc, that point is an end of the arc. In the sector it is as far from a point x
// as the radius less |x - c|, at least.
//
// Rounding. Let N be the sum of the sizes of all coordinates and weights that are involved. A
// neighbour is left out if on all of the segment it is farther by more than 2^-34 N. The walk then
// finds no way to it, as it takes only these:
//   - A place of the bisector, up to the segment's end, where it meets the segment's line. Of the
//     terms of a bisector the root of p is the least precise: p has a relative error of 2^-40
//     (bisector.cpp), so the root has 2^-41, and a place within N is off by 2^-41 N. All else is
//     off by some 2^-50 N; the roots of the quadratic equation, too, are those of an equation whose
//     terms differ by that. So at a point of the segment the two distances differ by 2^-39 N at
//     most.
//   - A place where the walk is, within 2^-46 N of the edge: that is on the segment, too.
//   - A point of the segment where it is nearer by isNearer(), whose rounding is 2^-46 N.
// The bounds above are off by some 2^-50 N.
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

/// Distances below this share of the numbers that they come of are rounding.
inline constexpr double kNegligible = powerOfTwo(-46);

inline double distanceOf(const Site& site, Point p) {
  return length(p - Point{site.x, site.y}) - site.r;
}

/// A place in the cell of a site, and how much farther the other sites are.
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
  /// Less what may be rounding.
  [[nodiscard]] double extraOf(const Site& other, double rounding) const {
    return distanceOf(other, at) - distance - rounding;
  }
};

class NeighborSearch {
 public:
  explicit NeighborSearch(const DelaunayGraph& delaunay) : delaunay_(delaunay) {}

  /// Lists half-edges of a cell, in the order of its star: all but those whose sites are certainly
  /// farther than its own one from all of a segment's rest, which begins at a place. False if any
  /// may have been left out. Half-edges to infinity are not listed.
  bool list(VertexId cell, const CellPlace& place, Point from, Point to,
            FlatArray<HalfedgeId>& found);
  /// The least extraOf() of all neighbours. REQUIRES: list() has not listed all.
  double leastExtra(VertexId cell, const CellPlace& place);
  /// Is a point in a cell, of which there is a tree, and not just by rounding? (If no neighbour is
  /// nearer than the cell's own site, no other site is.)
  bool surelyHolds(VertexId cell, Point p);

  /// How many neighbours and nodes have been looked at.
  [[nodiscard]] std::size_t asked() const { return asked_; }

 private:
  struct Node {
    Point first, last;  // the ends of the arc, as directions; 0 if it is no arc: all directions
    double radius, near;
    double size;  // of the largest numbers of a site
  };
  /// Level k has a node for each 4^k neighbours, level 1 comes first.
  struct Tree {
    std::size_t timesListed = 0;  // without the tree, which then is made
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
  FlatArray<std::uint32_t> treeNumbers_;  // by graph vertex: 0, or one more than the index
  FlatArray<Tree> trees_;
  FlatArray<HalfedgeId> neighbors_;  // of all trees
  FlatArray<Node> nodes_;
  std::size_t asked_ = 0;
};

}  // namespace apollonius::internal
