// A cell as polygons: the points of its edges (chords.h), and those of the border between them.
#pragma once

#include <optional>

#include "geometry/cell/polygon_cell.h"
#include "geometry/cell/rectangle_cell.h"
#include "geometry/polygons/chords.h"
#include "geometry/polygons/ring_tracer.h"
#include "geometry/polygons/rings.h"

namespace apollonius::internal {

/// What polygons end at: a rectangle, or a region, laid over the diagram.
struct PolygonWindow {
  Rectangle box;
  const ClippedDiagram* clippedDiagram = nullptr;
  const PolygonGrid* grid = nullptr;
};

/// Finds polygons of cells; keeps its scratch memory from one to the next.
class PolygonFinder {
 public:
  /// `keepsThin`: rings without area, too, so that each segment is there twice.
  PolygonFinder(const DiagramCore& core, const PolygonWindow& window, double tolerance,
                bool keepsThin = false);

  /// The polygons of a site's cell; none if what it bounds is as small as the distance of doubles.
  void find(Slot site, Rings& rings);

  /// What can be said of rings before they are traced.
  enum class Soundness : unsigned char {
    kSure,     ///< polygons: no two segments meet but where one follows the other
    kTouches,  ///< rings that do not cross, but may touch
    kUnsure,   ///< they may cross, where rounding has exchanged points
  };
  /// The rings as edges and border give them: neighbours have the same points. `isBorder` gets for
  /// each point whether a segment of the border starts there.
  Soundness findRaw(Slot site, Rings& rings, FlatArray<char>* isBorder = nullptr);

 private:
  bool appendRing(std::span<const BoundaryPiece> boundary, bool isHole, Rings& rings,
                  FlatArray<char>* isBorder);
  static void append(Point p, Rings& rings, FlatArray<char>* isBorder);

  const DiagramCore& core_;
  const Rectangle box_;
  const bool keepsThin_;
  std::optional<RectangleCellClipper> cells_;  // in a rectangle
  std::optional<PolygonCellClipper> parts_;    // in a region
  ChordFinder chords_;
  Tracer tracer_;
  Site site_{};
  Soundness soundness_ = Soundness::kSure;
};

}  // namespace apollonius::internal
