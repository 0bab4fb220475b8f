// Mends rings that rounding has put out of order: a point that is off by its last place can lie
// beyond a segment that it should be next to. All points get numbers, shared by the rings. Exact
// signs tell which segments meet, of all pairs that may (segment_pairs.h). Where two meet, ends as
// close as rounding become one point, in all cells; or the segment that passes a point is led
// through it. This is repeated until no segments meet. If it takes more than a few rounds, points
// farther apart are united in each further round, in the end any ends of segments that meet. The
// number of rounds is limited.
#pragma once

#include <cstdint>
#include <span>

#include "base/radix_sort.h"
#include "geometry/polygons/cell_list.h"
#include "geometry/polygons/point_numbers.h"
#include "geometry/window/rectangle.h"
#include "geometry/window/segment_grid.h"
#include "number/fp.h"

namespace apollonius::internal {

/// How far rounding can move points of edges in a window within this box. Depends on the distance
/// of a point from the farthest of the sites whose cells meet there (docs/PROOFS.md, "Polygons").
class PointRounding {
 public:
  explicit PointRounding(const Rectangle& box);
  [[nodiscard]] double at(double fromSite) const { return powerOfTwo(-38) * (size_ + fromSite); }

 private:
  double size_;  // the size of the window's coordinates
};

class Mesh {
 public:
  /// REQUIRES: `box` holds the window. All live as long.
  Mesh(const DiagramCore& core, const Rectangle& box, CellList& raw);

  /// Mends the rings until no two segments meet; if that is not reached, returns false and leaves
  /// the rings unchanged. Cost per round: O(n log n) for n segments, or the number of pairs near
  /// each other if there are fewer; rounds go on while rounding has to be undone.
  [[nodiscard]] bool mend();
  /// Limit of the distance of points that became one, in units of what rounding explains.
  [[nodiscard]] double closeness() const { return closeness_; }
  /// Number of segments and pairs examined, in all rounds.
  [[nodiscard]] std::size_t work() const { return work_; }

 private:
  struct Ring {
    std::uint32_t first, count;  // range in corners_
  };
  /// A segment that is to be led through a point.
  struct Detour {
    std::uint32_t from, to, through;
  };

  [[nodiscard]] Point at(std::uint32_t number) const { return numbers_.points()[number]; }
  [[nodiscard]] bool isOnBorder(std::uint32_t point) const { return isOnBorder_[point] != 0; }
  [[nodiscard]] double roundingOf(std::uint32_t point) const {
    return rounding_.at(fromSites_[point]);
  }
  [[nodiscard]] std::span<Ring> ringsOf(const CellList::Cell& cell) {
    return std::span(rings_).subspan(raw_.firstRing(cell),
                                     raw_.endRing(cell) - raw_.firstRing(cell));
  }
  void listSegments();
  void mendMeetings();
  void uniteTurned();
  void mend(const Segment& s, const Segment& t);
  bool uniteClose(std::span<const std::uint32_t> points);
  [[nodiscard]] std::uint32_t representative(std::uint32_t point);
  void unite(std::uint32_t a, std::uint32_t b);
  [[nodiscard]] const Detour* detourOf(std::uint32_t a, std::uint32_t b,
                                       std::span<const Keyed> byEnd) const;
  void replacePoints();
  void write();

  Rectangle box_;
  PointRounding rounding_;
  CellList& raw_;
  PointNumbers numbers_;
  FlatArray<double> fromSites_;       // by point: the largest distance from a site of its cells
  FlatArray<char> isOnBorder_;        // by point
  FlatArray<std::uint32_t> corners_;  // points of the rings, not repeated at their ends
  FlatArray<Ring> rings_;             // in the order of raw_
  FlatArray<Segment> segments_;       // each once
  FlatArray<std::uint32_t> united_;   // by point: itself, or one that it became in this round
  double closeness_ = 1;
  bool isUnited_ = false;  // have any points become one in this round?
  FlatArray<Detour> detours_;
  std::size_t work_ = 0;
};

}  // namespace apollonius::internal
