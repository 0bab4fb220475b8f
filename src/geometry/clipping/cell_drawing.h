// Drawings of cells: one cell, or all in portions, as commands or as texts.
#pragma once

#include "apollonius/path.h"
#include "geometry/cell/boundary_piece.h"
#include "geometry/clipping/clipping.h"

namespace apollonius::internal {

/// Adds a closed figure for each ring.
void drawCell(const Cell& cell, Tolerance tolerance, Path& path);

/// Replaces the drawings by those of the next portion, whose cursor is a slot. Throws
/// std::bad_alloc, std::length_error.
void drawCells(const DiagramCore& core, const Clipping& clipping, Tolerance tolerance,
               Portion& portion, CellDrawings& drawings);

/// Writes the drawings of the next portion as texts. REQUIRES: digits <= PathWriter::kMostDigits.
void writeCells(const DiagramCore& core, const Clipping& clipping, Tolerance tolerance,
                unsigned digits, Portion& portion, CellPaths& paths);

}  // namespace apollonius::internal
