// The place inside a border that is farthest from it, and from circles: branch and bound over
// boxes, the most promising one first (docs/PROOFS.md, "Circles inside").
//
// A place of the domain is no farther from the border than from a piece of it. So each piece that
// is near a box gives a linear function that is nowhere in the box below the distance. No place
// there is better than any weighted mean of such functions allows; the weights with the least
// largest value are those of a linear program of three unknowns. Its place is the next candidate.
//
// Three functions are enough for any optimum, so where all of the domain is on one side of the
// lines of three sides, the first box is the last one: in a polygon that is convex, however thin.
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "geometry/inscribed/border_tree.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// A circle inside: its centre, and how far that is from all obstacles at least.
struct Place {
  Point at;
  double r = 0;
};

/// A circle that places shall be far from.
struct Obstacle {
  Point center;
  double r;
};

/// Places are wanted in the cell of a circle: no other one is nearer there.
struct CellOfObstacle {
  Obstacle own;
  BorderTree& outline;
};

class WidestPlace {
 public:
  /// REQUIRES: `border` lives as long.
  explicit WidestPlace(BorderTree& border) : border_(border) {}

  /// Looks in a box for a place inside the border, and in a cell if there is one, that has a larger
  /// r than `best`, which it replaces. The r of any other place in the box is larger by at most the
  /// share 2^-11 and the grain, below which doubles tell no difference. False if the search does
  /// not end, as where the border comes back to itself but for rounding. Throws std::bad_alloc.
  /// Cost: in polygons and cells some ten to a hundred looks of O(log n).
  [[nodiscard]] bool find(const Rectangle& box, double grain, Place& best,
                          const CellOfObstacle* cell = nullptr);

 private:
  struct Box {
    Point center, half;       // of its extents
    double reach;             // from the centre to a corner
    double most;              // no place in it has a larger r
    double above;             // its centre is no farther from the obstacles
    std::uint32_t near, end;  // in near_, what may be the nearest obstacle in it
    bool isWide;              // is it to be divided across its width?
    bool isFree;              // inside, without a piece of the border or of the cell's outline

    friend bool operator<(const Box& a, const Box& b) { return a.most < b.most; }
  };
  /// A piece of the border near the box that is looked at, or the cell's circle.
  struct Near {
    std::uint32_t number;  // of a piece, or kCircle
    double distance;       // of the box's centre from the chord or the circle
    double height;         // of the piece
  };
  /// A piece that meets the box, and the part of its chord that does.
  struct Meeting {
    std::uint32_t piece;
    double height;
    BorderChord part;  // as seen from the centre
    Point normal;      // to the left of the chord
    bool isThrough;    // does it lead through the box?
    double position;
  };
  /// A function of p that is not below the distance in the box: value + slope (p - centre). For a
  /// wall, one that is not below 0 in the cell.
  struct Bound {
    enum class By : std::uint8_t { kDistance, kSide, kLine, kWall } by;
    std::uint32_t number;  // as in Near; for a wall, of a piece of the cell's outline
    double value;          // with the excess of a convex function over a linear one
    double excess;
    Point slope;
  };
  /// A combination of bounds, with weights of which those of distances add up to 1.
  struct Mean {
    std::uint32_t bounds[3];
    double weights[3];
    double most;  // its largest value in the box
    Point at;     // relative to the centre: where no bound is below the least one much
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
  FlatArray<Near> seen_;  // of the box that is looked at, as are all below
  FlatArray<Meeting> meeting_;
  bool isSideBySide_ = false;
  FlatArray<Bound> bounds_;
  FlatArray<std::uint32_t> outline_;  // pieces of the cell's outline that meet the box
};

}  // namespace apollonius::internal
