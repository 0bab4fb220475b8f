// The point inside a border that is farthest from it, and from circles: branch and bound over
// boxes, the most promising one first (docs/PROOFS.md, "Circles inside").
//
// A point of the domain is no farther from the border than from a piece of it. So each piece near a
// box gives a linear function that is an upper bound of the distance in the box. Any weighted mean
// of such functions is an upper bound, too; the weights for which its largest value is least solve
// a linear program of three unknowns. The program's point is the next candidate.
//
// Three functions are enough for any optimum. So if the whole domain is on one side of the lines of
// three sides, as in a convex polygon, however thin, the first box is the last one.
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "geometry/inscribed/border_tree.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// A circle inside: its centre, and a lower bound of the centre's distance from all obstacles.
struct Place {
  Point at;
  double r = 0;
};

/// A circle from which the centre is to be far.
struct Obstacle {
  Point center;
  double r;
};

/// The cell of a circle, if the centre is to be in it: no other circle is nearer there.
struct CellOfObstacle {
  Obstacle own;
  BorderTree& outline;
};

class WidestPlace {
 public:
  /// REQUIRES: `border` lives as long.
  explicit WidestPlace(BorderTree& border) : border_(border) {}

  /// Searches a box for a place inside the border, and in the cell if one is given, with a larger r
  /// than `best`, and replaces `best`. The r of any other place in the box is larger by at most the
  /// share 2^-11 and the grain, below which doubles tell no difference. False if the search does
  /// not end, as where the border returns to itself up to rounding. Throws std::bad_alloc. Cost: in
  /// polygons and cells some ten to a hundred steps of O(log n).
  [[nodiscard]] bool find(const Rectangle& box, double grain, Place& best,
                          const CellOfObstacle* cell = nullptr);

 private:
  struct Box {
    Point center, half;       // centre, and half of width and height
    double reach;             // from the centre to a corner
    double most;              // upper bound of r in it
    double above;             // upper bound of its centre's distance from the obstacles
    std::uint32_t near, end;  // range in near_: what may be the nearest obstacle in it
    bool isWide;              // is it to be divided across its width?
    bool isFree;              // inside, without a piece of the border or of the cell's outline

    friend bool operator<(const Box& a, const Box& b) { return a.most < b.most; }
  };
  /// A piece of the border near the current box, or the cell's circle.
  struct Near {
    std::uint32_t number;  // a piece, or kCircle
    double distance;       // from the box's centre to the chord or the circle
    double height;         // the piece's
  };
  /// A piece that meets the box, and the part of its chord that does.
  struct Meeting {
    std::uint32_t piece;
    double height;
    BorderChord part;  // relative to the centre
    Point normal;      // to the left of the chord
    bool isThrough;    // does it run through the whole box?
    double position;
  };
  /// An upper bound of the distance in the box: value + slope (p - centre). For a wall, a function
  /// that is not below 0 in the cell.
  struct Bound {
    enum class By : std::uint8_t { kDistance, kSide, kLine, kWall } by;
    std::uint32_t number;  // as in Near; for a wall, of a piece of the cell's outline
    double value;          // includes the excess of a convex function over a linear one
    double excess;
    Point slope;
  };
  /// A combination of bounds. The weights of bounds of the distance add up to 1.
  struct Mean {
    std::uint32_t bounds[3];
    double weights[3];
    double most;  // its largest value in the box
    Point at;     // relative to the centre: where the least of the bounds is about largest
  };
  static constexpr std::uint32_t kCircle = 0xFFFFFFFFu;  // the cell's own

  void look(Box box, std::uint32_t near, std::uint32_t end);
  [[nodiscard]] bool isInside(Box& box);
  void gather(Box& box, std::uint32_t near, std::uint32_t end);
  void halve(Box& box, double height);
  void split(Box& box, std::size_t k);
  void see(Box& box, std::uint32_t number);
  [[nodiscard]] bool refine(Box& box, const Mean& mean);
  [[nodiscard]] bool refineStrips(Box& box);
  void listMeeting(const Box& box);
  void listBounds(const Box& box);
  void listWalls(const Box& box);
  void boundByStrips(const Box& box, Mean& mean);
  [[nodiscard]] double excess(Bound::By by, std::uint32_t number, Point center, Point half,
                              Point slope) const;
  [[nodiscard]] double distanceOf(std::uint32_t number, Point p) const;
  [[nodiscard]] Mean leastMean(Point half) const;
  [[nodiscard]] double boundAround(const Box& box, const Mean& mean);
  [[nodiscard]] double lossOf(const Mean& mean, const Box& box, Point half) const;
  void consider(Point p, bool isInside = false);
  [[nodiscard]] bool isEnough(double most) const;

  BorderTree& border_;
  double grain_ = 0;
  const CellOfObstacle* cell_ = nullptr;
  Place best_;

  FlatArray<Box> boxes_;  // a heap
  FlatArray<std::uint32_t> near_;
  // All below belong to the current box.
  FlatArray<Near> seen_;
  FlatArray<Meeting> meeting_;
  bool isSideBySide_ = false;
  FlatArray<Bound> bounds_;
  FlatArray<std::uint32_t> outline_;  // pieces of the cell's outline that meet the box
};

}  // namespace apollonius::internal
