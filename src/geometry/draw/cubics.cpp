#include "geometry/draw/cubics.h"

#include <algorithm>

#include "number/fp.h"

namespace apollonius::internal {

namespace {

/// Bound on the distance between a conic and the cubic with the same ends and end tangents that
/// meets it at the middle of the arc, in units of the distance from the chord's middle to p1. As a
/// function of z = (w-1)/(w+1) the distance is of order z² (the sixth order in the length of a
/// piece) with a factor that grows from 0.0187 (z = 0) to 0.0725 (z = 1), and less for z < 0. Found
/// by evaluation; tests/geometry/conic_test.cpp holds it against the curves.
double cubicError(double w) {
  const double z = (w - 1) / (w + 1);
  return z * z * (0.02 + (z > 0 ? 0.054 * z : 0));
}

/// The cubic with the same ends and end tangents whose middle is the conic's.
void drawCubic(const Conic& conic, Path& path) {
  const double share = 4 * conic.w / (3 * (1 + conic.w));
  const Point a = conic.p0 + share * (conic.p1 - conic.p0),
              b = conic.p2 + share * (conic.p1 - conic.p2);
  path.curve(a.x, a.y, b.x, b.y, conic.p2.x, conic.p2.y);
}

void draw(const Conic& conic, double tolerance, Path& path, int depth) {
  if (conic.sagitta() <= tolerance) {
    path.line(conic.p2.x, conic.p2.y);
    return;
  }
  if (depth == 0 ||
      cubicError(conic.w) * length(conic.p1 - middle(conic.p0, conic.p2)) <= tolerance)
    return drawCubic(conic, path);
  Conic first, second;
  conic.halve(first, second);
  if (!conic.isSplitBy(first.p2)) return drawCubic(conic, path);
  draw(first, tolerance, path, depth - 1);
  draw(second, tolerance, path, depth - 1);
}

/// No finer than this share of the curve's size: about 64 cubic curves at worst.
constexpr double kFinestShare = powerOfTwo(-36);

}  // namespace

void drawConic(const Conic& conic, Tolerance tolerance, Path& path) {
  const double size = length(conic.p1 - conic.p0) + length(conic.p2 - conic.p1);
  const double allowed = std::min(tolerance.distance, tolerance.share * size);
  draw(conic, std::max(allowed, kFinestShare * size), path, Conic::kMostHalvings);
}

}  // namespace apollonius::internal
