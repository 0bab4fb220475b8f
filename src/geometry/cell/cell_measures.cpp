#include "geometry/cell/cell_measures.h"

#include "base/flat_array.h"
#include "base/radix_sort.h"
#include "geometry/cell/cell_sums.h"
#include "geometry/cell/polygon_cell.h"
#include "geometry/cell/rectangle_cell.h"
#include "geometry/window/rectangle_border.h"
#include "geometry/window/rectangle_clip.h"

namespace apollonius::internal {

namespace {

/// A border contact and its cell, to be sorted by cell.
struct SiteContact {
  Slot site;
  BorderContact contact;
};

/// Perimeters of cells at the border, of their parts with area only. Where the border runs along an
/// edge, or nearly along itself, rounding can leave slivers, which have length but no area.
class PartLengths {
 public:
  PartLengths(const DiagramCore& core, CellClipper& cells)
      : core_(core), cells_(cells), isDone_(core.ids().slots(), 0) {}

  /// Measures a cell and returns the length of its pieces on the border; 0 if the cell has been
  /// measured before.
  double measure(Slot slot) {
    if (isDone_[slot] != 0) return 0;
    isDone_[slot] = 1;
    double sum = 0, onBorder = 0;
    for (const BoundaryPiece& piece : cells_.find(slot).pieces) {
      const double length = lengthOf(piece.curve);
      sum += length;
      if (piece.neighbor == kNoSite) onBorder += length;
    }
    found_.push_back({slot, sum});
    return onBorder;
  }

  /// Replaces the lengths of the cells that have been measured.
  void list(std::vector<double>& lengths) const {
    for (const auto& [slot, length] : found_) lengths[core_.ids().idOf(slot)] = length;
  }

 private:
  struct Found {
    Slot slot;
    double length;
  };
  const DiagramCore& core_;
  CellClipper& cells_;
  FlatArray<char> isDone_;  // by slot
  FlatArray<Found> found_;
};

class RectangleSum {
 public:
  RectangleSum(const DiagramCore& core, const Rectangle& window, Measure what)
      : core_(core),
        window_(window),
        sums_(core, window, what),
        hasLengths_(what == Measure::kPerimeters),
        cells_(core, window, Parts::kWithArea),
        lengths_(core, cells_) {}

  void run(std::vector<double>& measures) {
    const Graph& graph = core_.delaunay().graph();
    forEachClippedPiece(core_.delaunay(), window_, VertexPrecision::kFast,
                        [&](HalfedgeId h, const ClippedPiece& piece) {
                          addPiece(piece, slotOf(graph.origin(h)), slotOf(graph.target(h)));
                        });
    addBorders();
    sums_.list(measures);
    if (hasLengths_) lengths_.list(measures);
  }

  /// Does no cell have a piece of the border? Then one cell has the whole window. (Edges can touch
  /// the border, so contacts prove nothing; the cells together have all of the border, or none.)
  [[nodiscard]] bool isUntouched() const { return onBorder_ < window_.width() + window_.height(); }

 private:
  void addPiece(const ClippedPiece& piece, Slot left, Slot right) {
    const Conic& curve = piece.curve;
    sums_.addEdge(left, right, curve);
    if (piece.fromSide != kNoSide) addContact(left, right, piece.fromSide, curve.p0, false);
    if (piece.toSide != kNoSide) addContact(left, right, piece.toSide, curve.p2, true);
  }

  void addContact(Slot left, Slot right, int side, Point point, bool leaves) {
    const double position = window_.positionOf(side, point);
    contacts_.push_back({left, {side, position, point, 0, leaves}});
    contacts_.push_back({right, {side, position, point, 0, !leaves}});
  }

