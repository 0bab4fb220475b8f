// Rings within rings: the smallest one around a point. Neither many rings nor long ones are asked
// one by one, where trees of boxes tell them apart.
//
// Rings are in a tree that parts them by place, or, where most lie over each other, by area: so
// islands side by side are left out by their boxes, and of rings around each other the first that
// are large enough are asked first.
//
// Pieces of a ring are in a tree in their order. Is a point on the left of an odd number of them?
// Of a row of pieces that each begin where the one before has ended, and with all of their boxes on
// the point's right, it is if the first one begins and the last one ends on different sides of its
// height. With all on its left, or above or below it, it never is.
#pragma once

#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// What a search asks of the rings.
class NestedRings {
 public:
  /// From one point to another, within the triangle with a third one.
  struct Piece {
    Point from, aside, to;
  };

  virtual ~NestedRings() = default;
  [[nodiscard]] virtual std::size_t pieceCount(std::uint32_t ring) const = 0;
  [[nodiscard]] virtual Piece piece(std::uint32_t ring, std::size_t k) const = 0;
  /// Does a ray to the right cross a piece, an odd number of times? Its start is in the piece's
  /// box, or on the box's border.
  virtual bool isCrossed(std::uint32_t ring, std::size_t k, Point from) = 0;
  /// Is the ring around what the search is for? Asked if the box is.
  virtual bool isAround(std::uint32_t ring) = 0;
};

class RingNesting {
 public:
  static constexpr std::uint32_t kNoRing = 0xFFFFFFFFu;

  /// REQUIRES: `rings` lives as long.
  explicit RingNesting(NestedRings& rings) : rings_(rings) {}

  void clear();
  /// A ring, numbered from 0 with gaps at will. REQUIRES: no search since clear().
  void add(std::uint32_t ring, double area, const Rectangle& box) {
    entries_.push_back({box, area, ring});
  }
  /// Of the rings that have more than an area, hold a point in their boxes, and are around what the
  /// search is for: the smallest, of those of one size the first; or kNoRing.
  [[nodiscard]] std::uint32_t find(Point p, double area);
  /// Is a point on the left of an odd number of a ring's pieces?
  [[nodiscard]] bool isInside(std::uint32_t ring, Point p);

  /// How many nodes, rings and pieces have been looked at.
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  struct Entry {
    Rectangle box;
    double area;
    std::uint32_t ring;
  };
  /// Of a tree whose nodes are in the order in which a walk enters them: the left child follows.
  struct Node {
    Rectangle box;
    double first, last;   // areas, the least and the most; or heights of a row's ends
    std::uint32_t right;  // child; of a ring: its entry
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
  FlatArray<Node> nodes_;            // of the rings, and of the pieces of those that were asked
  FlatArray<std::uint32_t> rootOf_;  // by ring, of its pieces; 0: not planted
  std::size_t looks_ = 0;
};

}  // namespace apollonius::internal
