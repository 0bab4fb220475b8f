// Rings within rings: finds the smallest ring around a point. Trees of boxes avoid testing all
// rings, or all pieces of a ring, one by one.
//
// Rings are in a tree that divides them by position, or, where most overlap, by area: so islands
// side by side are ruled out by their boxes, and of rings around each other the smallest that are
// large enough are tested first.
//
// Pieces of a ring are in a tree in their order. Is a point on the left of an odd number of them?
// Take a row of pieces, each of which begins where the one before ends. If all of their boxes are
// on the point's right, the answer is yes if the row begins and ends on different sides of the
// point's height. If all are on its left, or above or below it, the answer is no.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// The rings, as a search needs them.
class NestedRings {
 public:
  /// A piece from one point to another, within the triangle with a third one.
  struct Piece {
    Point from, aside, to;
  };

  virtual ~NestedRings() = default;
  [[nodiscard]] virtual std::size_t pieceCount(std::uint32_t ring) const = 0;
  [[nodiscard]] virtual Piece piece(std::uint32_t ring, std::size_t k) const = 0;
  /// Does a ray to the right cross a piece an odd number of times? Its start is in the piece's box,
  /// or on the box's border.
  virtual bool isCrossed(std::uint32_t ring, std::size_t k, Point from) = 0;
  /// Is the ring around the object of the search? Called if its box holds the search's point.
  virtual bool isAround(std::uint32_t ring) = 0;
};

class RingNesting {
 public:
  static constexpr std::uint32_t kNoRing = 0xFFFFFFFFu;

  /// REQUIRES: `rings` lives as long.
  explicit RingNesting(NestedRings& rings) : rings_(rings) {}

  void clear();
  /// Adds a ring. Numbers begin with 0 and may have gaps. REQUIRES: no search since clear().
  void add(std::uint32_t ring, double area, const Rectangle& box) {
    entries_.push_back({box, area, ring});
  }
  /// Finds the smallest ring with an area larger than `area` whose box holds p and that is around
  /// the object of the search; among equal areas, the first. kNoRing if there is none.
  [[nodiscard]] std::uint32_t find(Point p, double area);
  /// Is a point on the left of an odd number of a ring's pieces?
  [[nodiscard]] bool isInside(std::uint32_t ring, Point p);

  /// Number of nodes, rings and pieces examined.
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  struct Entry {
    Rectangle box;
    double area;
    std::uint32_t ring;
  };
  /// A node of a tree. Nodes are in preorder: the left child follows its parent.
  struct Node {
    Rectangle box;
    double first, last;   // least and largest area; or heights of a row's ends
    std::uint32_t right;  // the right child; in a leaf of rings: the ring's entry
  };
  struct Search;

  static std::uint32_t keyOf(double x);
  std::uint32_t plant(std::span<Keyed> rings);
  void search(std::uint32_t number, std::size_t count, Search& search);
  std::uint32_t plantRow(std::uint32_t ring, std::size_t begin, std::size_t count);
  bool isOdd(std::uint32_t number, std::uint32_t ring, std::size_t begin, std::size_t count,
             Point p);

  NestedRings& rings_;
  FlatArray<Entry> entries_;
  FlatArray<Node> nodes_;  // trees of the rings, and of the pieces of rings that were tested
  FlatArray<std::uint32_t> rootOf_;  // by ring: root of the tree of its pieces; 0: not built
  std::size_t looks_ = 0;
};

}  // namespace apollonius::internal
