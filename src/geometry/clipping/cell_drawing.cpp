#include "geometry/clipping/cell_drawing.h"

#include <cstddef>
#include <span>

#include "geometry/draw/cubics.h"
#include "geometry/draw/path_writer.h"

namespace apollonius::internal {

namespace {

void drawClosed(std::span<const BoundaryPiece> ring, Tolerance tolerance, Path& path) {
  const Point start = ring.front().curve.p0;
  path.move(start.x, start.y);
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Conic& curve = ring[k].curve;
    const bool isClosing = k + 1 == ring.size() && curve.isStraight();  // close() draws it
    if (!isClosing && !(curve.p0 == curve.p2)) drawConic(curve, tolerance, path);
  }
  path.close();
}

/// Gives draw(slot, cell) the cells from the cursor on, until the commands that it counts make a
/// portion.
template <class Draw>
void visitCells(const DiagramCore& core, const Clipping& clipping, Portion& portion, Draw&& draw) {
  const auto cells = clipping.cells(Parts::kWithArea);
  cells->expectAll();
  // By slot: as sites lie in memory, they lie in the plane.
  for (std::size_t drawn = 0; portion.cursor < core.ids().slots(); ++portion.cursor) {
    if (drawn >= portion.commands) return;
    const auto slot = static_cast<Slot>(portion.cursor);
    drawn += draw(slot, cells->find(slot));
  }
  portion.isDone = true;
}

}  // namespace

void drawCell(const Cell& cell, Tolerance tolerance, Path& path) {
  for (std::size_t ring = 0; ring < cell.ringCount(); ++ring)
    drawClosed(cell.ring(ring), tolerance, path);
}

void drawCells(const DiagramCore& core, const Clipping& clipping, Tolerance tolerance,
               Portion& portion, CellDrawings& drawings) {
  drawings = {};
  Path& path = drawings.content;
  visitCells(core, clipping, portion, [&](Slot slot, const Cell& cell) {
    const std::size_t before = path.commands.size();
    drawCell(cell, tolerance, path);
    if (path.commands.size() == before) return std::size_t{0};
    drawings.ends.push_back(core.ids().idOf(slot));
    drawings.ends.push_back(static_cast<double>(path.commands.size()));
    return path.commands.size() - before;
  });
}

void writeCells(const DiagramCore& core, const Clipping& clipping, Tolerance tolerance,
                unsigned digits, Portion& portion, CellPaths& paths) {
  paths = {};
  PathWriter writer(digits);
  Path path;
  bool isWritten = true;
  visitCells(core, clipping, portion, [&](Slot slot, const Cell& cell) {
    path.clear();
    drawCell(cell, tolerance, path);
    if (path.commands.empty()) return std::size_t{0};
    isWritten = writer.write(path, paths.content);
    paths.ends.push_back(core.ids().idOf(slot));
    paths.ends.push_back(static_cast<double>(paths.content.size()));
    return isWritten ? path.commands.size() : portion.commands;  // or else it is the last one
  });
  if (isWritten) return;
  portion.isDone = false;
  paths.ends.clear();
}

}  // namespace apollonius::internal
