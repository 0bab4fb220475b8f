// A turn along a circle as the pieces that it is drawn in: a quarter turn at most, so that each is
// a conic with a control point.
#pragma once

#include "predicate/point.h"

namespace apollonius::internal {

/// Is the turn from one direction to another, counter-clockwise, a quarter at most? Of equal ones:
/// none, rather than all.
constexpr bool isQuarterAtMost(Point from, Point to) {
  return cross(from, to) >= 0 && dot(from, to) >= 0;
}

/// visit(a, b) for the pieces, in order; the last one ends at `to`. `isShort`: the turn is a
/// quarter at most, and so one piece.
template <class Visit>
void visitQuarters(Point from, Point to, bool isShort, Visit&& visit) {
  for (int quarter = 0; quarter < 3 && !isShort; ++quarter) {
    const Point next = leftOf(from);
    visit(from, next);
    from = next;
    isShort = isQuarterAtMost(from, to);
  }
  visit(from, to);
}

}  // namespace apollonius::internal