  void addBorders() {
    FlatArray<Keyed> bySite(contacts_.size());
    for (std::uint32_t k = 0; k < bySite.size(); ++k) bySite[k] = {contacts_[k].site, k};
    sortByKey(bySite);
    FlatArray<BorderContact> own;
    FlatArray<BorderArc> arcs;
    for (std::size_t begin = 0; begin < bySite.size();) {
      const Slot slot = bySite[begin].key;
      own.clear();
      for (; begin < bySite.size() && bySite[begin].key == slot; ++begin)
        own.push_back(contacts_[bySite[begin].value].contact);
      if (hasLengths_) {
        onBorder_ += lengths_.measure(slot);
        continue;
      }
      linkBorderArcs(core_, slot, window_, own, arcs);
      for (const BorderArc& arc : arcs) {
        Point at = own[arc.from].point;
        for (int k = 0; k < arc.cornerCount; ++k) {
          const Point corner = window_.corner((arc.firstCorner + k) % 4);
          addBorder(slot, at, corner);
          at = corner;
        }
        addBorder(slot, at, own[arc.to].point);
      }
    }
  }

  void addBorder(Slot slot, Point from, Point to) {
    sums_.addBorder(slot, Conic::segment(from, to));
    onBorder_ += length(to - from);
  }

  const DiagramCore& core_;
  Rectangle window_;
  CellSums sums_;
  bool hasLengths_;
  RectangleCellClipper cells_;
  PartLengths lengths_;
  FlatArray<SiteContact> contacts_;
  double onBorder_ = 0;  // length of the border that cells have
};

}  // namespace

void measureCells(const DiagramCore& core, const Rectangle& window, Measure what,
                  std::vector<double>& measures) {
  RectangleSum sum(core, window, what);
  sum.run(measures);
  if (core.visibleCount() == 0 || !sum.isUntouched()) return;
  const Slot owner = ownerOfWindow(core, window);
  if (owner == kNoSlot) return;
  const std::size_t id = core.ids().idOf(owner);
  if (what == Measure::kCentroids) {
    measures[2 * id] = window.center().x;
    measures[2 * id + 1] = window.center().y;
  } else {
    measures[id] = what == Measure::kAreas ? window.width() * window.height()
                                           : 2 * (window.width() + window.height());
  }
}

void addBorders(const ClippedDiagram& clippedDiagram, CellSums& sums) {
  for (std::uint32_t k = 0; k < clippedDiagram.crossingCount(); ++k) {
    const Crossing& crossing = clippedDiagram.crossing(k);
    clippedDiagram.visitBoundaryChain(crossing, [&](Point from, Point to, std::uint32_t) {
      sums.addBorder(crossing.to, Conic::segment(from, to));
    });
  }
  for (const Keyed& interiorRing : clippedDiagram.interiorRings()) {
    const std::span<const Point> ring = clippedDiagram.polygon().ring(interiorRing.value);
    Point at = ring.back();
    for (const Point p : ring) {
      sums.addBorder(interiorRing.key, Conic::segment(at, p));
      at = p;
    }
  }
}

void measureCells(const ClippedDiagram& clippedDiagram, Measure what,
                  std::vector<double>& measures) {
  const DiagramCore& core = clippedDiagram.core();
  const NormalizedPolygon& polygon = clippedDiagram.polygon();
  const Graph& graph = core.delaunay().graph();
  CellSums sums(core, polygon.box, what);
  clippedDiagram.visitEdges(VertexPrecision::kFast, [&](HalfedgeId h, const Edge&,
                                                        const InsideInterval& piece) {
    sums.addEdge(slotOf(graph.origin(h)), slotOf(graph.target(h)), piece.curve, piece.multiplicity);
  });
  addBorders(clippedDiagram, sums);
  sums.list(measures);
  if (what != Measure::kPerimeters) return;
  PolygonCellClipper cells(clippedDiagram, Parts::kWithArea);
  PartLengths lengths(core, cells);
  for (std::uint32_t k = 0; k < clippedDiagram.crossingCount(); ++k)
    (void)lengths.measure(clippedDiagram.crossing(k).to);
  for (const Keyed& interiorRing : clippedDiagram.interiorRings())
    (void)lengths.measure(interiorRing.key);
  lengths.list(measures);
}

}  // namespace apollonius::internal
