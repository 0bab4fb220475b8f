#include "geometry/clipping/cell_drawing.h"

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

}  // namespace

void drawCell(const Cell& cell, Tolerance tolerance, Path& path) {
  for (std::size_t ring = 0; ring < cell.ringCount(); ++ring)
    drawClosed(cell.ring(ring), tolerance, path);
}

void writeCells(const DiagramCore& core, const Clipping& clipping, Tolerance tolerance,
                unsigned digits, Portion& portion, CellPaths& paths) {
  paths = {};
  const auto cells = clipping.cells(Parts::kWithArea);
  cells->expectAll();
  PathWriter writer(digits);
  Path path;
  // By slot: as sites lie in memory, they lie in the plane.
  for (std::size_t drawn = 0; portion.cursor < core.ids().slots(); ++portion.cursor) {
    if (drawn >= portion.commands) return;
    const auto slot = static_cast<Slot>(portion.cursor);
    path.clear();
    drawCell(cells->find(slot), tolerance, path);
    if (path.commands.empty()) continue;
    drawn += path.commands.size();
    if (!writer.write(path, paths.text)) {
      paths.ends.clear();
      return;
    }
    paths.ends.push_back(core.ids().idOf(slot));
    paths.ends.push_back(static_cast<double>(paths.text.size()));
  }
  portion.isDone = true;
}

}  // namespace apollonius::internal
