// The border of a domain as a tree of pieces: a ring, its two halves, and so on down to single
// curves and parts of these. A piece is within a known height of its chord, and its chord within
// the height of it. So whoever looks at the border from afar looks at few chords.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/flat_array.h"
#include "geometry/curve/conic.h"

namespace apollonius::internal {

struct BorderChord {
  Point a, b;

  /// The nearest place of the segment.
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
  /// Takes all rings out. Curves will not be halved that are within `finest` of their chords.
  void clear(double finest) {
    finest_ = finest;
    curves_ = 0;
    pieces_.clear();
    rings_.clear();
  }
  /// Adds a closed ring. Throws std::bad_alloc. Cost: O(n log n).
  void addRing(std::span<const Conic> ring);

  /// How many curves all rings have.
  [[nodiscard]] std::size_t curveCount() const { return curves_; }
  /// The pieces that are rings.
  [[nodiscard]] std::span<const std::uint32_t> rings() const { return rings_; }
  [[nodiscard]] BorderChord chord(std::uint32_t piece) const {
    return {pieces_[piece].curve.p0, pieces_[piece].curve.p2};
  }
  /// How far piece and chord are from each other, at most.
  [[nodiscard]] double height(std::uint32_t piece) const { return pieces_[piece].height; }
  /// The first half of a piece, which the second one follows; kWhole if it is not to be halved. A
  /// curve is halved when this is asked first. Throws std::bad_alloc.
  [[nodiscard]] std::uint32_t firstHalf(std::uint32_t piece);
  static constexpr std::uint32_t kWhole = 0;

  // All below halve pieces as far as they need, and throw std::bad_alloc. Costs are those of a
  // border of which a place sees few pieces at about the same distance.

  /// No more than the distance from a place to the border, and within the share of it; or any value
  /// that is at most `enough`, if the distance is. Cost: O(log n).
  [[nodiscard]] double distance(Point p, double share, double enough);
  /// Does the border meet a box? Then `place` becomes a place of it there. Cost: O(log n).
  [[nodiscard]] bool meets(Point center, Point half, Point& place);
  /// Replaces `pieces` by those that meet a box, of heights of at most `fine` where possible.
  void listMeeting(Point center, Point half, double fine, FlatArray<std::uint32_t>& pieces);
  /// Is a place inside the rings? By the even-odd rule. Cost: O(log n).
  [[nodiscard]] bool surrounds(Point p);
  /// How far the border, and so the domain, goes beyond the line of a piece's chord to the right of
  /// it, at most; infinity if that is more than `most`. Cost: O(log n).
  [[nodiscard]] double overhang(std::uint32_t piece, double most);

 private:
  static constexpr double kUnknown = -1;

  struct Piece {
    Conic curve;  ///< or the chord of several
    double height = 0;
    double overhang = kUnknown;
    /// The first half, if there is one. While a ring is added: the first of its curves.
    std::uint32_t half = kWhole;
    std::uint32_t curves = 1;  ///< how many curves it has; 0: a part of one
  };

  struct Seen {
    std::uint32_t piece;
    double distance;  ///< of the chord from a place, where that is asked for
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
