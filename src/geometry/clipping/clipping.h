// What is inside a window: of edges, of cells, and sums over all cells. Each kind of window
// implements this interface: RectangleClipping, PolygonClipping. All that works on a window
// (src/api) knows the interface only.
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

/// A piece of an edge, counter-clockwise about its reference site, and at which of its ends the
/// edge ends, too: at a Voronoi vertex. It is cut at the others.
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

/// All of it throws std::bad_alloc.
class Clipping {
 public:
  Clipping() = default;
  Clipping(const Clipping&) = delete;
  Clipping& operator=(const Clipping&) = delete;
  virtual ~Clipping() = default;

  /// A rectangle that holds the window.
  [[nodiscard]] virtual const Rectangle& box() const = 0;
  [[nodiscard]] virtual const Border& border() const = 0;
  /// Each ring of the window's border, the inside on its left.
  virtual void visitRings(FunctionRef<void(std::span<const Point>)> visit) const = 0;
  [[nodiscard]] virtual std::unique_ptr<CellClipper> cells(Parts parts) const = 0;
  /// Each piece of an edge inside, with the same bits after any history.
  virtual void visitEdges(EdgeVisitor& visitor) const = 0;
  virtual void measureCells(Measure what, std::vector<double>& measures) const = 0;
  /// Of new circles whose cells end at the window only, not at a distance from their sites.
  [[nodiscard]] virtual std::unique_ptr<NaturalNeighbors> naturalNeighbors() const = 0;
  /// Each edge inside once; render.h says how portions work.
  virtual void drawEdges(Tolerance tolerance, Portion& portion, Path& path) const = 0;
};

}  // namespace apollonius::internal
