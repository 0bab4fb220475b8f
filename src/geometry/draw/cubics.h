// Conics as cubic Bezier curves, within a tolerance and with few pieces.
#pragma once

#include "apollonius/path.h"
#include "geometry/curve/conic.h"

namespace apollonius::internal {

/// Continues a path that is at conic.p0 to conic.p2, by lines and cubic curves no further than
/// `tolerance` from the conic.
void drawConic(const Conic& conic, double tolerance, Path& path);

}  // namespace apollonius::internal
