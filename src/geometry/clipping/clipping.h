// Clips to a window: edges, cells, and sums over all cells. Each kind of window implements this
// interface: RectangleClipping, PolygonClipping. The code that works on a window (src/api) knows
// only the interface.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "apollonius/path.h"
#include "base/function_ref.h"
#include "diagram/diagram_core.h"
#include "geometry/cell/cell_clipper.h"
#include "geometry/cell/cell_measures.h"
#include "geometry/cell/natural_neighbors.h"
#include "geometry/curve/tolerance.h"
#include "geometry/window/border.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// A piece of an edge, counter-clockwise about its reference site. Each of its ends is a Voronoi
/// vertex, or a point where the edge is cut.
struct EdgePart {
  Conic curve;
  bool startsAtVertex, endsAtVertex;
};

/// Takes the pieces of edges, one by one.
class EdgeVisitor {
 public:
  /// The piece is of the edge of h, which starts at its reference site.
  virtual void visit(HalfedgeId h, const EdgePart& piece) = 0;

 protected:
  ~EdgeVisitor() = default;
};

/// All functions throw std::bad_alloc.
class Clipping {
 public:
  Clipping() = default;
  Clipping(const Clipping&) = delete;
  Clipping& operator=(const Clipping&) = delete;
  virtual ~Clipping() = default;

  /// A rectangle that holds the window.
  [[nodiscard]] virtual const Rectangle& box() const = 0;
  [[nodiscard]] virtual const Border& border() const = 0;
  /// Visits each ring of the window's border, the inside on its left.
  virtual void visitRings(FunctionRef<void(std::span<const Point>)> visit) const = 0;
  [[nodiscard]] virtual std::unique_ptr<CellClipper> cells(Parts parts) const = 0;
  /// Visits each piece of an edge inside, with the same bits after any history.
  virtual void visitEdges(EdgeVisitor& visitor) const = 0;
  virtual void measureCells(Measure what, std::vector<double>& measures) const = 0;
  /// The natural neighbours of new circles whose cells end at the window only, not at a distance
  /// from their sites.
  [[nodiscard]] virtual std::unique_ptr<NaturalNeighbors> naturalNeighbors() const = 0;
  /// Draws each edge inside once; render.h says how portions work.
  virtual void drawEdges(Tolerance tolerance, Portion& portion, Path& path) const = 0;
};

}  // namespace apollonius::internal
