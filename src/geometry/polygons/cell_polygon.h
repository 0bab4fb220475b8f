// The polygons of a cell: the points of its edges (chords.h), and those of the border between them.
#pragma once

#include "diagram/diagram_core.h"
#include "geometry/cell/cell_clipper.h"
#include "geometry/polygons/chords.h"
#include "geometry/polygons/ring_tracer.h"
#include "geometry/polygons/rings.h"
#include "geometry/window/border.h"

namespace apollonius::internal {

/// Finds the polygons of cells. Keeps its scratch memory from one cell to the next.
class PolygonFinder {
 public:
  /// `cells` clips the cells at this border. REQUIRES: both live as long.
  PolygonFinder(const DiagramCore& core, CellClipper& cells, const Border& border,
                Tolerance tolerance);

  /// CellClipper::expectAll.
  void expectAll() { cells_.expectAll(); }

  /// Finds the polygons of a site's cell; none if the cell is as small as the distance of doubles.
  void find(Slot site, Rings& rings);

  /// How well rings are known before they are traced.
  enum class Soundness : unsigned char {
    kSure,     ///< polygons: no two segments meet, except where one follows the other
    kTouches,  ///< the rings do not cross, but may touch
    kUnsure,   ///< the rings may cross, where rounding has swapped points
  };
  /// Finds the rings as edges and border give them: neighbours have the same points. `isBorder`
  /// gets for each point whether a segment of the border starts there.
  Soundness findRaw(Slot site, Rings& rings, FlatArray<char>* isBorder = nullptr);

 private:
  bool appendRing(std::span<const BoundaryPiece> boundary, bool isHole, Rings& rings,
                  FlatArray<char>* isBorder);
  [[nodiscard]] EdgePiece atReach(const BoundaryPiece& piece, Point center) const;
  static void append(Point p, Rings& rings, FlatArray<char>* isBorder);

  const DiagramCore& core_;
  CellClipper& cells_;
  const Border& border_;
  ChordFinder chords_;
  Tracer tracer_;
  Site site_{};
  Soundness soundness_ = Soundness::kSure;
};

}  // namespace apollonius::internal
