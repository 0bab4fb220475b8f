#include "geometry/clipping/cell_drawing.h"

#include <span>
#include <utility>

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

void drawCells(const DiagramCore& core, const Clipping& clipping, Tolerance tolerance,
               Portion& portion, CellDrawings& drawings) {
  drawings = {};
  Path& path = drawings.content;
  const auto cells = clipping.cells(Parts::kWithArea);
  cells->expectAll();
  // By slot: as sites lie in memory, they lie in the plane.
  for (; portion.cursor < core.ids().slots(); ++portion.cursor) {
    const std::size_t drawn = path.commands.size();
    if (drawn >= portion.commands) return;
    const auto slot = static_cast<Slot>(portion.cursor);
    drawCell(cells->find(slot), tolerance, path);
    if (path.commands.size() == drawn) continue;
    drawings.ends.push_back(core.ids().idOf(slot));
    drawings.ends.push_back(static_cast<double>(path.commands.size()));
  }
  portion.isDone = true;
}

void writeCells(const DiagramCore& core, const Clipping& clipping, Tolerance tolerance,
                unsigned digits, Portion& portion, CellPaths& paths) {
  CellDrawings drawings;
  drawCells(core, clipping, tolerance, portion, drawings);
  paths = {{}, std::move(drawings.ends)};
  PathWriter writer(digits);
  const double* numbers = drawings.content.coordinates.data();
  const std::span<const std::uint8_t> commands(drawings.content.commands);
  std::size_t from = 0;
  for (std::size_t k = 1; k < paths.ends.size(); k += 2) {
    const auto to = static_cast<std::size_t>(paths.ends[k]);
    numbers = writer.write(commands.subspan(from, to - from), numbers, paths.content);
    if (numbers == nullptr) {
      portion.isDone = false;
      paths.ends.clear();
      return;
    }
    paths.ends[k] = static_cast<double>(paths.content.size());
    from = to;
  }
}

}  // namespace apollonius::internal
