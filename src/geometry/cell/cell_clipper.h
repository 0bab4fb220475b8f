// Clips the cells of a diagram to a window, one by one. Each kind of window has its own clipper: a
// rectangle (rectangle_cell.h), a polygon (polygon_cell.h); or cuts further what another one leaves
// (reach_cell.h).
#pragma once

#include <limits>

#include "diagram/id_pool.h"
#include "geometry/cell/boundary_piece.h"

namespace apollonius::internal {

/// Which parts of a cell are found. kThinToo: those without area up to rounding as well, so that
/// the curve of an edge is in both of its cells.
enum class Parts : bool { kWithArea, kThinToo };

/// Keeps its scratch memory from one cell to the next.
class CellClipper {
 public:
  explicit CellClipper(Parts parts) : parts_(parts) {}
  CellClipper(const CellClipper&) = delete;
  CellClipper& operator=(const CellClipper&) = delete;
  virtual ~CellClipper() = default;

  /// The cell of a site, without parts if the site is hidden or nothing of the cell is inside.
  /// Valid until the next call. Throws std::bad_alloc.
  virtual const Cell& find(Slot site) = 0;
  /// All cells will be asked for, ascending by slot, so that mostly neighbours follow each other:
  /// what two of them have in common may be kept for the second. Throws std::bad_alloc.
  virtual void expectAll() {}
  /// From a site's centre, as far as its cell can go; infinity without a limit.
  [[nodiscard]] virtual double radiusOf(SiteId /*site*/) const {
    return std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] Parts parts() const { return parts_; }

 private:
  Parts parts_;
};

}  // namespace apollonius::internal
