// Conics as cubic Bezier curves and as polylines, within a tolerance and with few pieces.
#pragma once

#include <vector>

#include "apollonius/path.h"
#include "geometry/conic.h"

namespace apollonius::internal {

/// Continues a path that is at conic.p0 to conic.p2, by lines and cubic curves no further than
/// `tolerance` from the conic.
void drawConic(const Conic& conic, double tolerance, Path& path);

/// Appends points (x, y) of the conic, the last one conic.p2 and without conic.p0: a polyline no
/// further from it than that.
void flattenConic(const Conic& conic, double tolerance, std::vector<double>& points);

}  // namespace apollonius::internal
