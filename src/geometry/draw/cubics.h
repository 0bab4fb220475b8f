// Conics as cubic Bezier curves, within a tolerance and with few pieces.
#pragma once

#include "apollonius/path.h"
#include "geometry/curve/conic.h"
#include "geometry/curve/tolerance.h"

namespace apollonius::internal {

/// Continues a path that is at conic.p0 to conic.p2, by lines and cubic curves within a tolerance.
void drawConic(const Conic& conic, Tolerance tolerance, Path& path);

}  // namespace apollonius::internal
