// Which parts of the window's border belong to a cell, from the places where the cell's boundary
// leaves and enters the window.
//
// Walking counter-clockwise along the border, the cell begins at each place where its boundary
// (counter-clockwise, the cell on the left) leaves the window and ends where it enters: leaves and
// enters alternate. Rounding can exchange two that are close. So they are not matched by what
// follows what, but as two sorted lists, of which the k-th belong together; what rounding does is
// then as small as itself. Whether the first leave belongs to the first enter or to the second is
// the choice with (almost) no disorder, if the nearest sites of places between do not contradict.
#pragma once

#include <cstdint>

#include "base/flat_array.h"
#include "diagram/diagram_core.h"
#include "geometry/window/rectangle.h"

namespace apollonius::internal {

/// A point where a cell's boundary meets the window's border.
struct BorderContact {
  int side;
  double position;  ///< Rectangle::positionOf
  Point point;
  std::uint32_t piece;  ///< the piece of the boundary that ends here (leaves) or starts here
  bool leaves;
};

/// A part of the border, counter-clockwise from where a piece left to where a piece enters, over so
/// many corners.
struct BorderArc {
  std::uint32_t from, to;  ///< indices of contacts
  int firstCorner = 0, cornerCount = 0;
};

/// Matches the contacts of a cell, of which as many leave as enter; sorts them by position.
void linkBorderArcs(const DiagramCore& core, Slot site, const Rectangle& window,
                    FlatArray<BorderContact>& contacts, FlatArray<BorderArc>& arcs);

/// The site that owns the whole window if no edge meets it: the one nearest to most of its corners
/// and its middle, or kNoSlot. REQUIRES: not empty.
[[nodiscard]] Slot ownerOfWindow(const DiagramCore& core, const Rectangle& window);

}  // namespace apollonius::internal
