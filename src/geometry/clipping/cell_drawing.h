// Drawings of cells: of one, and the texts of all in portions.
#pragma once

#include "apollonius/path.h"
#include "geometry/cell/boundary_piece.h"
#include "geometry/clipping/clipping.h"

namespace apollonius::internal {

/// Adds a closed figure for each ring.
void drawCell(const Cell& cell, Tolerance tolerance, Path& path);

/// Replaces the texts by those of the portion, whose cursor is a slot. REQUIRES: digits <=
/// PathWriter::kMostDigits. Throws std::bad_alloc, std::length_error.
void writeCells(const DiagramCore& core, const Clipping& clipping, Tolerance tolerance,
                unsigned digits, Portion& portion, CellPaths& paths);

}  // namespace apollonius::internal
