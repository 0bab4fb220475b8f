// The border of a domain as a tree of pieces: a ring, its two halves, and so on down to single
// curves and parts of these. A piece and its chord are within a known height of each other. So a
// search far from the border looks at few chords.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "geometry/curve/conic.h"

namespace apollonius::internal {

struct BorderChord {
  Point a, b;

  /// The nearest point of the segment.
  [[nodiscard]] Point nearestTo(Point p) const {
    const Point way = b - a;
    const double along = dot(p - a, way), square = dot(way, way);
    return along >= square ? b : along > 0 ? a + (along / square) * way : a;
  }
  /// Keeps the part that is in a box about the origin; false if nothing of it is.
  [[nodiscard]] bool clip(Point half);
};

class BorderTree {
 public:
  /// Removes all rings. Curves within `finest` of their chords will not be halved.
  void clear(double finest) {
    finest_ = finest;
    curves_ = 0;
    pieces_.clear();
    rings_.clear();
  }
  /// Adds a closed ring. Throws std::bad_alloc. Cost: O(n log n).
  void addRing(std::span<const Conic> ring);

  /// Number of curves in all rings.
  [[nodiscard]] std::size_t curveCount() const { return curves_; }
  /// The pieces that are rings.
  [[nodiscard]] std::span<const std::uint32_t> rings() const { return rings_; }
  [[nodiscard]] BorderChord chord(std::uint32_t piece) const {
    return {pieces_[piece].curve.p0, pieces_[piece].curve.p2};
  }
  /// The largest distance of piece and chord from each other, at most.
  [[nodiscard]] double height(std::uint32_t piece) const { return pieces_[piece].height; }
  /// The first half of a piece, which the second one follows; kWhole if the piece cannot be halved.
  /// The first call halves the curve. Throws std::bad_alloc.
  [[nodiscard]] std::uint32_t firstHalf(std::uint32_t piece);
  static constexpr std::uint32_t kWhole = 0;

  // The functions below halve pieces as far as they need, and throw std::bad_alloc. Costs hold for
  // a border that has few pieces at about the same distance from a point.

  /// A lower bound of the distance from a point to the border, within this share of it; or any
  /// value that is at most `enough`, if the distance is. Cost: O(log n).
  [[nodiscard]] double distance(Point p, double share, double enough);
  /// Does the border meet a box? Then `place` becomes a point of the border there. Cost: O(log n).
  [[nodiscard]] bool meets(Point center, Point half, Point& place);
  /// Replaces `pieces` by those that meet a box, with heights of at most `fine` where possible.
  void listMeeting(Point center, Point half, double fine, FlatArray<std::uint32_t>& pieces);
  /// Is a point inside the rings, by the even-odd rule? Cost: O(log n).
  [[nodiscard]] bool surrounds(Point p);
  /// An upper bound of how far the border, and so the domain, extends beyond the line of a piece's
  /// chord, to the right of it; infinity if that is more than `most`. Cost: O(log n).
  [[nodiscard]] double overhang(std::uint32_t piece, double most);

 private:
  static constexpr double kUnknown = -1;

  struct Piece {
    Conic curve;  ///< or the chord of several
    double height = 0;
    double overhang = kUnknown;
    /// The first half, if there is one. While a ring is added: the first of its curves.
    std::uint32_t half = kWhole;
    std::uint32_t curves = 1;  ///< number of its curves; 0: a part of one
  };

  struct Seen {
    std::uint32_t piece;
    double distance;  ///< from the chord to a point, for searches by distance
  };

  void push(const Conic& curve, std::uint32_t curves);
  double overhangOf(const BorderChord& line, double fine, double most);

  double finest_ = 0;
  std::size_t curves_ = 0;
  FlatArray<Piece> pieces_;
  FlatArray<std::uint32_t> rings_;
  FlatArray<Seen> todo_;  // scratch
};

}  // namespace apollonius::internal
