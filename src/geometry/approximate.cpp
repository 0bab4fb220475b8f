#include "geometry/approximate.h"

#include <algorithm>
#include <vector>

#include "number/fp.h"

namespace apollonius::internal {

namespace {

// Halving a piece of weight w gives two of weight √((1+w)/2): w is 1 up to rounding after 600
// halvings at worst (w near 2^1023) and the sagitta falls to a quarter or less with each. Points
// that coincide in doubles end it sooner.
constexpr int kMostHalvings = 640;

/// No if a coordinate is not finite: a trusted snapshot can have invalid vertices.
bool isSplittable(const Conic& conic, Point m) {
  return dot(m, m) >= 0 && !(m == conic.p0 || m == conic.p2);
}

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
  if (!isSplittable(conic, first.p2)) return drawCubic(conic, path);
  draw(first, tolerance, path, depth - 1);
  draw(second, tolerance, path, depth - 1);
}

void flatten(const Conic& conic, double tolerance, std::vector<double>& points, int depth) {
  if (!conic.isStraight() && depth > 0 && conic.sagitta() > tolerance) {
    Conic first, second;
    conic.halve(first, second);
    if (isSplittable(conic, first.p2)) {
      flatten(first, tolerance, points, depth - 1);
      flatten(second, tolerance, points, depth - 1);
      return;
    }
  }
  points.push_back(conic.p2.x);
  points.push_back(conic.p2.y);
}

/// No finer than this share of the curve's size: 2^18 points or about 64 cubic curves at worst.
double finestFor(const Conic& conic) {
  return powerOfTwo(-36) * (length(conic.p1 - conic.p0) + length(conic.p2 - conic.p1));
}

}  // namespace

void drawConic(const Conic& conic, double tolerance, Path& path) {
  draw(conic, std::max(tolerance, finestFor(conic)), path, kMostHalvings);
}

void flattenConic(const Conic& conic, double tolerance, std::vector<double>& points) {
  flatten(conic, std::max(tolerance, finestFor(conic)), points, kMostHalvings);
}

}  // namespace apollonius::internal
